package io.github.lumbre.image;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/** How linear light becomes the values of a picture file with few bits. */
public enum ToneCurve {
  /** Clamp to [0,1], then the sRGB curve. */
  SRGB("srgb") {
    @Override
    public Rgb apply(Rgb linear) {
      return encode(linear);
    }
  },
  /** The 2016 report's: clamp, then v^(1/2.2). */
  GAMMA22("gamma22") {
    @Override
    public Rgb apply(Rgb linear) {
      return new Rgb(gamma(linear.r()), gamma(linear.g()), gamma(linear.b()));
    }
  },
  /** c / (1 + Y), then sRGB (Reinhard et al. 2002, on luminance Y). */
  REINHARD("reinhard") {
    @Override
    public Rgb apply(Rgb linear) {
      return encode(compressed(linear));
    }
  },
  /** x(2.51x+.03) / (x(2.43x+.59)+.14) for each channel, clamped, then sRGB (Narkowicz 2015). */
  ACES("aces") {
    @Override
    public Rgb apply(Rgb linear) {
      return encode(new Rgb(filmic(linear.r()), filmic(linear.g()), filmic(linear.b())));
    }
  };

  private static final double HUGE = 1e100;

  /** From here on the filmic curve is above 1, so that nothing is lost by stopping. */
  private static final double FILMIC_WHITE = 100;

  private final String label;

  ToneCurve(String label) {
    this.label = label;
  }

  /**
   * Returns the encoded values in [0,1] that a display is to show.
   *
   * @param linear any finite values; negative ones count as 0
   */
  public abstract Rgb apply(Rgb linear);

  /** Returns the name in scene files and on the command line. */
  public String label() {
    return label;
  }

  /** Returns the curve with that label, or empty if there is none. */
  public static Optional<ToneCurve> of(String label) {
    Objects.requireNonNull(label, "label");
    return Arrays.stream(values()).filter(curve -> curve.label.equals(label)).findFirst();
  }

  /** Returns whether the last step of this curve is the sRGB curve. */
  boolean endsInSrgb() {
    return this != GAMMA22;
  }

  private static Rgb encode(Rgb c) {
    return new Rgb(Srgb.encode(c.r()), Srgb.encode(c.g()), Srgb.encode(c.b()));
  }

  private static double gamma(double v) {
    return StrictMath.pow(Srgb.clamp(v), 1 / 2.2);
  }

  private static Rgb compressed(Rgb c) {
    Rgb positive = new Rgb(Math.max(0, c.r()), Math.max(0, c.g()), Math.max(0, c.b()));
    double max = positive.max();
    if (max <= HUGE) {
      return positive.times(1 / (1 + positive.luminance()));
    }
    // Divide by the largest component first: the luminance itself could overflow.
    Rgb scaled = positive.times(1 / HUGE).times(HUGE / max);
    return scaled.times(1 / (1 / max + scaled.luminance()));
  }

  private static double filmic(double v) {
    double x = Math.max(0, Math.min(v, FILMIC_WHITE));
    return x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
  }
}
