package io.github.lumbre.stage.drawing;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** The edges of the meshes of a scene. Immutable. */
public record Outlines(List<OutlinedPart> parts) {
  private static final int EDGES_PER_CHECK = 256;

  /** Primitives whose meshes belong together: those of one object at one place. */
  private record Key(String object, Transform toWorld) {}

  /**
   * Returns the edges of the meshes of a scene. Other shapes have none.
   *
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Outlines of(Scene scene) {
    Map<Key, List<Integer>> groups = new LinkedHashMap<>();
    List<Primitive> primitives = scene.primitives();
    for (int i = 0; i < primitives.size(); i++) {
      if (MeshEdges.meshOf(primitives.get(i).shape()).isPresent()) {
        Key key = new Key(scene.objectName(i), OutlinedPart.toWorldOf(primitives.get(i).shape()));
        groups.computeIfAbsent(key, k -> new ArrayList<>()).add(i);
      }
    }
    Map<List<TriangleMesh>, MeshEdges> known = new HashMap<>();
    List<OutlinedPart> parts = new ArrayList<>();
    groups.forEach(
        (key, members) -> {
          List<TriangleMesh> meshes =
              members.stream()
                  .map(i -> MeshEdges.meshOf(primitives.get(i).shape()).orElseThrow())
                  .toList();
          MeshEdges edges = known.computeIfAbsent(meshes, MeshEdges::of);
          parts.add(OutlinedPart.of(edges, key.toWorld(), members, meshes));
        });
    return new Outlines(parts);
  }

  /**
   * Returns the lines for the camera of a scene, in pixels of the rendered part of the frame; empty
   * if the camera bends straight lines.
   *
   * @param scene the scene of these edges, from any place
   * @param hasHidden whether hidden lines are wanted, too
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  Optional<Sketch> sketch(Scene scene, RenderSettings settings, PartOf numbers, boolean hasHidden) {
    double creaseDegrees = settings.get(Setting.CREASE_ANGLE);
    return Eye.of(scene.camera(), settings)
        .map(
            eye -> {
              Sketch sketch = new Sketch();
              Sights sights = new Sights(scene, eye, creaseDegrees, hasHidden);
              for (OutlinedPart part : parts) {
                EdgeKind kind = new EdgeKind(part.edges(), part.worldPositions(), creaseDegrees);
                add(part, kind, eye, sights, numbers, sketch);
              }
              return sketch;
            });
  }

  private static void add(
      OutlinedPart part, EdgeKind kind, Eye eye, Sights sights, PartOf numbers, Sketch sketch) {
    for (int edge = 0; edge < part.edges().count(); edge++) {
      if (edge % EDGES_PER_CHECK == 0) {
        Interrupts.check();
      }
      if (kind.isLine(edge, eye)) {
        int number = edge;
        SeenEdge.of(kind.from(edge), kind.to(edge), eye)
            .ifPresent(
                seen ->
                    seen.divide(
                        sights.of(part, kind, number),
                        sights.halvings,
                        (sight, fromX, fromY, toX, toY) -> {
                          if (sight != Sight.NONE) {
                            sketch
                                .of(part.partOf(number, numbers), sight == Sight.VISIBLE)
                                .add(fromX, fromY, toX, toY);
                          }
                        }));
      }
    }
  }

  /** Finds the sights of points of edges. Mutable; for one thread. */
  private static final class Sights {
    private final Occlusion occlusion;
    private final Seams seams;
    private final Sight behind;
    private final int halvings;

    Sights(Scene scene, Eye eye, double creaseDegrees, boolean hasHidden) {
      occlusion = new Occlusion(scene, eye);
      seams = new Seams(scene, eye, creaseDegrees);
      behind = hasHidden ? Sight.HIDDEN : Sight.NONE;
      halvings = hasHidden ? SeenEdge.FOR_VECTORS : SeenEdge.FOR_PIXELS;
    }

    Function<Vec3, Sight> of(OutlinedPart part, EdgeKind kind, int edge) {
      Vec3 along = kind.along(edge);
      Vec3 across = kind.across(edge, 0, along);
      boolean mayContinue = kind.isBorder(edge);
      return point -> {
        if (mayContinue && seams.continues(point, part, along, across)) {
          return Sight.NONE;
        }
        return occlusion.hides(point, hit -> part.isOnEdge(hit, edge)) ? behind : Sight.VISIBLE;
      };
    }
  }
}
