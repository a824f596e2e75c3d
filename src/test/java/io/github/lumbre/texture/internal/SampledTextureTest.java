package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import io.github.lumbre.texture.internal.SampledTexture.Wrap;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests wrap modes, channels and decoding of textures of models. */
class SampledTextureTest {
  /** Returns a texture whose red is the column from the left and green the row from the bottom. */
  private static SampledTexture indices(int width, int height, Filter filter, Wrap wrap) {
    short[] values = new short[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      values[3 * i] = (short) (i % width);
      values[3 * i + 1] = (short) (height - 1 - i / width);
    }
    return new SampledTexture(Pixels.of(width, height, 3, values), Role.DATA, filter, wrap, wrap);
  }

  @ParameterizedTest
  @CsvSource({
    "REPEAT, -.1, 3", "REPEAT, 1.3, 1", "REPEAT, -1.9, 0", "REPEAT, 7.6, 2",
    "MIRROR, -.1, 0", "MIRROR, 1.3, 2", "MIRROR, -1.9, 0", "MIRROR, 7.6, 1",
    "CLAMP, -.1, 0", "CLAMP, 1.3, 3", "CLAMP, -1.9, 0", "CLAMP, 7.6, 3",
    "REPEAT, .6, 2", "MIRROR, .6, 2", "CLAMP, .6, 2",
  })
  void wrapModesContinueTheTexture(Wrap wrap, double coordinate, int expected) {
    SampledTexture texture = indices(4, 4, Filter.NEAREST, wrap);
    assertThat(Math.round(65535 * texture.channel(coordinate, .1, 0))).isEqualTo(expected);
    assertThat(Math.round(65535 * texture.channel(.1, coordinate, 1))).isEqualTo(expected);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void borderOfTwoTexelsBelongsToTheOneOnTheRightAndAbove(int index) {
    SampledTexture texture = indices(4, 4, Filter.NEAREST, Wrap.REPEAT);
    assertThat(Math.round(65535 * texture.channel(index / 4., .1, 0))).isEqualTo(index);
    assertThat(Math.round(65535 * texture.channel(.1, index / 4., 1))).isEqualTo(index);
  }

  /** Only repeated columns and only repeated rows meet the other border. */
  @Test
  void eachDirectionHasItsWrapMode() {
    Pixels pixels = Pixels.of(2, 2, 1, new byte[] {0, 51, 102, (byte) 255});
    for (boolean isColumn : new boolean[] {false, true}) {
      Wrap wrapU = isColumn ? Wrap.REPEAT : Wrap.CLAMP;
      Wrap wrapV = isColumn ? Wrap.CLAMP : Wrap.REPEAT;
      SampledTexture texture =
          new SampledTexture(pixels, Role.DATA, Filter.BILINEAR, wrapU, wrapV);
      // The texel at the lower left is .4, its right neighbor 1, and the one above it 0.
      double atLeft = texture.channel(0, .25, 0);
      double atBottom = texture.channel(.25, 0, 0);
      assertThat(atLeft).isCloseTo(isColumn ? .7 : .4, within(1e-15));
      assertThat(atBottom).isCloseTo(isColumn ? .4 : .2, within(1e-15));
    }
  }

  @Test
  void hugeCoordinatesAreBeyondTheBordersAndInvalidOnesAtTheOrigin() {
    SampledTexture texture = indices(4, 4, Filter.BILINEAR, Wrap.CLAMP);
    assertThat(Math.round(65535 * texture.channel(1e300, -1e300, 0))).isEqualTo(3);
    assertThat(Math.round(65535 * texture.channel(-1e300, 1e300, 1))).isEqualTo(3);
    assertThat(texture.at(Double.NaN, .5)).isEqualTo(texture.at(0, 0));
    assertThat(InvalidCoordinates.take()).isEqualTo(1);
  }

  @Test
  void bordersAreInterpolatedByTheWrapMode() {
    double u = -.125;
    // Half way between the centers of column -1 and of column 0 lies the border.
    assertThat(65535 * indices(4, 4, Filter.BILINEAR, Wrap.REPEAT).channel(0, .5, 0))
        .isCloseTo(1.5, within(1e-9));
    assertThat(65535 * indices(4, 4, Filter.BILINEAR, Wrap.MIRROR).channel(u, .5, 0))
        .isCloseTo(0, within(1e-9));
    assertThat(65535 * indices(4, 4, Filter.BILINEAR, Wrap.CLAMP).channel(-5, .5, 0))
        .isCloseTo(0, within(1e-9));
    assertThat(65535 * indices(4, 4, Filter.BILINEAR, Wrap.CLAMP).channel(.5, .5, 0))
        .isCloseTo(1.5, within(1e-9));
  }

  @ParameterizedTest
  @EnumSource
  void repeatedTexturesAreThoseOfScenes(Filter filter) {
    byte[] values = new byte[3 * 5 * 7];
    SplittableRandom random = new SplittableRandom(64);
    random.nextBytes(values);
    Pixels pixels = Pixels.of(5, 7, 3, values);
    SampledTexture texture =
        new SampledTexture(pixels, Role.COLOR, filter, Wrap.REPEAT, Wrap.REPEAT);
    ImageTexture scene = new ImageTexture(pixels, Role.COLOR, filter);
    for (int i = 0; i < 1000; i++) {
      double u = random.nextDouble(-3, 3);
      double v = random.nextDouble(-3, 3);
      assertThat(texture.at(u, v).r()).isCloseTo(scene.at(u, v).r(), within(1e-12));
      assertThat(texture.at(u, v).b()).isCloseTo(scene.at(u, v).b(), within(1e-12));
    }
  }

  @Test
  void alphaIsNeverDecodedAndOneIfMissing() {
    Pixels pixels = Pixels.of(1, 1, 4, new byte[] {51, 102, (byte) 153, (byte) 204});
    SampledTexture texture =
        new SampledTexture(pixels, Role.COLOR, Filter.BILINEAR, Wrap.CLAMP, Wrap.CLAMP);
    assertThat(texture.channel(.3, .6, 3)).isCloseTo(.8, within(1e-15));
    assertThat(texture.channel(.3, .6, 0)).isEqualTo(Srgb.fromByte(51));
    assertThat(texture.channel(2).at(.3, .6)).isEqualTo(Srgb.fromByte(153));
    assertThat(indices(2, 2, Filter.NEAREST, Wrap.CLAMP).channel(.3, .6, 3)).isEqualTo(1);
  }

  @Test
  void hugeAndInvalidCoordinatesAreHarmless() {
    for (Wrap wrap : Wrap.values()) {
      SampledTexture texture = indices(3, 2, Filter.BILINEAR, wrap);
      for (double x : new double[] {1e300, -1e300, Double.MAX_VALUE, Double.NaN, 1 / 0.0}) {
        assertThat(texture.at(x, x).isFinite()).isTrue();
      }
    }
    InvalidCoordinates.take();
  }
}
