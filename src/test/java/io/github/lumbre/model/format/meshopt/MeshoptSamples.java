package io.github.lumbre.model.format.meshopt;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.testing.SampleFiles;
import java.nio.ByteBuffer;
import java.util.Base64;
import java.util.List;

/** Small streams that meshoptimizer has compressed; generate.mjs beside their file makes them. */
public final class MeshoptSamples {
  private static final List<Sample> ALL =
      SampleFiles.rows(MeshoptSamples.class, "streams.csv").map(MeshoptSamples::sample).toList();

  private MeshoptSamples() {}

  /**
   * A stream.
   *
   * @param sha256 of what meshoptimizer's decoder makes of it
   */
  public record Sample(
      String name,
      MeshoptMode mode,
      MeshoptFilter filter,
      int count,
      int stride,
      String sha256,
      byte[] stream) {
    ByteBuffer decode(byte[] changed) throws ModelFormatException {
      ByteBuffer decoded = mode.decode(ByteBuffer.wrap(changed), count, stride, "bufferViews[0]");
      filter.restore(decoded, stride);
      return decoded;
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** Returns all streams. */
  static List<Sample> all() {
    return ALL;
  }

  /** Returns a stream by its name. */
  public static Sample of(String name) {
    return ALL.stream().filter(sample -> sample.name.equals(name)).findFirst().orElseThrow();
  }

  private static Sample sample(String... cells) {
    return new Sample(
        cells[0],
        MeshoptMode.valueOf(cells[1]),
        MeshoptFilter.valueOf(cells[2]),
        Integer.parseInt(cells[3]),
        Integer.parseInt(cells[4]),
        cells[5],
        Base64.getDecoder().decode(cells[6]));
  }
}
