package io.github.lumbre.stage.drawing;

import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.section.Hatch;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scenefile.internal.PartSurface;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a drawing shows of surfaces: highlighted parts and cut surfaces in their colors, the hatches
 * of cut surfaces, and white paper in front of a background of another color.
 *
 * @param fills areas of one color
 * @param hatches lines on cut surfaces
 */
record Surfaces(List<Fill> fills, List<Lines> hatches) {
  /** A drawing of lines alone. */
  static final Surfaces NONE = new Surfaces(List.of(), List.of());

  /**
   * An area.
   *
   * @param part the number of its part; negative for the paper of all parts
   * @param outlines closed; the area is inside an odd number of them
   */
  record Fill(int part, Rgb color, List<double[]> outlines) {}

  /** Lines of a part. */
  record Lines(int part, Pen pen, Strokes strokes) {}

  /**
   * Returns the surfaces of a scene whose camera does not bend straight lines.
   *
   * @param surfaces by the numbers of their primitives
   */
  static Surfaces of(
      Scene scene, RenderSettings settings, Map<Integer, PartSurface> surfaces, PartOf numbers) {
    if (areNone(settings, surfaces)) {
      return NONE;
    }
    boolean isOnWhite = isOnWhite(settings);
    SurfaceMap map = SurfaceMap.of(scene, settings, surfaces, numbers);
    List<Fill> fills = new ArrayList<>();
    Regions.outlines(
            map.width(),
            map.keys(),
            key -> key != SurfaceMap.OUTSIDE && (key != SurfaceMap.PAPER || !isOnWhite))
        .forEach(
            (key, outlines) -> {
              int part = key == SurfaceMap.PAPER ? -1 : SurfaceMap.part(key);
              Rgb color = map.colors().getOrDefault(key, Rgb.WHITE);
              fills.add(new Fill(part, color, inPixels(outlines)));
            });
    fills.sort(Comparator.comparingInt(Fill::part));
    return new Surfaces(fills, hatches(scene, settings, surfaces, numbers));
  }

  /** Returns whether a drawing shows nothing but lines on white paper, so that it needs no map. */
  static boolean areNone(RenderSettings settings, Map<Integer, PartSurface> surfaces) {
    return isOnWhite(settings)
        && surfaces.values().stream().allMatch(s -> s.isPaper() && s.hatch().isEmpty());
  }

  private static boolean isOnWhite(RenderSettings settings) {
    return settings.background().filter(Rgb.WHITE::equals).isPresent();
  }

  private static List<double[]> inPixels(List<double[]> outlines) {
    return outlines.stream()
        .map(outline -> Arrays.stream(outline).map(c -> c / SurfaceMap.PER_PIXEL).toArray())
        .toList();
  }

  private static List<Lines> hatches(
      Scene scene, RenderSettings settings, Map<Integer, PartSurface> surfaces, PartOf numbers) {
    List<Lines> hatches = new ArrayList<>();
    Optional<Eye> eye = Eye.of(scene.camera(), settings);
    surfaces.keySet().stream()
        .sorted()
        .filter(primitive -> eye.isPresent() && surfaces.get(primitive).hatch().isPresent())
        .forEach(
            primitive -> {
              Hatch hatch = surfaces.get(primitive).hatch().get();
              int part = numbers.number(primitive, 0);
              hatching(scene, primitive, hatch)
                  .flatMap(lines -> lines(lines, part, hatch, primitive, scene, eye.get()))
                  .ifPresent(hatches::add);
            });
    return hatches;
  }

  private static Optional<Hatching> hatching(Scene scene, int primitive, Hatch hatch) {
    Shape shape = scene.primitives().get(primitive).shape();
    return MeshEdges.meshOf(shape)
        .filter(mesh -> mesh.hasUvs())
        .flatMap(mesh -> Hatching.of(mesh, hatch))
        .map(lines -> moved(lines, OutlinedPart.toWorldOf(shape)));
  }

  private static Hatching moved(Hatching lines, Transform toWorld) {
    List<Vec3[]> ends =
        lines.ends().stream()
            .map(of -> new Vec3[] {toWorld.point(of[0]), toWorld.point(of[1])})
            .toList();
    return new Hatching(ends, toWorld.vector(lines.across()));
  }

  private static Optional<Lines> lines(
      Hatching hatching, int part, Hatch hatch, int primitive, Scene scene, Eye eye) {
    Strokes strokes = new Strokes();
    Occlusion occlusion = new Occlusion(scene, eye);
    double width = 0;
    for (Vec3[] ends : hatching.ends()) {
      Optional<SeenEdge> seen = SeenEdge.of(ends[0], ends[1], eye);
      if (seen.isPresent()) {
        width = Math.max(width, Hatch.WIDTH * distance(ends, hatching.across(), eye));
        seen.get()
            .divide(
                point ->
                    occlusion.hides(point, hit -> hit.shape() == primitive)
                        ? Sight.HIDDEN
                        : Sight.VISIBLE,
                SeenEdge.FOR_VECTORS,
                (sight, fromX, fromY, toX, toY) -> {
                  if (sight == Sight.VISIBLE) {
                    strokes.add(fromX, fromY, toX, toY);
                  }
                });
      }
    }
    if (!(width > 0) || strokes.count() == 0) {
      return Optional.empty();
    }
    Pen pen = new Pen(hatch.ink(), Math.min(width, Pen.MAX_WIDTH));
    return Optional.of(new Lines(part, pen, strokes));
  }

  /** Returns the distance of a line from the next one in the picture. */
  private static double distance(Vec3[] ends, Vec3 across, Eye eye) {
    Point2 from = eye.pixel(ends[0]);
    Point2 to = eye.pixel(ends[1]);
    Point2 beside = eye.pixel(ends[0].plus(across));
    double dx = to.x() - from.x();
    double dy = to.y() - from.y();
    double length = Math.sqrt(dx * dx + dy * dy);
    return length > 0
        ? Math.abs(dx * (beside.y() - from.y()) - dy * (beside.x() - from.x())) / length
        : 0;
  }
}
