package io.github.lumbre.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.Texture;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the samples, densities and bounds of area lights. */
class AreaLightTest {
  private static final Rgb RADIANCE = new Rgb(1, 2, 3);
  private static final double RADIUS = .5;
  private static final double DISTANCE = 3;

  private static final Shape SPHERE =
      new Sphere(Transform.translation(new Vec3(0, DISTANCE, 0)), RADIUS);

  /** A 3 by 2 rectangle that faces up. */
  private static final Shape RECTANGLE = new Rectangle(Transform.IDENTITY, 3, 2, false);

  private static AreaLight light(Shape shape, boolean twoSided) {
    return new AreaLight(shape, new Emission(Texture.constant(RADIANCE), twoSided));
  }

  /** A sphere of radiance L gives a surface that faces it the irradiance πL (R/d)². */
  @Test
  void sphereLightsASurfaceThatFacesItByItsSolidAngleInTheDisc() {
    AreaLight light = light(SPHERE, false);
    int n = 64;
    double sum = 0;
    for (int i = 0; i < n * n; i++) {
      Point2 u = new Point2((i % n + .5) / n, (i / n + .5) / n);
      LightSample sample = light.sample(Vec3.ZERO, u).orElseThrow();
      assertThat(sample.target()).isEqualTo(LightSample.Target.SURFACE);
      assertThat(sample.isDelta()).isFalse();
      assertThat(sample.wi().length()).isCloseTo(1, within(1e-15));
      sum += sample.radiance().b() * sample.wi().y() / sample.pdf();
    }
    double exact = Math.PI * RADIANCE.b() * RADIUS * RADIUS / (DISTANCE * DISTANCE);
    assertThat(sum / (n * n)).isCloseTo(exact, within(1e-4 * exact));
  }

  @Test
  void densityOfASampleIsThatOfTheRayThatHitsIt() {
    SplittableRandom random = new SplittableRandom(81);
    Vec3 reference = new Vec3(.3, 1, -.2);
    for (Shape shape : new Shape[] {SPHERE, RECTANGLE}) {
      AreaLight light = light(shape, true);
      for (int i = 0; i < 100; i++) {
        Point2 u = new Point2(random.nextDouble(), random.nextDouble());
        LightSample sample = light.sample(reference, u).orElseThrow();
        NearestHit hit = new NearestHit();
        hit.aim(new Ray(reference, sample.wi()));
        assertThat(shape.intersect(hit)).isTrue();
        assertThat(light.pdf(reference, shape.surfaceAt(hit)))
            .isCloseTo(sample.pdf(), within(1e-6 * sample.pdf()));
      }
    }
  }

  @Test
  void backOfAOneSidedLightIsDarkAlsoInAUsedSample() {
    Shape panel = new Rectangle(Transform.IDENTITY, 3, 2, true);
    LightSample drawn = new LightSample();
    Point2 u = new Point2(.3, .6);
    for (boolean twoSided : new boolean[] {false, true}) {
      AreaLight light = light(panel, twoSided);
      light.sample(Vec3.Y.x(), Vec3.Y.y(), Vec3.Y.z(), u.x(), u.y(), drawn);
      assertThat(drawn.isEmpty()).isFalse();
      light.sample(
          Vec3.Y.negated().x(), Vec3.Y.negated().y(), Vec3.Y.negated().z(), u.x(), u.y(), drawn);
      assertThat(drawn.isEmpty()).isEqualTo(!twoSided);
    }
  }

  /** Seen from far away, a light of radiance L has an intensity of L times its visible area. */
  @Test
  void boundsHoldTheIntensityInTheStrongestDirection() {
    LightBounds ofSphere = light(SPHERE, false).bounds().orElseThrow();
    assertThat(ofSphere.intensity()).isCloseTo(3 * Math.PI * RADIUS * RADIUS, within(1e-12));
    LightBounds ofRectangle = light(RECTANGLE, false).bounds().orElseThrow();
    assertThat(ofRectangle.intensity()).isCloseTo(3 * 6, within(1e-12));
    assertThat(ofRectangle.axis()).isEqualTo(Vec3.Y);
    assertThat(ofRectangle.spread()).isBetween(0.0, 1e-8);
    assertThat(ofRectangle.fall()).isCloseTo(Math.PI / 2, within(1e-8));
    assertThat(light(RECTANGLE, true).bounds().orElseThrow().spread()).isEqualTo(Math.PI);
  }

  @Test
  void lightIsBlackOnlyIfItIsKnownToEmitNothing() {
    Texture<Rgb> dim = (u, v) -> Rgb.BLACK;
    assertThat(light(SPHERE, false).isBlack()).isFalse();
    assertThat(new AreaLight(SPHERE, new Emission(dim, false)).isBlack()).isFalse();
    Emission none = new Emission(Texture.constant(Rgb.BLACK), true);
    assertThat(new AreaLight(SPHERE, none).isBlack()).isTrue();
    assertThat(light(SPHERE, false).isDelta()).isFalse();
  }

  @Test
  void lightWithoutRadianceGivesNoSample() {
    Emission none = new Emission(Texture.constant(Rgb.BLACK), true);
    Optional<LightSample> sample =
        new AreaLight(SPHERE, none).sample(Vec3.ZERO, new Point2(.5, .5));
    assertThat(sample).isEmpty();
  }
}
