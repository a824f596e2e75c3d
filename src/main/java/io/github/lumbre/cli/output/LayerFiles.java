package io.github.lumbre.cli.output;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageLayer.Precision;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.Cryptomatte;
import io.github.lumbre.image.internal.PictureEncoder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Layers as PNG files in a folder, for programs that do not read OpenEXR. Names in files come from
 * untrusted sources: only letters, digits, dots, hyphens and underscores of them are kept. Mutable.
 */
public final class LayerFiles {
  private static final int MAX_NAME = 80;

  /** One of this many values may be far from all others, at either end. */
  private static final int OUTER = 100;

  private static final List<String> NORMAL = List.of("X", "Y", "Z");
  private static final List<String> COLOR = List.of("R", "G", "B");

  private final Path folder;
  private final Set<String> taken = new HashSet<>();
  private final Map<Path, Content> files = new LinkedHashMap<>();

  /** Writes one file. */
  @FunctionalInterface
  private interface Content {
    void write(OutputFile file) throws IOException;
  }

  /** Creates files in a folder, which {@link #write} creates. */
  public LayerFiles(Path folder) {
    this.folder = folder;
  }

  /**
   * Adds a layer. Normals become colors of n/2 + 1/2 with 8 bits; colors get the sRGB curve with 8
   * bits; all other layers have 16 bits, with the range of their values in the metadata.
   */
  public void add(ImageLayer layer) {
    Path file = file(layer.name().isEmpty() ? "picture" : layer.name());
    if (layer.channels().equals(NORMAL)
        && layer.name().toLowerCase(Locale.ROOT).contains("normal")) {
      files.put(file, out -> PictureEncoder.writeLinear(layer, -1, 1, 8, Map.of(), out));
    } else if (layer.channels().subList(0, Math.min(3, layer.channels().size())).equals(COLOR)) {
      files.put(
          file,
          out ->
              PictureEncoder.write(layer.toImage(), List.of(), out, ImageWriter.Options.ROUNDED));
    } else if (layer.channels().size() <= 3) {
      double[] range = range(layer);
      Map<String, String> texts = new LinkedHashMap<>();
      texts.put("Low", String.valueOf(range[0]));
      texts.put("High", String.valueOf(range[1]));
      files.put(file, out -> PictureEncoder.writeLinear(layer, range[0], range[1], 16, texts, out));
    }
  }

  /**
   * Returns the smallest and the largest finite value; two different numbers. Few values far from
   * all others, such as the distant parts of an infinite plane, are left out: the range then ends
   * one width of the middle 98 % beyond it.
   */
  private static double[] range(ImageLayer layer) {
    float[] finite = finite(layer.values());
    if (finite.length == 0) {
      return new double[] {0, 1};
    }
    Arrays.sort(finite);
    int outer = finite.length / OUTER;
    double width = (double) finite[finite.length - 1 - outer] - finite[outer];
    double low = Math.max(finite[0], finite[outer] - width);
    double high = Math.min(finite[finite.length - 1], finite[finite.length - 1 - outer] + width);
    return low < high ? new double[] {low, high} : new double[] {low, low + 1};
  }

  private static float[] finite(float[] values) {
    float[] finite = new float[values.length];
    int count = 0;
    for (float value : values) {
      if (Float.isFinite(value)) {
        finite[count++] = value;
      }
    }
    return Arrays.copyOf(finite, count);
  }

  /** Adds an 8-bit mask for each item of a matte: 255 where the item covers the whole pixel. */
  public void add(Cryptomatte matte) {
    String kind = matte.type().replaceFirst("^Crypto", "").toLowerCase(Locale.ROOT);
    if (matte.layers().isEmpty()) {
      return;
    }
    ImageLayer first = matte.layers().get(0);
    for (String name : matte.ids().keySet()) {
      files.put(
          file(kind + "-" + name),
          out ->
              PictureEncoder.writeLinear(
                  new ImageLayer(
                      kind,
                      List.of("Y"),
                      Precision.FLOAT,
                      first.width(),
                      first.height(),
                      matte.mask(name)),
                  0,
                  1,
                  8,
                  Map.of("Name", Messages.printable(name)),
                  out));
    }
  }

  private Path file(String name) {
    String safe = name.replaceAll("[^A-Za-z0-9._-]", "_");
    String base = safe.substring(0, Math.min(MAX_NAME, safe.length())).replaceFirst("^[.]+", "_");
    String unique = base;
    for (int number = 2; !taken.add(unique.toLowerCase(Locale.ROOT)); number++) {
      unique = base + "-" + number;
    }
    return folder.resolve(unique + ".png");
  }

  /** Returns the files that {@link #write} writes. */
  public List<Path> paths() {
    return new ArrayList<>(files.keySet());
  }

  /**
   * Creates the folder and writes all files.
   *
   * @throws TaskException if a file cannot be written
   */
  public void write() throws TaskException {
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(folder + ": cannot be created: " + FileFailure.reason(e), e);
    }
    for (Map.Entry<Path, Content> file : files.entrySet()) {
      try (OutputFile out = OutputFile.open(file.getKey())) {
        file.getValue().write(out);
      } catch (IOException e) {
        throw ExitCode.OUTPUT.failure(
            file.getKey() + ": cannot be written: " + FileFailure.reason(e), e);
      }
    }
  }
}
