package io.github.lumbre.scenefile;

import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.util.List;
import java.util.Set;

/** Checks whether a scene has what its settings ask for. */
final class SceneChecks {
  private SceneChecks() {}

  /** Warns of lines that settings ask for and a scene lacks. Infinite planes need none. */
  static void warnOfLines(Scene scene, RenderSettings settings, ProblemPlace place) {
    if (settings.get(Setting.LINE_WIDTH) == 0) {
      return;
    }
    if (Projection.of(scene.camera(), settings.width(), settings.height()).isEmpty()) {
      place.warn("draws no lines, because the camera bends straight lines");
      return;
    }
    long others =
        scene.primitives().stream()
            .map(Primitive::shape)
            .filter(shape -> !(shape instanceof Plane) && MeshEdges.meshOf(shape).isEmpty())
            .count();
    if (others > 0) {
      place.warn(
          "%s of %s shapes have no lines, because only meshes have edges"
              .formatted(others, scene.primitives().size()));
    }
  }

  /** Requires that all poses number their parts and lights alike if layers record the numbers. */
  static void requireNumbers(Scene scene, RenderSettings settings, Problems problems)
      throws SceneFormatException {
    SceneInside middle = SceneInside.of(scene);
    List<SceneInside> poses = scene.poses().stream().map(SceneInside::of).toList();
    Set<Layer> layers = settings.layers();
    boolean areParts = layers.contains(Layer.OBJECT) || layers.contains(Layer.MATERIAL);
    boolean lackParts =
        areParts && !poses.stream().allMatch(pose -> pose.names().equals(middle.names()));
    boolean lackLights =
        layers.contains(Layer.LIGHTS)
            && !poses.stream().allMatch(pose -> pose.lightGroups().isLike(middle.lightGroups()));
    if (lackParts || lackLights) {
      problems.error(
          Kind.INVALID,
          () -> "layers",
          "expected the same parts and lights in all poses for layers of objects, materials and"
              + " lights, found some that appear or vanish");
      throw problems.exception();
    }
  }
}
