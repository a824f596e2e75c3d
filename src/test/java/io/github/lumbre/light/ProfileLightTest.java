package io.github.lumbre.light;

import static io.github.lumbre.model.format.ies.IesSamples.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.internal.LightProfile;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Tests point lights with the profile of a lamp. */
class ProfileLightTest {
  private static final Point2 U = new Point2(.5, .5);
  private static final double[] TURN = {0, 90, 180, 270, 360};

  /** Brightest at 60 degrees from the axis, towards +x, and dark from 120. */
  private static final LightProfile WASHER =
      new LightProfile(
          new double[] {0, 60, 120},
          TURN,
          new int[] {0, 1, 2, 3, 0},
          new double[] {1, 4, 0, 1, 3, 0, 1, 1, 0, 1, 2, 0});

  private static Light light(LightProfile profile, Transform toWorld) {
    PointLight source =
        new PointLight(toWorld.point(Vec3.ZERO), new Rgb(2, 1, .5), Falloff.INVERSE_SQUARE);
    return profile.light(source, toWorld);
  }

  /** Returns the irradiance at distance 2 from a light's position. */
  private static double irradiance(Light light, Vec3 position, Vec3 direction) {
    return light
        .sample(position.plus(2, direction), U)
        .map(sample -> sample.radiance().r())
        .orElse(0.);
  }

  @Test
  void irradianceFollowsTheProfileAndTheDistance() {
    Light light = light(WASHER, Transform.IDENTITY);
    double[][] expected = {
      {0, 0, 1},
      {60, 0, 4},
      {60, 90, 3},
      {60, 180, 1},
      {60, -90, 2},
      {60, 45, 3.5},
      {30, 0, 2.5},
      {90, 0, 2},
      {121, 0, 0},
      {180, 0, 0}
    };
    for (double[] e : expected) {
      // A factor of 2, and the square of the distance 2.
      assertThat(irradiance(light, Vec3.ZERO, direction(e[0], e[1])))
          .as(Arrays.toString(e))
          .isCloseTo(e[2] * 2 / 4, within(1e-14));
    }
  }

  @Test
  void profileTurnsWithTheLightAndIsNotScaled() {
    Transform place =
        Transform.translation(new Vec3(1, 2, 3))
            .times(Transform.rotationDegrees(new Vec3(20, 130, -70)));
    Transform scaled = place.times(Transform.scale(new Vec3(2, 5, .1)));
    Light turned = light(WASHER, Transform.IDENTITY).transformed(scaled);
    Light plain = light(WASHER, Transform.IDENTITY);
    Vec3 position = place.point(Vec3.ZERO);
    for (double azimuth = 0; azimuth < 360; azimuth += 17) {
      Vec3 local = direction(50, azimuth);
      double expected = irradiance(plain, Vec3.ZERO, local);
      assertThat(irradiance(turned, position, place.vector(local)))
          .isCloseTo(expected, within(1e-14));
      assertThat(irradiance(light(WASHER, scaled), position, place.vector(local)))
          .isCloseTo(expected, within(1e-14));
    }
  }

  @Test
  void mirroredSpaceMirrorsTheProfile() {
    Light plain = light(WASHER, Transform.IDENTITY);
    Light mirrored = plain.transformed(Transform.scale(new Vec3(-1, 1, 1)));
    assertThat(irradiance(mirrored, Vec3.ZERO, direction(60, 180))).isCloseTo(2, within(1e-14));
    assertThat(irradiance(mirrored, Vec3.ZERO, direction(60, 0))).isCloseTo(.5, within(1e-14));
    assertThat(irradiance(mirrored, Vec3.ZERO, direction(60, 90))).isCloseTo(1.5, within(1e-14));
  }

  /** The midpoint rule has 1e5 directions; its error falls with the square of the steps. */
  @Test
  void powerIsTheFlux() {
    Light light = light(WASHER, Transform.IDENTITY);
    double flux = 0;
    double step = .5;
    for (double polar = step / 2; polar < 180; polar += step) {
      for (double azimuth = step / 2; azimuth < 360; azimuth += step) {
        double solidAngle =
            StrictMath.sin(Math.toRadians(polar)) * StrictMath.pow(Math.toRadians(step), 2);
        flux += 4 * irradiance(light, Vec3.ZERO, direction(polar, azimuth)) * solidAngle;
      }
    }
    assertThat(light.power(7)).isCloseTo(flux, within(1e-4 * flux));
    assertThat(WASHER.flux()).isCloseTo(flux / 2, within(1e-4 * flux));
  }

  @Test
  void boundsContainAllLight() {
    Transform place = Transform.rotationDegrees(new Vec3(40, 10, 5));
    LightBounds bounds = light(WASHER, place).bounds().orElseThrow();
    assertThat(bounds.intensity()).isEqualTo(8);
    assertThat(bounds.axis().minus(place.vector(Vec3.Z)).length()).isLessThan(1e-15);
    assertThat(bounds.spread()).isCloseTo(Math.toRadians(120), within(1e-8));
    assertThat(light(WASHER, place).farIrradiance()).isZero();
    LightProfile uplight =
        new LightProfile(
            new double[] {90, 180}, new double[] {0, 360}, new int[] {0, 0}, new double[] {0, 1});
    assertThat(light(uplight, place).bounds().orElseThrow().spread())
        .isGreaterThanOrEqualTo(Math.PI);
    assertThat(irradiance(light(uplight, Transform.IDENTITY), Vec3.ZERO, Vec3.Z.negated()))
        .isEqualTo(.5);
    assertThat(irradiance(light(uplight, Transform.IDENTITY), Vec3.ZERO, Vec3.Z)).isZero();
  }

  @Test
  void lightAtItsOwnPointAndDarkLampsGiveNothing() {
    Light light = light(WASHER, Transform.IDENTITY);
    assertThat(light.sample(Vec3.ZERO, U)).isEmpty();
    assertThat(light.isBlack()).isFalse();
    assertThat(light.isDelta()).isTrue();
    LightProfile dark =
        new LightProfile(new double[] {0}, new double[] {0, 360}, new int[2], new double[] {5});
    assertThat(light(dark, Transform.IDENTITY).isBlack()).isTrue();
    assertThat(dark.flux()).isZero();
  }
}
