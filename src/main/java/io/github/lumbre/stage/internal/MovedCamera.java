package io.github.lumbre.stage.internal;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scene.internal.SettingTypes.FlagType;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.stage.Stage;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A camera that was moved before a model, as the flags of a stage say it, with few digits.
 *
 * @param flags that give this camera
 */
public record MovedCamera(List<String> flags, PlacedCamera camera) {
  /** The options that say where a camera is and what it sees, which these flags replace. */
  public static final List<ModelOption<?>> REPLACED =
      List.of(
          Stage.CAMERA,
          Stage.VIEW,
          Stage.EYE,
          Stage.TARGET,
          Stage.ZOOM,
          Stage.FIT,
          Stage.PARALLEL,
          Stage.PERSPECTIVE,
          Stage.FOV);

  /** Decimals of coordinates, relative to the distance between the eye and its target. */
  private static final int DECIMALS = 6;

  private static final MathContext DIGITS = new MathContext(7);

  public MovedCamera {
    flags = List.copyOf(flags);
  }

  /**
   * Returns the camera that is next to a place.
   *
   * @param scene around a model
   * @param eye in world space
   * @param target in world space
   * @param height of the frame in world space, at depth 1 in perspective
   * @return empty if the flags cannot say it
   */
  public static Optional<MovedCamera> of(
      ParsedScene scene, Vec3 eye, Vec3 target, boolean isParallel, double height) {
    ModelContents model = scene.model().orElseThrow();
    Transform toWorld = ModelScene.TO_LEFT_HANDED.times(model.fromFile());
    Vec3 from = toWorld.inversePoint(eye);
    Vec3 to = toWorld.inversePoint(target);
    try {
      BigDecimal distance = new BigDecimal(to.minus(from).length());
      int decimals = DECIMALS - (distance.precision() - distance.scale());
      Stage stage =
          Stage.DEFAULT
              .with(Stage.LABEL, List.copyOf(model.labels()))
              .with(Stage.EYE, rounded(from, decimals))
              .with(Stage.TARGET, rounded(to, decimals))
              .with(Stage.PARALLEL, isParallel);
      Stage seen = isParallel ? zoomed(stage, scene, height) : stage.with(Stage.FOV, fov(height));
      return Optional.of(new MovedCamera(flags(seen), camera(seen, scene)));
    } catch (StagedCamera.Unsuited | IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private static Stage zoomed(Stage stage, ParsedScene scene, double height)
      throws StagedCamera.Unsuited {
    Lens.Orthographic whole = (Lens.Orthographic) camera(stage, scene).lens();
    return stage.with(Stage.ZOOM, rounded(whole.height() / height));
  }

  private static double fov(double height) {
    return rounded(2 * Math.toDegrees(Elementary.atan2(height / 2, 1)));
  }

  private static PlacedCamera camera(Stage stage, ParsedScene scene)
      throws StagedCamera.Unsuited {
    ModelContents model = scene.model().orElseThrow();
    Bounds3 box =
        Bounds3.of(
            ModelScene.TO_LEFT_HANDED.point(model.min()),
            ModelScene.TO_LEFT_HANDED.point(model.max()));
    double aspect = scene.settings().aspect();
    return new StagedCamera(stage, Framing.of(box), aspect, model.fromFile(), OptionalDouble.empty())
        .camera();
  }

  private static List<String> flags(Stage stage) {
    List<String> flags = new ArrayList<>();
    for (ModelOption<?> option : REPLACED) {
      flag(option, stage).ifPresent(flags::add);
    }
    return flags;
  }

  private static <T> Optional<String> flag(ModelOption<T> option, Stage stage) {
    return stage
        .find(option)
        .filter(value -> !option.defaultValue().equals(Optional.of(value)))
        .map(
            value ->
                option.type() instanceof FlagType
                    ? option.flag()
                    : option.flag() + "=" + option.type().shown(value));
  }

  private static Vec3 rounded(Vec3 point, int decimals) {
    return new Vec3(
        rounded(point.x(), decimals), rounded(point.y(), decimals), rounded(point.z(), decimals));
  }

  private static double rounded(double x, int decimals) {
    return new BigDecimal(x).setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
  }

  private static double rounded(double x) {
    return new BigDecimal(x).round(DIGITS).doubleValue();
  }
}
