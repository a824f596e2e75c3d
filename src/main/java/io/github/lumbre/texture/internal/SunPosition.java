package io.github.lumbre.texture.internal;

import io.github.lumbre.math.internal.Elementary;
import java.time.Instant;

/**
 * The place of the sun's center in the sky, without refraction.
 *
 * @param azimuth degrees from north, 90 in the east, in [0, 360]
 * @param elevation degrees above the horizon, in [-90, 90]
 */
public record SunPosition(double azimuth, double elevation) {
  private static final Instant FIRST = Instant.parse("1950-01-01T00:00:00Z");
  private static final Instant LAST = Instant.parse("2051-01-01T00:00:00Z");

  /** The noon from which days are counted. */
  private static final Instant J2000 = Instant.parse("2000-01-01T12:00:00Z");

  private static final double SECONDS_PER_DAY = 86400;

  /**
   * Returns the sun's position by the formulas for low precision of the Astronomical Almanac (page
   * C5), which are right to about 0.01 degrees.
   *
   * @param latitude degrees to the north of the equator, -90 to 90
   * @param longitude degrees to the east of Greenwich, -180 to 180
   * @param time from 1950 to 2050
   * @throws IllegalArgumentException if an argument is out of its range
   */
  public static SunPosition of(double latitude, double longitude, Instant time) {
    require(Math.abs(latitude) <= 90, "a latitude from -90 to 90", latitude);
    require(Math.abs(longitude) <= 180, "a longitude from -180 to 180", longitude);
    require(!time.isBefore(FIRST) && time.isBefore(LAST), "a time from 1950 to 2050", time);
    double days = (time.getEpochSecond() - J2000.getEpochSecond()) / SECONDS_PER_DAY;
    double anomaly = 357.528 + .9856003 * days;
    double alongEcliptic =
        280.460
            + .9856474 * days
            + 1.915 * Elementary.sinDegrees(anomaly)
            + .020 * Elementary.sinDegrees(2 * anomaly);
    double obliquity = 23.439 - 4e-7 * days;
    double x = Elementary.cosDegrees(alongEcliptic);
    double y = Elementary.cosDegrees(obliquity) * Elementary.sinDegrees(alongEcliptic);
    double toPole = Elementary.sinDegrees(obliquity) * Elementary.sinDegrees(alongEcliptic);
    // Sidereal time by Meeus 1998, "Astronomical Algorithms", eq. 12.4.
    double meridian = 280.46061837 + 360.98564736629 * days + longitude;
    double sine = Elementary.sinDegrees(meridian);
    double cosine = Elementary.cosDegrees(meridian);
    double toMeridian = x * cosine + y * sine;
    double east = y * cosine - x * sine;
    double up = Elementary.sinDegrees(latitude);
    double across = Elementary.cosDegrees(latitude);
    double north = across * toPole - up * toMeridian;
    double azimuth = Elementary.atan2(east, north) / Elementary.TWO_PI;
    double elevation = Elementary.asin(across * toMeridian + up * toPole) / Elementary.TWO_PI;
    return new SunPosition(360 * (azimuth - Math.floor(azimuth)), 360 * elevation);
  }

  private static void require(boolean condition, String expected, Object found) {
    if (!condition) {
      throw new IllegalArgumentException("expected " + expected + ", found " + found);
    }
  }
}
