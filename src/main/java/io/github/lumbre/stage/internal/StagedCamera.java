package io.github.lumbre.stage.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.internal.ModelReach;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * The camera that a stage puts before a model.
 *
 * <p>The angles and the film of a camera at an eye are rounded, so that an eye and a target that
 * were computed of such a camera give this very camera. Immutable.
 *
 * @param framed what it has in its frame
 * @param aspect width of the frame over its height
 * @param fromFile from the axes and the unit of the file to the model's world space
 * @param film the height of the film in world space, if a scale on paper states it
 */
record StagedCamera(
    Stage stage, Framing framed, double aspect, Transform fromFile, OptionalDouble film) {
  /** What a scale on paper needs. */
  static final String PARALLEL =
      "expected a parallel view, in which lengths keep their ratios, found another camera: state "
          + Stage.VIEW.flag()
          + " front or "
          + Stage.PARALLEL.flag();

  /** Degrees have this many parts. */
  private static final double ANGLES = 1e9;

  private static final MathContext LENGTHS = new MathContext(12);
  private static final MathContext FACTOR = new MathContext(2, RoundingMode.DOWN);

  /** What is across a direction is rounding if it is smaller, relative to its length. */
  private static final double VERTICAL = 1e-12;

  /** Thrown if an option does not suit the model. */
  static final class Unsuited extends Exception {
    private static final long serialVersionUID = 1;

    /** The name of the option. */
    final String option;

    Unsuited(String option, String message) {
      super(message);
      this.option = option;
    }
  }

  PlacedCamera camera() throws Unsuited {
    return stage.find(Stage.EYE).isPresent() ? atEye() : fromView();
  }

  private PlacedCamera fromView() throws Unsuited {
    View from = stage.find(Stage.VIEW).orElse(View.DEFAULT);
    Vec3 rotation = new Vec3(from.elevation(), -from.azimuth(), 0);
    requireScale();
    if (stage.isParallel()) {
      Framing.Parallel found =
          framed.parallel(from, aspect, stage.get(Stage.ZOOM), stage.labels());
      double least = framed.parallel(from, aspect, 1, Set.of()).height() * Framing.FILL;
      return placed(Lens.orthographic(scaled(found.height(), least)), found.eye(), rotation);
    }
    double fov = stage.find(Stage.FOV).orElse(Stage.DEFAULT_FOV);
    Vec3 eye = framed.eye(from, fov, aspect, stage.labels());
    return placed(zoomed(Lens.pinhole(fov), stage.get(Stage.ZOOM)), eye, rotation);
  }

  private void requireScale() throws Unsuited {
    if (film.isPresent() && !stage.isParallel()) {
      throw new Unsuited(Stage.SCALE.name(), PARALLEL);
    }
  }

  /**
   * Returns the height of the film that a scale on paper states; another one without a scale.
   *
   * @param least the height at which the model touches the frame
   */
  private double scaled(double otherwise, double least) throws Unsuited {
    if (stage.find(Stage.SCALE).isPresent() && film.orElse(least) < least) {
      throw new Unsuited(
          Stage.SCALE.name(),
          "expected at most %s times this scale, found a view that does not fit on the paper:"
                  .formatted(new BigDecimal(film.getAsDouble() / least).round(FACTOR).toPlainString())
              + " state a larger %s or size, or a smaller scale".formatted(Stage.PAGE.flag()));
    }
    return film.orElse(otherwise);
  }

  private PlacedCamera atEye() throws Unsuited {
    Vec3 inFile = stage.get(Stage.EYE);
    Vec3 eye = world("eye", inFile);
    Vec3 target =
        stage.find(Stage.TARGET).isPresent()
            ? world("target", stage.get(Stage.TARGET))
            : framed.middle();
    CameraPose pose = new CameraPose(eye, rotation(inFile, target.minus(eye)));
    return new PlacedCamera("", lens(pose), pose, OptionalDouble.empty());
  }

  private Lens lens(CameraPose pose) throws Unsuited {
    double zoom = stage.get(Stage.ZOOM);
    requireScale();
    if (stage.isParallel()) {
      double height = framed.heightAround(pose.position(), pose.axes(), aspect, stage.labels());
      if (film.isPresent()) {
        return Lens.orthographic(film.getAsDouble());
      }
      return Lens.orthographic(new BigDecimal(height / zoom).round(LENGTHS).doubleValue());
    }
    if (stage.find(Stage.FIT).isEmpty() || stage.find(Stage.FOV).isPresent()) {
      return zoomed(Lens.pinhole(stage.find(Stage.FOV).orElse(Stage.DEFAULT_FOV)), zoom);
    }
    double tan =
        framed
            .tanAround(pose.position(), pose.axes(), aspect, stage.labels())
            .orElseThrow(
                () ->
                    new Unsuited(
                        "fit",
                        "expected a part in front of the eye, found one that is not: move "
                            + Stage.EYE.flag()
                            + " away from it"));
    return pinhole(tan / zoom);
  }

  /** Returns a point of the file in world space. */
  private Vec3 world(String option, Vec3 inFile) throws Unsuited {
    Vec3 point = ModelScene.TO_LEFT_HANDED.point(fromFile.point(inFile));
    if (!(point.maxAbs() <= ModelReach.LARGEST)) {
      throw new Unsuited(
          option,
          "expected a point within %s of the origin, found %s"
              .formatted(PrintableText.number(ModelReach.LARGEST), Stage.EYE.type().format(inFile)));
    }
    return point;
  }

  /** Returns the rotation of a camera that looks along a direction, with the vertical upright. */
  private static Vec3 rotation(Vec3 eye, Vec3 direction) throws Unsuited {
    double largest = direction.maxAbs();
    if (!(largest > 0)) {
      throw new Unsuited(
          "target",
          "expected another point than the eye, found %s: move %s away, or state %s"
              .formatted(Stage.EYE.type().format(eye), Stage.EYE.flag(), Stage.TARGET.flag()));
    }
    Vec3 scaled = direction.times(1 / largest);
    double across = Math.sqrt(scaled.x() * scaled.x() + scaled.z() * scaled.z());
    double yaw = across > VERTICAL ? Elementary.atan2(scaled.x(), scaled.z()) : 0;
    return new Vec3(rounded(Elementary.atan2(-scaled.y(), across)), rounded(yaw), 0);
  }

  private static double rounded(double radians) {
    return Math.rint(Math.toDegrees(radians) * ANGLES) / ANGLES + 0.; // not -0
  }

  private static PlacedCamera placed(Lens lens, Vec3 eye, Vec3 rotation) {
    return new PlacedCamera("", lens, new CameraPose(eye, rotation), OptionalDouble.empty());
  }

  /** Returns a lens that shows things larger by a factor. */
  static Lens zoomed(Lens lens, double zoom) {
    if (zoom == 1) {
      return lens;
    }
    return lens instanceof Lens.Orthographic parallel
        ? Lens.orthographic(parallel.height() / zoom)
        : pinhole(Elementary.tanDegrees(((Lens.Pinhole) lens).fovDegrees() / 2) / zoom);
  }

  /** Returns a lens by the tangent of half of its angle; rounding does not put it out of range. */
  private static Lens pinhole(double tan) {
    double degrees = 2 * Math.toDegrees(Elementary.atan2(tan, 1));
    return Lens.pinhole(Math.max(Double.MIN_NORMAL, Math.min(degrees, Math.nextDown(180.))));
  }
}
