package io.github.lumbre.image.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/** Decodes pictures of ETC1S blocks (KTX File Format 2.0, BasisLZ global data). Stateless. */
final class Etc1sPicture {
  private static final int HEADER_BYTES = 20;
  private static final int IMAGE_BYTES = 20;
  private static final int NEEDS_LAST_FRAME = 2;

  private Etc1sPicture() {}

  /**
   * Fills a picture.
   *
   * @param levels in the file; the global data describe one picture for each
   */
  static void decode(KtxInput level, KtxInput global, int levels, TexelBlocks target)
      throws ImageFormatException {
    KtxInput image = global.part(HEADER_BYTES, IMAGE_BYTES, "an image description");
    if ((image.number(0, Integer.BYTES) & NEEDS_LAST_FRAME) != 0) {
      throw malformed("KTX has a frame of a video, expected one picture");
    }
    long at = HEADER_BYTES + (long) levels * IMAGE_BYTES;
    KtxInput endpoints = global.part(at, global.word(4), "the code book of colors");
    at += endpoints.size();
    KtxInput selectors = global.part(at, global.word(8), "the code book of selectors");
    at += selectors.size();
    Etc1sCodeBooks books =
        Etc1sCodeBooks.read(
            new BasisBits(endpoints),
            global.number(0, Short.BYTES),
            new BasisBits(selectors),
            global.number(2, Short.BYTES));
    KtxInput codes = global.part(at, global.word(12), "the list of codes");
    Etc1sTables tables = Etc1sTables.read(new BasisBits(codes));
    KtxInput colors = level.part(image.word(4), image.word(8), "the slice of colors");
    new Etc1sSlice(colors, books, tables, target, false).decode();
    if (target.hasAlpha()) {
      KtxInput alpha = level.part(image.word(12), image.word(16), "the slice of alpha");
      new Etc1sSlice(alpha, books, tables, target, true).decode();
    }
  }
}
