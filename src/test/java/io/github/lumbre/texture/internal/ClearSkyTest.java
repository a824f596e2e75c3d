package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the sky of a clear day against a published model of its irradiance. */
class ClearSkyTest {
  /** Direct and diffuse irradiance of level ground, in W/m². */
  private record Irradiance(double direct, double diffuse) {}

  /**
   * Bird and Hulstrom's clear sky (1981, SERI/TR-642-761): 0.3 cm of ozone, 1.5 cm of water, sea
   * level, and the model's aerosol and ground.
   */
  private static Irradiance bird(double elevation) {
    double zenith = 90 - elevation;
    double cosine = Math.cos(Math.toRadians(zenith));
    double mass = 1 / (cosine + .15 * Math.pow(93.885 - zenith, -1.25));
    double rayleigh = Math.exp(-.0903 * Math.pow(mass, .84) * (1 + mass - Math.pow(mass, 1.01)));
    double x = .3 * mass;
    double ozone =
        1
            - .1611 * x * Math.pow(1 + 139.48 * x, -.3035)
            - .002715 * x / (1 + .044 * x + .0003 * x * x);
    double gases = gases(mass);
    double water = water(mass);
    double depth = .2758 * Air.depths(380)[Air.AEROSOL] + .35 * Air.depths(500)[Air.AEROSOL];
    double aerosol =
        Math.exp(
            -Math.pow(depth, .873) * (1 + depth - Math.pow(depth, .7088)) * Math.pow(mass, .9108));
    double absorbing = 1 - .1 * (1 - mass + Math.pow(mass, 1.06)) * (1 - aerosol);
    double scattering = aerosol / absorbing;
    double above = SunColor.SOLAR_CONSTANT * cosine;
    double direct = above * .9662 * rayleigh * ozone * gases * water * aerosol;
    double scattered =
        above
            * .79
            * ozone
            * gases
            * water
            * absorbing
            * (.5 * (1 - rayleigh) + .84 * (1 - scattering))
            / (1 - mass + Math.pow(mass, 1.02));
    double sky = .0685 + (1 - .84) * (1 - scattering);
    double global = (direct + scattered) / (1 - ScatteredSun.GROUND * sky);
    return new Irradiance(direct, global - direct);
  }

  private static double gases(double mass) {
    return Math.exp(-.0127 * Math.pow(mass, .26));
  }

  private static double water(double mass) {
    double w = 1.5 * mass;
    return 1 - 2.4959 * w / (Math.pow(1 + 79.034 * w, .6828) + 6.385 * w);
  }

  /**
   * The model's irradiance over the sun's whole spectrum. Water and mixed gases absorb infrared
   * light, for which the model has no use: their part is Bird and Hulstrom's.
   */
  private static Irradiance model(double elevation) {
    double spacing = 50;
    double[] wavelengths = new double[74];
    for (int i = 0; i < wavelengths.length; i++) {
      wavelengths[i] = 300 + spacing * i + spacing / 2;
    }
    ScatteredSun light = new ScatteredSun(new Air(), wavelengths, elevation);
    double cosine = Math.sin(Math.toRadians(elevation));
    double mass = 1 / (cosine + .15 * Math.pow(93.885 - (90 - elevation), -1.25));
    double infrared = 0;
    for (double wavelength : wavelengths) {
      infrared += wavelength > 700 ? SunColor.irradiance(wavelength) * spacing : 0;
    }
    double absorbed = (1 - gases(mass) * water(mass)) * SunColor.SOLAR_CONSTANT / infrared;
    double direct = 0;
    double diffuse = 0;
    double[] sky = sky(light, wavelengths.length, elevation);
    for (int i = 0; i < wavelengths.length; i++) {
      double sun = SunColor.irradiance(wavelengths[i]) * spacing;
      sun *= wavelengths[i] > 700 ? 1 - absorbed : 1;
      direct += sun * light.direct(i) * cosine;
      diffuse += sun * sky[i];
    }
    return new Irradiance(direct, diffuse);
  }

  /** Returns the irradiance of level ground from the sky, by wavelength. */
  private static double[] sky(ScatteredSun light, int colors, double elevation) {
    double sunSine = Math.sin(Math.toRadians(elevation));
    double sunCosine = Math.cos(Math.toRadians(elevation));
    double[] sum = new double[colors];
    int rows = 24;
    int columns = 24;
    for (int row = 0; row < rows; row++) {
      double up = Math.sqrt((row + .5) / rows);
      for (int column = 0; column < columns; column++) {
        double towards = Math.cos(Math.PI * (column + .5) / columns);
        double[][] parts = new double[colors][3];
        light.add(up, towards, parts);
        double angle = up * sunSine + Math.sqrt(1 - up * up) * sunCosine * towards;
        for (int i = 0; i < colors; i++) {
          double radiance =
              parts[i][0] * ScatteredSun.molecules(angle)
                  + parts[i][1] * ScatteredSun.aerosol(angle)
                  + parts[i][2];
          sum[i] += radiance * Math.PI / (rows * columns);
        }
      }
    }
    return sum;
  }

  @ParameterizedTest
  @ValueSource(doubles = {10, 30, 60})
  void agreesWithBirdAndHulstrom(double elevation) {
    Irradiance expected = bird(elevation);
    Irradiance found = model(elevation);
    assertThat(found.direct() / expected.direct()).isCloseTo(1, within(.15));
    assertThat(found.diffuse() / expected.diffuse()).isCloseTo(1, within(.15));
  }

  @Test
  void aLowSunIsDarkerAndRedder() {
    Rgb higher = new ClearSky(0, 90).sun();
    for (double elevation : new double[] {60, 30, 10, 3}) {
      Rgb sun = new ClearSky(0, elevation).sun();
      assertThat(sun.luminance()).isLessThan(higher.luminance());
      assertThat(sun.g() / sun.r()).isLessThan(higher.g() / higher.r());
      assertThat(sun.b() / sun.g()).isLessThan(higher.b() / higher.g());
      higher = sun;
    }
  }

  @Test
  void theSkyIsBlueAboveAndPaleAtTheHorizon() {
    ClearSky sky = new ClearSky(0, 30);
    Rgb zenith = sky.at(.5, 1);
    Rgb horizon = sky.at(.5, .5);
    assertThat(zenith.b()).isGreaterThan(1.5 * zenith.r());
    assertThat(horizon.b()).isLessThan(1.1 * horizon.r());
    assertThat(horizon.luminance()).isGreaterThan(zenith.luminance());
  }

  @Test
  void whiteGroundAtNoonIsNearOne() {
    ClearSky sky = new ClearSky(0, 60);
    Rgb ground = sky.at(.2, .1);
    assertThat(ground.luminance() / ScatteredSun.GROUND).isBetween(.8, 1.2);
  }

  @Test
  void theGroundHasTheLightOfSunAndSky() {
    ClearSky sky = new ClearSky(20, 30);
    double sun = sky.sun().luminance() * .5;
    double expected = (sun + sky.horizontalIrradiance().luminance()) * ScatteredSun.GROUND;
    assertThat(sky.at(0, .2).luminance() * Math.PI).isCloseTo(expected, within(1e-12));
  }

  /** The bits are the same with all versions of Java. */
  @Test
  void hasTheSameBitsEverywhere() {
    ClearSky sky = new ClearSky(20, 30);
    Rgb sum = sky.sun().plus(sky.at(.3, .8)).plus(sky.at(.9, .51)).plus(sky.at(.1, .1));
    assertThat(sum).isEqualTo(new Rgb(4.2176427608003255, 3.3821482179268734, 2.4631556716508016));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1, 90.1, Double.NaN})
  void refusesPlacesBelowTheHorizon(double elevation) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new ClearSky(0, elevation))
        .withMessageContaining("expected an elevation from 0 to 90");
  }

  /** Between aphelion and perihelion, the sun has a diameter of 31.5 to 32.5 minutes of arc. */
  @Test
  void theSunHasItsSize() {
    assertThat(SunDisk.DIAMETER_DEGREES).isBetween(31.5 / 60, 32.5 / 60);
  }
}
