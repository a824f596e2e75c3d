package io.github.lumbre.junit;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Pixels;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.regex.Pattern;

/**
 * A golden picture in its folder.
 *
 * @param path of the file
 * @param name of the picture with its ending, relative to the folder, with slashes
 */
record GoldenFile(Path folder, Path path, String name) {
  private static final Pattern NAME = Pattern.compile("[\\w-][\\w.-]*(/[\\w-][\\w.-]*)*");

  /**
   * Returns the file of a name.
   *
   * @throws IllegalArgumentException if the name has other characters, or leads out of the folder
   */
  static GoldenFile of(Path folder, String name) {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException(
          "name: expected letters, digits, '.', '_' and '-' between slashes, such as"
              + " lights/spot, found '"
              + name
              + "'");
    }
    boolean isComplete = name.endsWith(".png") || name.endsWith(".exr");
    String complete = isComplete ? name : name + ".png";
    return new GoldenFile(folder, folder.resolve(complete), complete);
  }

  boolean isExr() {
    return name.endsWith(".exr");
  }

  /** Returns whether the file exists, and requires that no link leads out of the folder. */
  boolean exists() throws IOException {
    requireInside();
    return Files.exists(path);
  }

  /** Requires that no existing part of the path is a link that leads out of the folder. */
  private void requireInside() throws IOException {
    Path existing = path;
    while (!Files.exists(existing, LinkOption.NOFOLLOW_LINKS)) {
      existing = existing.getParent();
      if (existing == null || existing.equals(folder)) {
        return;
      }
    }
    boolean isBroken = !Files.exists(existing);
    if (isBroken || !existing.toRealPath().startsWith(folder.toRealPath())) {
      throw new IllegalArgumentException(
          "name: expected a file inside " + folder + ", found the link " + existing);
    }
  }

  /**
   * @throws ImageFormatException if the file is no picture
   */
  Encoded read() throws IOException {
    return Encoded.of(Files.readAllBytes(path), isExr());
  }

  /**
   * Returns what is found in the place of a picture.
   *
   * @param problem with the file as a picture
   */
  String whatElse(ImageFormatException problem) throws IOException {
    byte[] bytes = Files.readAllBytes(path);
    if (bytes.length == 0) {
      return "an empty file";
    }
    String start = new String(bytes, 0, Math.min(bytes.length, 40), StandardCharsets.ISO_8859_1);
    return start.startsWith("version https://git-lfs")
        ? "a pointer of Git LFS; 'git lfs pull' fetches the picture"
        : "a damaged file: " + problem.getMessage();
  }

  /** Returns the bytes and pixels that a file of a picture would have. */
  Encoded encode(Image picture, ImageWriter.Options options) throws IOException {
    if (!isExr()) {
      return Encoded.of(picture.toPng(options), false);
    }
    Path file = Files.createTempFile("lumbre-golden", ".exr");
    try {
      ImageWriter.write(picture, file);
      return Encoded.of(Files.readAllBytes(file), true);
    } finally {
      Files.delete(file);
    }
  }

  /** Stores a picture, unless the file has its pixels already. */
  void store(Encoded picture) throws IOException {
    requireInside();
    if (Files.exists(path) && has(picture)) {
      return;
    }
    Files.createDirectories(path.getParent());
    String other = "." + path.getFileName() + "." + ProcessHandle.current().pid() + ".part";
    Path part = path.resolveSibling(other);
    try {
      Files.write(part, picture.bytes());
      Files.move(part, path, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(part);
    }
  }

  /** Returns whether the file has the pixels of a picture; a damaged file does not. */
  private boolean has(Encoded picture) throws IOException {
    try {
      return read().hash().equals(picture.hash());
    } catch (ImageFormatException e) {
      return false;
    }
  }

  /**
   * A picture in the form of its file.
   *
   * @param bytes of the file
   * @param image in linear light
   * @param values what the pixels have in the file: four numbers each
   */
  record Encoded(byte[] bytes, Image image, int[] values) {
    static Encoded of(byte[] bytes, boolean isExr) throws IOException {
      if (isExr) {
        Image image = ImageReader.decodeLinear(bytes);
        return new Encoded(bytes, image, values(image));
      }
      Pixels pixels = ImageReader.decode(bytes);
      return new Encoded(
          bytes, linear(pixels, ImageReader.decodeLinear(bytes).rgb()), values(pixels));
    }

    private static int[] values(Image image) {
      int[] values = new int[4 * image.width() * image.height()];
      for (int i = 0; i < values.length / 4; i++) {
        for (int c = 0; c < 3; c++) {
          values[4 * i + c] = Float.floatToIntBits(image.rgb()[3 * i + c]);
        }
        values[4 * i + 3] = Float.floatToIntBits(image.alpha(i % image.width(), i / image.width()));
      }
      return values;
    }

    private static int[] values(Pixels pixels) {
      // A file of 8 bits and one of 16 bits are equal if they show the same colors.
      int scale = 65535 / pixels.max();
      int[] values = new int[4 * pixels.width() * pixels.height()];
      for (int i = 0; i < values.length / 4; i++) {
        int x = i % pixels.width();
        int y = i / pixels.width();
        for (int c = 0; c < 3; c++) {
          values[4 * i + c] = scale * pixels.raw(x, y, c);
        }
        values[4 * i + 3] = scale * pixels.alpha(x, y);
      }
      return values;
    }

    private static Image linear(Pixels pixels, float[] rgb) {
      float[] alpha = new float[pixels.hasAlpha() ? pixels.width() * pixels.height() : 0];
      for (int i = 0; i < alpha.length; i++) {
        int alphaOf = pixels.alpha(i % pixels.width(), i / pixels.width());
        alpha[i] = (float) alphaOf / pixels.max();
      }
      return new Image(pixels.width(), pixels.height(), rgb, alpha);
    }

    /** Returns the SHA-256 of the size and the pixels. */
    String hash() {
      ByteBuffer content = ByteBuffer.allocate(8 + 4 * values.length);
      content.putInt(image.width()).putInt(image.height());
      content.asIntBuffer().put(values);
      try {
        byte[] digest = MessageDigest.getInstance("SHA-256").digest(content.array());
        return HexFormat.of().formatHex(digest);
      } catch (NoSuchAlgorithmException e) {
        throw new AssertionError(e); // Every JDK has it.
      }
    }

    /** Returns the number of pixels whose values differ from those of a picture of this size. */
    int differences(Encoded other) {
      int count = 0;
      for (int i = 0; i < values.length; i += 4) {
        count += Arrays.equals(values, i, i + 4, other.values, i, i + 4) ? 0 : 1;
      }
      return count;
    }
  }
}
