package io.github.lumbre.image.jpeg;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;

/**
 * Counts the scans of a JPEG file without decoding them (ITU-T T.81, annex B). Every scan of a
 * progressive picture visits all blocks, even if it has few bytes. The decoding time is therefore
 * proportional to the number of scans times the number of pixels.
 */
final class JpegScans {
  /**
   * The largest number of scans. Encoders write about ten. The scan scripts that the libjpeg tools
   * accept have at most a hundred ({@code MAX_SCANS} in rdswitch.c).
   */
  static final int MAX_SCANS = 100;

  private static final int START_OF_SCAN = 0xda;
  private static final int END_OF_IMAGE = 0xd9;

  private JpegScans() {}

  /**
   * Checks the number of scans.
   *
   * @param from position of the first scan's marker
   * @throws ImageFormatException if there are more than {@link #MAX_SCANS}, or the file ends before
   *     the picture does, in which case libraries would fill the rest with gray
   */
  static void check(byte[] file, int from) throws ImageFormatException {
    int scans = 0;
    int at = from;
    while (at + 1 < file.length) {
      int marker = file[at + 1] & 0xff;
      if (file[at] != (byte) 0xff || marker == 0xff) {
        at++;
      } else if (marker == END_OF_IMAGE) {
        requireFew(scans);
        return;
      } else if (isAlone(marker)) {
        at += 2;
      } else {
        scans += marker == START_OF_SCAN ? 1 : 0;
        at += 2 + length(file, at + 2);
      }
    }
    throw malformed("JPEG is truncated");
  }

  private static void requireFew(int scans) throws ImageFormatException {
    if (scans > MAX_SCANS) {
      throw new ImageFormatException(
          ImageFormatException.Kind.TOO_LARGE,
          "JPEG has %d scans, expected at most %d; save it again as a baseline JPEG or as a PNG"
              .formatted(scans, MAX_SCANS));
    }
  }

  /** Returns whether a marker has no length field: a stuffed byte, a restart, TEM or SOI. */
  private static boolean isAlone(int marker) {
    return marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8);
  }

  private static int length(byte[] file, int at) throws ImageFormatException {
    if (at + 2 > file.length) {
      throw malformed("JPEG is truncated");
    }
    int length = (file[at] & 0xff) << 8 | file[at + 1] & 0xff;
    if (length < 2) {
      throw malformed("JPEG is damaged: a segment with an invalid length at byte " + (at - 2));
    }
    return length;
  }
}
