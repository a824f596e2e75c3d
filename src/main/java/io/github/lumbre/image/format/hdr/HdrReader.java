package io.github.lumbre.image.format.hdr;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.internal.LinearPicture;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.image.internal.PictureLimits;
import io.github.lumbre.image.internal.Primaries;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads Radiance pictures in RGBE, without compression and with both run-length encodings, in all
 * eight orientations (Ward 1991, "Real Pixels"; "Radiance File Formats", radiance-online.org).
 * Values are divided by EXPOSURE and COLORCORR, which state the factors that were applied, and
 * converted from PRIMARIES to those of BT.709. A component is mantissa · 2^(exponent − 136), as in most programs; Radiance adds half to mantissas.
 */
public final class HdrReader {
  private static final Pattern RESOLUTION =
      Pattern.compile("([-+])([XY]) +([0-9]{1,9}) +([-+])([XY]) +([0-9]{1,9})");

  /** The CIE x and y of red, green, blue and white that Radiance has without PRIMARIES. */
  private static final double[] RADIANCE = {.64, .33, .29, .6, .15, .06, .3333, .3333};

  private static final int MAX_LINE = 4096;

  /** Widths of lines that can have the newer encoding. */
  private static final int MIN_NEW = 8;

  private static final int MAX_NEW = 0x7fff;

  /** No more than this many bytes of pixels come from one byte of a file. */
  private static final long MAX_INFLATION = 4096;

  private final byte[] file;
  private int at;
  private int line = 1;
  private final double[] factors = {1, 1, 1};
  private Optional<double[]> toRec709 = Optional.empty();

  private HdrReader(byte[] file) {
    this.file = file;
  }

  public static boolean startsIn(byte[] file) {
    return file.length > 2 && file[0] == '#' && file[1] == '?';
  }

  /** Reads a file that {@link #startsIn} recognizes. */
  public static LinearPicture read(byte[] file, long maxPixels) throws ImageFormatException {
    try {
      return new HdrReader(file).read(maxPixels);
    } catch (ArrayIndexOutOfBoundsException e) {
      throw malformed("Radiance HDR ends too early");
    }
  }

  private LinearPicture read(long maxPixels) throws ImageFormatException {
    nextLine();
    for (String text = nextLine(); !text.isEmpty(); text = nextLine()) {
      readVariable(text);
    }
    Matcher resolution = RESOLUTION.matcher(nextLine());
    if (!resolution.matches() || resolution.group(2).equals(resolution.group(5))) {
      throw error("expected a resolution such as -Y 480 +X 640");
    }
    int lines = Integer.parseInt(resolution.group(3));
    int length = Integer.parseInt(resolution.group(6));
    boolean hasColumns = resolution.group(2).equals("X");
    int width = hasColumns ? lines : length;
    int height = hasColumns ? length : lines;
    PictureLimits.checkSize(width, height);
    PictureLimits.checkPixels(width, height, maxPixels);
    if (4L * width * height > MAX_INFLATION * (file.length - at)) {
      throw malformed("Radiance HDR ends too early");
    }
    float[] rgb = LinearReader.raster(width, height, 3);
    byte[] scan = new byte[4 * length];
    // Rows are counted from the top: y decreases from row to row.
    boolean fromLastLine = resolution.group(1).equals(hasColumns ? "-" : "+");
    boolean fromLastPixel = resolution.group(4).equals(hasColumns ? "+" : "-");
    for (int i = 0; i < lines; i++) {
      Interrupts.check();
      readScan(scan, length);
      int major = fromLastLine ? lines - 1 - i : i;
      for (int k = 0; k < length; k++) {
        int minor = fromLastPixel ? length - 1 - k : k;
        put(scan, 4 * k, rgb, hasColumns ? minor * width + major : major * width + minor);
      }
    }
    toRec709.ifPresent(matrix -> Primaries.convert(rgb, 3, matrix));
    return new LinearPicture(width, height, rgb, new float[0]);
  }

  private String nextLine() throws ImageFormatException {
    int start = at;
    while (file[at] != '\n') {
      at++;
      if (at - start > MAX_LINE) {
        throw error("expected a line of at most " + MAX_LINE + " bytes");
      }
    }
    String text = new String(file, start, at - start, StandardCharsets.ISO_8859_1);
    at++;
    line++;
    return text.endsWith("\r") ? text.substring(0, text.length() - 1) : text;
  }

  private void readVariable(String text) throws ImageFormatException {
    int equals = text.indexOf('=');
    String name = equals < 0 ? "" : text.substring(0, equals).trim();
    String value = text.substring(equals + 1).trim();
    switch (name) {
      case "FORMAT" -> {
        if (!value.equals("32-bit_rle_rgbe")) {
          String found = value.equals("32-bit_rle_xyze") ? "XYZE" : "another one";
          throw error("expected the format 32-bit_rle_rgbe, found " + found + "; save it as RGBE");
        }
      }
      case "EXPOSURE" -> divide(new String[] {value, value, value});
      case "COLORCORR" -> divide(value.split("\\s+"));
      case "PRIMARIES" -> toRec709 = conversion(value.split("\\s+"));
      default -> {
        // Comments and other variables do not change values.
      }
    }
  }

  /**
   * Returns the matrix from stated primaries. Those of Radiance itself count as BT.709's, as other
   * programs take them, and numbers that do not describe colors are ignored.
   */
  private static Optional<double[]> conversion(String... numbers) {
    try {
      double[] xy = Arrays.stream(numbers).mapToDouble(Double::parseDouble).toArray();
      boolean isUsual = xy.length == RADIANCE.length && Primaries.areSame(xy, RADIANCE);
      return isUsual ? Optional.empty() : Primaries.toRec709(xy);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  private void divide(String[] numbers) throws ImageFormatException {
    for (int i = 0; i < 3; i++) {
      try {
        factors[i] /= Double.parseDouble(numbers[i]);
      } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
        throw error("expected numbers");
      }
      if (!(factors[i] > 0) || !Double.isFinite(factors[i])) {
        throw error("expected positive numbers");
      }
    }
  }

  /** Returns an error of the line that was read last. */
  private ImageFormatException error(String message) {
    return malformed("Radiance HDR, line " + (line - 1) + ": " + message);
  }

  private void readScan(byte[] scan, int length) throws ImageFormatException {
    boolean isNew =
        length >= MIN_NEW
            && length <= MAX_NEW
            && file[at] == 2
            && file[at + 1] == 2
            && file[at + 2] >= 0;
    if (!isNew) {
      readOld(scan, length);
      return;
    }
    if (((file[at + 2] & 0xff) << 8 | file[at + 3] & 0xff) != length) {
      throw malformed("Radiance HDR is damaged: a line has another length than the picture");
    }
    at += 4;
    for (int component = 0; component < 4; component++) {
      for (int i = 0; i < length; ) {
        int count = file[at++] & 0xff;
        boolean isRun = count > 128;
        int end = i + (isRun ? count - 128 : count);
        if (count == 0 || end > length) {
          throw malformed("Radiance HDR is damaged: a run is too long");
        }
        for (; i < end; i++) {
          scan[4 * i + component] = isRun ? file[at] : file[at++];
        }
        at += isRun ? 1 : 0;
      }
    }
  }

  /**
   * Reads pixels one by one. A pixel of mantissas 1 repeats the previous one; its exponent is the
   * count, whose higher digits to the base 256 may follow in further pixels of this kind.
   */
  private void readOld(byte[] scan, int length) throws ImageFormatException {
    int shift = 0;
    for (int i = 0; i < length; at += 4) {
      if (file[at] != 1 || file[at + 1] != 1 || file[at + 2] != 1) {
        System.arraycopy(file, at, scan, 4 * i, 4);
        i++;
        shift = 0;
        continue;
      }
      long end = i + ((file[at + 3] & 0xffL) << shift);
      if (i == 0 || end > length || shift > 16) {
        throw malformed("Radiance HDR is damaged: a run is too long");
      }
      for (; i < end; i++) {
        System.arraycopy(scan, 4 * i - 4, scan, 4 * i, 4);
      }
      shift += 8;
    }
  }

  private void put(byte[] scan, int from, float[] rgb, int pixel) {
    int exponent = scan[from + 3] & 0xff;
    for (int i = 0; i < 3; i++) {
      double value = exponent == 0 ? 0 : Math.scalb(scan[from + i] & 0xff, exponent - 136);
      rgb[3 * pixel + i] = (float) (value * factors[i]);
    }
  }
}
