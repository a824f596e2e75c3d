package io.github.lumbre.cli.output;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.joining;

import io.github.lumbre.camera.ThinLensCamera;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.Specialization;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Reports the rendering steps that a scene does not need and that its render skips. */
public final class PlanReport {
  private final Scene scene;
  private final RenderSettings settings;
  private final List<SceneOrigins.Unused> unused;

  public PlanReport(SceneFile file) {
    scene = file.scene();
    settings = file.settings();
    unused = file.parsed().origins().unused();
  }

  /** Prints one line for each kind of step: what is done, or why it is skipped. */
  public void print(Messages out) {
    out.line("plan       assets: " + assets());
    out.line("           materials: " + materials());
    out.line("           normals: " + normals());
    out.line("           meshes: " + meshes());
    out.line("           light selection: " + choice());
    out.line("           path guiding: " + guiding());
    out.line("           lens: " + lens());
    out.line("           pixel coverage: " + coverage());
  }

  private String assets() {
    if (unused.isEmpty()) {
      return "all are used";
    }
    Map<String, Long> counts =
        unused.stream().collect(groupingBy(SceneOrigins.Unused::type, TreeMap::new, counting()));
    return "not decoded, because unused: "
        + counts.entrySet().stream()
            .map(type -> type.getKey() + " " + type.getValue())
            .collect(joining(", "));
  }

  private String materials() {
    List<Material> all = surfaces().stream().map(Primitive::material).toList();
    long uniform = all.stream().filter(Material::isUniform).count();
    return "%s of %s surfaces have a uniform BSDF, computed once instead of at every hit"
        .formatted(uniform, all.size());
  }

  private List<Primitive> surfaces() {
    return scene.primitives().stream().filter(p -> p.emission().isEmpty()).toList();
  }

  private String normals() {
    long mapped = surfaces().stream().filter(p -> p.material() instanceof NormalMapped).count();
    return mapped == 0
        ? "skipped, there are no normal maps"
        : "perturbed by normal maps on " + mapped + " of " + surfaces().size() + " surfaces";
  }

  private String meshes() {
    List<Shape> shapes = scene.primitives().stream().map(Primitive::shape).toList();
    long baked = shapes.stream().filter(Mesh.class::isInstance).count();
    long shared = shapes.stream().filter(MeshInstance.class::isInstance).count();
    if (baked + shared == 0) {
      return "skipped, there are none";
    }
    return baked
        + " used once, transformed at loading; "
        + shared
        + " instances of shared meshes, where each ray is transformed";
  }

  private String choice() {
    int count =
        settings.mode() == RenderSettings.Mode.PATH
            ? scene.emitters().size()
            : scene.lights().size();
    if (settings.mode() == RenderSettings.Mode.RAY) {
      return "skipped, ray mode samples every light: " + count;
    }
    if (count == 0) {
      return "skipped, there are no lights";
    }
    if (SceneInside.of(scene).takes(Specialization.ONE_EMITTER)) {
      return "skipped, there is a single light";
    }
    return switch (LightSampler.over(scene.emitters()).method()) {
      case FIXED -> "1 of " + count + ", with the same probabilities at every point";
      case ONE_BY_ONE ->
          "1 of " + count + ", with probabilities from the importance of each light at the point";
      case HIERARCHY ->
          "1 of " + count + ", with a light tree that evaluates about 2 log2(n) nodes";
    };
  }

  private String guiding() {
    if (settings.mode() == RenderSettings.Mode.RAY) {
      return "skipped, ray mode has no paths";
    }
    return settings.guiding() == RenderSettings.Guiding.OFF
        ? "skipped, it is off"
        : "by what a pilot render learns";
  }

  private String lens() {
    return scene.camera() instanceof ThinLensCamera
        ? "one lens point per sample"
        : "skipped, the camera has no lens";
  }

  private String coverage() {
    if (settings.transparent()) {
      return "counted, the background is transparent";
    }
    if (settings.background().isPresent()) {
      return "counted, the background is " + settings.text(Setting.BACKPLATE);
    }
    return scene.camera().leavesBlanks()
        ? "counted, the camera leaves some pixels blank"
        : "skipped, every sample covers its pixel";
  }
}
