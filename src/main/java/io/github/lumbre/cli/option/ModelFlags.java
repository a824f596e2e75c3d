package io.github.lumbre.cli.option;

import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.internal.OptionTypes.FoldersType;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.CameraChoice;
import io.github.lumbre.stage.internal.Look;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/**
 * The flags for a model file that is rendered by itself, generated from the declarations of the
 * options. Mutable: picocli stores the values from the command line here.
 *
 * <p>A command with this mixin must name {@link SettingFlags.Adder} as its model transformer.
 */
@Command
public final class ModelFlags extends Flags {
  private final Map<ModelOption<?>, Object> given = new LinkedHashMap<>();

  /** Why options have no use in this command. */
  private final Map<ModelOption<?>, String> useless = new HashMap<>();

  /** Whether a range of factors is an animation of this command. */
  private boolean mayExplode;

  /**
   * Takes options from the help of the command, which refuses them.
   *
   * @param reason why they have no use, for the message
   * @return this
   */
  public ModelFlags without(String reason, ModelOption<?>... options) {
    for (ModelOption<?> option : options) {
      useless.put(option, reason);
    }
    return this;
  }

  /** Returns the flags, under their heading. */
  CommandSpec flags() {
    CommandSpec flags = CommandSpec.create();
    flags.usageMessage().optionListHeading(Headings.MODEL);
    Stage.all().stream()
        .filter(option -> !option.flag().isEmpty())
        .forEach(option -> flags.addOption(flag(option)));
    return flags;
  }

  /** Numbers are converted by picocli, texts later, so that messages name the flag alone. */
  private OptionSpec flag(ModelOption<?> option) {
    Given<ModelOption<?>> kept = new Given<>(given, option);
    OptionSpec.Builder flag =
        OptionSpec.builder(option.flag())
            .paramLabel(option.label())
            .arity(option.label().isEmpty() ? "0" : "1")
            .description(option.help().replace("%", "%%"))
            .hidden(useless.containsKey(option))
            .getter(kept)
            .setter(kept);
    if (option.type() instanceof NumberType && option != ModelOption.EXPLODE) {
      return flag.type(Double.class).build();
    }
    if (option.type() instanceof FlagType) {
      return flag.type(boolean.class).build();
    }
    Optional<Class<?>> element = element(option.type());
    return element.isPresent()
        ? flag.type(List.class).auxiliaryTypes(element.get()).build()
        : flag.type(String.class).build();
  }

  /** Returns the type of the values of a repeatable flag; empty for others. */
  private static Optional<Class<?>> element(SettingType<?> type) {
    if (type instanceof FoldersType) {
      return Optional.of(Path.class);
    }
    return type instanceof TextsType texts && texts.separator().isEmpty()
        ? Optional.of(String.class)
        : Optional.empty();
  }

  /**
   * Returns the camera, sky, ground and background of the model.
   *
   * @throws ParameterException that names the flag, if a value is wrong
   */
  public Stage stage() {
    for (ModelOption<?> option : given.keySet()) {
      require(
          !useless.containsKey(option),
          option.flag() + ": cannot be used; " + useless.get(option));
    }
    Stage stage = Stage.DEFAULT;
    for (ModelOption<?> option : Stage.all()) {
      stage = with(option, stage);
    }
    Optional<String> contradiction = CameraChoice.contradiction(stage, ModelOption::flag);
    require(contradiction.isEmpty(), contradiction.orElse(""));
    Look look = Look.of(stage.find(Stage.LOOK));
    require(
        !look.isDrawing() || !isGiven(Stage.GROUND),
        Stage.GROUND.flag() + ": cannot be combined with --look lines, which has no shadows");
    require(
        !isGiven(Stage.SUN) || stage.sky().name().equals("sun"),
        Stage.SUN.flag() + ": requires --sky sun");
    require(
        !isGiven(Stage.PAGE) || !spec.commandLine().getParseResult().hasMatchedOption("--size"),
        Stage.PAGE.flag() + ": cannot be combined with --size");
    for (ModelOption<?> ofLines : List.of(Stage.LINE_WIDTH, Stage.CREASE, Stage.HIDDEN)) {
      require(
          !isGiven(ofLines) || look.hasLines(),
          ofLines.flag() + ": requires --look lines or clay,lines");
    }
    checks().requireFolders(ModelOption.ASSETS.flag(), stage.options().get(ModelOption.ASSETS));
    return stage;
  }

  private <T> Stage with(ModelOption<T> option, Stage stage) {
    if (!isGiven(option)) {
      return stage;
    }
    try {
      return stage.with(option, value(option));
    } catch (IllegalArgumentException e) {
      throw failure(option, e.getMessage());
    }
  }

  @SuppressWarnings("unchecked") // Other values than texts have the type of the option.
  private <T> T value(ModelOption<T> option) {
    Object found = given.get(option);
    if (option == ModelOption.EXPLODE) {
      FactorRange range = FactorRange.of((String) found);
      String refusal = "expected one factor, found a range, which 'lumbre render' animates";
      require(mayExplode || !range.isRange(), FactorRange.FLAG + ": " + refusal);
      return (T) Double.valueOf(range.last());
    }
    SettingType<T> type = option.type();
    T value = found instanceof String text ? type.parse(text) : (T) found;
    if (!type.accepts(value)) {
      throw failure(option, type.refusal(value));
    }
    return value;
  }

  /**
   * Makes the look lines, for drawings as vectors.
   *
   * @throws ParameterException if another look is given
   */
  public void drawLines() {
    Object look = given.getOrDefault(Stage.LOOK, Look.LINES);
    require(
        look.equals(Look.LINES),
        Stage.LOOK.flag() + ": expected " + Look.LINES + " for an .svg file, found " + look);
    boolean isSky = "sky".equalsIgnoreCase(String.valueOf(given.get(Stage.BACKGROUND)));
    require(
        !isSky, Stage.BACKGROUND.flag() + ": expected a color or transparent for an .svg file");
    given.put(Stage.LOOK, Look.LINES);
  }

  private boolean isGiven(ModelOption<?> option) {
    return given.containsKey(option);
  }

  private ParameterException failure(ModelOption<?> option, String message) {
    return new ParameterException(spec.commandLine(), option.flag() + ": " + message);
  }

  /**
   * Requires that no folder of files is given, as for a model from standard input.
   *
   * @throws ParameterException if one is
   */
  void requireNoAssets() {
    require(
        !isGiven(ModelOption.ASSETS),
        "--assets: cannot be used with a model from standard input, which names no files");
  }

  /**
   * Requires that no flag is given which a motion sets.
   *
   * @throws ParameterException that names the flag
   */
  void requireSuits(Motion motion) {
    mayExplode = !motion.explosion().isEmpty();
    require(
        motion.turns() == 0 || !isGiven(Stage.CAMERA),
        "--turntable: cannot be combined with --camera; --view sets the first view");
    require(
        motion.turns() == 0 || !isGiven(Stage.EYE),
        "--turntable: cannot be combined with --eye; --view sets the first view");
    require(
        motion.animation().isEmpty() || !isGiven(ModelOption.POSE),
        "--animation: cannot be combined with --pose, which is one picture of an animation");
  }

  /**
   * Requires that no flag for models is given.
   *
   * @throws ParameterException that names the first one that is
   */
  public void requireNone() {
    given.keySet().stream()
        .findFirst()
        .ifPresent(
            option -> {
              throw failure(option, "requires a model file: " + Models.NAMES);
            });
  }
}
