package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;

/**
 * The ray of a {@link Camera} for a point of its film. Mutable; each thread reuses one instance, so
 * that creating camera rays allocates nothing.
 */
public final class CameraRay {
  private double originX, originY, originZ;
  private double directionX, directionY, directionZ = 1;

  /** Creates a ray for {@link Camera#aim}. */
  public CameraRay() {}

  /** Sets the origin and the direction, of any length except 0. */
  void set(Vec3 origin, Vec3 direction) {
    originX = origin.x();
    originY = origin.y();
    originZ = origin.z();
    directionX = direction.x();
    directionY = direction.y();
    directionZ = direction.z();
  }

  /** Transforms the ray from camera space to world space and normalizes its direction. */
  void place(Vec3 position, Frame axes) {
    set(position.plus(axes.toWorld(origin())), axes.toWorld(direction()).normalized());
  }

  /** Returns the origin, in world space once a camera has set it. */
  public Vec3 origin() {
    return new Vec3(originX, originY, originZ);
  }

  /** Returns the direction, of unit length in world space once a camera has set it. */
  public Vec3 direction() {
    return new Vec3(directionX, directionY, directionZ);
  }

  /** Returns the x of {@link #origin}. */
  public double originX() {
    return originX;
  }

  /** Returns the y of {@link #origin}. */
  public double originY() {
    return originY;
  }

  /** Returns the z of {@link #origin}. */
  public double originZ() {
    return originZ;
  }

  /** Returns the x of {@link #direction}. */
  public double directionX() {
    return directionX;
  }

  /** Returns the y of {@link #direction}. */
  public double directionY() {
    return directionY;
  }

  /** Returns the z of {@link #direction}. */
  public double directionZ() {
    return directionZ;
  }

  /** Returns an immutable copy of this ray, without an end. */
  public Ray toRay() {
    return new Ray(origin(), direction());
  }
}
