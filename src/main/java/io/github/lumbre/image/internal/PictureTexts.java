package io.github.lumbre.image.internal;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.format.exr.ExrReader;
import io.github.lumbre.image.format.png.PngFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** Reads the metadata of picture files. Stateless. */
public final class PictureTexts {
  private PictureTexts() {}

  /**
   * Returns the metadata of a PNG or OpenEXR file by their keywords, from an untrusted source.
   *
   * @throws ImageFormatException if it is not an intact file of these formats
   * @throws IOException if it cannot be read
   */
  public static Map<String, String> read(Path picture) throws IOException {
    byte[] file = Files.readAllBytes(picture);
    if (PngFile.startsIn(file)) {
      return PngFile.texts(file);
    }
    if (ExrReader.startsIn(file)) {
      return LayeredImage.of(file).texts();
    }
    String found = FileContent.describe(file).orElse("another kind of file");
    throw ImageFormatException.malformed("expected a PNG or OpenEXR file, found " + found);
  }
}
