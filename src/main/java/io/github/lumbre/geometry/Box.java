package io.github.lumbre.geometry;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
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
  private static final Vec3[] AXES = {Vec3.X, Vec3.Y, Vec3.Z};

  /** The local axis along which u decreases, for the faces of each axis. */
  private static final int[] U_AXIS = {2, 0, 0};

  private static final int[] V_AXIS = {1, 2, 1};

  private final Transform toWorld;
  private final Vec3 half;
  private final Face[] faces = new Face[FACES];

  /**
   * A face. Hits read it instead of testing axes: such branches would be unpredictable.
   *
   * @param frame its shading frame, in world space
   * @param low its lowest local point
   * @param high its highest local point
   * @param u the local axis along which u decreases
   * @param v the local axis along which v decreases
   * @param halfU half of its length along {@code u}, in local units
   * @param halfV half of its length along {@code v}, in local units
   * @param area in world space
   */
  private record Face(
      Frame frame, Vec3 low, Vec3 high, Vec3 u, Vec3 v, double halfU, double halfV, double area) {
    /** Returns the point of the face that is closest to a local point. */
    Vec3 nearestTo(Vec3 p) {
      return new Vec3(
          clamp(p.x(), low.x(), high.x()),
          clamp(p.y(), low.y(), high.y()),
          clamp(p.z(), low.z(), high.z()));
    }

    private static double clamp(double x, double low, double high) {
      return Math.max(low, Math.min(x, high));
    }

    /** Returns the texture coordinates of a local point of the face. */
    TexturePoint texture(Vec3 local) {
      return new TexturePoint(
          (halfU - local.dot(u)) / (2 * halfU), (halfV - local.dot(v)) / (2 * halfV));
    }
  }

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
            .5 * Placement.size("width", width),
            .5 * Placement.size("height", height),
            .5 * Placement.size("depth", depth));
    for (int face = 0; face < FACES; face++) {
      faces[face] = face(face);
    }
  }

  private Face face(int number) {
    int axis = number >> 1;
    Vec3 side = (number & 1) == 0 ? AXES[axis].negated() : AXES[axis];
    Vec3 u = AXES[U_AXIS[axis]];
    Vec3 v = AXES[V_AXIS[axis]];
    double halfU = half.get(U_AXIS[axis]);
    double halfV = half.get(V_AXIS[axis]);
    Vec3 worldU = toWorld.vector(u);
    Vec3 worldV = toWorld.vector(v);
    Vec3 middle = side.times(half.get(axis));
    Vec3 reach = u.times(halfU).plus(halfV, v);
    return new Face(
        Frame.around(toWorld.normal(side), worldU.negated(), worldV.negated()),
        middle.minus(reach),
        middle.plus(reach),
        u,
        v,
        halfU,
        halfV,
        worldU.cross(worldV).length() * (2 * halfU) * (2 * halfV));
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
    double t = near > 0 ? near : far;
    if (!(t > 0 && t < nearest.t)) {
      return false;
    }
    nearest.t = t;
    // A ray enters through the face on the side that it comes from, and leaves through the opposite
    // face.
    int x = Axes.sign(dx);
    int y = Axes.sign(dy);
    int z = Axes.sign(dz);
    nearest.element =
        near > 0 ? face(t, nearX, nearY, x, y, z) : face(t, farX, farY, 1 - x, 1 - y, 1 - z);
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

  /**
   * Returns the number of the face at t.
   *
   * @param t greater than 0
   * @param tx t at the face of the x axis, as is ty at that of the y axis
   * @param x 1 if the face of the x axis is on its positive side, otherwise 0; as are y and z
   */
  private static int face(double t, double tx, double ty, int x, int y, int z) {
    int notX = Axes.differ(t, tx);
    int notY = Axes.differ(t, ty);
    int onX = 1 - notX;
    int onY = notX * (1 - notY);
    int onZ = notX * notY;
    return onX * x + onY * (2 + y) + onZ * (4 + z);
  }

  @Override
  public SurfaceHit surfaceAt(NearestHit hit) {
    Vec3 origin = toWorld.inversePoint(hit.origin());
    Vec3 direction = toWorld.inverseVector(hit.direction());
    Face face = faces[hit.element];
    Vec3 local = face.nearestTo(origin.plus(hit.t, direction));
    Frame frame = face.frame();
    return hit.surface.set(
        toWorld.point(local),
        frame.normal(),
        frame,
        face.texture(local),
        hit.backwards(),
        toWorld.pointError(local, frame.normal()));
  }

  @Override
  public boolean isClosed() {
    return true;
  }

  @Override
  public double area() {
    return 2 * (faces[0].area() + faces[2].area() + faces[4].area());
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
    for (int next = face + 1; next < FACES && rest >= faces[face].area(); next++) {
      if (sees(from, next)) {
        rest -= faces[face].area();
        face = next;
      }
    }
    Vec3 local = pointOf(face, Math.min(rest / faces[face].area(), 1), v);
    Vec3 position = toWorld.point(local);
    Frame frame = faces[face].frame();
    double pdf = Placement.solidAnglePdf(reference.minus(position), frame.normal(), visible);
    if (pdf > 0) {
      double error = toWorld.pointError(local, frame.normal());
      result.set(position, frame.normal(), faces[face].texture(local), error, pdf);
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
    Vec3 u = faces[face].u();
    Vec3 v = faces[face].v();
    Vec3 p = u.times((2 * a - 1) * faces[face].halfU()).plus((2 * b - 1) * faces[face].halfV(), v);
    return faces[face].nearestTo(p);
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
      sum += sees(from, face) ? faces[face].area() : 0;
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
}
