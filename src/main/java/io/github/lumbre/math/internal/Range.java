package io.github.lumbre.math.internal;

import io.github.lumbre.base.text.PrintableText;
import java.util.function.DoublePredicate;

/**
 * The valid numbers of a parameter, and their description for error messages. Programs and scene
 * files are checked by the same one. Immutable.
 *
 * @param low lower bound, which {@code accepts} may exclude
 * @param high upper bound, which {@code accepts} may exclude
 * @param accepts whether a number is valid
 * @param ifLow expected numbers, for a number that is too small
 * @param ifHigh expected numbers, for a number that is too large
 */
public record Range(
    double low, double high, DoublePredicate accepts, String ifLow, String ifHigh) {
  public static final Range ANY = closed(-Double.MAX_VALUE, Double.MAX_VALUE, "a finite number");
  public static final Range NOT_NEGATIVE = closed(0, Double.MAX_VALUE, "a finite number >= 0");
  public static final Range FROM_ONE = closed(1, Double.MAX_VALUE, "a finite number >= 1");
  public static final Range POSITIVE =
      above(0, Double.MAX_VALUE, "a finite number > 0", "a finite number > 0");
  public static final Range FRACTION = closed(0, 1);

  /** Extents of shapes: their squares must not overflow. */
  public static final Range SIZE = above(0, 1e150, "a finite number > 0", "a number <= 1e150");

  /** Returns the closed range [low, high]; bounds of the largest doubles are not mentioned. */
  public static Range closed(double low, double high) {
    if (high == Double.MAX_VALUE && (low == 0 || low == -high)) {
      return low == 0 ? NOT_NEGATIVE : ANY;
    }
    return closed(
        low,
        high,
        "a number from " + PrintableText.number(low) + " to " + PrintableText.number(high));
  }

  private static Range closed(double low, double high, String expected) {
    return new Range(low, high, x -> x >= low && x <= high, expected, expected);
  }

  /** Returns the open range (low, high). */
  public static Range open(double low, double high) {
    String expected =
        "a number in (" + PrintableText.number(low) + ", " + PrintableText.number(high) + ")";
    return new Range(low, high, x -> x > low && x < high, expected, expected);
  }

  /** Returns the half-open range (low, high]. */
  public static Range above(double low, double high) {
    String expected =
        "a number in (" + PrintableText.number(low) + ", " + PrintableText.number(high) + "]";
    return above(low, high, expected, expected);
  }

  private static Range above(double low, double high, String ifLow, String ifHigh) {
    return new Range(low, high, x -> x > low && x <= high, ifLow, ifHigh);
  }

  /** Returns these numbers and 0. */
  public Range orZero() {
    return new Range(
        low, high, x -> x == 0 || accepts.test(x), "0 or " + ifLow, "0 or " + ifHigh);
  }

  public boolean contains(double x) {
    return accepts.test(x);
  }

  /** Returns the expected numbers as text, for a number outside the range. */
  public String expectedFor(double x) {
    return x >= high ? ifHigh : ifLow;
  }

  /**
   * Returns a number if it is in the range.
   *
   * @param name of the parameter
   * @throws IllegalArgumentException if it is not
   */
  public double require(String name, double x) {
    if (!contains(x)) {
      throw new IllegalArgumentException(name + ": expected " + expectedFor(x) + ", found " + x);
    }
    return x;
  }
}
