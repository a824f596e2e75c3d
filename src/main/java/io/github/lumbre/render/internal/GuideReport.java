package io.github.lumbre.render.internal;

import io.github.lumbre.integrator.guiding.Guide;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * What the pilot render of {@code --guide} did.
 *
 * @param outcome whether the paths are guided, or why not
 * @param rays rays of the pilot's paths; 0 if there was nothing to learn
 * @param bytes size of the guide
 * @param hash hash of the guide, by which two processes can compare theirs; 0 without a guide
 */
public record GuideReport(Outcome outcome, long rays, long bytes, int hash) {
  /** Whether paths are guided, or why not. */
  public enum Outcome {
    /** Paths are guided. */
    GUIDED,
    /** No light can reach a surface. */
    NO_LIGHT,
    /** The pilot found no light, or too few vertices. */
    NOTHING_LEARNED
  }

  public static GuideReport used(Guide guide, long rays) {
    return new GuideReport(Outcome.GUIDED, rays, guide.bytes(), guide.hash());
  }

  public static GuideReport unused(Outcome outcome, long rays) {
    return new GuideReport(outcome, rays, 0, 0);
  }

  public String hashText() {
    return String.format("%08x", hash);
  }

  /** Returns the values by name, for the JSON summary. */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("outcome", outcome.name().toLowerCase(Locale.ROOT).replace('_', '-'));
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
      case GUIDED -> "paths are guided by %d kB, learned".formatted((bytes + 999) / 1000) + pilot;
    };
  }
}
