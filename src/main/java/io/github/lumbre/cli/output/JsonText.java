package io.github.lumbre.cli.output;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonPrimitive;
import com.google.gson.JsonSerializer;
import java.math.BigDecimal;
import java.math.MathContext;

/** Writes values as JSON, with the same digits on all versions of Java. Stateless. */
public final class JsonText {
  /** Decimals with this number of digits may be those of a number that was stated. */
  private static final int STATED_DIGITS = 15;

  private static final JsonSerializer<Double> NUMBERS =
      (number, type, context) -> new JsonPrimitive(decimal(number));

  private static final Gson LINE = builder().disableHtmlEscaping().create();
  private static final Gson COMPLETE =
      builder().disableHtmlEscaping().serializeNulls().create();
  private static final Gson PRETTY = builder().setPrettyPrinting().create();

  private JsonText() {}

  private static GsonBuilder builder() {
    return new GsonBuilder().registerTypeAdapter(Double.class, NUMBERS);
  }

  /**
   * Returns a value in one line.
   *
   * @throws IllegalArgumentException if a number in it is not finite
   */
  public static String line(Object value) {
    return LINE.toJson(value);
  }

  /**
   * Returns a value in one line, with the members that are null.
   *
   * @throws IllegalArgumentException if a number in it is not finite
   */
  public static String completeLine(Object value) {
    return COMPLETE.toJson(value);
  }

  /**
   * Returns a value in several lines.
   *
   * @throws IllegalArgumentException if a number in it is not finite
   */
  public static String pretty(Object value) {
    return PRETTY.toJson(value);
  }

  /**
   * Returns a decimal that is read as the same number: the shortest one, up to rounding. All
   * versions of Java return the same one, unlike {@link Double#toString(double)}.
   *
   * @param x finite
   */
  private static BigDecimal decimal(double x) {
    BigDecimal exact = new BigDecimal(x);
    int digits = STATED_DIGITS;
    BigDecimal rounded = exact.round(new MathContext(digits));
    while (rounded.doubleValue() != x) {
      rounded = exact.round(new MathContext(++digits));
    }
    BigDecimal shown = rounded.stripTrailingZeros();
    return shown.scale() < 1 && shown.precision() - shown.scale() <= STATED_DIGITS
        ? shown.setScale(1)
        : shown;
  }
}
