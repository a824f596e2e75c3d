package io.github.lumbre.model.format.dae;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelCamera.Lens;
import io.github.lumbre.model.internal.ModelCamera.Parallel;
import io.github.lumbre.model.internal.ModelCamera.Perspective;
import java.util.Optional;
import java.util.OptionalDouble;

/** The cameras of a COLLADA file, which users name; none is the usual one. */
final class DaeCameras {
  private static final double MAX_SIZE = 1e150;

  private final DaeDocument document;

  /** The length of the file's unit. */
  private final double unit;

  DaeCameras(DaeDocument document, double unit) {
    this.document = document;
    this.unit = unit;
  }

  /**
   * Returns the camera of a node; empty, with a warning, if it lacks what it needs.
   *
   * @param toWorld of the node, whose scale has no effect
   */
  Optional<ModelCamera> camera(DaeElement instance, DaeElement node, Transform toWorld) {
    Optional<DaeElement> found =
        document.find("camera", instance.attribute("url"), instance.location());
    if (found.isEmpty()) {
      return Optional.empty();
    }
    DaeElement camera = found.get();
    Optional<Lens> lens =
        camera
            .find("optics", "technique_common")
            .flatMap(
                technique ->
                    technique
                        .find("perspective")
                        .flatMap(this::perspective)
                        .or(() -> technique.find("orthographic").flatMap(this::parallel)));
    Optional<Transform> place = unscaled(toWorld);
    if (lens.isEmpty() || place.isEmpty()) {
      document
          .file()
          .warnings()
          .add(
              camera.location(),
              "expected a perspective or orthographic camera with its size, found another one; it"
                  + " is left out");
      return Optional.empty();
    }
    String title = node.title().isEmpty() ? camera.title() : node.title();
    return Optional.of(new ModelCamera(title, instance.location(), lens.get(), place.get(), true));
  }

  private Optional<Lens> perspective(DaeElement lens) {
    double aspect = positive(lens, "aspect_ratio");
    double y = positive(lens, "yfov");
    double x = positive(lens, "xfov");
    if (Double.isNaN(y) && x < 180) {
      double ratio = Double.isNaN(aspect) ? 1 : aspect;
      double height = Elementary.tanDegrees(x / 2) / ratio;
      y = 2 * Math.toDegrees(Elementary.atan2(height, 1));
    }
    boolean isSound = y > 0 && y < 180;
    OptionalDouble stated =
        Double.isNaN(aspect) ? OptionalDouble.empty() : OptionalDouble.of(aspect);
    return isSound ? Optional.of(new Perspective(Math.toRadians(y), stated)) : Optional.empty();
  }

  private Optional<Lens> parallel(DaeElement lens) {
    double aspect = positive(lens, "aspect_ratio");
    double ratio = Double.isNaN(aspect) ? 1 : aspect;
    double x = positive(lens, "xmag");
    double y = positive(lens, "ymag");
    double width = unit * (Double.isNaN(x) ? y * ratio : x);
    double height = unit * (Double.isNaN(y) ? x / ratio : y);
    boolean isSound = width > 0 && width <= MAX_SIZE && height > 0 && height <= MAX_SIZE;
    return isSound ? Optional.of(new Parallel(width, height)) : Optional.empty();
  }

  /** Returns a number above 0; NaN if it is missing or none. */
  private double positive(DaeElement lens, String name) {
    return lens.find(name)
        .flatMap(e -> document.numbers(e, 1))
        .map(found -> found[0])
        .filter(number -> number > 0)
        .orElse(Double.NaN);
  }

  /** Returns the place of a camera with axes of unit length; empty if it has no direction. */
  private static Optional<Transform> unscaled(Transform toWorld) {
    Vec3 back = toWorld.vector(Vec3.Z).normalized();
    Vec3 right = toWorld.vector(Vec3.Y).cross(back).normalized();
    Transform place =
        Transform.ofAxes(right, back.cross(right), back, toWorld.point(Vec3.ZERO));
    return Optional.of(place).filter(Transform::isInvertible);
  }
}
