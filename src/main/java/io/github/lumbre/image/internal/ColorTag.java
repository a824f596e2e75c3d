package io.github.lumbre.image.internal;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.format.imageio.BmpFile;
import io.github.lumbre.image.format.imageio.TiffFile;
import io.github.lumbre.image.format.jpeg.JpegFile;
import io.github.lumbre.image.format.png.PngFile;
import io.github.lumbre.image.format.webp.WebpFile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.InflaterInputStream;

/**
 * Finds the color space that a PNG, JPEG, WebP, TIFF or BMP file states if it is not sRGB, because
 * {@link ImageReader} ignores it. Only the description of an ICC profile is decoded. Sources: PNG
 * specification, third edition, sec. 11.3.2; ICC.1:2022, sec. 7 and B.4.
 */
public final class ColorTag {
  private static final int SRGB = 0x73524742;
  private static final int GAMA = 0x67414d41;
  private static final int ICCP = 0x69434350;
  private static final int IDAT = 0x49444154;
  private static final int DESCRIPTION = 0x64657363;
  private static final int MULTI_LOCALIZED = 0x6d6c7563;
  private static final int SRGB_GAMMA = 45455;

  /** Tolerance for gammas, which programs round differently: 0.1 % of sRGB's gamma. */
  private static final int GAMMA_TOLERANCE = 45;

  /** The number of bytes of a profile that are read; the description is near its beginning. */
  private static final int MAX_PROFILE = 1 << 16;

  private static final int MAX_NAME = 60;
  private static final byte[] JPEG_PROFILE = "ICC_PROFILE\0".getBytes(StandardCharsets.ISO_8859_1);

  private ColorTag() {}

  /**
   * Returns the color space that the file states, as text for messages; empty if it states sRGB or
   * none.
   */
  public static Optional<String> ignoredIn(byte[] file) {
    try {
      if (PngFile.startsIn(file)) {
        return ofPng(ByteBuffer.wrap(file));
      }
      if (JpegFile.startsIn(file)) {
        return ofJpeg(ByteBuffer.wrap(file));
      }
      byte[] profile = whole(file);
      return profile.length == 0 ? Optional.empty() : profile(profile);
    } catch (IndexOutOfBoundsException | ImageFormatException e) {
      // The file is damaged. Decoding reports that.
      return Optional.empty();
    }
  }

  /** Returns the profile of a file of a format that has it in one piece. */
  private static byte[] whole(byte[] file) throws ImageFormatException {
    if (WebpFile.startsIn(file)) {
      return WebpFile.profile(file);
    }
    if (TiffFile.startsIn(file)) {
      return TiffFile.profile(file);
    }
    return BmpFile.startsIn(file) ? BmpFile.profile(file) : new byte[0];
  }

  private static Optional<String> ofPng(ByteBuffer file) {
    Optional<String> found = Optional.empty();
    int at = Long.BYTES;
    while (at + 12 <= file.limit()) {
      int length = file.getInt(at);
      int type = file.getInt(at + 4);
      if (length < 0 || length > file.limit() - at - 12 || type == IDAT) {
        return found;
      }
      if (type == SRGB) {
        return Optional.empty();
      }
      if (type == ICCP) {
        // A profile takes precedence over a gamma.
        found = profile(pngProfile(file, at + 8, length));
        if (found.isEmpty()) {
          return found;
        }
      }
      if (type == GAMA && length == 4 && found.isEmpty()) {
        int gamma = file.getInt(at + 8);
        boolean isSrgb = Math.abs(gamma - SRGB_GAMMA) <= GAMMA_TOLERANCE;
        found = isSrgb ? found : Optional.of("a gamma of " + Integer.toUnsignedLong(gamma) / 1e5);
      }
      at += length + 12;
    }
    return found;
  }

  /**
   * Returns the inflated beginning of the profile, which follows a name, a zero byte and a
   * compression method.
   */
  private static byte[] pngProfile(ByteBuffer file, int start, int length) {
    int at = start;
    while (at < start + length && file.get(at) != 0) {
      at++;
    }
    int deflated = Math.max(0, start + length - at - 2);
    try (InputStream in =
        new InflaterInputStream(new ByteArrayInputStream(file.array(), at + 2, deflated))) {
      return in.readNBytes(MAX_PROFILE);
    } catch (IOException e) {
      return new byte[0];
    }
  }

  private static Optional<String> ofJpeg(ByteBuffer file) {
    int at = 2;
    while (at + 4 <= file.limit() && (file.get(at) & 0xff) == 0xff) {
      int marker = file.get(at + 1) & 0xff;
      if (marker == 0xff) {
        at++;
        continue;
      }
      int length = file.getShort(at + 2) & 0xffff;
      if (marker == 0xda || length < 2) {
        break;
      }
      // The two bytes after the name number the parts. The first part contains the description.
      int start = at + 4 + JPEG_PROFILE.length + 2;
      int end = Math.min(at + 2 + length, file.limit());
      if (marker == 0xe2 && start < end && hasProfile(file, at + 4)) {
        byte[] profile = new byte[end - start];
        file.get(start, profile);
        return profile(profile);
      }
      at += length + 2;
    }
    return Optional.empty();
  }

  private static boolean hasProfile(ByteBuffer file, int at) {
    return file.slice(at, JPEG_PROFILE.length).equals(ByteBuffer.wrap(JPEG_PROFILE));
  }

  private static Optional<String> profile(byte[] profile) {
    String name = description(ByteBuffer.wrap(profile)).strip();
    if (name.contains("sRGB") && !name.toLowerCase(Locale.ROOT).contains("linear")) {
      return Optional.empty();
    }
    return Optional.of("an ICC profile" + (name.isEmpty() ? "" : " (" + name + ")"));
  }

  /** Returns the description of a profile; empty if it has none or is damaged. */
  private static String description(ByteBuffer profile) {
    try {
      int tags = profile.getInt(128);
      for (int i = 0; i < Math.min(tags, 100); i++) {
        int tag = 132 + 12 * i;
        if (profile.getInt(tag) == DESCRIPTION) {
          return text(profile, profile.getInt(tag + 4));
        }
      }
      return "";
    } catch (IndexOutOfBoundsException e) {
      return "";
    }
  }

  private static String text(ByteBuffer profile, int at) {
    boolean isWide = profile.getInt(at) == MULTI_LOCALIZED;
    int start = at + (isWide ? profile.getInt(at + 24) : 12);
    int length = Math.max(0, profile.getInt(at + (isWide ? 20 : 8)));
    byte[] text = new byte[Math.min(length, isWide ? 2 * MAX_NAME : MAX_NAME)];
    profile.get(start, text);
    String name =
        new String(text, isWide ? StandardCharsets.UTF_16BE : StandardCharsets.ISO_8859_1);
    int end = name.indexOf('\0');
    return end < 0 ? name : name.substring(0, end);
  }
}
