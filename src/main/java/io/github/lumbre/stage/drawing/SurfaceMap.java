package io.github.lumbre.stage.drawing;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.PartSurface;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * The surface in the center of each square of a grid, by one ray: its color, or white paper.
 *
 * @param width of the grid
 * @param keys the surface of each square, in rows from the top: {@link #OUTSIDE}, {@link #PAPER},
 *     or a primitive's number, shifted by 32 bits, and a part's
 * @param colors the mean color of each surface
 */
record SurfaceMap(int width, long[] keys, Map<Long, Rgb> colors) {
  /** The squares along the side of a pixel. */
  static final int PER_PIXEL = 2;

  /** The key of squares that show nothing. */
  static final long OUTSIDE = -1;

  /** The key of squares that show white surfaces. */
  static final long PAPER = -2;

  /** A row of squares; three sums of components and the number of squares of each surface. */
  private record Row(long[] keys, Map<Long, double[]> sums) {}

  static SurfaceMap of(
      Scene scene, RenderSettings settings, Map<Integer, PartSurface> surfaces, PartOf numbers) {
    Crop window = settings.window();
    List<Row> rows =
        IntStream.range(0, PER_PIXEL * window.height())
            .parallel()
            .mapToObj(y -> new Tracer(scene, settings, surfaces, numbers).row(y))
            .toList();
    Map<Long, double[]> sums = new HashMap<>();
    rows.forEach(row -> row.sums.forEach((key, sum) -> sums.merge(key, sum, SurfaceMap::plus)));
    Map<Long, Rgb> colors = new HashMap<>();
    sums.forEach((key, s) -> colors.put(key, new Rgb(s[0] / s[3], s[1] / s[3], s[2] / s[3])));
    long[] keys = rows.stream().flatMapToLong(row -> Arrays.stream(row.keys)).toArray();
    return new SurfaceMap(PER_PIXEL * window.width(), keys, colors);
  }

  static int primitive(long key) {
    return (int) (key >> 32);
  }

  static int part(long key) {
    return (int) key;
  }

  private static double[] plus(double[] one, double[] other) {
    double[] sum = new double[one.length];
    Arrays.setAll(sum, i -> one[i] + other[i]);
    return sum;
  }

  /** Traces the rays of a row. Mutable; for one thread. */
  private static final class Tracer {
    private final Scene scene;
    private final RenderSettings settings;
    private final Map<Integer, PartSurface> surfaces;
    private final PartOf numbers;
    private final NearestHit hit = new NearestHit();
    private final Map<Long, double[]> sums = new HashMap<>();

    Tracer(
        Scene scene, RenderSettings settings, Map<Integer, PartSurface> surfaces, PartOf numbers) {
      this.scene = scene;
      this.settings = settings;
      this.surfaces = surfaces;
      this.numbers = numbers;
    }

    Row row(int number) {
      Crop window = settings.window();
      CameraRay aimed = new CameraRay();
      SobolSampler center = new SobolSampler(0);
      double v = (window.y() + (number + .5) / PER_PIXEL) / settings.height();
      long[] keys = new long[PER_PIXEL * window.width()];
      for (int column = 0; column < keys.length; column++) {
        double u = (window.x() + (column + .5) / PER_PIXEL) / settings.width();
        boolean isAimed = scene.camera().aim(u, v, center, aimed);
        keys[column] = isAimed ? key(aimed.toRay()) : OUTSIDE;
      }
      return new Row(keys, sums);
    }

    private long key(Ray ray) {
      hit.aim(ray);
      if (!Occlusion.findOpaque(scene, hit)) {
        return OUTSIDE;
      }
      PartSurface surface = surfaces.get(hit.shape());
      if (surface == null || surface.isPaper()) {
        return PAPER;
      }
      long part = numbers.number(hit.shape(), hit.element());
      long key = (long) hit.shape() << 32 | part & 0xffffffffL;
      Rgb color =
          surface
              .hatch()
              .map(hatch -> hatch.paper())
              .orElseGet(
                  () -> scene.primitiveAt(hit).material().at(scene.surfaceAt(hit)).albedo());
      sums.merge(key, new double[] {color.r(), color.g(), color.b(), 1}, SurfaceMap::plus);
      return key;
    }
  }
}
