package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import java.nio.charset.StandardCharsets;

/**
 * The orientation of a picture (KTX File Format 2.0, section 5.2). Other metadata have no effect on
 * it or are refused.
 *
 * @param isLeft whether rows begin at the right
 * @param isUp whether the first row is the bottom row
 */
record KtxMetadata(boolean isLeft, boolean isUp) {
  static KtxMetadata of(KtxInput in) throws ImageFormatException {
    KtxMetadata found = new KtxMetadata(false, false);
    int at = 0;
    while (at < in.size()) {
      KtxInput entry = in.part(at + Integer.BYTES, in.word(at), "an entry of the metadata");
      String text =
          new String(entry.file(), entry.from(), entry.size(), StandardCharsets.ISO_8859_1);
      String value = text.substring(text.indexOf('\0') + 1).replace("\0", "");
      if (text.startsWith("KTXorientation\0")) {
        found = new KtxMetadata(value.startsWith("l"), value.endsWith("u"));
      } else if (text.startsWith("KTXswizzle\0") && !value.equals("rgba")) {
        throw malformed("KTX has channels in another order (KTXswizzle), expected rgba");
      }
      at += Integer.BYTES + (entry.size() + 3 & -4);
    }
    return found;
  }
}
