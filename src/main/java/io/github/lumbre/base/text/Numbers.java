package io.github.lumbre.base.text;

import java.util.Locale;

/** Formats numbers for reports. */
public final class Numbers {
  private Numbers() {}

  /** Returns a share as a percentage with two digits, or three from 99.5 % on; 0 is 0 %. */
  public static String percent(double share) {
    if (share == 0) {
      return "0 %";
    }
    return String.format(Locale.ROOT, share >= .1 ? "%.0f %%" : "%.2g %%", 100 * share);
  }

  /** Returns a number with its noun, {@code 1 sample} or {@code 2 samples}. */
  public static String count(long number, String noun) {
    return number + " " + noun + (number == 1 ? "" : "s");
  }

  /** Returns a rate per second; see {@link #large}. */
  public static String rate(long count, double seconds) {
    return large(seconds > 0 ? count / seconds : 0);
  }

  /** Returns a number with three digits, {@code 1.25 M}; a whole number below 1 million. */
  public static String large(double number) {
    if (number >= 1e6) {
      return number >= 1e9
          ? String.format(Locale.ROOT, "%.3g G", number / 1e9)
          : String.format(Locale.ROOT, "%.3g M", number / 1e6);
    }
    return String.format(Locale.ROOT, "%.0f", number);
  }
}
