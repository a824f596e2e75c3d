package io.github.lumbre.render;

import java.util.List;

/**
 * What a render did.
 *
 * @param samples taken over all pixels
 * @param rays followed to what they meet, those from the camera included
 * @param shadowRays followed to see whether they meet anything
 * @param rejected samples that were not finite or were negative, and count as black
 * @param firstRejected the first few of those
 * @param saturated sample values too bright for the film, and cut to what it can hold
 */
public record RenderStatistics(
    long samples,
    long rays,
    long shadowRays,
    long rejected,
    List<RejectedSample> firstRejected,
    long saturated) {
  public RenderStatistics {
    firstRejected = List.copyOf(firstRejected);
  }

  /** Where a sample was rejected, so that it can be repeated: pixel of the full frame, number. */
  public record RejectedSample(int x, int y, int sample) {}
}
