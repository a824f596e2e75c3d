package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.sampling.Sampler;
import java.util.Objects;
import java.util.Optional;

/**
 * Turns points of the film into rays of the world. Immutable; its pose is a position and a
 * rotation, its proportions the film's.
 */
public abstract sealed class Camera
    permits PinholeCamera, ThinLensCamera, CylindricalCamera, FishEyeCamera, SphericalCamera {
  private final Vec3 position;
  private final Frame axes;
  private final double aspect;

  /**
   * @param position of the eye, in the world
   * @param axes in the world: right, up and forward, of unit length and at right angles
   * @param aspect width of the film over its height, &gt; 0 and finite
   */
  Camera(Vec3 position, Frame axes, double aspect) {
    this.position = Objects.requireNonNull(position, "position");
    this.axes = Objects.requireNonNull(axes, "axes");
    if (!(aspect > 0) || Double.isInfinite(aspect)) {
      throw new IllegalArgumentException("aspect: expected a finite number > 0, found " + aspect);
    }
    this.aspect = aspect;
  }

  /**
   * Returns the ray of unit direction that lights a film point, or empty where nothing is imaged:
   * outside the circle of a fisheye.
   *
   * @param film in [0,1)², v down; points outside continue the projection, see {@link #aim}
   * @param sampler started at the current sample; asked at its camera dimensions by cameras with a
   *     lens and by no other
   */
  @SuppressWarnings("exports") // internal
  public final Optional<Ray> rayFor(Point2 film, Sampler sampler) {
    CameraRay ray = new CameraRay();
    return aim(film.x(), film.y(), sampler, ray) ? Optional.of(ray.toRay()) : Optional.empty();
  }

  /**
   * Aims the ray of unit direction that lights a film point; returns false where nothing is imaged:
   * outside the circle of a fisheye.
   *
   * <p>Pixel filters reach beyond the film's sides. There the projection continues: panoramas wrap
   * around to the left and right, a spherical one passes over its poles as well, and a perspective
   * shows what lies beside the picture.
   *
   * @param u of the film, finite; in [0,1) on the film
   * @param v of the film, finite, down; in [0,1) on the film
   * @param sampler started at the current sample; asked at its camera dimensions by cameras with a
   *     lens and by no other
   * @param ray takes the result; as it was where nothing is imaged
   */
  @SuppressWarnings("exports") // internal
  public final boolean aim(double u, double v, Sampler sampler, CameraRay ray) {
    if (!aimLocally(u, v, sampler, ray)) {
      return false;
    }
    ray.place(position, axes);
    return true;
  }

  /** Tells whether some film points have no ray. */
  public boolean leavesBlanks() {
    return false;
  }

  /** Does what {@link #aim} does, in camera space; the direction need not be of unit length. */
  abstract boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray);

  /** Returns the film's width over its height. */
  final double aspect() {
    return aspect;
  }
}
