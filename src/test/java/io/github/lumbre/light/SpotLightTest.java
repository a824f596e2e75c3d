package io.github.lumbre.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import org.junit.jupiter.api.Test;

/** Tests the cone and the penumbra of spot lights. */
class SpotLightTest {
  private static final double EPS = 0x1p-52;
  private static final Point2 U = new Point2(.5, .5);
  private static final PointLight SOURCE =
      new PointLight(Vec3.ZERO, Rgb.WHITE, Falloff.INVERSE_SQUARE);

  private static SpotLight spot(double halfAngle, double penumbra) {
    return new SpotLight(SOURCE, Vec3.Z, halfAngle, penumbra);
  }

  /** Returns the irradiance at distance 1 in a direction at an angle from +z. */
  private static double share(SpotLight light, double radians) {
    Vec3 reference = new Vec3(StrictMath.sin(radians), 0, StrictMath.cos(radians));
    return light.sample(reference, U).map(sample -> sample.radiance().g()).orElse(0.0);
  }

  @Test
  void coneEndsSharplyAtItsAngle() {
    for (double degrees : new double[] {1e-3, 1, 30, 60, 89, 90}) {
      double edge = Math.toRadians(degrees);
      // 1e-12 radians, which the cosines of narrow cones cannot resolve.
      assertThat(share(spot(degrees, 0), edge - 1e-12)).isCloseTo(1, within(4 * EPS));
      assertThat(share(spot(degrees, 0), edge + 1e-12)).isZero();
      assertThat(share(spot(degrees, 0), 0)).isEqualTo(1);
      assertThat(share(spot(degrees, 0), Math.PI)).isZero();
    }
  }

  @Test
  void narrowestConesHaveTheirWidth() {
    for (double degrees : new double[] {1e-9, 1e-7, 1e-5}) {
      double edge = Math.toRadians(degrees);
      assertThat(share(spot(degrees, 0), .999 * edge)).isCloseTo(1, within(4 * EPS));
      assertThat(share(spot(degrees, 0), 1.001 * edge)).isZero();
      assertThat(share(spot(degrees, degrees), .5 * edge)).isCloseTo(.5, within(1e-9));
    }
  }

  @Test
  void penumbraIsASmoothStep() {
    SpotLight light = spot(60, 20);
    assertThat(share(light, Math.toRadians(39.999))).isCloseTo(1, within(4 * EPS));
    assertThat(share(light, Math.toRadians(60.001))).isZero();
    assertThat(share(light, Math.toRadians(50))).isCloseTo(.5, within(1e-14));
    assertThat(share(light, Math.toRadians(55))).isCloseTo(.15625, within(1e-14));
    assertThat(share(light, Math.toRadians(45))).isCloseTo(.84375, within(1e-14));
    assertThat(share(light, Math.toRadians(59.999))).isBetween(0.0, 1e-7);
  }

  @Test
  void fluxIsThatOfTheCone() {
    for (double degrees : new double[] {5, 60, 90}) {
      double edge = Math.toRadians(degrees);
      SpotLight light = spot(degrees, 0);
      int n = 100_000;
      double flux = 0;
      for (int i = 0; i < n; i++) {
        double angle = (i + .5) / n * Math.PI;
        flux += share(light, angle) * StrictMath.sin(angle) * 2 * Math.PI * Math.PI / n;
      }
      assertThat(flux).isCloseTo(2 * Math.PI * (1 - StrictMath.cos(edge)), within(2e-4));
    }
  }

  @Test
  void boundsEndWhereTheLightEnds() {
    for (double penumbra : new double[] {0, 20, 60}) {
      LightBounds bounds = spot(60, penumbra).bounds().orElseThrow();
      assertThat(bounds.spread()).isCloseTo(Math.toRadians(60 - penumbra), within(1e-8));
      assertThat(bounds.spread() + bounds.fall()).isCloseTo(Math.toRadians(60), within(1e-8));
      assertThat(bounds.axis()).isEqualTo(Vec3.Z);
      assertThat(bounds.box().center()).isEqualTo(Vec3.ZERO);
      assertThat(bounds.intensity()).isEqualTo(1);
    }
  }

  @Test
  void widestConeIsAHalfSpace() {
    SpotLight light = spot(90, 0);
    assertThat(light.sample(new Vec3(5, -3, 1e-9), U)).isPresent();
    assertThat(light.sample(new Vec3(5, -3, 0), U)).isPresent();
    assertThat(light.sample(new Vec3(5, -3, -1e-9), U)).isEmpty();
  }

  @Test
  void lightInsideTheConeIsTheSources() {
    SpotLight light = spot(60, 0);
    Vec3 reference = new Vec3(1, 2, 7);
    assertThat(light.sample(reference, U).orElseThrow())
        .usingRecursiveComparison()
        .isEqualTo(SOURCE.sample(reference, U).orElseThrow());
    assertThat(light.sample(Vec3.ZERO, U)).isEmpty();
    assertThat(light.isDelta()).isTrue();
    assertThat(light.isBlack()).isFalse();
    PointLight dark = new PointLight(Vec3.ZERO, Rgb.BLACK, Falloff.NONE);
    assertThat(new SpotLight(dark, Vec3.Z, 60, 0).isBlack()).isTrue();
  }

  @Test
  void coneFollowsItsAxisAndPosition() {
    PointLight source = new PointLight(new Vec3(1, 2, 3), Rgb.WHITE, Falloff.NONE);
    SpotLight light = new SpotLight(source, new Vec3(-.6, .8, 0), 10, 0);
    assertThat(light.sample(new Vec3(.4, 2.8, 3), U)).isPresent();
    assertThat(light.sample(new Vec3(1.6, 1.2, 3), U)).isEmpty();
    assertThat(light.sample(new Vec3(1, 2, 4), U)).isEmpty();
  }

  @Test
  void impossibleConesAreRefused() {
    for (double angle : new double[] {0, -1, 90.001, Double.NaN}) {
      assertThatThrownBy(() -> spot(angle, 0)).hasMessageContaining("halfAngleDegrees: expected");
    }
    for (double penumbra : new double[] {-1, 60.001, Double.NaN}) {
      assertThatThrownBy(() -> spot(60, penumbra))
          .hasMessageContaining("penumbraDegrees: expected");
    }
  }
}
