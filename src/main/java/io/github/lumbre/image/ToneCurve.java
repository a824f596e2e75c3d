package io.github.lumbre.image;

import io.github.lumbre.image.internal.Srgb;
import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;

/** The tone curves, which map linear light to the encoded values of a picture for display. */
public enum ToneCurve {
  /** Clamps to [0,1], then applies the sRGB curve. */
  SRGB("srgb") {
    @Override
    public Rgb mapped(Rgb linear) {
      return linear;
    }
  },
  /** Clamps to [0,1], then applies v^(1/2.2), as the 2016 report does. */
  GAMMA22("gamma22") {
    @Override
    public Rgb mapped(Rgb linear) {
      return linear;
    }

    @Override
    public Rgb apply(Rgb linear) {
      return new Rgb(gamma(linear.r()), gamma(linear.g()), gamma(linear.b()));
    }
  },
  /** c / (1 + Y) with luminance Y, then the sRGB curve (Reinhard et al. 2002). */
  REINHARD("reinhard") {
    @Override
    public Rgb mapped(Rgb linear) {
      return compressed(linear);
    }
  },
  /**
   * x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14) for each channel, clamped to [0,1], then the
   * sRGB curve (Narkowicz 2015).
   */
  ACES("aces") {
    @Override
    public Rgb mapped(Rgb linear) {
      return new Rgb(filmic(linear.r()), filmic(linear.g()), filmic(linear.b()));
    }
  },
  /**
   * Khronos PBR Neutral: keeps colors up to 0.8 and compresses highlights (Khronos Group 2024, "PBR
   * Neutral Tone Mapper Specification"), then sRGB.
   */
  NEUTRAL("neutral") {
    @Override
    public Rgb mapped(Rgb linear) {
      return neutral(linear);
    }
  },
  /** AgX with its base look (Sobotka 2022; polynomial of Wrensch 2023), then sRGB. */
  AGX("agx") {
    @Override
    public Rgb mapped(Rgb linear) {
      return agx(linear);
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
  public Rgb apply(Rgb linear) {
    Rgb c = mapped(linear);
    return new Rgb(Srgb.encode(c.r()), Srgb.encode(c.g()), Srgb.encode(c.b()));
  }

  /** Returns the light to which the last step, such as the sRGB curve, is applied. */
  public abstract Rgb mapped(Rgb linear);

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
  public boolean endsInSrgb() {
    return this != GAMMA22;
  }

  private static double gamma(double v) {
    return StrictMath.pow(Srgb.clamp(v), 1 / 2.2);
  }

  private static Rgb positive(Rgb c) {
    return new Rgb(
        Math.max(0, Math.min(c.r(), HUGE)),
        Math.max(0, Math.min(c.g(), HUGE)),
        Math.max(0, Math.min(c.b(), HUGE)));
  }

  private static Rgb neutral(Rgb linear) {
    Rgb c = positive(linear);
    double least = Math.min(c.r(), Math.min(c.g(), c.b()));
    double offset = least < .08 ? least - 6.25 * least * least : .04;
    Rgb shifted = c.plus(Rgb.gray(-offset));
    double peak = shifted.max();
    double start = .8 - .04;
    if (peak < start) {
      return shifted;
    }
    double range = 1 - start;
    double newPeak = 1 - range * range / (peak + range - start);
    double share = 1 - 1 / (.15 * (peak - newPeak) + 1);
    return shifted.times(newPeak / peak * (1 - share)).plus(Rgb.gray(newPeak * share));
  }

  private static Rgb agx(Rgb linear) {
    Rgb c = positive(linear);
    Rgb inset =
        new Rgb(
            .842479062253094 * c.r() + .0784335999999992 * c.g() + .0792237451477643 * c.b(),
            .0423282422610123 * c.r() + .878468636469772 * c.g() + .0791661274605434 * c.b(),
            .0423756549057051 * c.r() + .0784336 * c.g() + .879142973793104 * c.b());
    double r = sigmoid(inset.r());
    double g = sigmoid(inset.g());
    double b = sigmoid(inset.b());
    return new Rgb(
        outset(1.19687900512017 * r - .0980208811401368 * g - .0990297440797205 * b),
        outset(-.0528968517574562 * r + 1.15190312990417 * g - .0989611768448433 * b),
        outset(-.0529716355144438 * r - .0980434501171241 * g + 1.15107367264116 * b));
  }

  /** Returns the display value of a channel: a curve over the logarithm of its value. */
  private static double sigmoid(double v) {
    double stops = StrictMath.log(Math.max(v, 1e-10)) / StrictMath.log(2);
    double x = (Math.max(-12.47393, Math.min(4.026069, stops)) + 12.47393) / (12.47393 + 4.026069);
    double x2 = x * x;
    double x4 = x2 * x2;
    return 15.5 * x4 * x2
        - 40.14 * x4 * x
        + 31.96 * x4
        - 6.868 * x2 * x
        + .4298 * x2
        + .1191 * x
        - .00232;
  }

  private static double outset(double display) {
    return StrictMath.pow(Math.max(0, Math.min(1, display)), 2.2);
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
