package io.github.lumbre.camera;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;

/**
 * The ray that a {@link Camera} casts for a point of its film. Mutable: each thread lets the camera
 * aim one and the same again and again, so that casting rays makes no objects.
 */
public final class CameraRay {
  private double originX, originY, originZ;
  private double directionX, directionY, directionZ = 1;

  /** Makes a ray to be aimed. */
  public CameraRay() {}

  /** Sets where the ray begins and its direction, of any length but 0. */
  void set(Vec3 origin, Vec3 direction) {
    originX = origin.x();
    originY = origin.y();
    originZ = origin.z();
    directionX = direction.x();
    directionY = direction.y();
    directionZ = direction.z();
  }

  /** Moves the ray from camera space into the world, where its direction gets unit length. */
  void place(Vec3 position, Frame axes) {
    set(position.plus(axes.toWorld(origin())), axes.toWorld(direction()).normalized());
  }

  /** Returns where the ray begins. */
  public Vec3 origin() {
    return new Vec3(originX, originY, originZ);
  }

  /** Returns its direction, of unit length once a camera has aimed it. */
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

  /** Returns the same ray, which does not change with this. */
  public Ray toRay() {
    return new Ray(origin(), direction());
  }
}
