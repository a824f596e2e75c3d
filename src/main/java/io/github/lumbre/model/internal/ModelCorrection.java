package io.github.lumbre.model.internal;

import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelCamera.Lens;
import io.github.lumbre.model.internal.ModelCamera.Parallel;
import java.util.IdentityHashMap;
import java.util.Map;

/**
 * Turns and scales a model whose file is wrong about its up axis or its unit. All lengths change:
 * those of shapes, and the ranges of lights, the frames of parallel cameras and the attenuation
 * distances of materials. Intensities stay. Mutable: equal materials stay one object.
 */
final class ModelCorrection {
  private final Transform toWorld;
  private final double unit;
  private final Map<ModelMaterial, ModelMaterial> materials = new IdentityHashMap<>();

  private ModelCorrection(Transform toWorld, double unit) {
    this.toWorld = toWorld;
    this.unit = unit;
  }

  /**
   * Returns a model in the up axis and the unit that options state; itself if they state none.
   *
   * @param read a model, standing still, whose file states meters and +Y up
   */
  static Model of(Model read, ModelOptions options) {
    if (options.find(ModelOption.UP).isEmpty() && options.find(ModelOption.UNIT).isEmpty()) {
      return read;
    }
    Transform toWorld = options.toWorld();
    return new ModelCorrection(toWorld, options.find(ModelOption.UNIT).orElse(1.))
        .corrected(read)
        .from(toWorld, LengthUnit.nameOf(options.find(ModelOption.UNIT).orElse(1.)));
  }

  private Model corrected(Model read) {
    return read.with(
        read.parts().stream().map(this::part).toList(),
        read.cameras().stream().map(this::camera).toList(),
        read.lights().stream().map(this::light).toList());
  }

  private ModelPart part(ModelPart part) {
    return new ModelPart(
        part.node(),
        part.location(),
        part.geometry(),
        materials.computeIfAbsent(part.material(), this::material),
        toWorld.times(part.toWorld()));
  }

  private ModelMaterial material(ModelMaterial material) {
    return material.uses(MaterialParameter.ATTENUATION_DISTANCE)
        ? material.scaled(MaterialParameter.ATTENUATION_DISTANCE, unit)
        : material;
  }

  private ModelCamera camera(ModelCamera camera) {
    // The axes of the camera keep their lengths, which scale the frame of its lens.
    Transform kept = Transform.scale(new Vec3(1 / unit, 1 / unit, 1 / unit));
    return new ModelCamera(
        camera.name(),
        camera.location(),
        lens(camera.lens()),
        toWorld.times(camera.toWorld()).times(kept),
        camera.onlyByName());
  }

  private Lens lens(Lens lens) {
    return lens instanceof Parallel parallel
        ? new Parallel(unit * parallel.halfWidth(), unit * parallel.halfHeight())
        : lens;
  }

  private ModelLight light(ModelLight light) {
    return new ModelLight(
        light.name(),
        light.location(),
        light.kind(),
        light.intensity(),
        unit * light.range(),
        light.innerCone(),
        light.outerCone(),
        toWorld.times(light.toWorld()));
  }
}
