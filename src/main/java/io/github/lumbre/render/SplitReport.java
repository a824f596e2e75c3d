package io.github.lumbre.render;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * What the pilot render of {@code --split auto} chose, and why.
 *
 * @param branches number of branches of a path; 1 if paths are not split
 * @param gain ratio of squared error times rays of unsplit paths to that of split ones, as measured
 *     by the pilot; 1 if paths are not split
 * @param rays rays of the pilot; 0 if there was nothing to measure
 */
public record SplitReport(int branches, double gain, long rays) {
  /**
   * Returns the report on a scene. Takes the time of the pilot render.
   *
   * @param settings path mode and ray mode are both allowed; their number of branches is not used
   */
  public static SplitReport of(RenderSettings settings, Scene scene) {
    return SplitPilot.choose(settings, scene.framed(settings.aspect()));
  }

  /** Returns the same settings with the number of branches that was chosen. */
  RenderSettings applyTo(RenderSettings settings) {
    return settings.toBuilder().split(branches).build();
  }

  /** Returns the values by name, for the JSON summary. */
  public Map<String, Object> values() {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("branches", branches);
    values.put("gain", gain);
    values.put("pilot_rays", rays);
    return values;
  }

  /** Returns one line for people. */
  public String text() {
    if (rays == 0) {
      return "paths are not split: no light can reach a surface";
    }
    String pilot = " in a pilot render of %d rays".formatted(rays);
    return branches == 1
        ? "paths are not split: more branches were not more efficient" + pilot
        : String.format(
            Locale.ROOT,
            "paths are split into %d branches: %.2f times as efficient%s",
            branches,
            gain,
            pilot);
  }
}
