package io.github.lumbre.geometry;

import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import java.util.List;

/**
 * A bounding volume hierarchy over shapes. Immutable, shared by all threads.
 *
 * <p>The triangles of each {@link Mesh} are items of the hierarchy themselves; other shapes are
 * items as a whole, and unbounded ones are asked every time. Of hits at the same t the one of the
 * lower shape, and in it of the lower element, wins, so that no order of the search shows.
 *
 * <p>No hit is lost to rounding: the boxes are wider than their contents by {@link #MARGIN} of the
 * largest coordinate that entered, and every search widens them by as much of its ray's origin.
 * That is more than the test of any item can be wrong by.
 */
public final class Bvh {
  private static final double MARGIN = 16 * 0x1p-52;
  private static final int SIZE = BvhBuilder.NODE_SIZE;

  private final double[] nodes;
  private final int[] children;
  private final int root;
  private final boolean isEmpty;
  private final Triangles triangles;
  private final Shape[] shapes;
  private final int[] shapeNumbers;
  private final Shape[] unbounded;
  private final int[] unboundedNumbers;

  private Bvh(BvhBuilder tree, BvhItems items) {
    nodes = tree.nodes();
    children = tree.children();
    root = tree.root();
    isEmpty = items.isEmpty();
    triangles = items.triangles(tree.triangleOrder());
    shapeNumbers = items.shapeNumbers(tree.shapeOrder());
    shapes = items.shapes(shapeNumbers);
    unboundedNumbers = items.unboundedNumbers();
    unbounded = items.shapes(unboundedNumbers);
  }

  /** Builds the hierarchy over shapes, which are numbered by their place in the list. */
  public static Bvh over(List<? extends Shape> shapes) {
    BvhItems items = new BvhItems(List.copyOf(shapes), MARGIN);
    return new Bvh(new BvhBuilder(items.boxes(), items.triangleCount()), items);
  }

  /** Finds the nearest hit along a ray; tells whether there is one. */
  public boolean intersect(Ray ray, NearestHit nearest) {
    nearest.start(ray.tMax());
    return search(ray, nearest);
  }

  /** Tells whether anything lies on a ray: whether {@link #intersect} would find a hit. */
  public boolean isOccluded(Ray ray, NearestHit scratch) {
    scratch.start(ray.tMax());
    scratch.any = true;
    return search(ray, scratch);
  }

  private boolean search(Ray ray, NearestHit nearest) {
    boolean found = false;
    for (int i = 0; i < unbounded.length; i++) {
      found |= intersectShape(unbounded[i], unboundedNumbers[i], ray, nearest);
    }
    if (found && nearest.any) {
      return true;
    }
    Vec3 o = ray.origin();
    Vec3 d = ray.direction();
    return traverse(ray, o.x(), o.y(), o.z(), d.x(), d.y(), d.z(), nearest) | found;
  }

  /**
   * Continues a search in a hierarchy that is itself a shape of another: looks for a hit before
   * {@code nearest.t} along a ray given by its local coordinates. The shape's number is the
   * caller's to store.
   *
   * @param ray the world's; only passed on to shapes that are not triangles
   */
  boolean intersectPart(
      Ray ray,
      double ox,
      double oy,
      double oz,
      double dx,
      double dy,
      double dz,
      NearestHit nearest) {
    int outer = nearest.shape;
    nearest.shape = -1;
    boolean found = traverse(ray, ox, oy, oz, dx, dy, dz, nearest);
    nearest.shape = outer;
    return found;
  }

  /** The search proper. All state is in local variables on purpose. */
  private boolean traverse(
      Ray ray,
      double ox,
      double oy,
      double oz,
      double dx,
      double dy,
      double dz,
      NearestHit nearest) {
    if (isEmpty) {
      return false;
    }
    double[] boxes = nodes;
    int[] stack = nearest.stack;
    int[] stackNear = nearest.stackNear;
    int bottom = nearest.stackTop;
    int top = bottom;
    // Choose each axis' near side by the direction's sign; -0 chooses as a negative number would.
    double ix = 1 / dx;
    double iy = 1 / dy;
    double iz = 1 / dz;
    int nearX = ix < 0 ? 1 : 0;
    int nearY = iy < 0 ? 3 : 2;
    int nearZ = iz < 0 ? 5 : 4;
    int farX = nearX ^ 1;
    int farY = nearY ^ 1;
    int farZ = nearZ ^ 1;
    // Widen all boxes by the origin's rounding: shift the origin in for the one side and the other.
    double margin = MARGIN * Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz)));
    double inX = ox + Math.copySign(margin, ix);
    double inY = oy + Math.copySign(margin, iy);
    double inZ = oz + Math.copySign(margin, iz);
    double outX = ox - Math.copySign(margin, ix);
    double outY = oy - Math.copySign(margin, iy);
    double outZ = oz - Math.copySign(margin, iz);
    // Shear the longest axis onto the ray.
    int kz = longest(dx, dy, dz);
    int kx = kz == 2 ? 0 : kz + 1;
    int ky = kx == 2 ? 0 : kx + 1;
    double sz = 1 / pick(kz, dx, dy, dz);
    double sx = pick(kx, dx, dy, dz) / pick(kz, dx, dy, dz);
    double sy = pick(ky, dx, dy, dz) / pick(kz, dx, dy, dz);
    double okx = pick(kx, ox, oy, oz);
    double oky = pick(ky, ox, oy, oz);
    double okz = pick(kz, ox, oy, oz);
    boolean found = false;
    int best = rank(nearest.t);
    int node = root;
    while (true) {
      if (node >= 0) {
        // Test both children. A NaN needs an origin on the widened border: any answer is right.
        int at = node * SIZE;
        int near0 =
            nearRank(
                (boxes[at + nearX] - inX) * ix,
                (boxes[at + nearY] - inY) * iy,
                (boxes[at + nearZ] - inZ) * iz);
        int far0 =
            farRank(
                (boxes[at + farX] - outX) * ix,
                (boxes[at + farY] - outY) * iy,
                (boxes[at + farZ] - outZ) * iz);
        at += 6;
        int near1 =
            nearRank(
                (boxes[at + nearX] - inX) * ix,
                (boxes[at + nearY] - inY) * iy,
                (boxes[at + nearZ] - inZ) * iz);
        int far1 =
            farRank(
                (boxes[at + farX] - outX) * ix,
                (boxes[at + farY] - outY) * iy,
                (boxes[at + farZ] - outZ) * iz);
        int child = 2 * node;
        if (near0 <= Math.min(far0, best)) {
          if (near1 > Math.min(far1, best)) {
            node = children[child];
            continue;
          }
          // Go on with the nearer one.
          int farther = near0 <= near1 ? 1 : 0;
          stackNear[top] = Math.max(near0, near1);
          stack[top++] = children[child + farther];
          node = children[child + 1 - farther];
          continue;
        }
        if (near1 <= Math.min(far1, best)) {
          node = children[child + 1];
          continue;
        }
      } else {
        nearest.stackTop = top;
        boolean hit =
            BvhBuilder.isLeafOfShapes(node)
                ? intersectShapes(node, ray, nearest)
                : triangles.intersect(node, kx, ky, kz, okx, oky, okz, sx, sy, sz, nearest);
        if (hit) {
          found = true;
          best = rank(nearest.t);
          if (nearest.any) {
            break;
          }
        }
      }
      // Take up the last node put aside that does not begin beyond the best hit.
      do {
        top--;
      } while (top >= bottom && stackNear[top] > best);
      if (top < bottom) {
        break;
      }
      node = stack[top];
    }
    nearest.stackTop = bottom;
    return found;
  }

  private boolean intersectShapes(int leaf, Ray ray, NearestHit nearest) {
    boolean found = false;
    int first = BvhBuilder.leafFirst(leaf);
    int end = first + BvhBuilder.leafCount(leaf);
    for (int i = first; i < end; i++) {
      found |= intersectShape(shapes[i], shapeNumbers[i], ray, nearest);
    }
    return found;
  }

  /** Asks one shape, for hits at the same t as the best too if its number is the lower. */
  private static boolean intersectShape(Shape shape, int number, Ray ray, NearestHit nearest) {
    double best = nearest.t;
    if (number < nearest.shape) {
      nearest.t = Math.nextUp(best);
    }
    if (shape.intersect(ray, nearest)) {
      nearest.shape = number;
      return true;
    }
    nearest.t = best;
    return false;
  }

  /**
   * Returns the upper half of a number's bits. It never falls as the number rises, and all negative
   * numbers have negative ranks; among those the order is lost, but slabs only compare with what is
   * not negative. Ranks make the search insensitive to order beyond a millionth, never wrong; and
   * the smaller of two integers costs a fraction of that of two doubles, which minds NaN and -0.
   */
  private static int rank(double t) {
    return (int) (Double.doubleToRawLongBits(t) >> 32);
  }

  /** Returns the rank of where a ray is inside all three slabs, and at t ≥ 0. */
  private static int nearRank(double x, double y, double z) {
    return Math.max(Math.max(rank(x), rank(y)), Math.max(rank(z), 0));
  }

  /** Returns the rank of where a ray leaves the first of three slabs. */
  private static int farRank(double x, double y, double z) {
    return Math.min(Math.min(rank(x), rank(y)), rank(z));
  }

  private static int longest(double x, double y, double z) {
    double ax = Math.abs(x);
    double ay = Math.abs(y);
    double az = Math.abs(z);
    if (ax > ay) {
      return ax > az ? 0 : 2;
    }
    return ay > az ? 1 : 2;
  }

  private static double pick(int axis, double x, double y, double z) {
    return axis == 0 ? x : axis == 1 ? y : z;
  }
}
