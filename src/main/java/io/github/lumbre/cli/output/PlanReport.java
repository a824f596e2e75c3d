package io.github.lumbre.cli.output;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.joining;

import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.LightSampler;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneOrigins;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Specialization;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Tells what a scene does not require, and so is left out of its render. */
public final class PlanReport {
  private final Scene scene;
  private final RenderSettings settings;
  private final List<SceneOrigins.Unused> unused;

  public PlanReport(SceneFile file) {
    scene = file.scene();
    settings = file.settings();
    unused = file.origins().unused();
  }

  /** Prints a line for each kind of work: what is done, and what is not and why. */
  public void print(Messages out) {
    out.line("plan       assets: " + assets());
    out.line("           materials: " + materials());
    out.line("           normals: " + normals());
    out.line("           meshes: " + meshes());
    out.line("           choice of light: " + choice());
    out.line("           lens: " + lens());
    out.line("           coverage of pixels: " + coverage());
  }

  private String assets() {
    if (unused.isEmpty()) {
      return "all are used";
    }
    Map<String, Long> counts =
        unused.stream().collect(groupingBy(SceneOrigins.Unused::type, TreeMap::new, counting()));
    return "left undecoded, nothing uses them: "
        + counts.entrySet().stream()
            .map(type -> type.getKey() + " " + type.getValue())
            .collect(joining(", "));
  }

  private String materials() {
    List<Material> all = surfaces().stream().map(Primitive::material).toList();
    long uniform = all.stream().filter(Material::isUniform).count();
    return uniform
        + " of "
        + all.size()
        + " surfaces scatter everywhere alike, which is worked out once and not at every hit";
  }

  private List<Primitive> surfaces() {
    return scene.primitives().stream().filter(p -> p.emission().isEmpty()).toList();
  }

  private String normals() {
    long mapped = surfaces().stream().filter(p -> p.material() instanceof NormalMapped).count();
    return mapped == 0
        ? "left out, no map bends them"
        : "bent by maps on " + mapped + " of " + surfaces().size() + " surfaces";
  }

  private String meshes() {
    List<Shape> shapes = scene.primitives().stream().map(Primitive::shape).toList();
    long baked = shapes.stream().filter(Mesh.class::isInstance).count();
    long shared = shapes.stream().filter(MeshInstance.class::isInstance).count();
    if (baked + shared == 0) {
      return "left out, there are none";
    }
    return baked
        + " in one place, moved there once; "
        + shared
        + " places of shared meshes, where every ray is moved";
  }

  private String choice() {
    int count =
        settings.mode() == RenderSettings.Mode.PATH
            ? scene.emitters().size()
            : scene.lights().size();
    if (settings.mode() == RenderSettings.Mode.RAY) {
      return "left out, ray tracing asks all of the " + count;
    }
    if (count == 0) {
      return "left out, nothing shines";
    }
    if (scene.takes(Specialization.ONE_EMITTER)) {
      return "left out, there is one";
    }
    return switch (LightSampler.over(scene.emitters()).method()) {
      case FIXED -> "of " + count + " with the same probabilities everywhere";
      case ONE_BY_ONE -> "of " + count + ", each asked what it may send to the point";
      case HIERARCHY -> "of " + count + " by a hierarchy, which asks about 2 log2 of them";
    };
  }

  private String lens() {
    return scene.camera() instanceof ThinLensCamera
        ? "a point of it is drawn for every sample"
        : "left out, the camera has none";
  }

  private String coverage() {
    if (settings.transparent()) {
      return "counted, the background is transparent";
    }
    return scene.camera().leavesBlanks()
        ? "counted, the camera leaves some blank"
        : "left out, every sample covers its pixel";
  }
}
