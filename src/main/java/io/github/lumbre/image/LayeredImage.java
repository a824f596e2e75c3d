package io.github.lumbre.image;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.image.format.exr.ExrReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * All channels of an OpenEXR file, grouped by layer.
 *
 * @param width in pixels
 * @param height in pixels
 * @param layers the layers, sorted by name; the picture itself has an empty name
 * @param texts the text attributes of the file by name, from an untrusted source
 */
public record LayeredImage(
    int width, int height, List<ImageLayer> layers, Map<String, String> texts) {
  /** The largest number of values of all channels. */
  public static final long MAX_VALUES = 1L << 30;

  public LayeredImage {
    layers = List.copyOf(layers);
    texts = Collections.unmodifiableMap(new LinkedHashMap<>(texts));
  }

  /**
   * Reads an OpenEXR file.
   *
   * @throws ImageFormatException if it is not an intact OpenEXR file, or is too large
   * @throws IOException if the file cannot be read
   */
  public static LayeredImage read(Path file) throws IOException {
    return of(Files.readAllBytes(file));
  }

  /**
   * Returns the layers of an OpenEXR file's bytes.
   *
   * @throws ImageFormatException if they are not an intact OpenEXR file, or the picture is too
   *     large
   */
  public static LayeredImage of(byte[] file) throws ImageFormatException {
    if (!ExrReader.startsIn(file)) {
      String found = FileContent.describe(file).orElse("another kind of file");
      throw ImageFormatException.malformed("expected an OpenEXR file, found " + found);
    }
    return ExrReader.readLayers(file);
  }

  /** Returns the layer with a name; empty if there is none. */
  public Optional<ImageLayer> layer(String name) {
    return layers.stream().filter(layer -> layer.name().equals(name)).findFirst();
  }
}
