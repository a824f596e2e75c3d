package io.github.lumbre.parser;

import io.github.lumbre.text.PrintableText;

/**
 * The valid numbers of a key, and their description for error messages.
 *
 * @param low lower bound
 * @param openLow whether {@code low} itself is excluded
 * @param high upper bound
 * @param openHigh whether {@code high} itself is excluded
 * @param ifLow expected numbers, for a number that is too small
 * @param ifHigh expected numbers, for a number that is too large
 */
record Range(
    double low, boolean openLow, double high, boolean openHigh, String ifLow, String ifHigh) {
  static final Range ANY = closed(-Double.MAX_VALUE, Double.MAX_VALUE, "a finite number");
  static final Range NOT_NEGATIVE = closed(0, Double.MAX_VALUE, "a finite number >= 0");
  static final Range FROM_ONE = closed(1, Double.MAX_VALUE, "a finite number >= 1");
  static final Range POSITIVE =
      new Range(0, true, Double.MAX_VALUE, false, "a finite number > 0", "a finite number > 0");

  /** Extents of shapes: their squares must not overflow. */
  static final Range SIZE =
      new Range(0, true, 1e150, false, "a finite number > 0", "a number <= 1e150");

  /** Returns the closed range [low, high]; bounds of the largest doubles are not mentioned. */
  static Range closed(double low, double high) {
    if (high == Double.MAX_VALUE && (low == 0 || low == -high)) {
      return low == 0 ? NOT_NEGATIVE : ANY;
    }
    return closed(
        low,
        high,
        "a number from " + PrintableText.number(low) + " to " + PrintableText.number(high));
  }

  private static Range closed(double low, double high, String expected) {
    return new Range(low, false, high, false, expected, expected);
  }

  /** Returns the open range (low, high). */
  static Range open(double low, double high) {
    String expected =
        "a number in (" + PrintableText.number(low) + ", " + PrintableText.number(high) + ")";
    return new Range(low, true, high, true, expected, expected);
  }

  /** Returns the half-open range (low, high]. */
  static Range above(double low, double high) {
    String expected =
        "a number in (" + PrintableText.number(low) + ", " + PrintableText.number(high) + "]";
    return new Range(low, true, high, false, expected, expected);
  }

  boolean contains(double x) {
    return (openLow ? x > low : x >= low) && (openHigh ? x < high : x <= high);
  }

  /** Returns the expected numbers as text, for a number outside the range. */
  String expectedFor(double x) {
    return x > high || openHigh && x == high ? ifHigh : ifLow;
  }
}
