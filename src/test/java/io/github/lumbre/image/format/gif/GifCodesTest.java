package io.github.lumbre.image.format.gif;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the compression of pixels with a decoder by the specification. */
class GifCodesTest {
  private static byte[] written(byte[] pixels, int length, int bits) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    GifCodes codes = new GifCodes(bits, out);
    for (int i = 0; i < length; i++) {
      codes.write(pixels[i] & 0xff);
    }
    codes.end();
    return out.toByteArray();
  }

  private static void assertExact(byte[] pixels, int length, int bits) throws IOException {
    ByteBuffer file = ByteBuffer.wrap(written(pixels, length, bits));
    assertThat(GifFixture.decode(file, length)).isEqualTo(Arrays.copyOf(pixels, length));
    assertThat(file.hasRemaining()).isFalse();
  }

  /** Includes ends of the data in each state of the table, with widths from 3 to 12 bits. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 5, 8})
  void eachLengthIsExact(int bits) throws IOException {
    byte[] random = new byte[1 << 14];
    new Random(bits).nextBytes(random);
    for (int i = 0; i < random.length; i++) {
      random[i] &= (byte) ((1 << bits) - 1);
    }
    for (int length = 1; length < random.length; length += 1 + length / 512) {
      assertExact(random, length, bits);
    }
  }

  /** A run of one value has the longest strings. */
  @Test
  void runsAreExactAndShort() throws IOException {
    for (int length = 1; length < 20_000; length += 1 + length / 64) {
      assertExact(new byte[length], length, 2);
    }
    assertThat(written(new byte[1 << 20], 1 << 20, 8).length).isLessThan(2500);
  }

  /** Each code of 12 bits: a full table is cleared, and nothing is lost on the way. */
  @Test
  void aFullTableIsCleared() throws IOException {
    byte[] random = new byte[3 * 4096];
    new Random(7).nextBytes(random);
    for (int length = 3800; length < 3900; length++) {
      assertExact(random, length, 8);
    }
    assertExact(random, random.length, 8);
  }
}
