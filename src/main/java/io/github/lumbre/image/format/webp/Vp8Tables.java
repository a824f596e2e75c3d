package io.github.lumbre.image.format.webp;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Numbers that the VP8 format defines, from a resource that names the section of each table. */
final class Vp8Tables {
  /** The number of probabilities of tokens: 4 types, 8 bands, 3 contexts and 11 nodes. */
  static final int TOKENS = 4 * 8 * 3 * 11;

  /** The probabilities of tokens at the beginning of a frame. */
  static final int[] TOKEN_PROBABILITIES;

  /** The probabilities that the frame replaces a probability of tokens. */
  static final int[] REPLACEMENTS;

  /** The probabilities of modes of 4×4 blocks, by the modes above and to the left, and node. */
  static final int[] MODE_PROBABILITIES;

  /** The factors of the first coefficient, by quantizer index. */
  static final int[] DC_FACTORS;

  /** The factors of the other coefficients, by quantizer index. */
  static final int[] AC_FACTORS;

  static {
    try (InputStream in = Vp8Tables.class.getResourceAsStream("vp8.tables")) {
      String text = new String(in.readAllBytes(), StandardCharsets.US_ASCII);
      int[] numbers =
          text.lines()
              .filter(line -> !line.startsWith("#"))
              .flatMap(line -> Arrays.stream(line.split(" ")))
              .mapToInt(Integer::parseInt)
              .toArray();
      int modes = 2 * TOKENS + 900;
      TOKEN_PROBABILITIES = Arrays.copyOf(numbers, TOKENS);
      REPLACEMENTS = Arrays.copyOfRange(numbers, TOKENS, 2 * TOKENS);
      MODE_PROBABILITIES = Arrays.copyOfRange(numbers, 2 * TOKENS, modes);
      DC_FACTORS = Arrays.copyOfRange(numbers, modes, modes + 128);
      AC_FACTORS = Arrays.copyOfRange(numbers, modes + 128, modes + 256);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Vp8Tables() {}
}
