package io.github.lumbre.lab.perf;

import io.github.lumbre.image.Image;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** A hash of a picture's linear light: equal hashes mean bit-identical pictures. */
public final class RasterHash {
  /** The number of digits in tables, enough to distinguish any two pictures. */
  public static final int SHOWN_DIGITS = 16;

  private RasterHash() {}

  /**
   * Returns the SHA-256 of a picture in hexadecimal. The hashed bytes are width and height as
   * 32-bit integers, then the red, green and blue floats row by row from the top, all
   * little-endian. Alpha is not included.
   */
  public static String of(Image image) {
    MessageDigest digest = sha256();
    int row = 3 * image.width();
    ByteBuffer bytes = ByteBuffer.allocate(4 * row).order(ByteOrder.LITTLE_ENDIAN);
    digest.update(bytes.putInt(image.width()).putInt(image.height()).flip());
    float[] rgb = image.rgb();
    for (int y = 0; y < image.height(); y++) {
      bytes.clear();
      for (int i = 0; i < row; i++) {
        bytes.putFloat(rgb[y * row + i]);
      }
      digest.update(bytes.flip());
    }
    return HexFormat.of().formatHex(digest.digest());
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("every Java platform has SHA-256", e);
    }
  }
}
