package io.github.lumbre.image;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/** The tone curves, which map linear light to the encoded values of a picture for display. */
public enum ToneCurve {
  /** Clamps to [0,1], then applies the sRGB curve. */
  SRGB("srgb") {
    @Override
    public Rgb apply(Rgb linear) {
      return encode(linear);
    }
  },
  /** Clamps to [0,1], then applies v^(1/2.2), as the 2016 report does. */
  GAMMA22("gamma22") {
    @Override
    public Rgb apply(Rgb linear) {
      return new Rgb(gamma(linear.r()), gamma(linear.g()), gamma(linear.b()));
    }
  },
  /** c / (1 + Y) with luminance Y, then the sRGB curve (Reinhard et al. 2002). */
  REINHARD("reinhard") {
    @Override
    public Rgb apply(Rgb linear) {
      return encode(compressed(linear));
    }
  },
  /**
   * x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) for each channel, clamped to [0,1], then the
   * sRGB curve (Narkowicz 2015).
   */
  ACES("aces") {
    @Override
    public Rgb apply(Rgb linear) {
      return encode(new Rgb(filmic(linear.r()), filmic(linear.g()), filmic(linear.b())));
    }
  };

  private static final double HUGE = 1e100;

  /** Larger values are clamped to this one: the filmic curve exceeds 1 from here on anyway. */
  private static final double FILMIC_WHITE = 100;

  private final String label;

  ToneCurve(String label) {
    this.label = label;
  }

  /**
   * Returns the encoded values in [0,1] for display.
   *
   * @param linear any finite values; negative ones count as 0
   */
  public abstract Rgb apply(Rgb linear);

  /** Returns the name of the curve in scene files and on the command line. */
  public String label() {
    return label;
  }

  /** Returns the curve with the given label; empty if there is none. */
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
    // Divide by the largest component first, because the luminance could overflow.
    Rgb scaled = positive.times(1 / HUGE).times(HUGE / max);
    return scaled.times(1 / (1 / max + scaled.luminance()));
  }

  private static double filmic(double v) {
    double x = Math.max(0, Math.min(v, FILMIC_WHITE));
    return x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
  }
}
