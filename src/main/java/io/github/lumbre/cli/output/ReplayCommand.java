package io.github.lumbre.cli.output;

import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.SettingType;
import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Collectors;

/** The command line that repeats one sample of a render, for warnings. */
public final class ReplayCommand {
  private ReplayCommand() {}

  /** Returns the command with all flags that determine the sample. */
  static String of(Path scene, RenderSettings settings, RejectedSample sample) {
    return String.format(
        Locale.ROOT,
        "lumbre pixel %s %d,%d --sample %d --seed %d --size %dx%d --mode %s%s%s",
        ShellText.quoted(scene.toString()),
        sample.x(),
        sample.y(),
        sample.sample(),
        settings.seed(),
        settings.width(),
        settings.height(),
        SettingType.nameOf(settings.mode()),
        depth(settings),
        others(settings));
  }

  private static String depth(RenderSettings settings) {
    return switch (settings.mode()) {
      case PATH -> " --depth " + settings.maxTraceDepth();
      // Different depths can only come from the scene, and the command reads them from there.
      case RAY ->
          settings.reflectionTraceDepth() == settings.refractionTraceDepth()
              ? " --depth " + settings.reflectionTraceDepth()
              : "";
    };
  }

  private static String others(RenderSettings settings) {
    return FilmHeader.named().stream()
        .filter(settings::isSet)
        .map(setting -> " " + setting.flag() + " " + settings.text(setting))
        .collect(Collectors.joining());
  }

  public static String resume(Path film) {
    return "lumbre resume " + ShellText.quoted(film.toString());
  }
}
