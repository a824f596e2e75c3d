package io.github.lumbre.lab.checks;

import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.AreaLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.texture.Texture;
import java.util.List;
import java.util.Optional;

/** Invariants of lights: irradiance at a point, compared with closed forms. */
final class LightInvariants {
  private static final int SAMPLES = 1 << 16;

  /** Width, depth and height above the point. */
  private static final double[][] RECTANGLES = {
    {1, 1, 1},
    {2, 2, 1},
    {1, 1, 2},
    {1, 1, 10},
    {1, 1, 100},
    {1, 1, .01},
    {1, 1, 1e-6},
    {1e-6, 1e-6, 1},
    {1, .1, 1},
    {1.3, 1.05, 5.488},
    {1e6, 1e6, 1}
  };

  /** Radius, distance and angle from the normal in degrees, entirely above the horizon. */
  private static final double[][] SPHERES = {
    {1, 2, 0}, {1, 2, 30}, {1, 2, 60}, {.5, 3, 30}, {1, 1.000001, 0}, {1e-3, 1, 0}, {1e-6, 1, 60}
  };

  private LightInvariants() {}

  static List<Invariant> all() {
    return List.of(
        new Invariant(
            "rectangle-light",
            "relative difference of the irradiance from the closed form",
            "sides 1e-6 to 1e6 of the height, over the middle",
            1e-6,
            tries -> rectangles()),
        new Invariant(
            "sphere-light",
            "relative difference of the irradiance from π (R/d)² cos θ",
            "radii 1e-6 to 0.999999 of the distance",
            1e-6,
            tries -> spheres()),
        new Invariant(
            "point-light",
            "relative difference of the irradiance from I cos θ / d², in 2^-52",
            "distances 1e-3 to 1e3, angles to 89.9°",
            16,
            tries -> points()),
        new Invariant(
            "dome-light",
            "relative difference of the irradiance from π",
            "uniform environment light over a plane",
            1e-6,
            tries -> dome()));
  }

  /** Returns the irradiance at the origin of an upward-facing plane. */
  private static double irradiance(Light light) {
    Sampler sampler = new SobolSampler(31);
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
      sampler.startSample(0, 0, i);
      Optional<LightSample> drawn = light.sample(Vec3.ZERO, sampler.get2d(0));
      if (drawn.isPresent()) {
        double cosine = Math.max(0, drawn.get().wi().y());
        sum += drawn.get().radiance().g() * cosine / drawn.get().pdf();
      }
    }
    return sum / SAMPLES;
  }

  private static Emission white() {
    return new Emission(Texture.constant(Rgb.WHITE), false);
  }

  private static double rectangles() {
    double worst = 0;
    for (double[] r : RECTANGLES) {
      Transform place =
          Transform.translation(new Vec3(0, r[2], 0))
              .times(Transform.rotationDegrees(new Vec3(180, 0, 0)));
      Light light = new AreaLight(new Rectangle(place, r[0], r[1], false), white());
      double expected = overRectangle(.5 * r[0] / r[2], .5 * r[1] / r[2]);
      worst = Math.max(worst, Math.abs(irradiance(light) / expected - 1));
    }
    return worst;
  }

  /**
   * Returns the irradiance below the center of a rectangle, given its half sides in units of the
   * height.
   */
  private static double overRectangle(double x, double y) {
    double rootX = Math.sqrt(1 + x * x);
    double rootY = Math.sqrt(1 + y * y);
    return 2 * (x / rootX * Elementary.atan2(y, rootX) + y / rootY * Elementary.atan2(x, rootY));
  }

  private static double spheres() {
    double worst = 0;
    for (double[] s : SPHERES) {
      Vec3 center =
          new Vec3(Elementary.sinDegrees(s[2]), Elementary.cosDegrees(s[2]), 0).times(s[1]);
      Light light = new AreaLight(new Sphere(Transform.translation(center), s[0]), white());
      double ratio = s[0] / s[1];
      double expected = Math.PI * ratio * ratio * Elementary.cosDegrees(s[2]);
      worst = Math.max(worst, Math.abs(irradiance(light) / expected - 1));
    }
    return worst;
  }

  private static double points() {
    double worst = 0;
    for (double distance = 1e-3; distance <= 1e3; distance *= 10) {
      for (double angle : new double[] {0, 30, 60, 89.9}) {
        Vec3 direction = new Vec3(Elementary.sinDegrees(angle), Elementary.cosDegrees(angle), 0);
        Light light = new PointLight(direction.times(distance), Rgb.WHITE, Falloff.INVERSE_SQUARE);
        LightSample sample = light.sample(Vec3.ZERO, new SobolSampler(0).get2d(0)).orElseThrow();
        double found = sample.radiance().g() * sample.wi().y();
        double expected = Elementary.cosDegrees(angle) / (distance * distance);
        worst = Math.max(worst, Math.abs(found / expected - 1) / Invariants.EPSILON);
      }
    }
    return worst;
  }

  private static double dome() {
    return Math.abs(irradiance(EnvironmentLight.uniform(Rgb.WHITE)) / Math.PI - 1);
  }
}
