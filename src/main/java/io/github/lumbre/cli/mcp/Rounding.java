package io.github.lumbre.cli.mcp;

import io.github.lumbre.math.Vec3;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Rounds the lengths in results to a millionth of a model's diagonal, or finer, so that they have
 * no digits that say nothing. Matrices and counts stay as they are. Immutable.
 *
 * @param digits of lengths after the decimal point; negative for tens and more
 */
record Rounding(int digits) {
  private static final double FINENESS = 1e-6;

  /** The digits of numbers that are no lengths, such as components of unit vectors. */
  private static final int OTHERS = 6;

  private static final int MOST = 400;

  private static final Set<String> LENGTHS =
      Set.of("bounds", "depth", "position", "origin", "shift", "distance");

  private static final Set<String> OTHER_NUMBERS = Set.of("normal", "seconds", "degrees");

  /** Returns the rounding for a box; of none if the box is a point or is not finite. */
  static Rounding of(Vec3 min, Vec3 max) {
    double step = FINENESS * max.minus(min).length();
    if (!(step > 0 && step < Double.POSITIVE_INFINITY)) {
      return new Rounding(MOST);
    }
    BigDecimal exact = new BigDecimal(step);
    return new Rounding(exact.scale() - exact.precision() + 1);
  }

  /** Returns values whose lengths are rounded. */
  Map<String, Object> values(Map<String, Object> values) {
    Map<String, Object> rounded = new LinkedHashMap<>();
    values.forEach((key, value) -> rounded.put(key, value(key, value)));
    return rounded;
  }

  @SuppressWarnings("unchecked") // The keys of results are texts.
  private Object value(String key, Object value) {
    if (value instanceof Map<?, ?> members) {
      return values((Map<String, Object>) members);
    }
    if (value instanceof List<?> elements) {
      return elements.stream().map(element -> value(key, element)).toList();
    }
    if (value instanceof Double number && (LENGTHS.contains(key) || OTHER_NUMBERS.contains(key))) {
      return number(number, LENGTHS.contains(key) ? digits : OTHERS);
    }
    return value;
  }

  private static double number(double exact, int digits) {
    if (digits >= MOST || !Double.isFinite(exact)) {
      return exact;
    }
    double rounded = new BigDecimal(exact).setScale(digits, RoundingMode.HALF_EVEN).doubleValue();
    return Double.isFinite(rounded) ? rounded : exact;
  }
}
