package io.github.lumbre.cli.mcp;

import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.parser.Stage;
import io.github.lumbre.parser.Stage.View;
import java.util.Optional;

/** The arguments that several tools take. Stateless. */
final class ModelInputs {
  static final Input<String> MODEL =
      Input.requiredText(
          "model", "Path of a glTF, GLB, OBJ, PLY, STL, OFF, 3MF or ZIP file with a 3D model.");

  static final Input<Boolean> Z_UP =
      Input.flag("z_up", "Whether the z axis of an STL, PLY, OBJ or OFF file points up.");

  private ModelInputs() {}

  /** Returns the model that the arguments name. */
  static Studio.Staged model(Studio studio, Arguments arguments)
      throws ToolException, InterruptedException {
    return studio.model(arguments.get(MODEL), stage(arguments));
  }

  private static Stage stage(Arguments arguments) {
    Up up = arguments.get(Z_UP) ? Up.Z : Up.Y;
    return Stage.DEFAULT.reading(new ModelOptions(Optional.empty(), Optional.empty(), up, 1));
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
