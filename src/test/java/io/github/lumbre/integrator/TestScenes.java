package io.github.lumbre.integrator;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;

/** Parts of scenes for light transport tests. */
final class TestScenes {
  private TestScenes() {}

  /** Returns what the techniques of a path tracer with default options share. */
  static LightSampling sampling(Scene scene) {
    PathOptions options = PathOptions.toDepth(5);
    return new LightSampling(
        scene,
        options,
        options.lightSampler().over(scene),
        DirectionStrategy.of(options, Guide.NONE));
  }

  static SceneBuilder empty() {
    return Scene.builder().seenBy(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1));
  }

  static Matte matte(double albedo) {
    return new Matte(Texture.constant(Rgb.gray(albedo)));
  }

  static Glass glass(double ior) {
    return new Glass(
        Texture.constant(Rgb.WHITE),
        Texture.constant(Rgb.WHITE),
        ScalarTexture.constant(ior),
        ScalarTexture.constant(0));
  }

  static Emission glow(double radiance) {
    return new Emission(Texture.constant(Rgb.gray(radiance)), false);
  }

  static PointLight point(Vec3 position, double intensity) {
    return new PointLight(position, Rgb.gray(intensity), Falloff.INVERSE_SQUARE);
  }

  static Transform at(double x, double y, double z) {
    return Transform.translation(new Vec3(x, y, z));
  }

  static Transform turned(double xDegrees, double yDegrees, double zDegrees) {
    return Transform.rotationDegrees(new Vec3(xDegrees, yDegrees, zDegrees));
  }

  /** Returns a floor at y = 0 that faces up, wide enough for any of the tests. */
  static Rectangle floor() {
    return new Rectangle(Transform.IDENTITY, 1e4, 1e4, false);
  }

  /** Returns a rectangle at height h above the origin that faces down. */
  static Rectangle ceilingLamp(double width, double depth, double h) {
    return new Rectangle(at(0, h, 0).times(turned(180, 0, 0)), width, depth, false);
  }

  static Sphere sphere(double x, double y, double z, double radius) {
    return new Sphere(at(x, y, z), radius);
  }

  /** Returns a steep ray that hits the floor at (x, 0, 0) and starts below all lights. */
  static Ray lookingDownAt(double x) {
    return lookingDownAt(x, 1e-3);
  }

  /** Returns a steep ray that hits the floor at (x, 0, 0) and starts at a given height. */
  static Ray lookingDownAt(double x, double height) {
    Vec3 direction = new Vec3(.3, -1, .2).normalized();
    double way = height / -direction.y();
    return new Ray(new Vec3(x, 0, 0).plus(-way, direction), direction);
  }
}
