package io.github.lumbre.cli.output;

import io.github.lumbre.base.Release;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.SceneFile;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The metadata of a picture file. */
public final class PictureMetadata {
  /** With this environment variable, files state nothing that differs between equal renders. */
  private static final String REPRODUCIBLE = "SOURCE_DATE_EPOCH";

  private static final String SCENE = "Scene";

  /** The keyword of the hash of the scene. */
  public static final String SCENE_HASH = "SceneHash";

  /** The keyword of the number of samples per pixel. */
  public static final String SAMPLES = "Samples";

  /** The keyword of the target error. */
  public static final String TARGET_ERROR = "TargetError";

  /** The keyword of the stops that an automatic exposure has chosen. */
  public static final String CHOSEN_EXPOSURE = "ChosenExposure";

  /** The keyword of the hash of the GLB that a program has made of the model. */
  public static final String CONVERTED_HASH = "ConvertedModelHash";

  /** The keyword of the denoiser. */
  public static final String DENOISED = "Denoised";

  /** The keyword of the number of frames with which a frame of a sequence was denoised. */
  public static final String DENOISED_WITH = "DenoisedWith";

  /** The keyword that marks a picture that lacks samples, or a step after them. */
  public static final String PARTIAL = "Partial";

  private static final String HIDDEN = "HiddenLines";

  /** The keywords of pictures of lines alone. */
  private static final Set<String> OF_DRAWINGS =
      Set.of(
          "Software",
          SCENE,
          SCENE_HASH,
          CONVERTED_HASH,
          "Size",
          "Crop",
          "Labels",
          HIDDEN,
          keyword(Setting.LINE_WIDTH),
          keyword(Setting.CREASE_ANGLE),
          keyword(Setting.BACKPLATE),
          keyword(Setting.TRANSPARENT));

  private static final Set<Setting<?>> HAVE_OTHER_NAMES =
      Set.of(
          Setting.WIDTH,
          Setting.HEIGHT,
          Setting.MODE,
          Setting.SAMPLES,
          Setting.SEED,
          Setting.LAYERS);

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
    Map<String, String> metadata = of(scene, file, settings);
    if (!environment.containsKey(REPRODUCIBLE)) {
      metadata.put("Time", String.format(Locale.ROOT, "%.2f", seconds));
    }
    return metadata;
  }

  /** Returns the metadata by keyword that say what is rendered, in a mutable map. */
  public static Map<String, String> of(Path scene, SceneFile file, RenderSettings settings) {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("Software", "Lumbre " + Release.number());
    metadata.put(SCENE, Messages.printable(String.valueOf(scene.getFileName())));
    metadata.put(SCENE_HASH, file.hash());
    file.parsed().imported().ifPresent(model -> metadata.put(CONVERTED_HASH, model.hash()));
    metadata.put("Mode", SettingType.nameOf(settings.mode()));
    metadata.put(SAMPLES, String.valueOf(settings.samples()));
    settings()
        .filter(settings::isSet)
        .forEach(setting -> metadata.put(keyword(setting), settings.text(setting)));
    metadata.put("Seed", String.valueOf(settings.seed()));
    metadata.put("Size", settings.width() + "x" + settings.height());
    settings.crop().ifPresent(crop -> metadata.put("Crop", crop.toString()));
    labels(file).ifPresent(labels -> metadata.put("Labels", labels));
    file.parsed()
        .model()
        .filter(model -> model.sheet().hasHidden())
        .ifPresent(model -> metadata.put(HIDDEN, "dashed"));
    return metadata;
  }

  /**
   * Returns the metadata by keyword of a picture of lines alone, which does not depend on the flags
   * of sampling.
   */
  public static Map<String, String> ofDrawing(Path scene, SceneFile file) {
    Map<String, String> metadata = of(scene, file, file.settings());
    metadata.keySet().retainAll(OF_DRAWINGS);
    return metadata;
  }

  /** Returns the keywords of metadata that differ between pictures of other scenes or settings. */
  public static Set<String> identifying() {
    Set<String> keywords =
        new HashSet<>(
            Set.of(
                "Software",
                SCENE_HASH,
                CONVERTED_HASH,
                "Mode",
                SAMPLES,
                "Seed",
                "Size",
                "Crop",
                "Labels",
                HIDDEN,
                TARGET_ERROR,
                DENOISED,
                DENOISED_WITH));
    settings().map(PictureMetadata::keyword).forEach(keywords::add);
    return keywords;
  }

  /** Returns the keywords of metadata that all frames of a sequence have in common. */
  public static Set<String> ofAllFrames() {
    Set<String> keywords = identifying();
    keywords.add(SCENE);
    keywords.removeAll(Set.of(SCENE_HASH, CONVERTED_HASH, DENOISED_WITH));
    return keywords;
  }

  /** Returns the settings that metadata contain under their own names. */
  private static Stream<Setting<?>> settings() {
    return Setting.all().stream()
        .filter(setting -> setting.group() != Setting.Group.EXECUTION)
        .filter(setting -> !HAVE_OTHER_NAMES.contains(setting));
  }

  private static Optional<String> labels(SceneFile file) {
    return file
        .parsed()
        .model()
        .map(model -> new TreeSet<>(model.labels()))
        .filter(kinds -> !kinds.isEmpty())
        .map(kinds -> String.join(",", kinds));
  }

  /** Returns the keyword of a setting: its name with a capital letter. */
  public static String keyword(Setting<?> setting) {
    return setting.name().substring(0, 1).toUpperCase(Locale.ROOT) + setting.name().substring(1);
  }
}
