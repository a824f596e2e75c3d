package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * What a parser makes of the settings of a scene. Immutable.
 *
 * @param mode render mode that overrides the scene's; empty to keep it
 * @param change is applied to valid settings
 * @param limits that the changed settings must not exceed
 */
record SettingsChange(
    Optional<RenderSettings.Mode> mode, UnaryOperator<RenderSettings> change, Limits limits) {
  /** No change. */
  static final SettingsChange NONE =
      new SettingsChange(
          Optional.empty(),
          UnaryOperator.identity(),
          Limits.NONE.withPixels(SceneParser.MAX_PIXELS));

  SettingsChange inMode(RenderSettings.Mode newMode) {
    return new SettingsChange(Optional.of(newMode), change, limits);
  }

  SettingsChange overriding(UnaryOperator<RenderSettings> newChange) {
    return new SettingsChange(mode, Objects.requireNonNull(newChange, "newChange"), limits);
  }

  SettingsChange limitedTo(Limits newLimits) {
    return new SettingsChange(mode, change, newLimits);
  }

  /** Returns the settings of a scene that states none. */
  RenderSettings defaults() {
    return SettingsReader.defaults(mode);
  }

  /** Returns the settings; the caller's changes apply only if the file's settings are valid. */
  RenderSettings read(Optional<JsonNode> options, Problems problems) {
    boolean hadErrors = problems.hasErrors();
    RenderSettings inFile =
        options.map(o -> SettingsReader.read(o, mode)).orElseGet(this::defaults);
    if (problems.hasErrors() && !hadErrors) {
      return inFile;
    }
    return changed(inFile, "$.renderOptions", problems);
  }

  /**
   * Returns settings with the caller's changes, and equally many samples of each pose; adds an
   * error for each that exceeds a limit.
   *
   * @param place of the settings, for messages
   */
  RenderSettings changed(RenderSettings inFile, String place, Problems problems) {
    RenderSettings used = change.apply(inFile).withWholePoses();
    boolean isInFile = used.width() == inFile.width() && used.height() == inFile.height();
    if ((long) used.width() * used.height() > limits.pixels()) {
      boolean overrides = place.startsWith("$") && !isInFile;
      String where = overrides ? "the size that overrides " + place : place;
      String found = used.width() + "x" + used.height();
      problems.error(
          Kind.LIMIT,
          () -> where,
          "expected width x height <= " + limits.pixels() + ", found " + found);
    }
    Limits.excess("samples per pixel", limits.samples(), used.samples())
        .ifPresent(excess -> problems.error(Kind.LIMIT, () -> place, excess));
    return used;
  }
}
