package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Rgb;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that the studio is bright, finite and smooth. */
class StudioSkyTest {
  private static final int COLUMNS = 256;
  private static final int ROWS = 128;

  private static double light(double u, double v) {
    return light(StudioSky.SOFT, u, v);
  }

  private static double light(StudioSky sky, double u, double v) {
    return sky.at(u, v).g();
  }

  @Test
  void lightIsGrayAndFinite() {
    for (int i = 0; i <= 64; i++) {
      for (int j = 0; j <= 32; j++) {
        Rgb light = StudioSky.SOFT.at(i / 64.0, j / 32.0);
        assertThat(light).isEqualTo(Rgb.gray(light.g()));
        assertThat(light.g()).isBetween(.2, 7.5);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"SOFT, .45", "RELIEF, .8"})
  void neighborsInTheTableDifferLittle(StudioSky sky, double most) {
    for (int i = 0; i < COLUMNS; i++) {
      for (int j = 0; j < ROWS; j++) {
        double u = (double) i / COLUMNS;
        double v = (double) j / ROWS;
        double here = light(sky, u, v);
        assertThat(light(sky, u + 1.0 / COLUMNS, v)).isCloseTo(here, within(most));
        assertThat(light(sky, u, v + 1.0 / ROWS)).isCloseTo(here, within(most));
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void seamAndPolesAreClosed(StudioSky sky) {
    for (int j = 0; j <= 32; j++) {
      assertThat(light(sky, 0, j / 32.0)).isCloseTo(light(sky, 1, j / 32.0), within(1e-12));
      assertThat(light(sky, j / 32.0, 1)).isCloseTo(light(sky, .5, 1), within(1e-12));
      assertThat(light(sky, j / 32.0, 0)).isCloseTo(light(sky, .5, 0), within(1e-12));
    }
  }

  /** The key light stands to the left in front of the object: behind the camera's left shoulder. */
  @Test
  void keyLightIsTheBrightest() {
    double azimuth = Math.atan2(-.55, -.58) / (2 * Math.PI);
    double elevation = Math.asin(.6 / Math.sqrt(.55 * .55 + .6 * .6 + .58 * .58)) / Math.PI;
    double key = light(.5 + azimuth, .5 + elevation);
    assertThat(key).isGreaterThan(4);
    for (int i = 0; i < 64; i++) {
      for (int j = 0; j < 32; j++) {
        assertThat(light(i / 64.0, j / 32.0)).isLessThanOrEqualTo(key + .05);
      }
    }
  }
}
