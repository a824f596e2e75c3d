package io.github.lumbre.image;

import java.util.OptionalDouble;

/**
 * The exposure of a finished picture: a fixed number of stops, or automatic.
 *
 * @param stops number of stops, each of which doubles the brightness; empty for automatic exposure
 */
public record Exposure(OptionalDouble stops) {
  /** No change of brightness. */
  public static final Exposure NONE = of(0);

  /** Automatic exposure: scales the geometric mean of the luminances to 18 % gray. */
  public static final Exposure AUTO = new Exposure(OptionalDouble.empty());

  /**
   * @throws IllegalArgumentException if the number of stops is not finite
   */
  public Exposure {
    if (stops.isPresent() && !Double.isFinite(stops.getAsDouble())) {
      throw new IllegalArgumentException(
          "stops: expected a finite number, found " + stops.getAsDouble());
    }
  }

  /** Returns the exposure of a fixed number of stops. */
  public static Exposure of(double stops) {
    return new Exposure(OptionalDouble.of(stops));
  }

  /**
   * Returns the factor by which a picture is multiplied. Automatic exposure uses 0.18 / exp(mean of
   * ln max(Y, 1e-6)) over the pixels with luminance Y &gt; 0, and 1 for a black picture. An
   * infinite luminance counts as {@link Float#MAX_VALUE}.
   */
  public double factor(Image image) {
    return stops.isPresent() ? StrictMath.pow(2, stops.getAsDouble()) : automatic(image);
  }

  // Java would make the code of the next two at the first call, which delays each start.

  @Override
  public boolean equals(Object other) {
    return other instanceof Exposure exposure && stops.equals(exposure.stops);
  }

  @Override
  public int hashCode() {
    return stops.hashCode();
  }

  private static double automatic(Image image) {
    double sum = 0;
    long count = 0;
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < image.width(); x++) {
        double luminance = image.pixel(x, y).luminance();
        if (luminance > 0) {
          sum += StrictMath.log(Math.max(Math.min(luminance, Float.MAX_VALUE), 1e-6));
          count++;
        }
      }
    }
    return count == 0 ? 1 : .18 / StrictMath.exp(sum / count);
  }
}
