package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;

/** Pictures reach the page as they are, or as the nearest half floats. */
class PictureBytesTest {
  /** The value of a half float, by its definition. */
  private static double value(int half) {
    int exponent = half >> 10 & 31;
    int mantissa = half & 1023;
    double sign = (half & 0x8000) == 0 ? 1 : -1;
    return sign
        * (exponent == 0
            ? mantissa * 0x1p-24
            : (1 + mantissa / 1024.) * StrictMath.pow(2, exponent - 15));
  }

  @Test
  void halvesAreTheNearestOnes() {
    for (int half = 0; half < 0x7bff; half++) {
      float low = (float) value(half);
      float high = (float) value(half + 1);
      float middle = (low + high) / 2;
      int even = half % 2 == 0 ? half : half + 1;
      assertThat(PictureBytes.half(low)).isEqualTo((short) half);
      assertThat(PictureBytes.half(-low)).isEqualTo((short) (half | 0x8000));
      assertThat(PictureBytes.half(Math.nextDown(middle))).isEqualTo((short) half);
      assertThat(PictureBytes.half(middle)).isEqualTo((short) even);
      assertThat(PictureBytes.half(Math.nextUp(middle))).isEqualTo((short) (half + 1));
    }
    assertThat(PictureBytes.half(65519)).isEqualTo((short) 0x7bff);
    assertThat(PictureBytes.half(65520)).isEqualTo((short) 0x7c00);
    assertThat(PictureBytes.half(Float.POSITIVE_INFINITY)).isEqualTo((short) 0x7c00);
    assertThat(PictureBytes.half(Float.NEGATIVE_INFINITY)).isEqualTo((short) 0xfc00);
    assertThat(PictureBytes.half(Float.NaN) & 0x7fff).isGreaterThan(0x7c00);
  }

  @Test
  void headerAndValuesAreInOrder() {
    Image image = new Image(1, 2, new float[] {1, 2, 3, 4, 5, 6}, new float[] {0, .5f});
    ByteBuffer bytes =
        ByteBuffer.wrap(PictureBytes.of(image, true, 7)).order(ByteOrder.LITTLE_ENDIAN);
    for (int expected : new int[] {1, 2, 4, 4, 7}) {
      assertThat(bytes.getInt()).isEqualTo(expected);
    }
    for (float expected : new float[] {1, 2, 3, 0, 4, 5, 6, .5f}) {
      assertThat(bytes.getFloat()).isEqualTo(expected);
    }
    assertThat(bytes.hasRemaining()).isFalse();
  }
}
