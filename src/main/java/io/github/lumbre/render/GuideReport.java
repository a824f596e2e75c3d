package io.github.lumbre.render;

import io.github.lumbre.guiding.Guide;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * What the pilot render of {@code --guide} did, and why.
 *
 * @param outcome whether the paths are guided, or why not
 * @param gain if it was measured, squared error times rays of unguided paths, over the product for
 *     guided ones. Otherwise it is predicted from the pilot's records: the second moment of the
 *     light that scattered rays find, over the second moment with guided paths; 1 if nothing was
 *     learned
 * @param isMeasured whether both kinds of paths were tried; {@code on} does not try them
 * @param rays rays of the pilot; 0 if there was nothing to learn
 * @param bytes size of the guide
 * @param hash hash of the guide, by which two processes can compare theirs; 0 without a guide
 */
public record GuideReport(
    Outcome outcome, double gain, boolean isMeasured, long rays, long bytes, int hash) {
  /** Whether paths are guided, or why not. */
  public enum Outcome {
    /** Paths are guided. */
    GUIDED,
    /** Guided paths would hardly be less noisy. */
    NOT_BETTER,
    /** No light can reach a surface. */
    NO_LIGHT,
    /** The pilot found no light, or too few vertices. */
    NOTHING_LEARNED
  }

  static GuideReport used(Guide guide, double gain, boolean isMeasured, long rays) {
    return new GuideReport(Outcome.GUIDED, gain, isMeasured, rays, guide.bytes(), guide.hash());
  }

  /** Returns a report without a guide, for a predicted gain. */
  static GuideReport unused(Outcome outcome, double gain, long rays) {
    return new GuideReport(outcome, gain, false, rays, 0, 0);
  }

  /** Returns the report on a guide that was tried and is not used. */
  static GuideReport tried(double gain, long rays) {
    return new GuideReport(Outcome.NOT_BETTER, gain, true, rays, 0, 0);
  }

  /**
   * Returns the report on a scene. Takes the time of the pilot render.
   *
   * @param settings guiding that is off counts as {@link RenderSettings.Guiding#AUTO}
   * @throws InterruptedException if the calling thread is interrupted
   */
  public static GuideReport of(RenderSettings settings, Scene scene) throws InterruptedException {
    RenderSettings guided =
        settings.guiding() == RenderSettings.Guiding.OFF
            ? settings.toBuilder().guiding(RenderSettings.Guiding.AUTO).build()
            : settings;
    try {
      Scene framed = scene.framed(settings.aspect());
      return GuidePilot.learn(guided, framed, PilotRows.of(settings)).report();
    } catch (PilotRows.Stopped e) {
      throw new AssertionError("nothing stops it", e);
    }
  }

  /** Returns the hash as text. */
  public String hashText() {
    return String.format("%08x", hash);
  }

  /** Returns the values by name, for the JSON summary. */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("outcome", outcome.name().toLowerCase(Locale.ROOT).replace('_', '-'));
    values.put("gain", gain);
    values.put("measured", isMeasured);
    values.put("pilot_rays", rays);
    values.put("bytes", bytes);
    values.put("hash", hashText());
    return values;
  }

  /** Returns one line for people. */
  public String text() {
    String pilot = " in a pilot render of %d rays".formatted(rays);
    return switch (outcome) {
      case NO_LIGHT -> "paths are not guided: no light can reach a surface";
      case NOTHING_LEARNED -> "paths are not guided: nothing was learned" + pilot;
      case NOT_BETTER ->
          "paths are not guided: %s gain %s%s".formatted(kind(), decimal(gain), pilot);
      case GUIDED ->
          "paths are guided by %d kB: %s gain %s%s"
              .formatted((bytes + 999) / 1000, kind(), decimal(gain), pilot);
    };
  }

  private String kind() {
    return isMeasured ? "measured" : "predicted";
  }

  private static String decimal(double value) {
    return String.format(Locale.ROOT, "%.2f", value);
  }
}
