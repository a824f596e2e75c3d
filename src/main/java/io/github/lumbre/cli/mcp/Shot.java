package io.github.lumbre.cli.mcp;

import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.stage.internal.ViewNumbers;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What a call takes a picture of: a scene, seen by its camera. Immutable.
 *
 * @param title what the view is called
 * @param parts of the model; none in other scenes
 * @param notes what was changed of the scene's settings
 * @param identity of what the scene is made of: two shots with equal ones and equal settings have
 *     the same picture
 */
record Shot(
    Path path,
    String title,
    SceneFile file,
    PartTable parts,
    List<String> notes,
    List<Object> identity) {
  Shot {
    notes = List.copyOf(notes);
    identity = List.copyOf(identity);
  }

  /** Returns this shot with other settings. */
  Shot with(RenderSettings settings) {
    return new Shot(path, title, file.with(settings), parts, notes, identity);
  }

  /** Returns whether the scene is made around a model. */
  boolean isModel() {
    return file.parsed().model().isPresent();
  }

  /** Returns a summary of a tool's result: the file, and what a picture of it lacks. */
  JsonSummary summary(String tool) {
    JsonSummary summary = new JsonSummary(tool, isModel() ? "model" : "scene", path);
    summary.put("warnings", file.warnings().stream().map(Problem::toString).toList());
    return summary;
  }

  /** Adds what is seen. */
  void describe(JsonSummary summary) {
    file.settings().crop().ifPresent(crop -> summary.put("crop", crop.toString()));
    summary.putView("view", title, file.settings(), numbers(), parts);
  }

  private ViewNumbers numbers() {
    RenderSettings settings = file.settings();
    if (isModel()) {
      return ViewNumbers.of(file.scene(), settings, parts);
    }
    Crop window = settings.window();
    Optional<Projection> projection =
        Projection.of(
            file.scene().framed(settings.aspect()).camera(), settings.width(), settings.height());
    return new ViewNumbers(
        projection.map(p -> p.cropped(window.x(), window.y())),
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        List.of());
  }

  /** Returns how lengths of results are rounded. */
  Rounding rounding() {
    Optional<ModelContents> model = file.parsed().model();
    double size = 2 * file.scene().radius();
    return model.isPresent()
        ? Rounding.of(model.get().min(), model.get().max())
        : Rounding.of(Vec3.ZERO, new Vec3(size, 0, 0));
  }
}
