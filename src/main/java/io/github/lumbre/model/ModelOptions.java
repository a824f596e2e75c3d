package io.github.lumbre.model;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.OptionTypes.PoseType;
import io.github.lumbre.model.internal.OptionValues;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/** What to read from a model file, and how: values of {@link ModelOption}s. Immutable. */
public final class ModelOptions {
  /** The look of matte, light gray surfaces. Cut-outs stay cut out; glass is opaque, too. */
  public static final String CLAY = "clay";

  /** The look of white paper without light and shadow, for drawings. */
  public static final String WHITE = "white";

  /** The rest pose, default materials, and the up axis and unit of the file. */
  public static final ModelOptions DEFAULT =
      new ModelOptions(OptionValues.NONE, Limits.NONE, false);

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
   * @param seconds finite, at least 0; after the end, the last pose holds
   * @param shutter the time of the motion in seconds, from {@code seconds} on, 0 to {@link
   *     RenderSettings#MAX_SHUTTER}
   * @param poses number of poses that stand for the motion, in the middle of as many equal parts of
   *     its time: a power of two, up to {@link RenderSettings#MAX_POSES}
   */
  public record Pose(String animation, double seconds, double shutter, int poses) {
    public Pose {
      Objects.requireNonNull(animation, "animation");
      PoseType.SECONDS.require("seconds", seconds);
      Setting.SHUTTER.type().require("shutter", shutter);
      Setting.POSES.type().require("poses", poses);
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

  private final OptionValues values;
  private final Limits limits;
  private final boolean mayLackFiles;

  private ModelOptions(OptionValues values, Limits limits, boolean mayLackFiles) {
    this.values = values;
    this.limits = Objects.requireNonNull(limits, "limits");
    this.mayLackFiles = mayLackFiles;
  }

  /** Creates options without limits of their own, which correct what a file states. */
  public ModelOptions(Optional<Pose> pose, Optional<String> variant, Up up, double unit) {
    this(
        OptionValues.NONE
            .with(ModelOption.POSE, pose)
            .with(ModelOption.VARIANT, variant)
            .with(ModelOption.UP, up)
            .with(ModelOption.UNIT, unit),
        Limits.NONE,
        false);
  }

  /**
   * Returns these options with another value.
   *
   * @throws IllegalArgumentException if it is out of range; the message names the option
   */
  public <T> ModelOptions with(ModelOption<T> option, T value) {
    return new ModelOptions(values.with(option, value), limits, mayLackFiles);
  }

  /** Returns these options with another value; with the default if it is empty. */
  public <T> ModelOptions with(ModelOption<T> option, Optional<T> value) {
    return new ModelOptions(values.with(option, value), limits, mayLackFiles);
  }

  /** Returns the value of an option, or its default; empty if it has none. */
  public <T> Optional<T> find(ModelOption<T> option) {
    return values.find(option);
  }

  /** Returns the value of an option that has a default. */
  public <T> T get(ModelOption<T> option) {
    return find(option).orElseThrow();
  }

  /** Returns limits for the model, its textures and its other files. */
  public Limits limits() {
    return limits;
  }

  /**
   * Returns whether pictures and meshes of a glTF file whose data cannot be read are left out with
   * a warning, instead of an error; missing pictures of OBJ files always are, and missing pictures
   * of a model that is rendered by itself.
   */
  public boolean mayLackFiles() {
    return mayLackFiles;
  }

  /** Returns these options with the motion of their pose by the shutter and poses of settings. */
  public ModelOptions during(RenderSettings settings) {
    return find(ModelOption.POSE)
        .map(start -> with(ModelOption.POSE, start.during(settings)))
        .orElse(this);
  }

  /** Returns these options with another up axis and unit; empty for those of the file. */
  public ModelOptions oriented(Optional<Up> newUp, OptionalDouble newUnit) {
    Optional<Double> length =
        newUnit.isPresent() ? Optional.of(newUnit.getAsDouble()) : Optional.empty();
    return with(ModelOption.UP, newUp).with(ModelOption.UNIT, length);
  }

  /** Returns these options with limits. */
  public ModelOptions limitedTo(Limits newLimits) {
    return new ModelOptions(values, newLimits, mayLackFiles);
  }

  /** Returns these options, which may lack files or not. */
  public ModelOptions mayLackFiles(boolean mayLack) {
    return new ModelOptions(values, limits, mayLack);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ModelOptions that
        && values.equals(that.values)
        && limits.equals(that.limits)
        && mayLackFiles == that.mayLackFiles;
  }

  @Override
  public int hashCode() {
    return Objects.hash(values, limits, mayLackFiles);
  }

  @Override
  public String toString() {
    return "ModelOptions" + values + (mayLackFiles ? ", may lack files" : "");
  }

  /** Returns the map from the space of a file that states no axes and units to +Y up. */
  public Transform toWorld() {
    return toWorld(Up.Y, 1);
  }

  /**
   * Returns the map from the space of a file to +Y up.
   *
   * @param upOfFile the axis that the file states, which {@link ModelOption#UP} corrects
   * @param unitOfFile the unit that the file states, which {@link ModelOption#UNIT} corrects
   */
  public Transform toWorld(Up upOfFile, double unitOfFile) {
    double length = find(ModelOption.UNIT).orElse(unitOfFile);
    Transform scale = Transform.scale(new Vec3(length, length, length));
    return find(ModelOption.UP).orElse(upOfFile) == Up.Y
        ? scale
        : Transform.rotationDegrees(new Vec3(-QUARTER_TURN_DEGREES, 0, 0)).times(scale);
  }
}
