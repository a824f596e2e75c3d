package io.github.lumbre.image.compare;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.compare.internal.HeatScale;
import io.github.lumbre.math.internal.Elementary;

/**
 * The perceived difference between two pictures when a viewer alternates between them on a screen
 * (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström &amp; Fairchild 2020, "FLIP: A Difference
 * Evaluator for Alternating Images", LDR-FLIP): 0 where they look identical, at most 1.
 *
 * <p>Linear light is clamped to [0,1]. As in the paper, the viewer is 0.7 m from a screen that is
 * 0.7 m wide with 3840 pixels: 67 pixels per degree. Equation numbers and names of constants are
 * the paper's. Stateless.
 */
public final class Flip {
  private static final double PIXELS_PER_DEGREE = .7 * 3840 / .7 * Math.PI / 180;

  /** The white point CIE D65 of sRGB. */
  private static final double[] WHITE = {.950428545377181, 1, 1.088900370798128};

  private static final double QC = .7;
  private static final double PC = .4;
  private static final double PT = .95;
  private static final double QF = .5;

  /** Width of the filters that detect edges and points, in degrees. */
  private static final double FEATURE_WIDTH = .082;

  /** Contrast sensitivity of luminance, red-green and blue-yellow: table 1. */
  private static final double[][] SENSITIVITY = {
    {1, .0047, 0, 1e-5}, {1, .0053, 0, 1e-5}, {34.1, .04, 13.5, .025}
  };

  /** The largest difference: between pure green and pure blue. */
  private static final double LARGEST =
      Elementary.pow(distance(lab(new double[] {0, 1, 0}), lab(new double[] {0, 0, 1})), QC);

  /** Heat colors of a difference picture, sRGB-encoded, evenly spaced from 0 to 1. */
  private static final int[][] HEAT = {
    {0, 0, 4}, {58, 12, 96}, {133, 33, 107}, {205, 64, 71}, {247, 125, 21}, {252, 255, 190}
  };

  private Flip() {}

  /**
   * Returns the mean of the differences at all pixels.
   *
   * @throws IllegalArgumentException if the pictures have different sizes
   */
  public static double mean(Image test, Image reference) {
    return map(test, reference).mean();
  }

  /**
   * Returns the mean of the differences in each tile, so that a small object that has changed is
   * not lost in a large picture.
   *
   * @param side of the square tiles in pixels, at least 1; tiles at the right and the lower edge
   *     may be smaller
   * @return numbers in [0,1] of the tiles, row by row from the top left
   * @throws IllegalArgumentException if the pictures have different sizes
   */
  public static double[] tiles(Image test, Image reference, int side) {
    Plane map = map(test, reference);
    int across = (map.width() + side - 1) / side;
    double[] means = new double[across * ((map.height() + side - 1) / side)];
    for (int i = 0; i < means.length; i++) {
      means[i] = mean(map, i % across * side, i / across * side, side);
    }
    return means;
  }

  private static double mean(Plane map, int left, int top, int side) {
    int right = Math.min(left + side, map.width());
    int bottom = Math.min(top + side, map.height());
    double sum = 0;
    for (int y = top; y < bottom; y++) {
      for (int x = left; x < right; x++) {
        sum += map.values()[y * map.width() + x];
      }
    }
    return sum / ((right - left) * (bottom - top));
  }

  /**
   * Returns a picture of the differences: black where the pictures look identical, purple, red,
   * orange, pale yellow at 1.
   *
   * @throws IllegalArgumentException if the pictures have different sizes
   */
  public static Image picture(Image test, Image reference) {
    Plane map = map(test, reference);
    float[] rgb = new float[3 * map.values().length];
    for (int i = 0; i < map.values().length; i++) {
      HeatScale.paint(map.values()[i], HEAT, rgb, 3 * i);
    }
    return new Image(map.width(), map.height(), rgb, new float[0]);
  }

  /** Returns the difference at every pixel of two pictures of the same size. */
  static Plane map(Image test, Image reference) {
    requireSameSize(test, reference);
    Plane[] testOpponent = opponents(test);
    Plane[] referenceOpponent = opponents(reference);
    Plane color = colorDifference(testOpponent, referenceOpponent);
    Plane features = featureDifference(testOpponent[0], referenceOpponent[0]);
    return Plane.of(
        color.width(),
        color.height(),
        i -> Elementary.pow(color.values()[i], 1 - features.values()[i]));
  }

  static void requireSameSize(Image test, Image reference) {
    if (test.width() != reference.width() || test.height() != reference.height()) {
      throw new IllegalArgumentException(
          "reference: expected %dx%d pixels, found %dx%d"
              .formatted(test.width(), test.height(), reference.width(), reference.height()));
    }
  }

  /** Returns the planes of YCxCz (sec. 4.1). */
  private static Plane[] opponents(Image image) {
    Plane[] planes = new Plane[3];
    for (int c = 0; c < 3; c++) {
      planes[c] =
          new Plane(image.width(), image.height(), new double[image.width() * image.height()]);
    }
    for (int i = 0; i < planes[0].values().length; i++) {
      int x = i % image.width();
      int y = i / image.width();
      Rgb seen = image.pixel(x, y).times(image.alpha(x, y));
      double[] xyz = xyz(new double[] {clamped(seen.r()), clamped(seen.g()), clamped(seen.b())});
      double luminance = xyz[1] / WHITE[1];
      planes[0].values()[i] = 116 * luminance - 16;
      planes[1].values()[i] = 500 * (xyz[0] / WHITE[0] - luminance);
      planes[2].values()[i] = 200 * (luminance - xyz[2] / WHITE[2]);
    }
    return planes;
  }

  /** Returns the color difference after filtering by contrast sensitivity, in [0,1] (sec. 4.1). */
  private static Plane colorDifference(Plane[] test, Plane[] reference) {
    Plane[] testSeen = seen(test);
    Plane[] referenceSeen = seen(reference);
    return Plane.of(
        test[0].width(),
        test[0].height(),
        i -> {
          double d = distance(lab(linear(testSeen, i)), lab(linear(referenceSeen, i)));
          return remapped(Elementary.pow(d, QC));
        });
  }

  private static double remapped(double difference) {
    double limit = PC * LARGEST;
    return difference < limit
        ? PT / limit * difference
        : PT + (difference - limit) / (LARGEST - limit) * (1 - PT);
  }

  private static Plane[] seen(Plane[] opponents) {
    Plane[] blurred = new Plane[3];
    for (int c = 0; c < 3; c++) {
      blurred[c] = blurred(opponents[c], SENSITIVITY[c]);
    }
    return blurred;
  }

  /** Convolves with a sum of two Gaussians, each separable into rows and columns. */
  private static Plane blurred(Plane plane, double[] s) {
    double[] first = gaussian(s[1]);
    if (s[2] == 0) {
      double[] weights = scaled(first, 1 / sum(first));
      return plane.convolved(weights, weights);
    }
    double[] second = gaussian(s[3]);
    double firstHeight = s[0] * Math.sqrt(Math.PI / s[1]);
    double secondHeight = s[2] * Math.sqrt(Math.PI / s[3]);
    double mass = firstHeight * sum(first) * sum(first) + secondHeight * sum(second) * sum(second);
    Plane a = plane.convolved(scaled(first, firstHeight / mass), first);
    Plane b = plane.convolved(scaled(second, secondHeight / mass), second);
    return Plane.of(plane.width(), plane.height(), i -> a.values()[i] + b.values()[i]);
  }

  /** Returns exp(-π² x² / b), x in degrees, over the support of the widest Gaussian. */
  private static double[] gaussian(double b) {
    int reach = (int) Math.ceil(3 * Math.sqrt(.04 / (2 * Math.PI * Math.PI)) * PIXELS_PER_DEGREE);
    double[] weights = new double[2 * reach + 1];
    for (int i = -reach; i <= reach; i++) {
      double degrees = i / PIXELS_PER_DEGREE;
      weights[i + reach] = Elementary.exp(-Math.PI * Math.PI * degrees * degrees / b);
    }
    return weights;
  }

  /** Returns YCxCz converted to linear RGB, clamped to [0,1]. */
  private static double[] linear(Plane[] opponents, int i) {
    double luminance = (opponents[0].values()[i] + 16) / 116;
    double x = (luminance + opponents[1].values()[i] / 500) * WHITE[0];
    double y = luminance * WHITE[1];
    double z = (luminance - opponents[2].values()[i] / 200) * WHITE[2];
    return new double[] {
      clamped(3.241003275 * x - 1.537398934 * y - .498615861 * z),
      clamped(-.969224334 * x + 1.875930071 * y + .041554224 * z),
      clamped(.055639423 * x - .204011202 * y + 1.057148933 * z)
    };
  }

  private static double[] xyz(double[] rgb) {
    return new double[] {
      (10135552 * rgb[0] + 8788810 * rgb[1] + 4435075 * rgb[2]) / 24577794,
      (2613072 * rgb[0] + 8788810 * rgb[1] + 887015 * rgb[2]) / 12288897,
      (1425312 * rgb[0] + 8788810 * rgb[1] + 70074185 * rgb[2]) / 73733382
    };
  }

  /** Returns L*a*b* with the chroma of dark colors reduced (Hunt effect, eq. 4). */
  private static double[] lab(double[] rgb) {
    double[] xyz = xyz(rgb);
    double y = response(xyz[1] / WHITE[1]);
    double lightness = 116 * y - 16;
    return new double[] {
      lightness,
      .01 * lightness * 500 * (response(xyz[0] / WHITE[0]) - y),
      .01 * lightness * 200 * (y - response(xyz[2] / WHITE[2]))
    };
  }

  private static double response(double t) {
    double limit = 6.0 / 29;
    return t > limit * limit * limit
        ? Elementary.pow(t, 1.0 / 3)
        : t / (3 * limit * limit) + 4.0 / 29;
  }

  /** Returns the distance HyAB (eq. 5). */
  private static double distance(double[] a, double[] b) {
    double da = a[1] - b[1];
    double db = a[2] - b[2];
    return Math.abs(a[0] - b[0]) + Math.sqrt(da * da + db * db);
  }

  /** Returns the difference of edges and points, in [0,1] (sec. 4.2). */
  private static Plane featureDifference(Plane test, Plane reference) {
    Plane[] a = features(normalised(test));
    Plane[] b = features(normalised(reference));
    return Plane.of(
        test.width(),
        test.height(),
        i -> {
          double edges = Math.abs(a[0].values()[i] - b[0].values()[i]);
          double points = Math.abs(a[1].values()[i] - b[1].values()[i]);
          return Elementary.pow(Math.min(1, Math.max(edges, points) / Math.sqrt(2)), QF);
        });
  }

  private static Plane normalised(Plane luminance) {
    return Plane.of(luminance.width(), luminance.height(), i -> (luminance.values()[i] + 16) / 116);
  }

  /** Returns two planes: the strength of edges and the strength of points. */
  private static Plane[] features(Plane luminance) {
    double spread = .5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
    int reach = (int) Math.ceil(3 * spread);
    double[] blur = new double[2 * reach + 1];
    double[] edge = new double[2 * reach + 1];
    double[] point = new double[2 * reach + 1];
    for (int i = -reach; i <= reach; i++) {
      double relative = i / spread;
      double weight = Elementary.exp(-relative * relative / 2);
      blur[i + reach] = weight;
      edge[i + reach] = -i * weight;
      point[i + reach] = (relative * relative - 1) * weight;
    }
    double[] even = scaled(blur, 1 / sum(blur));
    return new Plane[] {
      strength(luminance, balanced(edge), even), strength(luminance, balanced(point), even)
    };
  }

  private static Plane strength(Plane luminance, double[] along, double[] even) {
    Plane across = luminance.convolved(along, even);
    Plane down = luminance.convolved(even, along);
    return Plane.of(
        luminance.width(),
        luminance.height(),
        i -> {
          double x = across.values()[i];
          double y = down.values()[i];
          return Math.sqrt(x * x + y * y);
        });
  }

  /** Returns scaled weights whose positive ones sum to 1 and whose negative ones sum to -1. */
  private static double[] balanced(double[] weights) {
    double positive = 0;
    double negative = 0;
    for (double weight : weights) {
      positive += Math.max(0, weight);
      negative -= Math.min(0, weight);
    }
    double[] balanced = new double[weights.length];
    for (int i = 0; i < weights.length; i++) {
      balanced[i] = weights[i] / (weights[i] > 0 ? positive : negative);
    }
    return balanced;
  }

  private static double[] scaled(double[] weights, double factor) {
    double[] scaled = new double[weights.length];
    for (int i = 0; i < weights.length; i++) {
      scaled[i] = weights[i] * factor;
    }
    return scaled;
  }

  private static double sum(double[] weights) {
    double sum = 0;
    for (double weight : weights) {
      sum += weight;
    }
    return sum;
  }

  private static double clamped(double v) {
    return Math.max(0, Math.min(v, 1));
  }
}
