package io.github.lumbre.render;

import java.io.Serializable;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * What a render did.
 *
 * @param samples taken over all pixels
 * @param rays followed to what they meet, those from the camera included
 * @param shadowRays followed to see whether they meet anything
 * @param rejected samples that were not finite or were negative, and count as black
 * @param firstRejected the first few of those
 * @param saturated sample values too bright for the film, and cut to what it can hold
 * @param unreadable points of textures that were not finite, and were taken as (0, 0)
 * @param clamped samples darkened to the settings' clamp
 * @param clampedLight what those lost, the sum of the means of their channels; its last digits
 *     depend on the order of work
 */
public record RenderStatistics(
    long samples,
    long rays,
    long shadowRays,
    long rejected,
    List<RejectedSample> firstRejected,
    long saturated,
    long unreadable,
    long clamped,
    double clampedLight)
    implements Serializable {
  /** Nothing done. */
  public static final RenderStatistics ZERO =
      new RenderStatistics(0, 0, 0, 0, List.of(), 0, 0, 0, 0);

  private static final int MAX_FIRST_REJECTED = 10;

  public RenderStatistics {
    firstRejected = List.copyOf(firstRejected);
  }

  /** Returns what was wrong with samples, and nothing of the work that they were. */
  public static RenderStatistics ofFaults(
      long rejected, List<RejectedSample> firstRejected, long saturated) {
    return new RenderStatistics(0, 0, 0, rejected, firstRejected, saturated, 0, 0, 0);
  }

  /** Returns what was wrong with samples, without the work that they were. */
  public RenderStatistics faults() {
    return ofFaults(rejected, firstRejected, saturated);
  }

  /** Returns what two workers, or two passes, did together. */
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
        unreadable + o.unreadable,
        clamped + o.clamped,
        clampedLight + o.clampedLight);
  }

  /** Where a sample was rejected, so that it can be repeated: pixel of the full frame, number. */
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
