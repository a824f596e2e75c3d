package io.github.lumbre.model;

import io.github.lumbre.limit.Limits;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.section.Section;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scene.SettingType;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * What to read from a model file, and how.
 *
 * @param pose the animation and time whose pose is used; empty for the rest pose
 * @param variant the name of the material variant; empty for the default materials
 * @param up the axis of the file that points up; empty for the one that its format states: +Y in
 *     glTF, +Z in 3MF, and +Y in STL, PLY, OBJ and OFF, which state none
 * @param unit length of the file's unit in world units, &gt; 0; empty for the one that the file
 *     states in meters (glTF, 3MF), and 1 for formats that state none
 * @param pointRadius radius of the spheres that show points, in the file's unit, &gt; 0; empty for
 *     half the median distance of a point to the nearest other one
 * @param hidden names of parts to leave out; {@code *} stands for any text. A part is a node or an
 *     object with all below it, a group or a solid; in a file without them, a connected piece, such
 *     as {@code piece 2}
 * @param highlighted names of parts, as above, beside which all others are pale; empty for none
 * @param sections planes that cut the model: what is in front of all of them is removed, and closed
 *     parts get a hatched surface there. {@code x=0.5} is a plane across an axis of the file, in
 *     its unit, {@code y=50%} in percent of the model's bounds, and {@code 0,0,1/1,1,0} a point and
 *     a normal, which points to the front. In front of an axis is the viewer from the right, the
 *     top or the front; {@code +x=0.5} and {@code -x=0.5} name the removed side
 * @param look {@link #CLAY} or {@link #WHITE}, which replaces all materials; empty for the
 *     materials of the file
 * @param limits for the model, its textures and its other files
 * @param lenient whether pictures and meshes of a glTF file whose data cannot be read are left out
 *     with a warning, instead of an error; missing pictures of OBJ files always are, and missing
 *     pictures of a model that is rendered by itself
 * @param assets folders, besides that of the model, from which files that it names may come; see
 *     {@link ModelFolder#of(Path, List)}. They have no effect if the bytes of the
 *     limits are limited, as those of uploads are, or if the caller passes a {@link ModelFolder}
 */
public record ModelOptions(
    Optional<Pose> pose,
    Optional<String> variant,
    Optional<Up> up,
    OptionalDouble unit,
    OptionalDouble pointRadius,
    List<String> hidden,
    List<String> highlighted,
    List<String> sections,
    String look,
    Limits limits,
    boolean lenient,
    List<Path> assets) {
  /** The look of matte, light gray surfaces. Cut-outs stay cut out; glass is opaque, too. */
  public static final String CLAY = "clay";

  /** The look of white paper without light and shadow, for drawings. */
  public static final String WHITE = "white";

  /** The rest pose, default materials, and the up axis and unit of the file. */
  public static final ModelOptions DEFAULT =
      new ModelOptions(
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          List.of(),
          List.of(),
          List.of(),
          "",
          Limits.NONE,
          false,
          List.of());

  private static final double QUARTER_TURN_DEGREES = 90;

  /** The axis that points up. */
  public enum Up {
    /** +Y. */
    Y,
    /** +Z: readers map (x, y, z) to (x, z, -y). */
    Z
  }

  /**
   * A point in time of an animation, or the time during which it moves for one picture.
   *
   * @param seconds at least 0; after the end, the last pose holds
   * @param shutter the time of the motion in seconds, from {@code seconds} on, 0 to {@link
   *     RenderSettings#MAX_SHUTTER}
   * @param poses number of poses that stand for the motion, in the middle of as many equal parts of
   *     its time: a power of two, up to {@link RenderSettings#MAX_POSES}
   */
  public record Pose(String animation, double seconds, double shutter, int poses) {
    public Pose {
      Objects.requireNonNull(animation, "animation");
      require("shutter", Setting.SHUTTER.type(), shutter);
      require("poses", Setting.POSES.type(), poses);
    }

    private static <T> void require(String name, SettingType<T> type, T value) {
      if (!type.accepts(value)) {
        throw new IllegalArgumentException(
            name + ": expected " + type.expected() + ", found " + value);
      }
    }

    /** Creates a pose that stands still. */
    public Pose(String animation, double seconds) {
      this(animation, seconds, 0, 1);
    }

    /** Returns the motion from this pose on, by the shutter and the poses of settings. */
    public Pose during(RenderSettings settings) {
      return new Pose(animation, seconds, settings.get(Setting.SHUTTER), settings.poses());
    }

    /** Returns the times of the poses, in seconds. */
    public List<Double> times() {
      return IntStream.range(0, poses)
          .mapToObj(i -> seconds + shutter * (i + (poses == 1 ? 0 : .5)) / poses)
          .toList();
    }
  }

  public ModelOptions {
    Objects.requireNonNull(pose, "pose");
    Objects.requireNonNull(variant, "variant");
    Objects.requireNonNull(up, "up");
    Objects.requireNonNull(unit, "unit");
    Objects.requireNonNull(pointRadius, "pointRadius");
    hidden = List.copyOf(hidden);
    highlighted = List.copyOf(highlighted);
    sections = List.copyOf(sections);
    sections.forEach(Section::of);
    Objects.requireNonNull(limits, "limits");
    assets = List.copyOf(assets);
    if (!List.of("", CLAY, WHITE).contains(look)) {
      throw new IllegalArgumentException("look: expected clay or white, found " + look);
    }
    requireLength("unit", unit.orElse(1));
    requireLength("pointRadius", pointRadius.orElse(1));
  }

  private static void requireLength(String name, double length) {
    if (!(length > 0 && Double.isFinite(length))) {
      throw new IllegalArgumentException(name + ": expected a finite number > 0, found " + length);
    }
  }

  /** Creates options without limits of their own, which correct what a file states. */
  public ModelOptions(Optional<Pose> pose, Optional<String> variant, Up up, double unit) {
    this(
        pose,
        variant,
        Optional.of(up),
        OptionalDouble.of(unit),
        OptionalDouble.empty(),
        List.of(),
        List.of(),
        List.of(),
        "",
        Limits.NONE,
        false,
        List.of());
  }

  /** Returns these options with the motion of their pose by the shutter and poses of settings. */
  public ModelOptions during(RenderSettings settings) {
    return pose.map(start -> posed(start.during(settings))).orElse(this);
  }

  /** Returns these options with a pose. */
  public ModelOptions posed(Pose newPose) {
    return new ModelOptions(
        Optional.of(newPose),
        variant,
        up,
        unit,
        pointRadius,
        hidden,
        highlighted,
        sections,
        look,
        limits,
        lenient,
        assets);
  }

  private ModelOptions with(OptionalDouble radius, Limits newLimits, boolean isLenient) {
    return new ModelOptions(
        pose,
        variant,
        up,
        unit,
        radius,
        hidden,
        highlighted,
        sections,
        look,
        newLimits,
        isLenient,
        assets);
  }

  private ModelOptions showing(
      List<String> hide, List<String> highlight, List<String> cut, String newLook) {
    return new ModelOptions(
        pose,
        variant,
        up,
        unit,
        pointRadius,
        hide,
        highlight,
        cut,
        newLook,
        limits,
        lenient,
        assets);
  }

  /** Returns these options with another up axis and unit; empty for those of the file. */
  public ModelOptions oriented(Optional<Up> newUp, OptionalDouble newUnit) {
    return new ModelOptions(
        pose,
        variant,
        newUp,
        newUnit,
        pointRadius,
        hidden,
        highlighted,
        sections,
        look,
        limits,
        lenient,
        assets);
  }

  /** Returns these options with a radius of points, in the file's unit, &gt; 0. */
  public ModelOptions withPointRadius(double radius) {
    return with(OptionalDouble.of(radius), limits, lenient);
  }

  /** Returns these options with hidden parts; see {@link #hidden}. */
  public ModelOptions hiding(List<String> parts) {
    return showing(parts, highlighted, sections, look);
  }

  /** Returns these options with highlighted parts; see {@link #highlighted}. */
  public ModelOptions highlighting(List<String> parts) {
    return showing(hidden, parts, sections, look);
  }

  /**
   * Returns these options with other {@link #sections}; none for the whole model.
   *
   * @throws IllegalArgumentException if a text is not a section
   */
  public ModelOptions cutBy(List<String> planes) {
    return showing(hidden, highlighted, planes, look);
  }

  /** Returns these options with a look; see {@link #look}. */
  public ModelOptions looking(String newLook) {
    return showing(hidden, highlighted, sections, newLook);
  }

  /** Returns these options with limits. */
  public ModelOptions limitedTo(Limits newLimits) {
    return with(pointRadius, newLimits, lenient);
  }

  /** Returns these options, lenient or not. */
  public ModelOptions lenient(boolean isLenient) {
    return with(pointRadius, limits, isLenient);
  }

  /** Returns these options with further folders of files; see {@link #assets}. */
  public ModelOptions withAssets(List<Path> folders) {
    return new ModelOptions(
        pose,
        variant,
        up,
        unit,
        pointRadius,
        hidden,
        highlighted,
        sections,
        look,
        limits,
        lenient,
        folders);
  }

  /** Returns the map from the space of a file that states no axes and units to +Y up. */
  public Transform toWorld() {
    return toWorld(Up.Y, 1);
  }

  /**
   * Returns the map from the space of a file to +Y up.
   *
   * @param upOfFile the axis that the file states, which {@link #up} corrects
   * @param unitOfFile the unit that the file states, which {@link #unit} corrects
   */
  public Transform toWorld(Up upOfFile, double unitOfFile) {
    double length = unit.orElse(unitOfFile);
    Transform scale = Transform.scale(new Vec3(length, length, length));
    return up.orElse(upOfFile) == Up.Y
        ? scale
        : Transform.rotationDegrees(new Vec3(-QUARTER_TURN_DEGREES, 0, 0)).times(scale);
  }
}
