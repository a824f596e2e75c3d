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
  public static final int BYTES_PER_PIXEL =
      12 + 4 + 16 + 2 * 20 + 5 * 4 + 2 * 4 + ChangeTest.BYTES_PER_PIXEL;

  /** How much less frames weigh for each squared step in time, as a power of e. */
  private static final double DECAY = .02;

  /** The weight of frames at the ends of a sequence, whose light may change steadily. */
  private static final double ONE_SIDED = .35;

  /** Added to variances, so that their ratio is a number. */
  private static final double LEAST_VARIANCE = 1e-30;

  private final SeenFrame frame;
  private final int threads;
  private final int width;
  private final int height;
  private final ChangeTest test;

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
    test = new ChangeTest(width, height, frame::leastVariance, threads);
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

  private void add(FrameTracks only, double most) throws InterruptedException {
    float[] same = test.weights(only.differences, only.variances, only.isFollowed);
    forEach(pixel -> add(only, pixel, most * same[pixel]));
  }

  private void add(FrameTracks one, FrameTracks other, double most) throws InterruptedException {
    float[] ofOne = test.weights(one.differences, one.variances, one.isFollowed);
    float[] ofOther = test.weights(other.differences, other.variances, other.isFollowed);
    float[] ofBoth = weights(one, other);
    forEach(
        pixel -> {
          add(one, pixel, most * Math.max(ofBoth[pixel], ofOne[pixel]));
          add(other, pixel, most * Math.max(ofBoth[pixel], ofOther[pixel]));
        });
  }

  /** Returns the weights of the mean of two frames. */
  private float[] weights(FrameTracks one, FrameTracks other) throws InterruptedException {
    float[] both = new float[weights.length];
    float[] means = new float[sums.length];
    float[] variances = new float[weights.length];
    forEach(
        pixel -> {
          both[pixel] = one.isFollowed[pixel] * other.isFollowed[pixel];
          double own = frame.variances[pixel];
          double others = (one.variances[pixel] - own) + (other.variances[pixel] - own);
          variances[pixel] = (float) (own + .25 * others);
          for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
            means[i] = (float) (.5 * ((double) one.differences[i] + other.differences[i]));
          }
        });
    return test.weights(means, variances, both);
  }

  /** Adds a pixel. Light that is noisier than the frame's own weighs less. */
  private void add(FrameTracks tracks, int pixel, double same) {
    double own = frame.variances[pixel] + LEAST_VARIANCE;
    double there = Math.max(own, tracks.variances[pixel] - frame.variances[pixel]);
    double weight = same * Math.sqrt(own / there);
    weights[pixel] += (float) weight;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
      sums[i] += (float) (weight * tracks.differences[i]);
    }
  }

  private void forEach(Rows.OfPixel action) throws InterruptedException {
    Rows.forEach(width, height, threads, action);
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
