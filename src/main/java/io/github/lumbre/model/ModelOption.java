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
 * An option of a model. This is the only declaration: flags, tools for agents, scene files and Java
 * all use it. The constants of this class say what is read from a file; those of a stage say how it
 * is shown. Immutable.
 *
 * @param <T> the type of its values
 * @param name is the key of model objects if {@code isInScenes}
 * @param type defines the allowed values and their text form
 * @param help what it does, for help texts; {@code {default}} stands for the default
 * @param defaultValue empty if it depends on the file or on other options
 * @param isInScenes whether model objects of scenes have it
 * @param flag of the command line; an empty text if there is none
 * @param label stands for the flag's value in help texts; empty for a flag without a value
 * @param tool name of the argument of tools for agents; an empty text if there is none
 * @param toolHelp what the argument does
 * @param toolValue the value that a true argument sets; empty if the argument has values
 */
public record ModelOption<T>(
    String name,
    SettingType<T> type,
    String help,
    Optional<T> defaultValue,
    boolean isInScenes,
    String flag,
    String label,
    String tool,
    String toolHelp,
    Optional<T> toolValue) {
  private static final String CLAY = ModelOptions.CLAY;
  private static final String WHITE = ModelOptions.WHITE;

  private static final NumberType LENGTH =
      new NumberType(ModelReach.SMALLEST, ModelReach.LARGEST);

  /**
   * The axis of the file that points up; without it, the one that its format states: +Y in glTF, +Z
   * in 3MF, any in COLLADA, and +Y in STL, PLY, OBJ and OFF, which state none.
   */
  public static final ModelOption<ModelOptions.Up> UP =
      new ModelOption<>(
              "up",
              new NamedType<>(Map.of("y", ModelOptions.Up.Y, "z", ModelOptions.Up.Z)),
              "Axis of the file that points up (as the file states, else y).")
          .withFlag("up", "y|z")
          .inScenes()
          .inTools(
              "z_up",
              "Whether the z axis of the file points up, whatever it states.",
              Optional.of(ModelOptions.Up.Z));

  /**
   * The length of the file's unit in world units; without it, the one that the file states in
   * meters (glTF, 3MF, COLLADA), and 1 for formats that state none.
   */
  public static final ModelOption<Double> UNIT =
      new ModelOption<>(
              "unit",
              LENGTH,
              "Length of the file's unit (as the file states, in meters, else 1).")
          .inScenes()
          .withFlag("unit", "LENGTH")
          .inTools("unit", "Length of the file's unit; without it, as the file states, in meters.");

  /**
   * The radius of the spheres that show points, in the file's unit; without it, half the median
   * distance of a point to the nearest other one.
   */
  public static final ModelOption<Double> POINT_RADIUS =
      new ModelOption<>(
              "pointRadius", LENGTH, "Radius of points, in the file's unit (by their density).")
          .inScenes()
          .withFlag("points", "RADIUS");

  /**
   * Planes that cut the model: what is in front of all of them is removed, and closed parts get a
   * hatched surface there. {@code x=0.5} is a plane across an axis of the file, in its unit, {@code
   * y=50%} in percent of the model's bounds, and {@code 0,0,1/1,1,0} a point and a normal, which
   * points to the front. In front of an axis is the viewer from the right, the top or the front;
   * {@code +x=0.5} and {@code -x=0.5} name the removed side.
   */
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

  /**
   * How far parts are moved apart, from 0 to 1, where the boxes around no two of them overlap. They
   * move in straight lines, along the common axis of a pair or across its thinnest overlap; parts
   * of one node first. The planes of {@link #SECTION} are those of the model before.
   */
  public static final ModelOption<Double> EXPLODE =
      new ModelOption<>(
              "explode",
              new NumberType(0, 1),
              "Move the parts apart: 1 until no boxes around them overlap ({default}). A range such"
                  + " as 0..1 is an animation.")
          .withDefault(0.)
          .inScenes()
          .withFlag("explode", "FACTOR|A..B")
          .inTools(
              "explode",
              "How far the parts are moved apart, from 0 to 1, where no boxes around them overlap"
                  + " (0).");

  /** The animation and time whose pose is used; without it, the rest pose. */
  public static final ModelOption<ModelOptions.Pose> POSE =
      new ModelOption<>("pose", new PoseType(), "Pose of an animation at a time (the rest pose).")
          .inScenes()
          .withFlag("pose", "NAME@SECONDS")
          .inTools(
              "pose",
              "Animation and time whose pose is shown, such as walk@0.5; 'describe' lists the"
                  + " animations. Without it, the rest pose.");

  /** The name of the material variant; without it, the default materials. */
  public static final ModelOption<String> VARIANT =
      new ModelOption<>(
              "variant",
              new TextType("a name"),
              "Material variant to use (the default materials).")
          .inScenes()
          .withFlag("variant", "NAME")
          .inTools(
              "variant", "Material variant, as 'describe' lists it; without it, the default.");

  /**
   * {@link ModelOptions#CLAY} or {@link ModelOptions#WHITE}, which replaces all materials; without
   * it, the materials of the file.
   */
  public static final ModelOption<String> LOOK =
      new ModelOption<>(
              "look",
              new NamedType<>(Map.of(CLAY, CLAY, WHITE, WHITE)),
              "Material that replaces all others.")
          .inScenes();

  /**
   * Names of parts to leave out; {@code *} stands for any text. A part is a node or an object with
   * all below it, a group or a solid; in a file without them, a connected piece, such as {@code
   * piece 2}.
   */
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

  /** Names of parts, as of {@link #HIDE}, beside which all others are pale. */
  public static final ModelOption<List<String>> HIGHLIGHT =
      new ModelOption<>(
              "highlight",
              new TextsType("names", "", name -> true),
              "Show a part in its color, or in orange, and all others pale. Repeatable.")
          .withDefault(List.of())
          .inScenes()
          .withFlag("highlight", "PART")
          .inTools("highlight", "Names of parts to show in color, and all others pale.");

  /**
   * Folders, besides that of the model, from which files that it names may come; see {@link
   * ModelFolder#of(Path, List)}. They have no effect if the bytes of the limits are limited, as
   * those of uploads are, or if the caller passes a {@link ModelFolder}.
   */
  public static final ModelOption<List<Path>> ASSETS =
      new ModelOption<>(
              "assets",
              new FoldersType(),
              "Further folder from which textures and buffers that the model names may come."
                  + " Repeatable.")
          .withDefault(List.<Path>of())
          .withFlag("assets", "DIR");

  private static final List<ModelOption<?>> ALL =
      List.of(
          UP, UNIT, POINT_RADIUS, SECTION, EXPLODE, POSE, VARIANT, LOOK, HIDE, HIGHLIGHT, ASSETS);

  /** Declares an option without a default, which only Java has. */
  public ModelOption(String name, SettingType<T> type, String help) {
    this(name, type, help, Optional.empty(), false, "", "", "", "", Optional.empty());
  }

  /** Returns this option with a default. */
  public ModelOption<T> withDefault(T value) {
    String text = help.replace("{default}", type.shown(value));
    return new ModelOption<>(
        name, type, text, Optional.of(value), isInScenes, flag, label, tool, toolHelp, toolValue);
  }

  private ModelOption<T> inScenes() {
    return new ModelOption<>(
        name, type, help, defaultValue, true, flag, label, tool, toolHelp, toolValue);
  }

  /** Returns this option with a flag, whose name is given without hyphens before it. */
  public ModelOption<T> withFlag(String newFlag, String newLabel) {
    return new ModelOption<>(
        name,
        type,
        help,
        defaultValue,
        isInScenes,
        "--" + newFlag,
        newLabel,
        tool,
        toolHelp,
        toolValue);
  }

  /** Returns this option as an argument of the tools for agents, with a description for them. */
  public ModelOption<T> inTools(String newTool, String newHelp) {
    return inTools(newTool, newHelp, Optional.empty());
  }

  private ModelOption<T> inTools(String newTool, String newHelp, Optional<T> ifTrue) {
    return new ModelOption<>(
        name, type, help, defaultValue, isInScenes, flag, label, newTool, newHelp, ifTrue);
  }

  /** Returns the options of this class, in the order of scene files. */
  public static List<ModelOption<?>> all() {
    return ALL;
  }

  // Java would make the code of the next two at the first call, which delays each start.

  @Override
  public boolean equals(Object other) {
    return this == other
        || other instanceof ModelOption<?> option
            && name.equals(option.name)
            && parts().equals(option.parts());
  }

  private List<Object> parts() {
    return List.of(
        help, flag, label, tool, toolHelp, isInScenes, type, defaultValue, toolValue);
  }

  @Override
  public int hashCode() {
    return name.hashCode();
  }

  @Override
  public String toString() {
    return name;
  }
}
