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
import java.util.function.Predicate;

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
   * Returns the visible lines for the camera of a scene, in pixels of the rendered part of the
   * frame; empty if the camera bends straight lines.
   *
   * @param scene the scene of these edges, from any place
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public Optional<Strokes> strokes(Scene scene, RenderSettings settings) {
    double creaseDegrees = settings.get(Setting.CREASE_ANGLE);
    return Eye.of(scene.camera(), settings)
        .map(
            eye -> {
              Strokes strokes = new Strokes();
              Occlusion occlusion = new Occlusion(scene, eye);
              Seams seams = new Seams(scene, eye, creaseDegrees);
              for (OutlinedPart part : parts) {
                EdgeKind kind = new EdgeKind(part.edges(), part.worldPositions(), creaseDegrees);
                add(part, kind, eye, occlusion, seams, strokes);
              }
              return strokes;
            });
  }

  private static void add(
      OutlinedPart part,
      EdgeKind kind,
      Eye eye,
      Occlusion occlusion,
      Seams seams,
      Strokes strokes) {
    for (int edge = 0; edge < part.edges().count(); edge++) {
      if (edge % EDGES_PER_CHECK == 0) {
        Interrupts.check();
      }
      if (kind.isLine(edge, eye)) {
        int number = edge;
        Vec3 along = kind.along(edge);
        Vec3 across = kind.across(edge, 0, along);
        boolean mayContinue = kind.isBorder(edge);
        Predicate<Vec3> isVisible =
            point ->
                !(mayContinue && seams.continues(point, part, along, across))
                    && !occlusion.hides(point, part, number);
        SeenEdge.of(kind.from(edge), kind.to(edge), eye)
            .ifPresent(seen -> seen.add(isVisible, strokes));
      }
    }
  }
}
