package io.github.lumbre.image.format.jpeg;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.PictureLimits;
import java.awt.image.Raster;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * The structure of a JPEG file, read without decoding it (ITU-T T.81, annex B).
 *
 * @param width in pixels
 * @param height in pixels
 * @param components number of color components
 * @param adobe color transform in the Adobe marker, or -1 if there is no such marker
 * @param content the file without color profiles, previews and comments, with an end marker, and
 *     with a JFIF marker if the three components are YCbCr
 */
public record JpegFile(int width, int height, int components, int adobe, byte[] content) {
  private static final int YCCK = 2;
  private static final byte[] JFIF = {
    (byte) 0xff, (byte) 0xe0, 0, 16, 'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0
  };
  private static final int START_OF_SCAN = 0xda;
  private static final byte[] END = {(byte) 0xff, (byte) 0xd9};

  public static boolean startsIn(byte[] file) {
    return file.length >= 3 && unsigned(file, 0) == 0xffd8 && file[2] == (byte) 0xff;
  }

  /**
   * Reads the structure of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if the segments are damaged or truncated, or the picture exceeds
   *     the limits, has too many scans, or is larger than its data can hold
   */
  public static JpegFile read(byte[] file) throws ImageFormatException {
    ByteArrayOutputStream kept = new ByteArrayOutputStream(file.length);
    ByteBuffer frame = ByteBuffer.allocate(0);
    boolean jfif = false;
    int adobe = -1;
    int kind = 0;
    int at = 2;
    while (true) {
      at = skipFill(file, at);
      int marker = file[at + 1] & 0xff;
      int length = segmentLength(file, at);
      if (isFrame(marker)) {
        frame = frame(file, at, length);
        kind = marker;
      }
      jfif |= marker == 0xe0 && hasText(file, at, length, "JFIF\0");
      boolean isAdobe = marker == 0xee && hasText(file, at, length, "Adobe") && length >= 14;
      adobe = isAdobe ? file[at + 15] & 0xff : adobe;
      if (marker == START_OF_SCAN) {
        break;
      }
      if (isAdobe || !isApplicationOrComment(marker)) {
        kept.write(file, at, length + 2);
      }
      at += length + 2;
    }
    if (frame.limit() == 0) {
      throw malformed("JPEG has no header");
    }
    boolean hasEnd = JpegScans.check(file, at, new JpegCoverage(frame, kind));
    kept.write(file, at, file.length - at);
    kept.writeBytes(hasEnd ? new byte[0] : END);
    return of(frame, jfif, adobe, kept.toByteArray());
  }

  private static JpegFile of(ByteBuffer frame, boolean jfif, int adobe, byte[] kept)
      throws ImageFormatException {
    int height = frame.getShort(1) & 0xffff;
    int width = frame.getShort(3) & 0xffff;
    int components = frame.get(5);
    PictureLimits.checkSize(width, height);
    // Each block of 8×8 samples takes at least one bit. With the coarsest subsampling there is one
    // block for every 128 pixels.
    if ((long) width * height > 8L * 128 * kept.length) {
      throw malformed("JPEG data are too short for " + width + "x" + height + " pixels");
    }
    boolean ycc = components == 3 && adobe < 0 && (jfif || !namedRgb(frame));
    ByteArrayOutputStream content = new ByteArrayOutputStream(kept.length + 20);
    content.write(0xff);
    content.write(0xd8);
    content.writeBytes(ycc ? JFIF : new byte[0]);
    content.writeBytes(kept);
    return new JpegFile(width, height, components, adobe, content.toByteArray());
  }

  /**
   * Returns the RGB values of a decoded picture with four components (CMYK or YCCK). By Adobe's
   * convention the values are inverted: 255 means no ink.
   */
  public Pixels inks(Raster raster) {
    byte[] rgb = new byte[3 * raster.getWidth() * raster.getHeight()];
    int[] row = new int[4 * raster.getWidth()];
    int i = 0;
    for (int y = 0; y < raster.getHeight(); y++) {
      raster.getPixels(0, y, raster.getWidth(), 1, row);
      for (int x = 0; x < row.length; x += 4) {
        double luma = row[x];
        double cb = row[x + 1] - 128;
        double cr = row[x + 2] - 128;
        int key = row[x + 3];
        rgb[i++] = paint(adobe == YCCK ? 255 - (luma + 1.402 * cr) : row[x], key);
        rgb[i++] =
            paint(adobe == YCCK ? 255 - (luma - .344136 * cb - .714136 * cr) : row[x + 1], key);
        rgb[i++] = paint(adobe == YCCK ? 255 - (luma + 1.772 * cb) : row[x + 2], key);
      }
    }
    return Pixels.of(raster.getWidth(), raster.getHeight(), 3, rgb);
  }

  private byte paint(double ink, int key) {
    double limited = Math.max(0, Math.min(255, ink));
    return (byte) Math.round(adobe < 0 ? (255 - limited) * (255 - key) / 255 : limited * key / 255);
  }

  private static int skipFill(byte[] file, int from) throws ImageFormatException {
    int at = from;
    while (at + 1 < file.length && file[at] == (byte) 0xff && file[at + 1] == (byte) 0xff) {
      at++;
    }
    if (at + 4 > file.length) {
      throw malformed("JPEG is truncated");
    }
    if (file[at] != (byte) 0xff) {
      throw malformed("JPEG is damaged: no marker at byte " + at);
    }
    return at;
  }

  private static int segmentLength(byte[] file, int at) throws ImageFormatException {
    int length = unsigned(file, at + 2);
    if (length < 2) {
      throw malformed("JPEG is damaged: a segment with an invalid length at byte " + at);
    }
    if (at + 2 + length > file.length) {
      throw malformed("JPEG is truncated");
    }
    return length;
  }

  private static ByteBuffer frame(byte[] file, int at, int length) throws ImageFormatException {
    ByteBuffer frame = ByteBuffer.wrap(file, at + 4, length - 2).slice();
    if (length < 8 || length < 8 + 3 * (frame.get(5) & 0xff)) {
      throw malformed("JPEG has a header that is too short");
    }
    if (frame.get(0) != 8) {
      throw malformed("JPEG has " + frame.get(0) + " bits a channel, expected 8");
    }
    return frame;
  }

  /** Returns whether a marker starts a frame: SOF0 to SOF15, but not DHT, JPG and DAC. */
  private static boolean isFrame(int marker) {
    return (marker & 0xf0) == 0xc0 && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
  }

  private static boolean isApplicationOrComment(int marker) {
    return (marker & 0xf0) == 0xe0 || marker == 0xfe;
  }

  private static boolean namedRgb(ByteBuffer frame) {
    return frame.get(6) == 'R' && frame.get(9) == 'G' && frame.get(12) == 'B';
  }

  private static boolean hasText(byte[] file, int at, int length, String text) {
    byte[] expected = text.getBytes(StandardCharsets.US_ASCII);
    return length >= 2 + expected.length
        && ByteBuffer.wrap(file, at + 4, expected.length).equals(ByteBuffer.wrap(expected));
  }

  private static int unsigned(byte[] file, int at) {
    return (file[at] & 0xff) << 8 | file[at + 1] & 0xff;
  }

  /**
   * Counts the scans of a JPEG file without decoding them (ITU-T T.81, annex B). Every scan of a
   * progressive picture visits all blocks, even if it has few bytes. The decoding time is therefore
   * proportional to the number of scans times the number of pixels.
   */
  private static final class JpegScans {
    /**
     * The largest number of scans. Encoders write about ten. The scan scripts that the libjpeg
     * tools accept have at most a hundred ({@code MAX_SCANS} in rdswitch.c).
     */
    static final int MAX_SCANS = 100;

    private static final int START_OF_SCAN = 0xda;
    private static final int END_OF_IMAGE = 0xd9;

    private JpegScans() {}

    /**
     * Checks the scans, and returns whether an end marker follows them. Without one, the scans have
     * to hold the whole picture; decoding finds out whether the data of the last one are cut off.
     *
     * @param from position of the first scan's marker
     * @param coverage receives the scans
     * @throws ImageFormatException if there are more than {@link #MAX_SCANS}, or the file ends
     *     before the picture does, in which case libraries would fill the rest with gray
     */
    static boolean check(byte[] file, int from, JpegCoverage coverage)
        throws ImageFormatException {
      int scans = 0;
      int at = from;
      while (at + 1 < file.length) {
        int marker = file[at + 1] & 0xff;
        if (file[at] != (byte) 0xff || marker == 0xff) {
          at++;
        } else if (marker == END_OF_IMAGE) {
          requireFew(scans);
          return true;
        } else if (isAlone(marker)) {
          at += 2;
        } else {
          int length = length(file, at + 2);
          if (marker == START_OF_SCAN && at + 2 + length <= file.length) {
            scans++;
            coverage.add(ByteBuffer.wrap(file, at + 4, length - 2).slice());
          }
          at += 2 + length;
        }
      }
      if (at > file.length || !coverage.isComplete()) {
        throw malformed("JPEG is truncated");
      }
      requireFew(scans);
      return false;
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
}
