package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Objects;
import java.util.Optional;

/**
 * A camera that turns film points into world-space rays. Immutable. Its pose is a position and a
 * rotation; it takes its aspect ratio from the film.
 */
public abstract sealed class Camera
    permits PinholeCamera,
        OrthographicCamera,
        ThinLensCamera,
        CylindricalCamera,
        FishEyeCamera,
        SphericalCamera {
  private final Vec3 position;
  private final Frame axes;
  private final double aspect;

  /**
   * Creates a camera.
   *
   * @param position the eye, in world space
   * @param axes the orthonormal world-space directions right (+x), up (+y) and forward (+z)
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
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
   * Returns the world-space ray, with unit direction, for a film point. Empty outside the circle of
   * a fisheye, where the film has no image.
   *
   * @param film in [0,1)² with v down; points outside continue the projection, see {@link #aim}
   * @param sampler started at the current sample; only cameras with a lens use it, at its camera
   *     dimensions
   */
  public final Optional<Ray> rayFor(Point2 film, Sampler sampler) {
    CameraRay ray = new CameraRay();
    return aim(film.x(), film.y(), sampler, ray) ? Optional.of(ray.toRay()) : Optional.empty();
  }

  /**
   * Computes the world-space ray, with unit direction, for a film point. Returns false outside the
   * circle of a fisheye, where the film has no image.
   *
   * <p>Pixel filters extend beyond the edges of the film, where the projection continues. Panoramas
   * wrap around to the left and right, and spherical ones also continue across their poles.
   * Perspective cameras show the scene beside the picture.
   *
   * @param u film coordinate to the right, finite; in [0,1) on the film
   * @param v film coordinate down, finite; in [0,1) on the film
   * @param sampler started at the current sample; only cameras with a lens use it, at its camera
   *     dimensions
   * @param ray receives the result; unchanged if this returns false
   * @return whether the film point has a ray
   */
  public final boolean aim(double u, double v, Sampler sampler, CameraRay ray) {
    if (!aimLocally(u, v, sampler, ray)) {
      return false;
    }
    ray.place(position, axes);
    return true;
  }

  /** Returns the same camera, with the same lens, at another place. */
  public abstract Camera movedTo(Vec3 newPosition, Frame newAxes);

  /**
   * Returns the film point where a world-space point appears, through the center of the lens; empty
   * if it is behind the camera or has no image. The film is [0,1)² with v down; points outside are
   * beside the picture.
   */
  public final Optional<Point2> project(Vec3 point) {
    Vec3 local = axes.toLocal(point.minus(position));
    return projectLocally(local).filter(p -> Double.isFinite(p.x()) && Double.isFinite(p.y()));
  }

  /** Returns the film point of a point in camera space. */
  abstract Optional<Point2> projectLocally(Vec3 point);

  /** Returns the eye, in world space. */
  public final Vec3 position() {
    return position;
  }

  /** Returns the world-space directions right (+x), up (+y) and forward (+z). */
  public final Frame axes() {
    return axes;
  }

  /** Returns whether some film points have no ray. */
  public boolean leavesBlanks() {
    return false;
  }

  /** Computes the ray of {@link #aim} in camera space; its direction need not have unit length. */
  abstract boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray);

  /** Returns the width of the film divided by its height. */
  final double aspect() {
    return aspect;
  }

  /** Returns where it is, for people. */
  @Override
  public String toString() {
    return getClass().getSimpleName() + " at " + position();
  }
}
