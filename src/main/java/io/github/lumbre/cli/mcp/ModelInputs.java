package io.github.lumbre.cli.mcp;

import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.CameraChoice;
import io.github.lumbre.stage.internal.Look;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The arguments that several tools take: those of the options of models. Stateless. */
final class ModelInputs {
  static final Input<String> MODEL =
      Input.requiredText(
          "model",
          "Path of a glTF, GLB, OBJ, PLY, STL, OFF, 3MF, COLLADA or ZIP file with a 3D model.");

  /** The same argument of tools that show scenes, too. */
  static final Input<String> MODEL_OR_SCENE =
      Input.requiredText(
          "model",
          "Path of a glTF, GLB, OBJ, PLY, STL, OFF, 3MF, COLLADA or ZIP file with a 3D model, or of a"
              + " scene in JSON, whose own camera and settings count within the bounds of this tool.");

  /** The options that say where the camera is. */
  private static final List<ModelOption<?>> PLACES =
      List.of(Stage.VIEW, Stage.CAMERA, Stage.EYE, Stage.TARGET);

  private static final Map<ModelOption<?>, Input<?>> INPUTS = new LinkedHashMap<>();

  static {
    Stage.all().stream()
        .filter(option -> !option.tool().isEmpty())
        .sorted(Comparator.comparing(ModelOption::tool))
        .forEach(option -> INPUTS.put(option, input(option)));
  }

  private ModelInputs() {}

  private static Input<?> input(ModelOption<?> option) {
    String name = option.tool();
    String help = option.toolHelp();
    if (option.toolValue().isPresent() || option.type() instanceof FlagType) {
      return Input.flag(name, help);
    }
    if (option.type() instanceof NumberType numbers) {
      return Input.number(name, numbers, help);
    }
    return option.type() instanceof TextsType ? Input.texts(name, help) : Input.text(name, help);
  }

  /** Returns the arguments of all options but some, by their names. */
  static List<Input<?>> allBut(ModelOption<?>... others) {
    List<ModelOption<?>> left = new ArrayList<>(INPUTS.keySet());
    left.removeAll(List.of(others));
    return left.stream().<Input<?>>map(INPUTS::get).toList();
  }

  /** Returns the arguments of all options but those that say where the camera is. */
  static List<Input<?>> withoutPlace() {
    return allBut(PLACES.toArray(ModelOption<?>[]::new));
  }

  /** Returns the arguments of what is read of a file, for tools that show no picture. */
  static List<Input<?>> ofReading() {
    return List.of(
        INPUTS.get(ModelOption.POSE),
        INPUTS.get(ModelOption.UNIT),
        INPUTS.get(ModelOption.VARIANT),
        INPUTS.get(ModelOption.UP));
  }

  /** Returns the argument of an option. */
  static Input<?> of(ModelOption<?> option) {
    return INPUTS.get(option);
  }

  /**
   * Requires that no option of a model is stated, as for a scene.
   *
   * @throws ToolException that names the first one that is
   */
  static void requireNone(Arguments arguments) throws ToolException {
    for (Input<?> input : INPUTS.values()) {
      if (arguments.isGiven(input)) {
        throw new ToolException(
            input.name() + ": requires a model; a scene in JSON states its own camera and objects");
      }
    }
  }

  /** Returns the stage that the arguments describe; without a camera, at the default view. */
  static Stage stage(Arguments arguments) throws ToolException {
    Stage stage = Stage.DEFAULT;
    for (ModelOption<?> option : INPUTS.keySet()) {
      stage = with(option, arguments, stage);
    }
    requireSuiting(stage);
    return stage.find(Stage.CAMERA).isPresent() ? stage : stage.framed();
  }

  private static void requireSuiting(Stage stage) throws ToolException {
    Optional<String> contradiction = CameraChoice.contradiction(stage, ModelOption::tool);
    if (contradiction.isPresent()) {
      throw new ToolException(contradiction.get());
    }
    if (stage.get(Stage.GROUND) && Look.of(stage.find(Stage.LOOK)).isDrawing()) {
      throw new ToolException(
          "ground: cannot be combined with the look 'lines', which has no shadows");
    }
  }

  /** Returns what a picture on a stage is called. */
  static String title(Arguments arguments) {
    Optional<String> camera = text(Stage.CAMERA, arguments).map(name -> "camera " + name);
    Optional<String> eye = text(Stage.EYE, arguments).map(place -> "eye " + place);
    return text(Stage.VIEW, arguments).or(() -> eye).or(() -> camera).orElse("30,20");
  }

  @SuppressWarnings("unchecked") // The arguments of these options are texts.
  private static Optional<String> text(ModelOption<?> option, Arguments arguments) {
    return (Optional<String>) arguments.get(INPUTS.get(option));
  }

  private static <T> Stage with(ModelOption<T> option, Arguments arguments, Stage stage)
      throws ToolException {
    try {
      Optional<T> value = value(option, arguments.get(INPUTS.get(option)));
      value.filter(v -> !option.type().accepts(v)).ifPresent(v -> refuse(option, v));
      return value.map(v -> stage.with(option, v)).orElse(stage);
    } catch (IllegalArgumentException e) {
      throw new ToolException(option.tool() + ": " + e.getMessage(), e);
    }
  }

  private static <T> void refuse(ModelOption<T> option, T value) {
    throw new IllegalArgumentException(option.type().refusal(value));
  }

  @SuppressWarnings("unchecked") // The arguments of options have values of their types, or texts.
  private static <T> Optional<T> value(ModelOption<T> option, Object given) {
    if (given instanceof Boolean isSet) {
      return isSet ? option.toolValue().or(() -> Optional.of((T) Boolean.TRUE)) : Optional.empty();
    }
    if (given instanceof Optional<?> value) {
      return value.map(v -> v instanceof String text ? option.type().parse(text) : (T) v);
    }
    return Optional.of((T) given);
  }
}
