package io.github.lumbre.image.format.webp;

import static io.github.lumbre.image.ImageFormatException.malformed;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.internal.LowBits;
import io.github.lumbre.image.internal.PictureLimits;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;

/** A WebP file with a still picture (RFC 9649, sec. 2). Mutable; one for each file. */
public final class WebpFile {
  /** The message about a file that ends too early. */
  static final String TRUNCATED = "WebP is truncated";

  private static final int RIFF = 0x46464952;
  private static final int WEBP = 0x50424557;
  private static final int EXTENDED = 0x58385056;
  private static final int PROFILE = 0x50434349;
  private static final int ALPHA = 0x48504c41;
  private static final int LOSSY = 0x20385056;
  private static final int LOSSLESS = 0x4c385056;

  /** The bytes before the first chunk. */
  private static final int HEADER_BYTES = 12;

  private static final int CHUNK_HEADER_BYTES = 8;
  private static final int EXTENDED_BYTES = 10;
  private static final int LOSSY_BYTES = 10;
  private static final int LOSSLESS_BYTES = 5;
  private static final int LOSSLESS_SIGNATURE = 0x2f;
  private static final int SIDE_BITS = 14;
  private static final int SIDE_MASK = (1 << SIDE_BITS) - 1;
  private static final int ANIMATED = 2;

  /** Memory that decoding takes, besides 8 MiB for prefix codes. */
  private static final int BYTES_PER_PIXEL = 12;

  /**
   * A part of the file.
   *
   * @param type the four characters of its name, the first one in the lowest bits; 0 if there is no
   *     such part
   * @param from the position of its data
   * @param end the position after them
   */
  private record Chunk(int type, int from, int end) {
    private static final Chunk NONE = new Chunk(0, 0, 0);

    int length() {
      return end - from;
    }
  }

  private final byte[] file;
  private Chunk header = Chunk.NONE;
  private Chunk profile = Chunk.NONE;
  private Chunk alpha = Chunk.NONE;

  /** The chunk of the picture. */
  private Chunk frame = Chunk.NONE;

  private int width;
  private int height;

  private WebpFile(byte[] file) throws ImageFormatException {
    this.file = file;
    int at = HEADER_BYTES;
    while (frame == Chunk.NONE) {
      Chunk chunk = chunk(at);
      switch (chunk.type) {
        case EXTENDED -> header = chunk;
        case PROFILE -> profile = chunk;
        case ALPHA -> alpha = chunk;
        case LOSSY, LOSSLESS -> frame = chunk;
        default -> {}
      }
      at = chunk.end + (chunk.length() & 1);
    }
  }

  public static boolean startsIn(byte[] file) {
    return file.length >= HEADER_BYTES && number(file, 0) == RIFF && number(file, 8) == WEBP;
  }

  /**
   * Reads the headers of a file that {@link #startsIn} recognizes.
   *
   * @throws ImageFormatException if they are damaged, the file is an animation, or the picture
   *     exceeds the limits or is larger than its data can hold
   */
  public static EncodedPicture open(byte[] file) throws ImageFormatException {
    WebpFile webp = new WebpFile(file);
    if (webp.frame.type == LOSSY) {
      webp.readLossyHeader();
    } else {
      webp.readLosslessHeader();
    }
    PictureLimits.checkSize(webp.width, webp.height);
    webp.checkExtended();
    return new EncodedPicture(
        webp.width,
        webp.height,
        BYTES_PER_PIXEL,
        webp.frame.type == LOSSY ? webp::lossy : webp::lossless);
  }

  /**
   * Returns the ICC profile; empty if there is none.
   *
   * @param file a file that {@link #startsIn} recognizes
   * @throws ImageFormatException if its chunks are damaged
   */
  public static byte[] profile(byte[] file) throws ImageFormatException {
    Chunk profile = new WebpFile(file).profile;
    return Arrays.copyOfRange(file, profile.from, profile.end);
  }

  private Chunk chunk(int at) throws ImageFormatException {
    int from = at + CHUNK_HEADER_BYTES;
    if (from > file.length) {
      throw malformed(TRUNCATED);
    }
    int length = number(file, at + Integer.BYTES);
    if (length < 0 || length > file.length - from) {
      throw malformed(TRUNCATED);
    }
    int type = number(file, at);
    boolean isAnimated = type == EXTENDED && length > 0 && (file[from] & ANIMATED) != 0;
    if (isAnimated) {
      throw malformed("WebP has an animation, expected a still picture");
    }
    return new Chunk(type, from, from + length);
  }

  private void readLossyHeader() throws ImageFormatException {
    if (frame.length() < LOSSY_BYTES || !isKeyFrame(frame.from)) {
      throw malformed("WebP has no VP8 key frame");
    }
    int sides = number(file, frame.from + 6);
    width = sides & SIDE_MASK;
    height = sides >> 16 & SIDE_MASK;
    // The modes of a macroblock take at least one bit.
    if (width * height / Vp8Decoder.MACROBLOCK > (long) Byte.SIZE * frame.length()) {
      throw malformed("WebP data are too short for " + width + "x" + height + " pixels");
    }
  }

  /** Returns whether there is a visible key frame with a known version (RFC 6386, sec. 9.1). */
  private boolean isKeyFrame(int at) {
    int tag = unsigned24(file, at);
    boolean isKey = (tag & 1) == 0 && (tag >> 1 & 7) <= 3 && (tag >> 4 & 1) == 1;
    return isKey && unsigned24(file, at + 3) == 0x2a019d;
  }

  private void readLosslessHeader() throws ImageFormatException {
    if (frame.length() < LOSSLESS_BYTES || file[frame.from] != LOSSLESS_SIGNATURE) {
      throw malformed("WebP has no lossless picture");
    }
    int sides = number(file, frame.from + 1);
    if (sides >>> 2 * SIDE_BITS + 1 != 0) {
      throw malformed("WebP has a lossless picture of an unknown version");
    }
    width = 1 + (sides & SIDE_MASK);
    height = 1 + (sides >> SIDE_BITS & SIDE_MASK);
  }

  /** Checks that the picture has the size that the file's header states, if there is one. */
  private void checkExtended() throws ImageFormatException {
    if (header == Chunk.NONE) {
      return;
    }
    if (header.length() < EXTENDED_BYTES
        || width != 1 + unsigned24(file, header.from + 4)
        || height != 1 + unsigned24(file, header.from + 7)) {
      throw malformed(
          "WebP has a picture of " + width + "x" + height + " pixels, but its header does not");
    }
  }

  private Pixels lossy() throws ImageFormatException {
    Vp8Plane[] planes = Vp8Decoder.decode(file, frame.from, frame.end, width, height);
    boolean hasAlpha = alpha != Chunk.NONE;
    byte[] values = new Vp8Colors(planes, width, height).rgb(hasAlpha ? 4 : 3);
    if (hasAlpha) {
      byte[] opacity = AlphaPlane.decode(file, alpha.from, alpha.end, width, height);
      for (int i = 0; i < opacity.length; i++) {
        values[4 * i + 3] = opacity[i];
      }
    }
    return Pixels.of(width, height, hasAlpha ? 4 : 3, values);
  }

  private Pixels lossless() throws ImageFormatException {
    boolean hasAlpha = (number(file, frame.from + 1) >> 2 * SIDE_BITS & 1) == 1;
    LowBits bits = new LowBits(file, frame.from + LOSSLESS_BYTES, frame.end, TRUNCATED);
    int[] pixels = LosslessDecoder.decode(bits, width, height);
    int channels = hasAlpha ? 4 : 3;
    byte[] values = new byte[channels * pixels.length];
    for (int i = 0, at = 0; i < pixels.length; i++, at += channels) {
      values[at] = (byte) (pixels[i] >> 16);
      values[at + 1] = (byte) (pixels[i] >> 8);
      values[at + 2] = (byte) pixels[i];
      if (hasAlpha) {
        values[at + 3] = (byte) (pixels[i] >> 24);
      }
    }
    return Pixels.of(width, height, channels, values);
  }

  /** Returns the little-endian number of three bytes. */
  static int unsigned24(byte[] file, int at) {
    return file[at] & 0xff | (file[at + 1] & 0xff) << 8 | (file[at + 2] & 0xff) << 16;
  }

  private static int number(byte[] file, int at) {
    return ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).getInt(at);
  }
}
