package io.github.lumbre.base.text;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Map;

/** Numbers and units as people read them, on labels and in texts. Stateless. */
public final class Quantities {
  private static final MathContext DIGITS = new MathContext(4);
  private static final MathContext ONE_DIGIT = new MathContext(1, RoundingMode.DOWN);

  /** Numbers with more zeros than this, before or after the point, have an exponent. */
  private static final int MOST_ZEROS = 6;

  private static final Map<String, String> SYMBOLS =
      Map.of(
          "micron", "µm",
          "millimeter", "mm",
          "centimeter", "cm",
          "inch", "in",
          "foot", "ft",
          "meter", "m");

  private Quantities() {}

  /** Returns a finite number with four significant digits, such as 12.35 or 1.235e-9. */
  public static String text(double value) {
    return text(new BigDecimal(value).round(DIGITS).stripTrailingZeros());
  }

  private static String text(BigDecimal value) {
    boolean isPlain =
        value.scale() >= -MOST_ZEROS && value.scale() - value.precision() < MOST_ZEROS;
    return isPlain ? value.toPlainString() : value.toString().replace("E+", "e").replace('E', 'e');
  }

  /** Returns a number with its unit; the number alone if there is none. */
  public static String text(double value, String unit) {
    return unit.isEmpty() ? text(value) : text(value) + " " + symbol(unit);
  }

  /** Returns the symbol of a unit, such as mm for millimeter; its name if it has none. */
  public static String symbol(String unit) {
    return SYMBOLS.getOrDefault(unit, unit);
  }

  /** Returns the largest of 1, 2, 5, 10, 20 and so on, and of 0.5, 0.2, 0.1, up to a number. */
  public static double roundDown(double value) {
    BigDecimal digit = new BigDecimal(value).round(ONE_DIGIT);
    int first = digit.unscaledValue().intValueExact();
    int round = first >= 5 ? 5 : first >= 2 ? 2 : 1;
    return new BigDecimal(BigInteger.valueOf(round), digit.scale()).doubleValue();
  }
}
