package io.github.lumbre.cli;

import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.scene.RenderSettings;
import java.nio.file.Path;
import java.util.Locale;

/** The command that repeats a sample of a render: what to type after a warning. */
final class ReplayCommand {
  private ReplayCommand() {}

  /** Returns the command, with all flags that decide which sample it is. */
  static String of(Path scene, RenderSettings settings, RejectedSample sample) {
    return String.format(
        Locale.ROOT,
        "lumbre pixel %s %d,%d --sample %d --seed %d --size %dx%d --mode %s%s",
        quoted(scene.toString()),
        sample.x(),
        sample.y(),
        sample.sample(),
        settings.seed(),
        settings.width(),
        settings.height(),
        FlagConverters.lower(settings.mode()),
        depth(settings));
  }

  private static String depth(RenderSettings settings) {
    return switch (settings.mode()) {
      case PATH ->
          " --depth "
              + settings.maxTraceDepth()
              + (settings.split() > 1 ? " --split " + settings.split() : "");
      // Two depths that differ can only come from the scene, which the command reads again.
      case RAY ->
          settings.reflectionTraceDepth() == settings.refractionTraceDepth()
              ? " --depth " + settings.reflectionTraceDepth()
              : "";
    };
  }

  /** Returns a name as a shell takes it. */
  private static String quoted(String name) {
    return name.matches("[A-Za-z0-9_./\\\\:-]+") ? name : "'" + name.replace("'", "'\\''") + "'";
  }
}
