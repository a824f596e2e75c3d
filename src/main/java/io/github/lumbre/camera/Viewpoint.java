package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * Where a camera stands and looks, and its lens, for films of any aspect ratio. Immutable.
 *
 * @param eye position of the camera in world space
 * @param target the point in the middle of the picture
 * @param up direction that is up in the picture
 */
public record Viewpoint(Vec3 eye, Vec3 target, Vec3 up, Lens lens) {
  /**
   * @throws IllegalArgumentException if a number is not finite, the two points are the same, or
   *     {@code up} is zero or along the view
   */
  public Viewpoint {
    Objects.requireNonNull(lens, "lens");
    Frame.lookingAt(eye, target, up);
  }

  /**
   * Returns the camera.
   *
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   */
  public Camera camera(double aspect) {
    return lens.camera(eye, Frame.lookingAt(eye, target, up), aspect);
  }
}
