package io.github.lumbre.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import org.junit.jupiter.api.Test;

/** Tests the irradiance and falloff of point lights. */
class PointLightTest {
  private static final double EPS = 0x1p-52;
  private static final Point2 U = new Point2(.5, .5);
  private static final Rgb INTENSITY = new Rgb(1, 2, 3);

  private static LightSample sample(Light light, Vec3 reference) {
    return light.sample(reference, U).orElseThrow();
  }

  @Test
  void withoutFalloffTheDistanceDoesNotMatter() {
    Light light = new PointLight(Vec3.ZERO, INTENSITY, Falloff.NONE);
    for (double distance = 1e-9; distance < 1e9; distance *= 7) {
      LightSample sample = sample(light, new Vec3(0, -distance, 0));
      assertThat(sample.radiance()).isEqualTo(INTENSITY);
      assertThat(sample.wi().minus(Vec3.Y).length()).isLessThanOrEqualTo(EPS);
    }
  }

  @Test
  void physicalIrradianceFallsWithTheSquareOfTheDistance() {
    Vec3 position = new Vec3(1, 2, 3);
    Light light = new PointLight(position, INTENSITY, Falloff.INVERSE_SQUARE);
    for (double distance = .1; distance <= 1e3; distance *= 1.7) {
      Vec3 wi = new Vec3(.48, .6, .64);
      LightSample sample = sample(light, position.plus(-distance, wi));
      double expected = 3 / (distance * distance);
      // The reference point is rounded to an ulp of the position, at most 4 ulp at 0.1.
      double error = expected * EPS * (16 + 32 / distance);
      assertThat(sample.radiance().b()).isCloseTo(expected, within(error));
      assertThat(sample.wi().minus(wi).length()).isLessThan(EPS * (4 + 8 / distance));
    }
  }

  @Test
  void lightIsADeltaAtItsPosition() {
    Vec3 position = new Vec3(1, 2, 3);
    Light light = new PointLight(position, INTENSITY, Falloff.NONE);
    LightSample sample = sample(light, Vec3.ZERO);
    assertThat(sample.isDelta()).isTrue();
    assertThat(light.isDelta()).isTrue();
    assertThat(sample.target()).isEqualTo(LightSample.Target.POINT);
    assertThat(sample.end()).isEqualTo(position);
  }

  @Test
  void nothingArrivesAtTheLightItself() {
    for (Falloff falloff : Falloff.values()) {
      Light light = new PointLight(Vec3.X, INTENSITY, falloff);
      assertThat(light.sample(Vec3.X, U)).isEmpty();
    }
  }

  @Test
  void usedSampleIsEmptyAtTheLightItself() {
    LightSample drawn = new LightSample();
    Light light = new PointLight(Vec3.X, INTENSITY, Falloff.INVERSE_SQUARE);
    light.sample(0, 0, 0, U.x(), U.y(), drawn);
    assertThat(drawn.isEmpty()).isFalse();
    light.sample(1, 0, 0, U.x(), U.y(), drawn);
    assertThat(drawn.isEmpty()).isTrue();
  }

  @Test
  void lightsAreEitherNearOrOfOneIrradianceEverywhere() {
    Vec3 position = new Vec3(1, 2, 3);
    for (Falloff falloff : Falloff.values()) {
      PointLight bulb = new PointLight(position, INTENSITY, falloff);
      for (Light light : new Light[] {bulb, new SpotLight(bulb, Vec3.Z, 30, 10)}) {
        boolean isFar = falloff == Falloff.NONE;
        assertThat(light.bounds().isEmpty()).isEqualTo(isFar);
        assertThat(light.farIrradiance()).isEqualTo(isFar ? 3 : 0);
        light.bounds().ifPresent(bounds -> assertThat(bounds.intensity()).isEqualTo(3));
      }
    }
    assertThat(new DirectionalLight(Vec3.Z, INTENSITY).farIrradiance()).isEqualTo(3);
  }

  @Test
  void powersOfTwoScaleExactly() {
    Vec3 position = new Vec3(.3, 1.7, -2.9);
    Light light = new PointLight(position, INTENSITY, Falloff.INVERSE_SQUARE);
    LightSample sample = sample(light, Vec3.X);
    for (int exponent = -30; exponent <= 30; exponent++) {
      double s = Math.scalb(1.0, exponent);
      Rgb scaled = INTENSITY.times(s * s);
      Light other = new PointLight(position.times(s), scaled, Falloff.INVERSE_SQUARE);
      assertThat(sample(other, Vec3.X.times(s)).radiance()).isEqualTo(sample.radiance());
      assertThat(sample(other, Vec3.X.times(s)).wi()).isEqualTo(sample.wi());
    }
  }

  @Test
  void lightWithoutIntensityIsBlack() {
    assertThat(new PointLight(Vec3.ZERO, Rgb.BLACK, Falloff.NONE).isBlack()).isTrue();
    assertThat(new PointLight(Vec3.ZERO, new Rgb(0, 0, 1e-300), Falloff.NONE).isBlack()).isFalse();
  }

  @Test
  void directionalLightIsTheSameEverywhere() {
    Light light = new DirectionalLight(new Vec3(0, -.6, .8), INTENSITY);
    for (Vec3 reference : new Vec3[] {Vec3.ZERO, new Vec3(1e9, -1e9, 5)}) {
      LightSample sample = sample(light, reference);
      assertThat(sample.wi().plus(Vec3.ZERO)).isEqualTo(new Vec3(0, .6, -.8));
      assertThat(sample.radiance()).isEqualTo(INTENSITY);
      assertThat(sample.target()).isEqualTo(LightSample.Target.INFINITY);
      assertThat(sample.isDelta()).isTrue();
    }
    assertThat(light.isBlack()).isFalse();
    assertThat(new DirectionalLight(Vec3.Z, Rgb.BLACK).isBlack()).isTrue();
  }
}
