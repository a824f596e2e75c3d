package io.github.lumbre.cli.output;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.scenefile.internal.PartTable.Part;
import io.github.lumbre.stage.internal.ViewNumbers;
import io.github.lumbre.stage.internal.ViewNumbers.Seen;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Values for JSON that describe a model's parts, and what its pictures show. Stateless. */
final class PartJson {
  private static final int MOST = 1000;

  private PartJson() {}

  /** Returns the first parts of a model. */
  static List<Map<String, Object>> parts(PartTable table) {
    return table.parts().stream().limit(MOST).map(PartJson::part).toList();
  }

  private static Map<String, Object> part(Part part) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", part.name());
    if (part.triangles() > 0) {
      entry.put("triangles", part.triangles());
    }
    if (part.points() > 0) {
      entry.put("points", part.points());
    }
    entry.put("bounds", bounds(part.box()));
    return entry;
  }

  /** Returns the least and the largest coordinates of a box. */
  static List<List<Double>> bounds(Bounds3 box) {
    return List.of(vector(box.min()), vector(box.max()));
  }

  private static List<Double> vector(Vec3 v) {
    return List.of(v.x(), v.y(), v.z());
  }

  static Map<String, Object> view(RenderSettings settings, ViewNumbers numbers, PartTable table) {
    Map<String, Object> view = new LinkedHashMap<>();
    view.put("width", settings.window().width());
    view.put("height", settings.window().height());
    numbers
        .projection()
        .filter(p -> p.matrix().stream().flatMap(List::stream).allMatch(Double::isFinite))
        .ifPresent(
            projection -> {
              view.put("projection", projection.isParallel() ? "parallel" : "perspective");
              view.put("matrix", projection.matrix());
            });
    if (!numbers.seen().isEmpty()) {
      view.put("depth", List.of(numbers.near(), numbers.far()));
    }
    view.put("visible_part_count", numbers.seen().size());
    view.put(
        "visible_parts", numbers.seen().stream().limit(MOST).map(s -> seen(s, table)).toList());
    return view;
  }

  private static Map<String, Object> seen(Seen seen, PartTable table) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", table.parts().get(seen.part()).name());
    entry.put("pixels", seen.pixels());
    entry.put("box", List.of(seen.left(), seen.top(), seen.right(), seen.bottom()));
    return entry;
  }
}
