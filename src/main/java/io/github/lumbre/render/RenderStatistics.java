package io.github.lumbre.render;

import java.io.Serializable;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * The statistics of a render.
 *
 * @param samples the number of samples over all pixels
 * @param rays the number of rays traced to their nearest hit, including camera rays
 * @param shadowRays the number of rays tested for occlusion
 * @param rejected the number of rejected samples, which are added as black: negative, NaN or
 *     infinite ones, and those with a ray through more than 65,536 transparent surfaces
 * @param firstRejected the first few rejected samples
 * @param saturated the number of samples too bright for the film, which were reduced to its maximum
 * @param invalidCoordinates the number of invalid texture coordinates (NaN or infinite), which were
 *     replaced with (0, 0)
 * @param clamped the number of samples scaled down to the settings' clamp
 * @param clampedLight the light lost by clamping, as the sum of the means of the channels; its last
 *     digits depend on the order of work
 * @param faint the number of samples with less light than a film holds precisely, below 1e-16
 */
public record RenderStatistics(
    long samples,
    long rays,
    long shadowRays,
    long rejected,
    List<RejectedSample> firstRejected,
    long saturated,
    long invalidCoordinates,
    long clamped,
    double clampedLight,
    long faint)
    implements Serializable {
  /** The statistics before any work. */
  public static final RenderStatistics ZERO =
      new RenderStatistics(0, 0, 0, 0, List.of(), 0, 0, 0, 0);

  private static final int MAX_FIRST_REJECTED = 10;

  /** Creates statistics without faint samples. */
  public RenderStatistics(
      long samples,
      long rays,
      long shadowRays,
      long rejected,
      List<RejectedSample> firstRejected,
      long saturated,
      long invalidCoordinates,
      long clamped,
      double clampedLight) {
    this(
        samples,
        rays,
        shadowRays,
        rejected,
        firstRejected,
        saturated,
        invalidCoordinates,
        clamped,
        clampedLight,
        0);
  }

  public RenderStatistics {
    firstRejected = List.copyOf(firstRejected);
  }

  /** Returns statistics with the given invalid samples and without any work. */
  public static RenderStatistics ofFaults(
      long rejected, List<RejectedSample> firstRejected, long saturated) {
    return new RenderStatistics(0, 0, 0, rejected, firstRejected, saturated, 0, 0, 0);
  }

  /** Returns the statistics of invalid samples only, without the work. */
  public RenderStatistics faults() {
    return ofFaults(rejected, firstRejected, saturated);
  }

  /** Returns the combined statistics of two workers or two passes. */
  public RenderStatistics plus(RenderStatistics o) {
    return new RenderStatistics(
        samples + o.samples,
        rays + o.rays,
        shadowRays + o.shadowRays,
        rejected + o.rejected,
        Stream.concat(firstRejected.stream(), o.firstRejected.stream())
            .sorted()
            .limit(MAX_FIRST_REJECTED)
            .toList(),
        saturated + o.saturated,
        invalidCoordinates + o.invalidCoordinates,
        clamped + o.clamped,
        clampedLight + o.clampedLight,
        faint + o.faint);
  }

  /**
   * A rejected sample, identified so that it can be repeated.
   *
   * @param x the pixel's column in the full frame
   * @param y the pixel's row in the full frame
   * @param sample the sample's number
   */
  public record RejectedSample(int x, int y, int sample)
      implements Comparable<RejectedSample>, Serializable {
    private static final Comparator<RejectedSample> ORDER =
        Comparator.comparingInt(RejectedSample::y)
            .thenComparingInt(RejectedSample::x)
            .thenComparingInt(RejectedSample::sample);

    @Override
    public int compareTo(RejectedSample o) {
      return ORDER.compare(this, o);
    }
  }
}
