package io.github.lumbre.model.internal;

/** Parses simple decimal numbers fast, with the same bits as Double.parseDouble. Stateless. */
public final class Decimals {
  /** The largest exponent of a power of ten that a double represents exactly. */
  private static final int MAX_EXACT_POWER = 22;

  private static final long MAX_EXACT_INTEGER = 1L << 53;
  private static final double[] POWERS_OF_TEN = new double[MAX_EXACT_POWER + 1];

  static {
    POWERS_OF_TEN[0] = 1;
    for (int i = 1; i <= MAX_EXACT_POWER; i++) {
      POWERS_OF_TEN[i] = 10 * POWERS_OF_TEN[i - 1];
    }
  }

  private Decimals() {}

  /**
   * Returns a number, if it is an integer below 2^53 times or divided by a power of ten up to
   * 10^22; otherwise NaN. Both are exact doubles, so one operation rounds the result as
   * Double.parseDouble does (Clinger 1990, "How to Read Floating Point Numbers Accurately").
   *
   * @param start index of the first character
   * @param end index after the last character
   */
  public static double exact(byte[] text, int start, int end) {
    boolean negative = start < end && text[start] == '-';
    int i = negative ? start + 1 : start;
    long digits = 0;
    int exponent = 0;
    int count = 0;
    boolean hasPoint = false;
    for (; i < end; i++) {
      byte c = text[i];
      if (isDigit(c) && digits < MAX_EXACT_INTEGER / 10) {
        digits = 10 * digits + c - '0';
        exponent -= hasPoint ? 1 : 0;
        count++;
      } else if (c == '.' && !hasPoint) {
        hasPoint = true;
      } else {
        break;
      }
    }
    if (i < end) {
      int written = writtenExponent(text, i, end);
      if (written == Integer.MIN_VALUE) {
        return Double.NaN;
      }
      exponent += written;
    }
    if (count == 0 || Math.abs(exponent) > MAX_EXACT_POWER) {
      return Double.NaN;
    }
    double value =
        exponent < 0 ? digits / POWERS_OF_TEN[-exponent] : digits * POWERS_OF_TEN[exponent];
    return negative ? -value : value;
  }

  /** Returns an exponent of one or two digits, such as e-05; otherwise Integer.MIN_VALUE. */
  private static int writtenExponent(byte[] text, int from, int end) {
    boolean negative = from + 1 < end && text[from + 1] == '-';
    boolean positive = from + 1 < end && text[from + 1] == '+';
    int first = negative || positive ? from + 2 : from + 1;
    if ((text[from] | 0x20) != 'e' || first >= end || end - first > 2) {
      return Integer.MIN_VALUE;
    }
    int value = 0;
    for (int i = first; i < end; i++) {
      if (!isDigit(text[i])) {
        return Integer.MIN_VALUE;
      }
      value = 10 * value + text[i] - '0';
    }
    return negative ? -value : value;
  }

  private static boolean isDigit(byte c) {
    return c >= '0' && c <= '9';
  }
}
