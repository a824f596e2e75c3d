package io.github.lumbre.cli.output;

import io.github.lumbre.checkpoint.FilmHeader;
import io.github.lumbre.lab.Release;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/** The metadata of a picture file. */
public final class PictureMetadata {
  /** With this environment variable, files state nothing that differs between equal renders. */
  private static final String REPRODUCIBLE = "SOURCE_DATE_EPOCH";

  private PictureMetadata() {}

  /**
   * Returns the metadata by keyword, in a mutable map.
   *
   * @param scene the scene's path
   * @param settings settings of the render
   * @param seconds rendering time; left out if the environment has {@code SOURCE_DATE_EPOCH}
   */
  public static Map<String, String> of(
      Path scene, SceneFile file, RenderSettings settings, double seconds) {
    return of(scene, file, settings, seconds, System.getenv());
  }

  static Map<String, String> of(
      Path scene,
      SceneFile file,
      RenderSettings settings,
      double seconds,
      Map<String, String> environment) {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("Software", "Lumbre " + Release.number());
    metadata.put("Scene", Messages.printable(String.valueOf(scene.getFileName())));
    metadata.put("SceneHash", file.hash());
    metadata.put("Mode", SettingType.nameOf(settings.mode()));
    metadata.put("Samples", String.valueOf(settings.samples()));
    for (Setting<?> setting : FilmHeader.named()) {
      if (settings.isSet(setting)) {
        metadata.put(keyword(setting), settings.text(setting));
      }
    }
    metadata.put("Seed", String.valueOf(settings.seed()));
    metadata.put("Size", settings.width() + "x" + settings.height());
    settings.crop().ifPresent(crop -> metadata.put("Crop", crop.toString()));
    if (!environment.containsKey(REPRODUCIBLE)) {
      metadata.put("Time", String.format(Locale.ROOT, "%.2f", seconds));
    }
    return metadata;
  }

  /** Returns the keyword of a setting: its name with a capital letter. */
  public static String keyword(Setting<?> setting) {
    return setting.name().substring(0, 1).toUpperCase(Locale.ROOT) + setting.name().substring(1);
  }
}
