package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import java.util.List;

/** What models without materials, cameras and lights have in common. Stateless. */
public final class PlainModel {
  /**
   * The reflectance of surfaces without a material: light gray paint, which leaves room for
   * brighter surfaces.
   */
  public static final double ALBEDO = .7;

  private PlainModel() {}

  /**
   * Returns the material of surfaces that have none: diffuse light gray, visible from both sides.
   */
  public static ModelMaterial defaultMaterial() {
    return matte("", "").set(MaterialParameter.BASE_COLOR, Rgb.grey(ALBEDO)).build();
  }

  /**
   * Returns the material of surfaces that have none.
   *
   * @param isColored whether its vertices have colors, which are its albedo then
   */
  public static ModelMaterial material(boolean isColored) {
    return isColored ? matte("", "").build() : defaultMaterial();
  }

  /** Returns a builder of a white diffuse material that is visible from both sides. */
  public static ModelMaterial.Builder matte(String name, String location) {
    return ModelMaterial.builder(name, location)
        .set(MaterialParameter.METALLIC, 0)
        .set(MaterialParameter.SPECULAR, 0)
        .doubleSided(true);
  }

  /** Returns a model that has parts only. */
  public static Model of(List<ModelPart> parts, List<String> warnings) {
    return new Model(
        TriangleMesh.Front.NORMALS, parts, List.of(), List.of(), List.of(), List.of(), warnings);
  }
}
