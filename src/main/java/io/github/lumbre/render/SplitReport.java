package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** What the pilot render of {@code --split auto} chose, and why. Immutable. */
public final class SplitReport {
  /** Why paths are split or not. */
  enum Reason {
    /** Branches are more efficient. */
    BETTER,
    /** Branches are not, or not certainly, more efficient. */
    NOT_BETTER,
    /** No light can reach a surface. */
    NO_LIGHT,
    /** The render is too short for a pilot. */
    SHORT
  }

  /** The samples per pixel that a render without a number of samples is expected to have. */
  private static final int OPEN_SAMPLES = 64;

  private static final int SMALLEST_PILOT = 1024;

  private final SplitPlan plan;
  private final Reason reason;
  private final double gain;
  private final double bound;
  private final long rays;

  /**
   * @param gain rays of unsplit paths relative to those of split ones, for the same squared error,
   *     as measured by the pilot; 1 if paths are not split
   * @param bound the gain less two standard errors
   * @param rays rays of the pilot's samples
   */
  SplitReport(SplitPlan plan, Reason reason, double gain, double bound, long rays) {
    this.plan = plan;
    this.reason = reason;
    this.gain = gain;
    this.bound = bound;
    this.rays = rays;
  }

  static SplitReport without(Reason reason, long rays) {
    return new SplitReport(SplitPlan.NONE, reason, 1, 1, rays);
  }

  /**
   * Returns the report on a scene. Takes the time of the pilot render.
   *
   * @param settings path mode and ray mode are both allowed; their number of branches is not used
   * @throws InterruptedException if the calling thread is interrupted
   */
  public static SplitReport of(RenderSettings settings, Scene scene) throws InterruptedException {
    try {
      return SplitPilot.choose(settings, scene.framed(settings.aspect()), PilotRows.of(settings));
    } catch (PilotRows.Stopped e) {
      throw new AssertionError("nothing stops it", e);
    }
  }

  /**
   * Returns the number of pilot pixels for a render of a given length: a pilot traces about 192
   * samples for each, and that is at most 2 % of the render's. It is 0 for short renders.
   *
   * @param pixels of the full frame
   * @param samples requested for each pixel; {@link RenderSettings#MAX_SAMPLES} if another limit
   *     ends the render, which then counts as one of 64 samples
   */
  public static int pilotPixels(long pixels, int samples) {
    int expected = samples == RenderSettings.MAX_SAMPLES ? OPEN_SAMPLES : samples;
    if (expected < SplitPilot.SAMPLES) {
      return 0;
    }
    double most = (double) pixels * expected * SplitPilot.LARGEST_SHARE / SplitPilot.WORK;
    int chosen = 0;
    for (int size = SMALLEST_PILOT; size <= RenderSettings.MAX_SPLIT_PILOT; size *= 4) {
      chosen = size <= most ? size : chosen;
    }
    return chosen;
  }

  /** Returns the number of branches of each pixel. */
  SplitPlan plan() {
    return plan;
  }

  /** Returns the settings of the integrator that follows the plan. */
  RenderSettings applyTo(RenderSettings settings) {
    return plan.isEmpty() ? settings.toBuilder().split(1).build() : settings;
  }

  /** Returns the rays of the pilot's samples; 0 if there was nothing to measure. */
  public long rays() {
    return rays;
  }

  /** Returns the measured gain; 1 if paths are not split. */
  public double gain() {
    return gain;
  }

  /** Returns the mean number of branches over the frame. */
  public double branches() {
    return plan.meanBranches();
  }

  /** Returns the SHA-256 of the plan, which films of the same picture share. */
  public String hash() {
    return plan.hash();
  }

  /** Returns the values by name, for the JSON summary. */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("branches", plan.meanBranches());
    values.put("gain", gain);
    values.put("gain_at_least", bound);
    values.put("pilot_rays", rays);
    values.put("plan", plan.hash());
    return values;
  }

  /** Returns one line for people. */
  public String text() {
    return switch (reason) {
      case NO_LIGHT -> "paths are not split: no light can reach a surface";
      case SHORT -> "paths are not split: the render is too short for a pilot render";
      case NOT_BETTER ->
          "paths are not split: no more efficient for certain in a pilot render of %d rays"
              .formatted(rays);
      case BETTER ->
          String.format(
              Locale.ROOT,
              "paths are split into %s: %.2f times as efficient (at least %.2f) in a pilot render"
                  + " of %d rays",
              numbers(),
              gain,
              bound,
              rays);
    };
  }

  private String numbers() {
    return IntStream.rangeClosed(0, SplitChoice.MOST)
        .filter(exponent -> plan.share(exponent) > 0)
        .mapToObj(this::number)
        .collect(Collectors.joining(", "));
  }

  private String number(int exponent) {
    double share = plan.share(exponent);
    String branches = (1 << exponent) + (exponent == 0 ? " branch" : " branches");
    return share == 1
        ? branches
        : String.format(Locale.ROOT, "%s in %.0f %% of the frame", branches, 100 * share);
  }
}
