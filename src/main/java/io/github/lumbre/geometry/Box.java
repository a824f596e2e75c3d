package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.texture.TexturePoint;

/**
 * A box around the local origin with faces perpendicular to the local axes. Rays hit its faces from
 * both sides. Face 2a lies on the negative side of axis a, face 2a + 1 on the positive side.
 *
 * <p>Texture coordinates are in [0, 1]. On the x faces, u decreases along z; on the others, along
 * x. On the y faces, v decreases along z; on the others, along y.
 */
public final class Box implements Shape {
  private static final int FACES = 6;

  /** What is added to the face through which a ray leaves: it meets that face last. */
  private static final int LEAVING = FACES;

  private static final Vec3[] AXES = {Vec3.X, Vec3.Y, Vec3.Z};

  /** The local axis along which u decreases, for the faces of each axis. */
  private static final int[] U_AXIS = {2, 0, 0};

  private static final int[] V_AXIS = {1, 2, 1};

  private final Transform toWorld;
  private final Vec3 half;
  private final Frame[] frames = new Frame[FACES];
  private final double[] faceArea = new double[FACES];

  /**
   * Creates a box.
   *
   * @param toWorld invertible
   * @param width along local x, in (0, 1e150]
   * @param height along local y, in (0, 1e150]
   * @param depth along local z, in (0, 1e150]
   * @throws IllegalArgumentException if the transform is singular or a size is out of range
   */
  public Box(Transform toWorld, double width, double height, double depth) {
    this.toWorld = Placement.invertible(toWorld);
    half =
        new Vec3(
            .5 * Range.SIZE.require("width", width),
            .5 * Range.SIZE.require("height", height),
            .5 * Range.SIZE.require("depth", depth));
    for (int face = 0; face < FACES; face++) {
      Vec3 axis = AXES[face >> 1];
      Vec3 u = toWorld.vector(AXES[U_AXIS[face >> 1]]);
      Vec3 v = toWorld.vector(AXES[V_AXIS[face >> 1]]);
      Vec3 normal = toWorld.normal((face & 1) == 0 ? axis.negated() : axis);
      frames[face] = Frame.around(normal, u.negated(), v.negated());
      faceArea[face] =
          u.cross(v).length()
              * (2 * half.get(U_AXIS[face >> 1]))
              * (2 * half.get(V_AXIS[face >> 1]));
    }
  }

  /**
   * Returns a box around a point, with faces perpendicular to the world's axes.
   *
   * @param size lengths along x, y and z in world units, each in (0, 1e150]
   */
  public static Box of(Vec3 center, Vec3 size) {
    return new Box(Placement.at(center), size.x(), size.y(), size.z());
  }

  /** Returns the map from local to world space. */
  public Transform toWorld() {
    return toWorld;
  }

  /** Returns the lengths along local x, y and z. */
  public Vec3 size() {
    return half.times(2);
  }

  @Override
  public Box transformed(Transform outer) {
    return new Box(outer.times(toWorld), 2 * half.x(), 2 * half.y(), 2 * half.z());
  }

  @Override
  public Bounds3 bounds() {
    return Placement.outward(toWorld, new Bounds3(half.negated(), half));
  }

  /**
   * {@inheritDoc} On edges and corners, x faces take precedence over y faces, and y faces over z
   * faces.
   */
  @Override
  public boolean intersect(NearestHit nearest) {
    double ox = nearest.localOriginX(toWorld);
    double oy = nearest.localOriginY(toWorld);
    double oz = nearest.localOriginZ(toWorld);
    double dx = nearest.localDirectionX(toWorld);
    double dy = nearest.localDirectionY(toWorld);
    double dz = nearest.localDirectionZ(toWorld);
    double nearX = enter(ox, dx, half.x());
    double nearY = enter(oy, dy, half.y());
    double nearZ = enter(oz, dz, half.z());
    double farX = leave(ox, dx, half.x());
    double farY = leave(oy, dy, half.y());
    double farZ = leave(oz, dz, half.z());
    double near = Math.max(nearX, Math.max(nearY, nearZ));
    double far = Math.min(farX, Math.min(farY, farZ));
    if (!(near <= far)) {
      return false;
    }
    boolean enters = nearest.isAfterPassed(near, 0);
    double t = enters ? near : far;
    if (!(t < nearest.t && (enters || nearest.isAfterPassed(far, LEAVING)))) {
      return false;
    }
    nearest.t = t;
    // A ray enters through the face on the side that it comes from, and leaves through the opposite
    // face.
    if (enters) {
      nearest.element = near == nearX ? face(0, -dx) : near == nearY ? face(1, -dy) : face(2, -dz);
    } else {
      nearest.element =
          LEAVING + (far == farX ? face(0, dx) : far == farY ? face(1, dy) : face(2, dz));
    }
    return true;
  }

  /**
   * Returns the t at which a ray enters the slab |x| ≤ half. For a ray parallel to the slab,
   * returns −∞ inside and +∞ outside.
   */
  private static double enter(double o, double d, double half) {
    if (d == 0) {
      return Math.abs(o) <= half ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }
    return (-Math.copySign(half, d) - o) / d;
  }

  private static double leave(double o, double d, double half) {
    return d == 0 ? Double.POSITIVE_INFINITY : (Math.copySign(half, d) - o) / d;
  }

  private static int face(int axis, double side) {
    return 2 * axis + (side > 0 ? 1 : 0);
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    Vec3 origin = toWorld.inversePoint(hit.origin());
    Vec3 direction = toWorld.inverseVector(hit.direction());
    int face = hit.element % LEAVING;
    Vec3 local = onFace(face, origin.plus(hit.t, direction));
    Frame frame = frames[face];
    return hit.surface.set(
        toWorld.point(local),
        frame.normal(),
        frame,
        texture(face, local),
        hit.backwards(),
        toWorld.pointError(local, frame.normal()));
  }

  /** Returns the point of a face that is closest to a nearby local point. */
  private Vec3 onFace(int face, Vec3 p) {
    double side = (face & 1) == 0 ? -1 : 1;
    int axis = face >> 1;
    return new Vec3(
        axis == 0 ? side * half.x() : clamp(p.x(), half.x()),
        axis == 1 ? side * half.y() : clamp(p.y(), half.y()),
        axis == 2 ? side * half.z() : clamp(p.z(), half.z()));
  }

  private static double clamp(double x, double half) {
    return Math.max(-half, Math.min(x, half));
  }

  private TexturePoint texture(int face, Vec3 local) {
    int u = U_AXIS[face >> 1];
    int v = V_AXIS[face >> 1];
    return new TexturePoint(
        (half.get(u) - local.get(u)) / (2 * half.get(u)),
        (half.get(v) - local.get(v)) / (2 * half.get(v)));
  }

  @Override
  public boolean isClosed() {
    return true;
  }

  @Override
  public double area() {
    return 2 * (faceArea[0] + faceArea[2] + faceArea[4]);
  }

  /**
   * {@inheritDoc} Points are uniform by area on the faces that are visible from the reference
   * point.
   */
  @Override
  public void sample(double x, double y, double z, double u, double v, SurfaceSample result) {
    Vec3 reference = new Vec3(x, y, z);
    Vec3 from = toWorld.inversePoint(reference);
    double visible = visibleArea(from);
    result.clear();
    if (!(visible > 0)) {
      return;
    }
    double rest = u * visible;
    int face = firstVisible(from);
    for (int next = face + 1; next < FACES && rest >= faceArea[face]; next++) {
      if (sees(from, next)) {
        rest -= faceArea[face];
        face = next;
      }
    }
    Vec3 local = pointOf(face, Math.min(rest / faceArea[face], 1), v);
    Vec3 position = toWorld.point(local);
    Frame frame = frames[face];
    double pdf = Placement.solidAnglePdf(reference.minus(position), frame.normal(), visible);
    if (pdf > 0) {
      double error = toWorld.pointError(local, frame.normal());
      result.set(position, frame.normal(), texture(face, local), error, pdf);
    }
  }

  @Override
  public double pdf(Vec3 reference, SurfaceHit onShape) {
    Vec3 from = toWorld.inversePoint(reference);
    Vec3 way = reference.minus(onShape.position());
    if (!isInside(from) && !(way.dot(onShape.geometricNormal()) > 0)) {
      return 0;
    }
    double visible = visibleArea(from);
    return visible > 0 ? Placement.solidAnglePdf(way, onShape.geometricNormal(), visible) : 0;
  }

  private Vec3 pointOf(int face, double a, double b) {
    int u = U_AXIS[face >> 1];
    int v = V_AXIS[face >> 1];
    Vec3 p = AXES[u].times((2 * a - 1) * half.get(u)).plus((2 * b - 1) * half.get(v), AXES[v]);
    return onFace(face, p);
  }

  private boolean isInside(Vec3 local) {
    return Math.abs(local.x()) <= half.x()
        && Math.abs(local.y()) <= half.y()
        && Math.abs(local.z()) <= half.z();
  }

  private boolean sees(Vec3 from, int face) {
    double along = from.get(face >> 1);
    return isInside(from) || ((face & 1) == 0 ? -along : along) > half.get(face >> 1);
  }

  private double visibleArea(Vec3 from) {
    double sum = 0;
    for (int face = 0; face < FACES; face++) {
      sum += sees(from, face) ? faceArea[face] : 0;
    }
    return sum;
  }

  private int firstVisible(Vec3 from) {
    int face = 0;
    while (face < FACES - 1 && !sees(from, face)) {
      face++;
    }
    return face;
  }

  /** Returns where it is, for people. */
  @Override
  public String toString() {
    return "Box in " + bounds();
  }
}
