package io.github.lumbre.stage.internal;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.PartTable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What a picture of a model shows, by one ray through the center of each pixel. The nearest surface
 * counts, also if it is transparent.
 *
 * @param projection from the model's world space to the pixels of the picture; empty if the camera
 *     bends straight lines
 * @param near the depth of the nearest visible point; infinite if no point is visible
 * @param far the depth of the farthest visible point; negative and infinite if no point is visible
 * @param seen the visible parts, in their order
 */
public record ViewNumbers(
    Optional<Projection> projection, double near, double far, List<Seen> seen) {
  /**
   * A visible part, and the smallest rectangle around its pixels.
   *
   * @param part its number in the table
   * @param right the column after the last one
   * @param bottom the row after the last one
   */
  public record Seen(int part, long pixels, int left, int top, int right, int bottom) {}

  /** The parts in a row of pixels, and the depths. */
  private record Row(int[] parts, double near, double far) {}

  public ViewNumbers {
    seen = List.copyOf(seen);
  }

  public static ViewNumbers of(Scene scene, RenderSettings settings, PartTable table) {
    List<Row> rows = rows(scene, settings, table);
    return new ViewNumbers(
        projection(scene, settings),
        rows.stream().mapToDouble(Row::near).min().orElseThrow(),
        rows.stream().mapToDouble(Row::far).max().orElseThrow(),
        seen(rows, table.parts().size()));
  }

  /** Returns the part in each pixel of a picture, in rows from the top. */
  static int[] parts(Scene scene, RenderSettings settings, PartTable table) {
    return rows(scene, settings, table).stream()
        .flatMapToInt(row -> Arrays.stream(row.parts))
        .toArray();
  }

  /** Returns the map from the model's world space to the pixels of a picture. */
  static Optional<Projection> projection(Scene scene, RenderSettings settings) {
    Crop window = settings.window();
    return Projection.of(scene.camera(), settings.width(), settings.height())
        .map(p -> p.from(ModelScene.TO_LEFT_HANDED).cropped(window.x(), window.y()));
  }

  private static List<Row> rows(Scene scene, RenderSettings settings, PartTable table) {
    Crop window = settings.window();
    return IntStream.range(window.y(), window.y() + window.height())
        .parallel()
        .mapToObj(y -> row(scene, settings, table, y))
        .toList();
  }

  private static Row row(Scene scene, RenderSettings settings, PartTable table, int y) {
    Crop window = settings.window();
    Vec3 eye = scene.camera().position();
    Vec3 forward = scene.camera().axes().normal();
    NearestHit hit = new NearestHit();
    CameraRay aimed = new CameraRay();
    SobolSampler center = new SobolSampler(0);
    int[] parts = new int[window.width()];
    Arrays.fill(parts, PartTable.NONE);
    double near = Double.POSITIVE_INFINITY;
    double far = Double.NEGATIVE_INFINITY;
    for (int column = 0; column < parts.length; column++) {
      double u = (window.x() + column + .5) / settings.width();
      if (scene.camera().aim(u, (y + .5) / settings.height(), center, aimed)) {
        Ray ray = aimed.toRay();
        scene.intersect(ray, hit);
        parts[column] = table.at(hit);
        if (parts[column] != PartTable.NONE) {
          Vec3 point = ray.origin().plus(hit.t(), ray.direction());
          double depth = point.minus(eye).dot(forward);
          near = Math.min(near, depth);
          far = Math.max(far, depth);
        }
      }
    }
    return new Row(parts, near, far);
  }

  private static List<Seen> seen(List<Row> rows, int count) {
    long[] pixels = new long[count];
    int[][] boxes = new int[count][];
    for (int y = 0; y < rows.size(); y++) {
      int[] parts = rows.get(y).parts;
      for (int x = 0; x < parts.length; x++) {
        if (parts[x] != PartTable.NONE) {
          pixels[parts[x]]++;
          int[] box = boxes[parts[x]];
          boxes[parts[x]] =
              box == null
                  ? new int[] {x, y, x + 1, y + 1}
                  : new int[] {Math.min(box[0], x), box[1], Math.max(box[2], x + 1), y + 1};
        }
      }
    }
    List<Seen> seen = new ArrayList<>();
    for (int part = 0; part < count; part++) {
      if (pixels[part] > 0) {
        int[] box = boxes[part];
        seen.add(new Seen(part, pixels[part], box[0], box[1], box[2], box[3]));
      }
    }
    return seen;
  }
}
