package io.github.lumbre.lab.metrics;

import io.github.lumbre.image.Image;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The noise of a picture, estimated without a reference from pairs of renders that differ only in
 * their seeds.
 *
 * <p>For values a and b of a pair, (a − b)²/2 is an unbiased estimate of their variance. The
 * variance is the mean squared error of an unbiased renderer. Divided by m² + 0.01, where m is the
 * mean of all pictures, and averaged over pixels and channels, it is the relative mean squared
 * error.
 *
 * @param relativeMses one estimate per pair
 */
public record PictureNoise(List<Double> relativeMses) {
  /** Keeps dark pixels from dominating; in units of squared linear light. */
  private static final double FLOOR = .01;

  public PictureNoise {
    relativeMses = List.copyOf(relativeMses);
  }

  /**
   * Returns the noise of pictures.
   *
   * @param pictures an even number of pictures, pair by pair, with the same size and independent
   *     seeds
   */
  public static PictureNoise of(List<Image> pictures) {
    double[] means = means(pictures);
    List<Double> estimates = new ArrayList<>();
    for (int i = 0; i < pictures.size(); i += 2) {
      estimates.add(relativeMse(pictures.get(i).rgb(), pictures.get(i + 1).rgb(), means));
    }
    return new PictureNoise(estimates);
  }

  private static double[] means(List<Image> pictures) {
    double[] means = new double[pictures.get(0).rgb().length];
    for (Image picture : pictures) {
      float[] rgb = picture.rgb();
      Arrays.setAll(means, i -> means[i] + (double) rgb[i] / pictures.size());
    }
    return means;
  }

  private static double relativeMse(float[] a, float[] b, double[] means) {
    double sum = 0;
    for (int i = 0; i < means.length; i++) {
      double difference = (double) a[i] - b[i];
      sum += difference * difference / 2 / (means[i] * means[i] + FLOOR);
    }
    return sum / means.length;
  }

  /** Returns the mean of all pairs' estimates. */
  public double relativeMse() {
    return relativeMses.stream().mapToDouble(Double::doubleValue).sum() / relativeMses.size();
  }
}
