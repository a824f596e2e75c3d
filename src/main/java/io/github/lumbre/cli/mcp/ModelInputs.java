package io.github.lumbre.cli.mcp;

import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The arguments that several tools take. Stateless. */
final class ModelInputs {
  static final Input<String> MODEL =
      Input.requiredText(
          "model", "Path of a glTF, GLB, OBJ, PLY, STL, OFF, 3MF or ZIP file with a 3D model.");

  private static final Map<ModelOption<?>, Input<?>> INPUTS = new LinkedHashMap<>();

  static {
    Stage.all().stream()
        .filter(option -> !option.tool().isEmpty())
        .sorted(Comparator.comparing(ModelOption::tool))
        .forEach(option -> INPUTS.put(option, input(option)));
  }

  private ModelInputs() {}

  private static Input<?> input(ModelOption<?> option) {
    if (option.toolValue().isPresent()) {
      return Input.flag(option.tool(), option.toolHelp());
    }
    return option.type() instanceof TextsType
        ? Input.texts(option.tool(), option.toolHelp())
        : Input.text(option.tool(), option.toolHelp());
  }

  /** Returns the argument of an option. */
  static Input<?> of(ModelOption<?> option) {
    return INPUTS.get(option);
  }

  /** Returns the arguments of all options but some, by their names. */
  static List<Input<?>> allBut(ModelOption<?>... others) {
    List<ModelOption<?>> left = new ArrayList<>(INPUTS.keySet());
    left.removeAll(List.of(others));
    return left.stream().<Input<?>>map(INPUTS::get).toList();
  }

  /** Returns the model that the arguments name. */
  static Studio.Staged model(Studio studio, Arguments arguments) throws ToolException {
    Stage stage = Stage.DEFAULT;
    for (ModelOption<?> option : INPUTS.keySet()) {
      stage = with(option, arguments, stage);
    }
    return studio.model(arguments.get(MODEL), stage);
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

  @SuppressWarnings("unchecked") // Lists of texts are values of such options.
  private static <T> Optional<T> value(ModelOption<T> option, Object given) {
    if (given instanceof Boolean isSet) {
      return option.toolValue().filter(value -> isSet);
    }
    return given instanceof List<?> texts
        ? Optional.of((T) texts)
        : ((Optional<String>) given).map(option.type()::parse);
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
