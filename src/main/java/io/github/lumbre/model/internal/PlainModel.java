package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
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
    return matte("", "").set(MaterialParameter.BASE_COLOR, Rgb.gray(ALBEDO)).build();
  }

  /**
   * Returns the material of surfaces that have none.
   *
   * @param colors four linear components per vertex, which are the albedo and the opacity; may be
   *     empty
   */
  public static ModelMaterial material(float... colors) {
    if (colors.length == 0) {
      return defaultMaterial();
    }
    return matte("", "")
        .alphaMode(smallestAlpha(colors) < 1 ? AlphaMode.BLEND : AlphaMode.OPAQUE)
        .build();
  }

  private static float smallestAlpha(float... colors) {
    float smallest = 1;
    for (int i = 3; i < colors.length; i += 4) {
      smallest = Math.min(smallest, colors[i]);
    }
    return smallest;
  }

  /**
   * Sets the alpha of all colors to 1, with a warning, if all are invisible: alpha is not used.
   *
   * @param location of the colors in the file, for the warning
   * @param colors four components each
   */
  public static void showInvisible(String location, float[] colors, Warnings warnings) {
    for (int i = 3; i < colors.length; i += 4) {
      if (colors[i] > 0) {
        return;
      }
    }
    if (colors.length > 0) {
      warnings.add(location, "ignored alpha, which is 0 everywhere");
    }
    for (int i = 3; i < colors.length; i += 4) {
      colors[i] = 1;
    }
  }

  /** Returns a builder of a white diffuse material that is visible from both sides. */
  public static ModelMaterial.Builder matte(String name, String location) {
    return ModelMaterial.builder(name, location)
        .set(MaterialParameter.METALLIC, 0)
        .set(MaterialParameter.SPECULAR, 0)
        .doubleSided(true);
  }

  /**
   * Returns a model whose vertices are points; those that are not finite are left out.
   *
   * @param location of the points in the file, for warnings
   */
  public static Model cloud(
      String location, ModelGeometry vertices, Transform toWorld, Warnings warnings) {
    ModelGeometry points = vertices.points();
    int broken = vertices.vertexCount() - points.vertexCount();
    if (broken > 0) {
      warnings.add(location, "left out points that are not finite numbers: " + broken);
    }
    showInvisible(location, points.colors(), warnings);
    ModelPart part =
        new ModelPart(ModelNode.undivided(""), "", points, material(points.colors()), toWorld);
    return of(points.isVisible() ? List.of(part) : List.of(), warnings.all());
  }

  public static Model of(List<ModelPart> parts, List<String> warnings) {
    return new Model(
        Transform.IDENTITY,
        "",
        TriangleMesh.Front.NORMALS,
        parts,
        1,
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        warnings,
        List.of());
  }
}
