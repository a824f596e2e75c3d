package io.github.lumbre.image.format.webp;

import io.github.lumbre.testing.SampleFiles;
import java.util.List;
import java.util.stream.Stream;

/**
 * Small pictures that libwebp has encoded with many settings; generate.py in the folder of the
 * files makes them.
 */
public final class WebpSamples {
  private WebpSamples() {}

  /**
   * What libwebp makes of a file by default.
   *
   * @param sha256 of red, green, blue and alpha of all pixels, row by row
   */
  record Sample(String name, int width, int height, boolean hasAlpha, String sha256) {
    @Override
    public String toString() {
      return name;
    }
  }

  /** Returns what the files of still pictures contain. */
  static List<Sample> all() {
    return SampleFiles.rows(WebpSamples.class, "decoded.csv")
        .map(
            s ->
                new Sample(
                    s[0],
                    Integer.parseInt(s[1]),
                    Integer.parseInt(s[2]),
                    Boolean.parseBoolean(s[3]),
                    s[4]))
        .toList();
  }

  /** Returns the content of a file. */
  public static byte[] file(String name) {
    return SampleFiles.bytes(WebpSamples.class, name + ".webp");
  }

  /** Returns the contents of all files of still pictures. */
  public static Stream<byte[]> files() {
    return all().stream().map(sample -> file(sample.name));
  }
}
