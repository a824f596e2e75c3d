package io.github.lumbre.denoise;

/**
 * Two estimates of the same picture, from the two halves of its samples.
 *
 * @param first from the first halves
 * @param second from the second halves
 */
record Estimates(Raster first, Raster second) {
  /** Returns the estimates of means and their noise. */
  static Estimates of(Raster mean, Raster noise) {
    return new Estimates(mean.plus(noise), mean.minus(noise));
  }

  /** Returns the mean of both. */
  Raster mean() {
    return first.with(second, (a, b) -> (a + b) / 2);
  }

  /** Returns half of their difference, whose square estimates the variance of the mean. */
  Raster noise() {
    return first.with(second, (a, b) -> (a - b) / 2);
  }

  /** Returns both at half the size. */
  Estimates halved() {
    return new Estimates(first.halved(), second.halved());
  }

  /** Returns both with their coarse structure replaced by that of others of half the size. */
  Estimates over(Estimates coarse) {
    return new Estimates(over(first, coarse.first), over(second, coarse.second));
  }

  private static Raster over(Raster fine, Raster coarse) {
    Raster change = coarse.minus(fine.halved());
    return fine.plus(change.doubled(fine.width(), fine.height()));
  }

  /**
   * Returns an estimate of the mean of the relative squared error of filtered pictures: the
   * variance that the difference of both shows. Errors that both share are not seen.
   */
  double relativeError() {
    double sum = 0;
    for (int i = 0; i < first.values().length; i++) {
      double mean = ((double) first.values()[i] + second.values()[i]) / 2;
      double noise = ((double) first.values()[i] - second.values()[i]) / 2;
      sum += noise * noise / (mean * mean + Denoised.FLOOR);
    }
    return sum / first.values().length;
  }

  /**
   * Returns the better of two filtered pictures around each pixel. Each filtered half is compared
   * with the other, unfiltered half, whose own noise is the same for both pictures (Rousselle,
   * Knaus &amp; Zwicker 2012).
   *
   * @param noisy the halves before filtering
   */
  static Estimates better(Estimates one, Estimates other, Estimates noisy) {
    Raster gain = one.distance(noisy).minus(other.distance(noisy)).blurred(3).blurred(3);
    Raster share = gain.with(gain, (g, same) -> g > 0 ? 1 : 0).blurred(2).blurred(2);
    return new Estimates(
        mixed(one.first, other.first, share), mixed(one.second, other.second, share));
  }

  /** Returns squared distances between filtered and unfiltered halves, in one channel. */
  private Raster distance(Estimates noisy) {
    int channels = first.channels();
    Raster result = new Raster(first.width(), first.height(), 1);
    for (int i = 0; i < first.values().length; i++) {
      double a = first.values()[i];
      double b = second.values()[i];
      double ofFirst = a - noisy.second.values()[i];
      double ofSecond = b - noisy.first.values()[i];
      // The mean of both filtered halves has the same bias as each, but half of the variance.
      double distance = (ofFirst * ofFirst + ofSecond * ofSecond) / 2 - (a - b) * (a - b) / 4;
      double mean = (a + b) / 2;
      result.values()[i / channels] += (float) (distance / (mean * mean + Denoised.FLOOR));
    }
    return result;
  }

  private static Raster mixed(Raster one, Raster other, Raster share) {
    Raster result = new Raster(one.width(), one.height(), one.channels());
    for (int i = 0; i < result.values().length; i++) {
      float t = share.values()[i / one.channels()];
      result.values()[i] = one.values()[i] * (1 - t) + other.values()[i] * t;
    }
    return result;
  }
}
