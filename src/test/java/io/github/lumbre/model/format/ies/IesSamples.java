package io.github.lumbre.model.format.ies;

import io.github.lumbre.math.Vec3;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleBinaryOperator;

/** Photometric files that tests make. */
public final class IesSamples {
  /** A file with everything that may be there: keywords, a table of tilts, factors, opening. */
  public static final String FULL =
      """
      IESNA:LM-63-2002
      [TEST] 1
      [MANUFAC] Lumbre
      [LUMINAIRE] Wallwasher
      TILT=INCLUDE
      1
      3
      0 45 90
      1 .9 .8
      2 1000 2 3 2 1 2 0.1 0.1 0
      0.9 1 50
      0 45 90
      0 90
      100 80 0
      100 60 0
      """;

  /** A file of 1986: no first line, numbers that are broken over lines, a factor of two parts. */
  public static final String OLD =
      """
      An old lamp, with commas
      TILT=NONE
      1, 1000, 1, 3,
      1, 1, 1, 0, 0, 0
      0.5, 0.5, 50
      0, 90,
      180
      0
      100, 80,
      60
      """;

  private IesSamples() {}

  /** Returns the bytes of a file. */
  public static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /**
   * Returns a file of a lamp.
   *
   * @param candela by vertical and horizontal angle, in degrees
   */
  public static String file(
      List<Double> vertical, List<Double> horizontal, DoubleBinaryOperator candela) {
    StringBuilder text = new StringBuilder("IESNA:LM-63-2002\nTILT=NONE\n");
    text.append("1 -1 1 %d %d 1 2 0 0 0\n".formatted(vertical.size(), horizontal.size()));
    text.append("1 1 10\n");
    vertical.forEach(angle -> text.append(angle).append('\n'));
    horizontal.forEach(angle -> text.append(angle).append('\n'));
    for (double azimuth : horizontal) {
      for (double polar : vertical) {
        text.append(String.format(Locale.ROOT, "%.9f ", candela.applyAsDouble(polar, azimuth)));
      }
      text.append('\n');
    }
    return text.toString();
  }

  /** Returns a direction by its angles in degrees. */
  public static Vec3 direction(double polar, double azimuth) {
    double p = Math.toRadians(polar);
    double a = Math.toRadians(azimuth);
    double sine = StrictMath.sin(p);
    return new Vec3(sine * StrictMath.cos(a), sine * StrictMath.sin(a), StrictMath.cos(p));
  }
}
