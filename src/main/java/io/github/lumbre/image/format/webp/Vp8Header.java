package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/**
 * The header of a VP8 key frame (RFC 6386, sec. 9 and 19.2).
 *
 * @param modes the data of the modes, after the header
 * @param residuals the data of the coefficients, in 1, 2, 4 or 8 parts that alternate by row
 * @param segmentProbabilities of the nodes of a segment number; empty if there are no numbers
 * @param quantizers of the four segments
 * @param filters of the four segments
 * @param tokens the probabilities of tokens
 * @param skipping the probability that a macroblock has coefficients; -1 if all may have them
 */
record Vp8Header(
    BoolDecoder modes,
    BoolDecoder[] residuals,
    int[] segmentProbabilities,
    Vp8Quantizer[] quantizers,
    Vp8Filters filters,
    int[] tokens,
    int skipping) {
  static final int SEGMENTS = 4;

  /** The bytes before the coded header: of a frame, and of a key frame. */
  private static final int TAG_BYTES = 10;

  /** The settings that may differ between segments, and the probabilities of segment numbers. */
  private record Segments(
      boolean present, boolean absolute, int[] quantizers, int[] filters, int[] probabilities) {
    static Segments read(BoolDecoder bits) throws ImageFormatException {
      boolean present = bits.flag();
      boolean hasNumbers = present && bits.flag();
      boolean hasValues = present && bits.flag();
      boolean absolute = hasValues && bits.flag();
      int[] quantizers = hasValues ? bits.optionals(SEGMENTS, 7) : new int[SEGMENTS];
      int[] filters = hasValues ? bits.optionals(SEGMENTS, 6) : new int[SEGMENTS];
      int[] probabilities = new int[hasNumbers ? SEGMENTS - 1 : 0];
      for (int i = 0; i < probabilities.length; i++) {
        probabilities[i] = bits.flag() ? bits.unsigned(8) : 255;
      }
      return new Segments(present, absolute, quantizers, filters, probabilities);
    }

    int value(int[] values, int segment, int base) {
      return !present ? base : absolute ? values[segment] : base + values[segment];
    }
  }

  /**
   * Reads the header of a frame.
   *
   * @param from the position of the frame
   * @param end the position after it
   */
  static Vp8Header read(byte[] file, int from, int end) throws ImageFormatException {
    int start = from + TAG_BYTES;
    int first = start + (WebpFile.unsigned24(file, from) >> 5);
    if (first > end) {
      throw malformed("VP8 is truncated");
    }
    BoolDecoder bits = new BoolDecoder(file, start, first);
    bits.unsigned(2); // The color space (there is only one), and a promise about clamping.
    Segments segments = Segments.read(bits);
    Vp8Filters filters = filters(bits, segments);
    BoolDecoder[] residuals = residuals(file, first, end, 1 << bits.unsigned(2));
    Vp8Quantizer[] quantizers = quantizers(bits, segments);
    bits.flag(); // Whether later frames keep the probabilities.
    int[] tokens = Vp8Tables.TOKEN_PROBABILITIES.clone();
    for (int i = 0; i < tokens.length; i++) {
      tokens[i] = bits.bit(Vp8Tables.REPLACEMENTS[i]) == 1 ? bits.unsigned(8) : tokens[i];
    }
    int skipping = bits.flag() ? bits.unsigned(8) : -1;
    return new Vp8Header(
        bits, residuals, segments.probabilities, quantizers, filters, tokens, skipping);
  }

  private static Vp8Quantizer[] quantizers(BoolDecoder bits, Segments segments)
      throws ImageFormatException {
    int index = bits.unsigned(7);
    int[] offsets = bits.optionals(5, 4);
    Vp8Quantizer[] quantizers = new Vp8Quantizer[SEGMENTS];
    for (int i = 0; i < SEGMENTS; i++) {
      quantizers[i] = Vp8Quantizer.of(segments.value(segments.quantizers, i, index), offsets);
    }
    return quantizers;
  }

  private static Vp8Filters filters(BoolDecoder bits, Segments segments)
      throws ImageFormatException {
    boolean isSimple = bits.flag();
    int level = bits.unsigned(6);
    int sharpness = bits.unsigned(3);
    // Of four kinds of reference frames, and of four modes.
    int[] offsets = bits.flag() && bits.flag() ? bits.optionals(8, 6) : new int[8];
    int[] levels = new int[2 * SEGMENTS];
    for (int i = 0; i < SEGMENTS && level > 0; i++) {
      int base = segments.value(segments.filters, i, level) + offsets[0];
      levels[2 * i] = Math.max(0, Math.min(63, base));
      levels[2 * i + 1] = Math.max(0, Math.min(63, base + offsets[4]));
    }
    return new Vp8Filters(isSimple, sharpness, levels);
  }

  private static BoolDecoder[] residuals(byte[] file, int from, int end, int count)
      throws ImageFormatException {
    BoolDecoder[] parts = new BoolDecoder[count];
    int sizes = from;
    int start = from + 3 * (count - 1);
    if (start > end) {
      throw malformed("VP8 is truncated");
    }
    for (int i = 0; i < count; i++, sizes += 3) {
      int size = i == count - 1 ? end - start : WebpFile.unsigned24(file, sizes);
      if (size > end - start) {
        throw malformed("VP8 is truncated");
      }
      parts[i] = new BoolDecoder(file, start, start + size);
      start += size;
    }
    return parts;
  }
}
