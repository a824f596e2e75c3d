package io.github.lumbre.camera;

import io.github.lumbre.camera.internal.LensRanges;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.math.sampling.Sampler;
import java.util.Objects;
import java.util.Optional;

/**
 * A perspective camera with a thin lens: points off the plane of focus blur into the shape of the
 * aperture. The film is sampled as in {@link PinholeCamera}, independently of the lens.
 */
public final class ThinLensCamera extends Camera {
  /** Above this focus distance, the rays of a film point are parallel. */
  private static final double INFINITY = 1e12;

  private final double halfHeight;
  private final double focusDistance;
  private final double apertureSize;
  private final Aperture aperture;

  /**
   * Creates a camera.
   *
   * @param position the center of the lens, in world space
   * @param axes the orthonormal world-space directions right, up and forward
   * @param aspect the width of the film divided by its height, &gt; 0 and finite
   * @param fovDegrees the full vertical angle of view, in degrees, in (0, 180)
   * @param focusDistance from the lens to the plane of focus, in world units, &gt; 0; values above
   *     1e12 count as infinite: all rays of a film point are parallel
   * @param apertureSize the size of one unit of the aperture in world units, ≥ 0: the radius of a
   *     disk, the width of a mask
   * @param aperture the shape of the aperture
   * @throws IllegalArgumentException if a number is out of range
   */
  public ThinLensCamera(
      Vec3 position,
      Frame axes,
      double aspect,
      double fovDegrees,
      double focusDistance,
      double apertureSize,
      Aperture aperture) {
    super(position, axes, aspect);
    halfHeight = PinholeCamera.halfHeight(fovDegrees);
    this.focusDistance = LensRanges.FOCUS_DISTANCE.require("focusDistance", focusDistance);
    this.apertureSize = Range.NOT_NEGATIVE.require("apertureSize", apertureSize);
    this.aperture = Objects.requireNonNull(aperture, "aperture");
  }

  private ThinLensCamera(ThinLensCamera other, Vec3 position, Frame axes) {
    super(position, axes, other.aspect());
    halfHeight = other.halfHeight;
    focusDistance = other.focusDistance;
    apertureSize = other.apertureSize;
    aperture = other.aperture;
  }

  @Override
  public ThinLensCamera movedTo(Vec3 newPosition, Frame newAxes) {
    return new ThinLensCamera(this, newPosition, newAxes);
  }

  /** Returns whether points off the plane of focus blur. */
  public boolean isBlurring() {
    return apertureSize > 0 && focusDistance <= INFINITY;
  }

  /** Returns the distance from the lens to the plane of focus, in world units. */
  public double focusDistance() {
    return focusDistance;
  }

  /** Returns the size of one unit of the aperture, in world units. */
  public double apertureSize() {
    return apertureSize;
  }

  /** Returns the shape of the aperture. */
  public Aperture aperture() {
    return aperture;
  }

  /** Returns half the width and half the height of the plane of focus on the film, in world units. */
  public Point2 focusedHalfSize() {
    double half = focusDistance * halfHeight;
    return new Point2(half * aspect(), half);
  }

  @Override
  Optional<Point2> projectLocally(Vec3 point) {
    return PinholeCamera.film(point, aspect(), halfHeight);
  }

  @Override
  boolean aimLocally(double u, double v, Sampler sampler, CameraRay ray) {
    Vec3 chief = PinholeCamera.direction(u, v, aspect(), halfHeight);
    Point2 lens = aperture.sample(sampler);
    Vec3 origin = new Vec3(lens.x() * apertureSize, lens.y() * apertureSize, 0);
    ray.set(origin, towardsFocus(chief, origin));
    return true;
  }

  /**
   * Returns the direction from a lens point to focusDistance·chief; its length is chosen to avoid
   * overflow.
   */
  private Vec3 towardsFocus(Vec3 chief, Vec3 origin) {
    if (apertureSize == 0 || focusDistance > INFINITY) {
      return chief;
    }
    return focusDistance < 1
        ? chief.times(focusDistance).minus(origin).normalized()
        : chief.minus(origin.times(1 / focusDistance)).normalized();
  }
}
