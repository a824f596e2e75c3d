package generator;

import java.util.List;
import java.util.stream.Stream;

/** The pictures of the table of renders, with the sizes and samples that their times are for. */
final class TableScenes {
  private TableScenes() {}

  static List<Scene> all() {
    return Stream.of(
            LensScenes.all(), FigureScenes.all(), ProceduralScenes.all(), PanoramaScenes.all())
        .flatMap(List::stream)
        .toList();
  }

  /** A path traced row. */
  static Scene row(String name, int width, int height, int samples, int bucketSize) {
    return new Scene("table-" + name, width, height, samples)
        .set("maxTraceDepth", 5)
        .set("bucketSize", bucketSize)
        .set("threads", 8);
  }
}
