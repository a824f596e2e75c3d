package io.github.lumbre.image.compare;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.math.internal.Elementary;

/**
 * The structural similarity of two pictures (Wang, Bovik, Sheikh &amp; Simoncelli 2004, "Image
 * Quality Assessment: From Error Visibility to Structural Similarity"): 1 for identical pictures, 0
 * for unrelated ones. It compares the encoded luminance in [0,1].
 *
 * <p>The window is the paper's, a Gaussian of 1.5 pixels over 11 x 11 pixels. At the border it
 * repeats the nearest pixels, so that small pictures also have a similarity.
 */
final class Ssim {
  private static final int REACH = 5;
  private static final double SPREAD = 1.5;
  private static final double C1 = .01 * .01;
  private static final double C2 = .03 * .03;

  private Ssim() {}

  /** Returns the mean similarity of two pictures of the same size, at most 1. */
  static double of(Image a, Image b) {
    return map(luma(a), luma(b)).mean();
  }

  private static Plane map(Plane a, Plane b) {
    Plane meanA = blurred(a);
    Plane meanB = blurred(b);
    Plane squareA = blurred(product(a, a));
    Plane squareB = blurred(product(b, b));
    Plane mixed = blurred(product(a, b));
    return Plane.of(
        a.width(),
        a.height(),
        i -> {
          double ma = meanA.values()[i];
          double mb = meanB.values()[i];
          double spread = squareA.values()[i] - ma * ma + squareB.values()[i] - mb * mb;
          double common = mixed.values()[i] - ma * mb;
          return (2 * ma * mb + C1)
              * (2 * common + C2)
              / ((ma * ma + mb * mb + C1) * (spread + C2));
        });
  }

  private static Plane luma(Image image) {
    return Plane.of(
        image.width(),
        image.height(),
        i -> {
          int x = i % image.width();
          int y = i / image.width();
          Rgb seen = image.pixel(x, y).times(image.alpha(x, y));
          return Srgb.encode(seen.luminance());
        });
  }

  private static Plane product(Plane a, Plane b) {
    return Plane.of(a.width(), a.height(), i -> a.values()[i] * b.values()[i]);
  }

  private static Plane blurred(Plane plane) {
    double[] weights = new double[2 * REACH + 1];
    double sum = 0;
    for (int i = -REACH; i <= REACH; i++) {
      weights[i + REACH] = Elementary.exp(-i * i / (2 * SPREAD * SPREAD));
      sum += weights[i + REACH];
    }
    for (int i = 0; i < weights.length; i++) {
      weights[i] /= sum;
    }
    return plane.convolved(weights, weights);
  }
}
