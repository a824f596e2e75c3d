package io.github.lumbre.model;

import io.github.lumbre.model.internal.ModelReach;
import io.github.lumbre.model.internal.OptionTypes.FoldersType;
import io.github.lumbre.model.internal.OptionTypes.NamedType;
import io.github.lumbre.model.internal.OptionTypes.PoseType;
import io.github.lumbre.model.internal.OptionTypes.TextType;
import io.github.lumbre.model.internal.OptionTypes.TextsType;
import io.github.lumbre.model.section.Section;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An option of a model, with its name, values, default and meaning. This is the only declaration:
 * flags, tools for agents, scene files and Java all use it. The constants of this class say what is
 * read from a file; those of a stage say how it is shown. Immutable.
 *
 * @param <T> the type of its values
 */
public final class ModelOption<T> {
  private static final String CLAY = ModelOptions.CLAY;
  private static final String WHITE = ModelOptions.WHITE;

  private static final NumberType LENGTH =
      new NumberType(ModelReach.SMALLEST, ModelReach.LARGEST);

  /** See {@link ModelOptions#up}. */
  public static final ModelOption<ModelOptions.Up> UP =
      new ModelOption<>(
              "up",
              new NamedType<>(Map.of("y", ModelOptions.Up.Y, "z", ModelOptions.Up.Z)),
              "Axis of the file that points up (y; glTF and 3MF: as the file states).")
          .withFlag("up", "y|z")
          .inScenes()
          .inTools(
              "z_up",
              "Whether the z axis of the file points up, whatever it states.",
              Optional.of(ModelOptions.Up.Z));

  /** See {@link ModelOptions#unit}. */
  public static final ModelOption<Double> UNIT =
      new ModelOption<>(
              "unit",
              LENGTH,
              "Length of the file's unit (1; glTF and 3MF: as the file states, in meters).")
          .inScenes()
          .withFlag("unit", "LENGTH");

  /** See {@link ModelOptions#pointRadius}. */
  public static final ModelOption<Double> POINT_RADIUS =
      new ModelOption<>(
              "pointRadius", LENGTH, "Radius of points, in the file's unit (by their density).")
          .inScenes()
          .withFlag("points", "RADIUS");

  /** See {@link ModelOptions#sections}. */
  public static final ModelOption<List<String>> SECTION =
      new ModelOption<>(
              "section",
              new TextsType(Section.EXPECTED, "", Section::isValid),
              "Cut the model by a plane: x=0.5 in the file's unit, y=50%, -z=2 to remove the other"
                  + " side, or a point and a normal 0,0,1/1,1,0. Repeatable: two remove a quarter.")
          .withDefault(List.of())
          .inScenes()
          .withFlag("section", "PLANE")
          .inTools(
              "planes",
              "Planes that cut the model, in the file's axes and unit, or in percent of its bounds:"
                  + " x=0.5 or y=50% removes what is in front of the plane, seen from the right,"
                  + " the top or the front; +z=2 removes larger z, -z=2 smaller z; 0,0,1/1,1,0 is a"
                  + " plane by a point and a normal to the removed side. Two planes remove a"
                  + " quarter.");

  /** See {@link ModelOptions#pose}. */
  public static final ModelOption<ModelOptions.Pose> POSE =
      new ModelOption<>("pose", new PoseType(), "Pose of an animation at a time (the rest pose).")
          .inScenes()
          .withFlag("pose", "NAME@SECONDS");

  /** See {@link ModelOptions#variant}. */
  public static final ModelOption<String> VARIANT =
      new ModelOption<>(
              "variant",
              new TextType("a name"),
              "Material variant to use (the default materials).")
          .inScenes()
          .withFlag("variant", "NAME");

  /** See {@link ModelOptions#look}. */
  public static final ModelOption<String> LOOK =
      new ModelOption<>(
              "look",
              new NamedType<>(Map.of(CLAY, CLAY, WHITE, WHITE)),
              "Material that replaces all others.")
          .inScenes();

  /** See {@link ModelOptions#hidden}. */
  public static final ModelOption<List<String>> HIDE =
      new ModelOption<>(
              "hide",
              new TextsType("names", "", name -> true),
              "Leave out a node, object, group or solid, or 'piece N' in a file without them; '*'"
                  + " stands for any text. Repeatable; 'lumbre check' lists the parts.")
          .withDefault(List.of())
          .inScenes()
          .withFlag("hide", "PART")
          .inTools(
              "hide",
              "Names of parts to leave out, as 'describe' lists them; * stands for any text.");

  /** See {@link ModelOptions#highlighted}. */
  public static final ModelOption<List<String>> HIGHLIGHT =
      new ModelOption<>(
              "highlight",
              new TextsType("names", "", name -> true),
              "Show a part in its color, or in orange, and all others pale. Repeatable.")
          .withDefault(List.of())
          .inScenes()
          .withFlag("highlight", "PART")
          .inTools("highlight", "Names of parts to show in color, and all others pale.");

  /** See {@link ModelOptions#assets}. */
  public static final ModelOption<List<Path>> ASSETS =
      new ModelOption<>(
              "assets",
              new FoldersType(),
              "Further folder from which textures and buffers that the model names may come."
                  + " Repeatable.")
          .withDefault(List.<Path>of())
          .withFlag("assets", "DIR");

  private static final List<ModelOption<?>> ALL =
      List.of(UP, UNIT, POINT_RADIUS, SECTION, POSE, VARIANT, LOOK, HIDE, HIGHLIGHT, ASSETS);

  private final String name;
  private final SettingType<T> type;
  private final String help;
  private final Optional<T> missing;
  private final boolean inScenes;
  private final Usage<T> usage;

  /**
   * Where an option is used besides Java and scenes; empty texts where it is not.
   *
   * @param toolValue the value that a true argument of a tool has; empty if the tool takes values
   */
  private record Usage<T>(
      String flag, String label, String tool, String toolHelp, Optional<T> toolValue) {}

  private ModelOption(
      String name,
      SettingType<T> type,
      String help,
      Optional<T> missing,
      boolean inScenes,
      Usage<T> usage) {
    this.name = name;
    this.type = type;
    this.help = help;
    this.missing = missing;
    this.inScenes = inScenes;
    this.usage = usage;
  }

  /**
   * Declares an option without a default, which only Java has.
   *
   * @param help what it does, for help texts; {@code {default}} stands for the default
   */
  public ModelOption(String name, SettingType<T> type, String help) {
    this(name, type, help, Optional.empty(), false, new Usage<>("", "", "", "", Optional.empty()));
  }

  /** Returns this option with a default. */
  public ModelOption<T> withDefault(T value) {
    return new ModelOption<>(name, type, help, Optional.of(value), inScenes, usage);
  }

  /** Returns this option as a key of a model object in scenes. */
  private ModelOption<T> inScenes() {
    return new ModelOption<>(name, type, help, missing, true, usage);
  }

  /**
   * Returns this option with a flag of the command line.
   *
   * @param flag without hyphens before it
   * @param label stands for the value in help texts; empty for a flag without a value
   */
  public ModelOption<T> withFlag(String flag, String label) {
    Usage<T> used = new Usage<>(flag, label, usage.tool, usage.toolHelp, usage.toolValue);
    return new ModelOption<>(name, type, help, missing, inScenes, used);
  }

  /** Returns this option as an argument of the tools for agents, with a description for them. */
  public ModelOption<T> inTools(String tool, String toolHelp) {
    return inTools(tool, toolHelp, Optional.empty());
  }

  private ModelOption<T> inTools(String tool, String toolHelp, Optional<T> ifTrue) {
    Usage<T> used = new Usage<>(usage.flag, usage.label, tool, toolHelp, ifTrue);
    return new ModelOption<>(name, type, help, missing, inScenes, used);
  }

  /** Returns the options of this class, in the order of scene files. */
  public static List<ModelOption<?>> all() {
    return ALL;
  }

  /** Returns the name, which is the key in scenes if {@link #isInScenes}. */
  public String name() {
    return name;
  }

  /** Returns the type, which defines the allowed values and their text form. */
  public SettingType<T> type() {
    return type;
  }

  /** Returns the default; empty if it depends on the file or on other options. */
  public Optional<T> missing() {
    return missing;
  }

  /** Returns a description for help texts, with the default. */
  public String help() {
    return help.replace("{default}", missing.map(type::shown).orElse(""));
  }

  /** Returns whether model objects of scenes have it as a key. */
  public boolean isInScenes() {
    return inScenes;
  }

  /** Returns the command line flag; an empty text if there is none. */
  public String flag() {
    return usage.flag.isEmpty() ? "" : "--" + usage.flag;
  }

  /** Returns the placeholder of the flag's value; empty for a flag without a value. */
  public String label() {
    return usage.label;
  }

  /** Returns the name of the argument of tools; an empty text if there is none. */
  public String tool() {
    return usage.tool;
  }

  /** Returns the description of the argument of tools. */
  public String toolHelp() {
    return usage.toolHelp;
  }

  /** Returns the value that the argument of tools sets if it is true; empty if it has values. */
  public Optional<T> toolValue() {
    return usage.toolValue;
  }

  /**
   * Returns the value if it is in range.
   *
   * @throws IllegalArgumentException if it is not; the message names the option, the expected
   *     values and the value
   */
  public T require(T value) {
    return type.require(name, value);
  }

  @Override
  public String toString() {
    return name;
  }
}
