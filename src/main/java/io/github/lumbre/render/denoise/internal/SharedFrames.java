package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.image.Image;
import io.github.lumbre.math.internal.Elementary;
import java.util.List;
import java.util.Optional;

/**
 * Mixes a denoised frame with its neighbors in time, so that what moves does not simmer. Each pixel
 * follows the point that it shows. The light there, divided by albedo, is mixed with the weights
 * that the noise which is left in both frames allows: where their light differs by more, it has
 * changed, and a mixture would lag behind.
 *
 * <p>Two neighbors at the same distance in time may also be compared as a pair: their mean stays
 * the same where light changes steadily. Where neighbors have the same light, it does not change by
 * one bit.
 */
public final class SharedFrames {
  /** The number of frames before a frame, and after it, with which it is mixed. */
  public static final int REACH = 3;

  /** What {@link #mixed} needs in memory, besides the frames. */
  public static final int BYTES_PER_PIXEL = 12 + 4 + 16 + 2 * 20 + 5 * 4 + 12;

  /** Pixels to each side whose differences are compared with their noise. */
  private static final int NEAR = 2;

  /** Squared differences may be this much larger than the variance that was expected. */
  private static final double EXPECTED = 1;

  /** The excess of squared differences that makes weights smaller by a factor of e. */
  private static final double TOLERANCE = .5;

  /** How much less frames weigh for each squared step in time, as a power of e. */
  private static final double DECAY = .02;

  /** The weight of frames at the ends of a sequence, whose light may change steadily. */
  private static final double ONE_SIDED = .35;

  /** Larger ratios of squared differences and variances count as this. */
  private static final double LARGEST_RATIO = 1e6;

  /** Added to variances, for each square of light. */
  private static final double LEAST_VARIANCE = 1e-12;

  private final SeenFrame frame;
  private final int threads;
  private final int width;
  private final int height;
  private final Means around;

  /** Where the camera sees the point of each pixel. */
  private final double[] places;

  /** Sums of weighted differences. */
  private final float[] sums;

  /** Sums of weights, without that of the frame itself. */
  private final float[] weights;

  private SharedFrames(SeenFrame frame, int threads) {
    this.frame = frame;
    this.threads = threads;
    width = frame.image.width();
    height = frame.image.height();
    around = new Means(width, height, NEAR, threads);
    sums = new float[3 * width * height];
    weights = new float[width * height];
    places = FrameTracks.places(frame);
  }

  /**
   * Returns the picture of a frame, mixed with frames before and after it.
   *
   * @param before the nearest first
   * @param after the nearest first
   * @param threads number of threads; the result does not depend on it
   * @throws InterruptedException if the calling thread is interrupted
   */
  public static Image mixed(
      SeenFrame frame, List<SeenFrame> before, List<SeenFrame> after, int threads)
      throws InterruptedException {
    SharedFrames shared = new SharedFrames(frame, threads);
    for (int i = 0; i < Math.max(before.size(), after.size()); i++) {
      double most = Elementary.exp(-DECAY * (i + 1) * (i + 1));
      Optional<FrameTracks> one = shared.tracks(before, i);
      Optional<FrameTracks> other = shared.tracks(after, i);
      if (one.isPresent() && other.isPresent()) {
        shared.add(one.get(), other.get(), most);
      } else {
        shared.add(one.or(() -> other).orElseThrow(), ONE_SIDED * most);
      }
    }
    return shared.picture();
  }

  private Optional<FrameTracks> tracks(List<SeenFrame> frames, int index)
      throws InterruptedException {
    return index < frames.size()
        ? Optional.of(FrameTracks.of(frame, places, frames.get(index), threads))
        : Optional.empty();
  }

  /** The squared differences of pixels over their variances, averaged over neighborhoods. */
  @FunctionalInterface
  private interface Ratio {
    /** Returns the ratio of a pixel that is followed. */
    double of(int pixel);
  }

  private void add(FrameTracks only, double most) throws InterruptedException {
    float[] ratios = averaged(only.isFollowed, pixel -> ratio(only, pixel));
    forEach(pixel -> add(only, pixel, most * weight(ratios[pixel]) * only.isFollowed[pixel]));
  }

  private void add(FrameTracks one, FrameTracks other, double most) throws InterruptedException {
    float[] both = new float[weights.length];
    for (int i = 0; i < both.length; i++) {
      both[i] = one.isFollowed[i] * other.isFollowed[i];
    }
    float[] ofOne = averaged(one.isFollowed, pixel -> ratio(one, pixel));
    float[] ofOther = averaged(other.isFollowed, pixel -> ratio(other, pixel));
    float[] ofBoth = averaged(both, pixel -> ratio(one, other, pixel));
    forEach(
        pixel -> {
          double pair = weight(ofBoth[pixel]) * both[pixel];
          double first = weight(ofOne[pixel]) * one.isFollowed[pixel];
          double second = weight(ofOther[pixel]) * other.isFollowed[pixel];
          add(one, pixel, most * Math.max(pair, first));
          add(other, pixel, most * Math.max(pair, second));
        });
  }

  private void add(FrameTracks tracks, int pixel, double weight) {
    weights[pixel] += (float) weight;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      sums[i] += (float) (weight * tracks.differences[i]);
    }
  }

  private static double weight(double ratio) {
    return ratio <= EXPECTED ? 1 : Elementary.exp((EXPECTED - ratio) / TOLERANCE);
  }

  private double ratio(FrameTracks tracks, int pixel) {
    double squares = 0;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      squares += (double) tracks.differences[i] * tracks.differences[i];
    }
    return ratio(squares, tracks.variances[pixel], pixel);
  }

  /** Returns the ratio of the mean of two frames. */
  private double ratio(FrameTracks one, FrameTracks other, int pixel) {
    double squares = 0;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      double mean = .5 * ((double) one.differences[i] + other.differences[i]);
      squares += mean * mean;
    }
    double own = frame.variances[pixel];
    double others = (one.variances[pixel] - own) + (other.variances[pixel] - own);
    return ratio(squares, own + .25 * others, pixel);
  }

  private double ratio(double squares, double variance, int pixel) {
    if (squares == 0) {
      return 0;
    }
    double least = 0;
    for (int c = 0; c < 3; c++) {
      double light = frame.divided(pixel, c);
      least += LEAST_VARIANCE * light * light;
    }
    double ratio = squares / (variance + least);
    return ratio < LARGEST_RATIO ? ratio : LARGEST_RATIO;
  }

  /** Averages ratios over the pixels of neighborhoods that are followed. */
  private float[] averaged(float[] isFollowed, Ratio ratio) throws InterruptedException {
    float[] ratios = new float[weights.length];
    forEach(
        pixel -> {
          if (isFollowed[pixel] > 0) {
            ratios[pixel] = (float) ratio.of(pixel);
          }
        });
    float[] averaged = new float[ratios.length];
    around.of(ratios, isFollowed, averaged);
    return averaged;
  }

  @FunctionalInterface
  private interface OfPixel {
    void run(int pixel);
  }

  private void forEach(OfPixel action) throws InterruptedException {
    Rows.compute(
        height,
        threads,
        () ->
            y -> {
              for (int pixel = y * width; pixel < (y + 1) * width; pixel++) {
                action.run(pixel);
              }
            });
  }

  private Image picture() {
    float[] rgb = frame.image.rgb().clone();
    float[] alpha = new float[frame.image.hasAlpha() ? weights.length : 0];
    for (int i = 0; i < alpha.length; i++) {
      alpha[i] = frame.image.alpha(i % width, i / width);
    }
    for (int i = 0; i < rgb.length; i++) {
      double change = sums[i] / (1 + (double) weights[i / 3]) * frame.divisors[i];
      if (change != 0) {
        rgb[i] = (float) Math.max(0, Math.min(Float.MAX_VALUE, rgb[i] + change));
      }
    }
    return new Image(width, height, rgb, alpha);
  }
}
