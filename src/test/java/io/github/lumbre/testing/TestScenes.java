package io.github.lumbre.testing;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;

/** Parts of scenes for tests. */
public final class TestScenes {
  private TestScenes() {}

  public static SceneBuilder empty() {
    return Scene.builder().seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1));
  }

  public static Matte matte(double albedo) {
    return new Matte(Texture.constant(Rgb.gray(albedo)));
  }

  public static Glass glass(double ior) {
    return new Glass(
        Texture.constant(Rgb.WHITE),
        Texture.constant(Rgb.WHITE),
        ScalarTexture.constant(ior),
        ScalarTexture.constant(0));
  }

  public static Emission glow(double radiance) {
    return new Emission(Texture.constant(Rgb.gray(radiance)), false);
  }

  public static PointLight point(Vec3 position, double intensity) {
    return new PointLight(position, Rgb.gray(intensity), Falloff.INVERSE_SQUARE);
  }

  public static Transform at(double x, double y, double z) {
    return Transform.translation(new Vec3(x, y, z));
  }

  public static Transform turned(double xDegrees, double yDegrees, double zDegrees) {
    return Transform.rotationDegrees(new Vec3(xDegrees, yDegrees, zDegrees));
  }

  /** Returns a floor at y = 0 that faces up, wide enough for any of the tests. */
  public static Rectangle floor() {
    return new Rectangle(Transform.IDENTITY, 1e4, 1e4, false);
  }

  /** Returns a rectangle at height h above the origin that faces down. */
  public static Rectangle ceilingLamp(double width, double depth, double h) {
    return new Rectangle(at(0, h, 0).times(turned(180, 0, 0)), width, depth, false);
  }

  public static Sphere sphere(double x, double y, double z, double radius) {
    return new Sphere(at(x, y, z), radius);
  }

  /** Returns a wide rectangle at z that faces the origin. */
  public static Rectangle wall(double z) {
    return new Rectangle(at(0, 0, z).times(turned(-90, 0, 0)), 100, 100, true);
  }

  /** Returns a plastic without reflection. */
  public static MetallicRoughness.Builder plastic(double albedo) {
    return MetallicRoughness.builder()
        .set(MaterialParameter.METALLIC, 0)
        .set(MaterialParameter.SPECULAR, 0)
        .set(MaterialParameter.BASE_COLOR, Rgb.gray(albedo));
  }

  /** Returns a steep ray that hits the floor at (x, 0, 0) and starts below all lights. */
  public static Ray lookingDownAt(double x) {
    return lookingDownAt(x, 1e-3);
  }

  /** Returns a steep ray that hits the floor at (x, 0, 0) and starts at a given height. */
  public static Ray lookingDownAt(double x, double height) {
    Vec3 direction = new Vec3(.3, -1, .2).normalized();
    double way = height / -direction.y();
    return new Ray(new Vec3(x, 0, 0).plus(-way, direction), direction);
  }
}
