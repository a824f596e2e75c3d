package io.github.lumbre.model.format.draco;

import io.github.lumbre.testing.SampleFiles;
import java.util.List;
import java.util.stream.Stream;

/**
 * Small meshes that Google's encoder has compressed with each method; generate.mjs in the folder of
 * the files makes them. The attributes have the numbers 0 to 6: positions, normals, texture
 * coordinates, colors, joints, weights, and one more number.
 */
public final class DracoSamples {
  private DracoSamples() {}

  /**
   * What Google's decoder makes of a file.
   *
   * @param sha256 of the corners as 32-bit integers and the values of all points, attribute by
   *     attribute
   */
  record Sample(String name, int faces, int points, String sha256) {
    @Override
    public String toString() {
      return name;
    }
  }

  /** Returns what the files contain. */
  static List<Sample> all() {
    return SampleFiles.rows(DracoSamples.class, "decoded.csv")
        .map(s -> new Sample(s[0], Integer.parseInt(s[1]), Integer.parseInt(s[2]), s[3]))
        .toList();
  }

  /** Returns the content of a file. */
  public static byte[] file(String name) {
    return SampleFiles.bytes(DracoSamples.class, name + ".drc");
  }

  /** Returns the contents of all files. */
  static Stream<byte[]> files() {
    return all().stream().map(sample -> file(sample.name));
  }
}
