package io.github.lumbre.image.animation;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A constant number of frames in a number of seconds, in lowest terms: 25/1, or 30000/1001.
 * Immutable.
 *
 * @param frames 1 to 65535
 * @param seconds 1 to 65535; at most {@link #LONGEST_FRAME} times {@code frames}
 */
public record FrameRate(int frames, int seconds) {
  /** The longest time of a frame, in seconds. */
  public static final int LONGEST_FRAME = 600;

  private static final int MAX = 65535;
  private static final Pattern DECIMAL = Pattern.compile("([0-9]{1,5})(?:\\.([0-9]{1,4}))?");
  private static final Pattern FRACTION = Pattern.compile("([0-9]{1,5})/([0-9]{1,5})");

  /** Creates a rate; reduces the fraction. */
  public FrameRate {
    int divisor = divisor(frames, seconds);
    if (divisor > 0) {
      frames /= divisor;
      seconds /= divisor;
    }
    if (frames < 1
        || frames > MAX
        || seconds < 1
        || seconds > Math.min(MAX, LONGEST_FRAME * frames)) {
      throw new IllegalArgumentException(
          "expected 1/%d to %d frames per second, as a fraction of numbers up to %d, found %d/%d"
              .formatted(LONGEST_FRAME, MAX, MAX, frames, seconds));
    }
  }

  /**
   * Returns the rate that a text states: {@code 25}, {@code 12.5} or {@code 30000/1001} frames per
   * second.
   *
   * @throws IllegalArgumentException if the text states no rate, or a rate out of range
   */
  public static FrameRate parse(String text) {
    Matcher fraction = FRACTION.matcher(text);
    if (fraction.matches()) {
      return new FrameRate(
          Integer.parseInt(fraction.group(1)), Integer.parseInt(fraction.group(2)));
    }
    Matcher decimal = DECIMAL.matcher(text);
    if (!decimal.matches()) {
      throw new IllegalArgumentException(
          "expected frames per second such as 25, 12.5 or 30000/1001, found " + text);
    }
    String digits = decimal.group(2) == null ? "" : decimal.group(2);
    int scale = 1;
    for (int i = 0; i < digits.length(); i++) {
      scale *= 10;
    }
    return new FrameRate(Integer.parseInt(decimal.group(1) + digits), scale);
  }

  /** Returns the greatest common divisor of two numbers that are not both 0. */
  private static int divisor(int a, int b) {
    return b == 0 ? a : divisor(b, a % b);
  }

  /**
   * Returns the time of a frame in hundredths of a second. The sum of the times of any number of
   * frames from the first one on is the exact sum, rounded to the nearest hundredth.
   *
   * @param frame counted from 0
   */
  public int hundredths(int frame) {
    return (int) (rounded(frame + 1L) - rounded(frame));
  }

  /** Returns the time of a number of frames in hundredths of a second; halves are rounded up. */
  private long rounded(long count) {
    return (200 * count * seconds + frames) / (2L * frames);
  }

  /** Returns whether there are more frames per second than a whole number. */
  boolean isAbove(int perSecond) {
    return frames > (long) perSecond * seconds;
  }

  /** Returns the frames per second: {@code 25}, or {@code 30000/1001}. */
  @Override
  public String toString() {
    return frames + (seconds == 1 ? "" : "/" + seconds);
  }
}
