package io.github.lumbre.image.format.ktx;

import io.github.lumbre.testing.SampleFiles;
import java.util.Base64;
import java.util.List;

/** Small files that Basis Universal has encoded; generate.mjs beside their table makes them. */
public final class KtxSamples {
  private static final List<Sample> ALL =
      SampleFiles.rows(KtxSamples.class, "pictures.csv").map(KtxSamples::sample).toList();

  private KtxSamples() {}

  /**
   * A file.
   *
   * @param sha256 of the RGBA values that Basis Universal's transcoder makes of it
   */
  public record Sample(
      String name, int width, int height, boolean hasAlpha, String sha256, byte[] file) {
    @Override
    public String toString() {
      return name;
    }
  }

  /** Returns all files. */
  public static List<Sample> all() {
    return ALL;
  }

  /** Returns a copy of a file by its name. */
  public static byte[] file(String name) {
    return ALL.stream()
        .filter(sample -> sample.name.equals(name))
        .findFirst()
        .orElseThrow()
        .file
        .clone();
  }

  private static Sample sample(String... cells) {
    return new Sample(
        cells[0],
        Integer.parseInt(cells[1]),
        Integer.parseInt(cells[2]),
        cells[3].equals("1"),
        cells[4],
        Base64.getDecoder().decode(cells[5]));
  }
}
