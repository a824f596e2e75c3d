package io.github.lumbre.cli.output;

import io.github.lumbre.base.Release;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.scenefile.internal.SceneContents;
import io.github.lumbre.stage.internal.ViewNumbers;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * The summary of a command's result or failure as one line of JSON. Mutable.
 *
 * <p>Keys may be added; {@link #FORMAT} changes with every incompatible change.
 */
public final class JsonSummary {
  static final String FORMAT = "lumbre-summary-1";

  private final Map<String, Object> values = new LinkedHashMap<>();

  /**
   * @param command name of the command
   * @param scene path of its scene
   */
  public JsonSummary(String command, Path scene) {
    this(command, "scene", scene);
  }

  /**
   * @param command name of the command
   * @param key JSON key of the command's input
   * @param path path of the input
   */
  public JsonSummary(String command, String key, Path path) {
    values.put("format", FORMAT);
    values.put("version", Release.number());
    values.put("command", command);
    values.put(key, path.toString());
  }

  public void print(Messages out) {
    values.replaceAll((key, value) -> value instanceof Supplier<?> late ? late.get() : value);
    out.line(JsonText.line(values));
  }

  /** Returns the values by their keys. */
  public Map<String, Object> values() {
    return Collections.unmodifiableMap(values);
  }

  public void put(String key, Object value) {
    values.put(key, value);
  }

  /** Adds the settings and warnings of a scene. */
  public void putScene(SceneFile file) {
    RenderSettings settings = file.settings();
    values.put("scene_sha256", file.hash());
    values.put("width", settings.width());
    values.put("height", settings.height());
    settings.crop().ifPresent(crop -> values.put("crop", crop.toString()));
    values.put("mode", SettingType.nameOf(settings.mode()));
    values.put("samples_per_pixel", settings.samples());
    values.put("adaptive", settings.adaptive());
    for (Setting<?> setting : FilmHeader.named()) {
      values.put(setting.name(), value(setting, settings));
    }
    values.put("seed", settings.seed());
    values.put("warnings", file.warnings().stream().map(ProblemText::of).toList());
  }

  /**
   * Returns a value for JSON: a number or a string; null instead of an infinite limit, and of what
   * is not there.
   */
  private static Object value(Setting<?> setting, RenderSettings settings) {
    Object value = settings.get(setting);
    if (value instanceof Optional<?> color) {
      return color.isPresent() ? settings.text(setting) : null;
    }
    if (value instanceof Double number) {
      return Double.isFinite(number) ? number : null;
    }
    return value instanceof Enum<?> constant ? SettingType.nameOf(constant) : value;
  }

  /** Adds the counts of a scene's contents. */
  public void putContents(SceneContents contents) {
    values.put("camera", contents.camera());
    values.put("shapes", contents.shapes());
    values.put("meshes", contents.meshes());
    values.put("triangles", contents.triangles());
    values.put("points", contents.points());
    values.put("lights", contents.lights());
    values.put("materials", contents.materials());
    values.put("textures", contents.textures());
  }

  /** Adds the names of what a model offers, its bounds and its parts. */
  public void putModel(ModelContents model, PartTable parts) {
    values.put("cameras", model.cameras());
    values.put(
        "animations",
        model.animations().stream()
            .map(
                animation -> {
                  Map<String, Object> entry = new LinkedHashMap<>();
                  entry.put("name", animation.name());
                  animation.seconds().ifPresent(seconds -> entry.put("seconds", seconds));
                  return entry;
                })
            .toList());
    values.put("variants", model.variants());
    values.put("material_names", model.materials());
    if (!model.unit().isEmpty()) {
      values.put("unit", "meter");
      values.put("file_unit", model.unit());
    }
    values.put("bounds", PartJson.bounds(new Bounds3(model.min(), model.max())));
    values.put("part_count", parts.parts().size());
    values.put("parts", PartJson.parts(parts));
  }

  /** Adds the contents of a model, and what its pictures show; nothing without a model. */
  public void putPictures(Map<Path, SceneFile> pictures) {
    ParsedScene first = pictures.values().iterator().next().parsed();
    if (first.model().isPresent()) {
      PartTable parts = first.model().get().parts(first.scene());
      putContents(first.contents());
      putModel(first.model().get(), parts);
      pictures.forEach(
          (path, file) -> {
            ViewNumbers numbers = ViewNumbers.of(file.scene(), file.settings(), parts);
            putView("file", path, file.settings(), numbers, parts);
          });
    }
  }

  /** Adds what a picture of a model shows to the list of views. */
  public void putView(
      String key, Object name, RenderSettings settings, ViewNumbers numbers, PartTable parts) {
    List<Object> views = new ArrayList<>();
    if (values.get("views") instanceof List<?> before) {
      views.addAll(before);
    }
    Map<String, Object> view = new LinkedHashMap<>();
    view.put(key, name.toString());
    view.putAll(PartJson.view(settings, numbers, parts));
    views.add(view);
    values.put("views", views);
  }

  /** Adds the estimated memory of a render. */
  public void putEstimate(MemoryEstimate estimate) {
    values.put("pixels", estimate.pixels());
    values.put("threads", estimate.threads());
    values.put("film_bytes", estimate.filmBytes());
    values.put("scene_bytes", estimate.sceneBytes());
    values.put("thread_bytes", estimate.threadBytes());
    values.put("needed_bytes", estimate.neededBytes());
    values.put("checkpoint_copy_bytes", estimate.copyBytes());
    values.put("max_heap_bytes", estimate.maxHeapBytes());
    values.put("fits", estimate.fits());
  }

  /** Returns whether the added result is a partial picture. */
  public boolean isPartial() {
    return Boolean.FALSE.equals(values.get("complete"));
  }

  /**
   * Adds the result of a render. A rejected sample is listed as x and y in the full frame, and
   * index.
   *
   * @param seconds rendering time
   */
  public void putResult(RenderResult result, double seconds) {
    RenderStatistics statistics = result.statistics();
    values.put("complete", result.complete());
    values.put("seconds", seconds);
    values.put("samples", statistics.samples());
    values.put("rays", statistics.rays());
    values.put("shadow_rays", statistics.shadowRays());
    values.put("rejected", statistics.rejected());
    values.put(
        "first_rejected",
        statistics.firstRejected().stream()
            .map(sample -> List.of(sample.x(), sample.y(), sample.sample()))
            .toList());
    values.put("saturated", statistics.saturated());
    values.put("faint", statistics.faint());
    // Classes that other commands do not need.
    values.put("peak_heap_bytes", (Supplier<Long>) Summary::peakHeapBytes);
  }
}
