package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the sun's position against published values. */
class SunPositionTest {
  /** The error that the formulas claim, in degrees. */
  private static final double ERROR = .01;

  /** Reda and Andreas 2003, "Solar Position Algorithm", table A5.1, without refraction. */
  @Test
  void agreesWithTheSolarPositionAlgorithm() {
    SunPosition sun = SunPosition.of(39.742476, -105.1786, Instant.parse("2003-10-17T19:30:30Z"));
    assertThat(sun.azimuth()).isCloseTo(194.34024, within(ERROR / cosine(39.872046)));
    assertThat(sun.elevation()).isCloseTo(39.872046, within(ERROR));
  }

  /** Meeus 1998, "Astronomical Algorithms", example 25.b: seen from the pole, a declination. */
  @Test
  void agreesWithMeeus() {
    SunPosition sun = SunPosition.of(90, 0, Instant.parse("1992-10-13T00:00:00Z"));
    assertThat(sun.elevation()).isCloseTo(-7.783872, within(ERROR));
  }

  /** The sun crosses the equator at equinoxes, and its declination is the obliquity in June. */
  @ParameterizedTest
  @CsvSource({
    "2026-03-20T14:46:00Z, 0",
    "2026-09-23T00:05:00Z, 0",
    "2026-06-21T08:24:00Z, 23.436",
    "2026-12-21T20:50:00Z, -23.436"
  })
  void seasonsBeginAtTheirTimes(Instant time, double declination) {
    assertThat(SunPosition.of(90, 0, time).elevation()).isCloseTo(declination, within(ERROR));
    assertThat(SunPosition.of(-90, 0, time).elevation()).isCloseTo(-declination, within(ERROR));
  }

  /** Noon is in the south of Munich and in the north of Sydney; mornings are in the east. */
  @Test
  void theSunRisesInTheEast() {
    assertThat(SunPosition.of(48.1, 11.6, Instant.parse("2026-06-21T11:15:00Z")).azimuth())
        .isCloseTo(180, within(1.));
    assertThat(SunPosition.of(-33.9, 151.2, Instant.parse("2026-06-21T01:57:00Z")).azimuth())
        .matches(azimuth -> Math.abs(Math.IEEEremainder(azimuth, 360)) < 1);
    assertThat(SunPosition.of(48.1, 11.6, Instant.parse("2026-03-20T05:15:00Z")).azimuth())
        .isCloseTo(90, within(2.));
  }

  private static double cosine(double degrees) {
    return Math.cos(Math.toRadians(degrees));
  }

  /** The bits are the same with all versions of Java. */
  @Test
  void hasTheSameBitsEverywhere() {
    assertThat(SunPosition.of(48.1, 11.6, Instant.parse("2026-06-21T12:00:00Z")))
        .isEqualTo(new SunPosition(203.67495732099562, 63.79387935845873));
  }

  @ParameterizedTest
  @ValueSource(doubles = {-90.1, 91, Double.NaN})
  void refusesLatitudesBeyondThePoles(double latitude) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SunPosition.of(latitude, 0, Instant.parse("2026-06-21T12:00:00Z")))
        .withMessage("expected a latitude from -90 to 90, found " + latitude);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-180.1, 360, Double.NaN})
  void refusesLongitudesBeyondTheDateLine(double longitude) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SunPosition.of(0, longitude, Instant.parse("2026-06-21T12:00:00Z")))
        .withMessage("expected a longitude from -180 to 180, found " + longitude);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"1949-12-31T23:59:59Z", "2051-01-01T00:00:00Z", "+999999999-01-01T00:00:00Z"})
  void refusesTimesOutsideOfTheFormulas(Instant time) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> SunPosition.of(0, 0, time))
        .withMessage("expected a time from 1950 to 2050, found " + time);
  }
}
