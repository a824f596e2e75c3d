package io.github.lumbre.cli.mcp;

import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.parser.Stage;
import io.github.lumbre.parser.Stage.Sky;
import io.github.lumbre.parser.Stage.View;
import io.github.lumbre.parser.internal.Look;
import io.github.lumbre.scene.Setting;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/** The arguments that several tools take. Stateless. */
final class ModelInputs {
  static final Input<String> MODEL =
      Input.requiredText(
          "model", "Path of a glTF, GLB, OBJ, PLY, STL, OFF, 3MF or ZIP file with a 3D model.");

  static final Input<Boolean> Z_UP =
      Input.flag("z_up", "Whether the z axis of the file points up, whatever it states.");

  static final Input<List<String>> HIDE =
      Input.texts(
          "hide", "Names of parts to leave out, as 'describe' lists them; * stands for any text.");

  static final Input<List<String>> HIGHLIGHT =
      Input.texts("highlight", "Names of parts to show in color, and all others pale.");

  static final Input<List<String>> PLANES =
      Input.texts(
          "planes",
          "Planes that cut the model, in the file's axes and unit, or in percent of its bounds:"
              + " x=0.5 or y=50% removes what is in front of the plane, seen from the right, the"
              + " top or the front; +z=2 removes larger z, -z=2 smaller z; 0,0,1/1,1,0 is a plane"
              + " by a point and a normal to the removed side. Two planes remove a quarter.");

  static final Input<List<String>> LABELS =
      Input.texts(
          "labels",
          "Labels to draw, some of: "
              + String.join(", ", Stage.LABELS)
              + ". Axes and dimensions are in the file's axes and unit; parts are names.");

  static final Input<Optional<String>> LOOK =
      Input.text(
          "look",
          "Shows the shape alone: clay (matte, light gray), lines (black on white: silhouettes,"
              + " creases and borders), or clay,lines. Without it, as the file says.");

  private ModelInputs() {}

  /** Returns the model that the arguments name. */
  static Studio.Staged model(Studio studio, Arguments arguments) throws ToolException {
    return studio.model(arguments.get(MODEL), stage(arguments));
  }

  private static Stage stage(Arguments arguments) throws ToolException {
    Look look = look(arguments.get(LOOK));
    Optional<Up> up = arguments.get(Z_UP) ? Optional.of(Up.Z) : Optional.empty();
    ModelOptions options =
        ModelOptions.DEFAULT
            .oriented(up, OptionalDouble.empty())
            .hiding(arguments.get(HIDE))
            .highlighting(arguments.get(HIGHLIGHT))
            .looking(look.materials());
    List<String> labels = arguments.get(LABELS);
    if (!Stage.LABELS.containsAll(labels)) {
      throw new ToolException("labels: expected some of " + Stage.LABELS + ", found " + labels);
    }
    try {
      return new Stage(
          Optional.empty(),
          Optional.empty(),
          Stage.DEFAULT_FOV,
          new Sky(look.sky()),
          false,
          look.background(),
          false,
          look.lineWidth(),
          Setting.CREASE_ANGLE.missing(),
          Set.copyOf(labels),
          options.cutBy(arguments.get(PLANES)));
    } catch (IllegalArgumentException e) {
      throw new ToolException("planes: " + e.getMessage(), e);
    }
  }

  private static Look look(Optional<String> text) throws ToolException {
    try {
      return text.map(Look::of).orElse(Look.OF_FILE);
    } catch (IllegalArgumentException e) {
      throw new ToolException("look: " + e.getMessage(), e);
    }
  }

  /** Returns the direction in a text. */
  static View view(String text) throws ToolException {
    try {
      return View.of(text);
    } catch (IllegalArgumentException e) {
      throw new ToolException("view: " + e.getMessage(), e);
    }
  }
}
