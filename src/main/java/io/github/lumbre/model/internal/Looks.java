package io.github.lumbre.model.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Replaces the materials of a model by one, for pictures that show the shape alone. Confined to one
 * thread.
 *
 * <p>Cut-outs stay cut out: opacity from a texture that is below a half, or below the cutoff of the
 * material. All else is opaque, glass too. The model's own lights are left out.
 */
final class Looks {
  private static final double BLEND_CUTOFF = .5;

  private final boolean isWhite;
  private final Map<ModelMaterial, ModelMaterial> materials = new IdentityHashMap<>();
  private final Map<ModelGeometry, ModelGeometry> colorless = new IdentityHashMap<>();

  private Looks(boolean isWhite) {
    this.isWhite = isWhite;
  }

  static Model of(Model model, ModelOptions options) {
    if (options.find(ModelOption.LOOK).isEmpty()) {
      return model;
    }
    Looks looks = new Looks(options.get(ModelOption.LOOK).equals(ModelOptions.WHITE));
    List<ModelPart> parts = new ArrayList<>();
    for (ModelPart part : model.parts()) {
      ModelGeometry geometry =
          looks.colorless.computeIfAbsent(
              part.geometry(), g -> g.colors().length == 0 ? g : g.withoutColors());
      parts.add(
          part.with(
              part.node(),
              geometry,
              looks.materials.computeIfAbsent(part.material(), looks::material)));
    }
    return model.unlit(parts);
  }

  private ModelMaterial material(ModelMaterial m) {
    double gray = isWhite ? 1 : PlainModel.ALBEDO;
    ModelMaterial.Builder plain =
        PlainModel.matte(m.name(), m.location())
            .set(MaterialParameter.BASE_COLOR, Rgb.gray(gray))
            .doubleSided(m.doubleSided());
    MaterialInput opacity = m.input(MaterialParameter.OPACITY);
    boolean isMask = m.alphaMode() == AlphaMode.MASK;
    if (isMask || m.alphaMode() == AlphaMode.BLEND && opacity.texture().isPresent()) {
      plain
          .alphaMode(AlphaMode.MASK)
          .alphaCutoff(isMask ? m.alphaCutoff() : BLEND_CUTOFF)
          .set(MaterialParameter.OPACITY, opacity);
    }
    return isWhite ? plain.flat().build() : plain.build();
  }
}
