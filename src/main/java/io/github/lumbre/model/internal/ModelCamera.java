package io.github.lumbre.model.internal;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;
import java.util.OptionalDouble;

/**
 * A camera of a model. It looks along its local -z, with +y up and +x to the right (glTF 2.0,
 * section 3.10).
 *
 * @param name empty if it has none
 * @param location in the file, such as {@code nodes[3].camera}
 * @param toWorld from the camera's local space to the model's world space
 * @param onlyByName whether a picture has this camera only if a user names it: programs write
 *     cameras into files of its format that nobody chose
 */
public record ModelCamera(
    String name, String location, Lens lens, Transform toWorld, boolean onlyByName) {
  /** Creates a camera that a picture has unless a user wants another one. */
  public ModelCamera(String name, String location, Lens lens, Transform toWorld) {
    this(name, location, lens, toWorld, false);
  }

  public sealed interface Lens {}

  /**
   * A perspective projection.
   *
   * @param verticalFov the angle between the lower and the upper edge, in radians
   * @param aspect width over height; empty if the frame decides it
   */
  public record Perspective(double verticalFov, OptionalDouble aspect) implements Lens {}

  /**
   * A parallel projection.
   *
   * @param halfWidth half the width of the frame, in units of the camera's local space, which are
   *     those of the model's world space, since no node scales a camera
   * @param halfHeight half the height of the frame, in the same units
   */
  public record Parallel(double halfWidth, double halfHeight) implements Lens {}

  /** Returns the width over the height of the frame, in world space; empty if the file has none. */
  public OptionalDouble aspect() {
    if (lens instanceof Perspective perspective) {
      return perspective.aspect();
    }
    Parallel parallel = (Parallel) lens;
    double width = parallel.halfWidth() * toWorld.vector(Vec3.X).length();
    return OptionalDouble.of(width / (parallel.halfHeight() * toWorld.vector(Vec3.Y).length()));
  }

  public ModelCamera {
    Objects.requireNonNull(name, "name");
    Objects.requireNonNull(location, "location");
    Objects.requireNonNull(lens, "lens");
    Objects.requireNonNull(toWorld, "toWorld");
  }
}
