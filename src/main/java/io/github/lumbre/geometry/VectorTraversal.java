package io.github.lumbre.geometry;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The search by vectors of eight floats: a node's eight boxes, or a leaf's eight triangles, at a
 * time. Floats only choose what may be hit; each of these triangles is then tested in double
 * precision as everywhere. The only class that needs the module jdk.incubator.vector.
 *
 * <p>The bounds of all errors are derived in docs/design.md. No method takes or returns vectors,
 * since where one is not inlined they are allocated; neither are masks used, for the same reason.
 */
final class VectorTraversal implements Traversal {
  private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;

  /** A bit for each lane. */
  private static final IntVector LANES =
      IntVector.fromArray(IntVector.SPECIES_256, new int[] {1, 2, 4, 8, 16, 32, 64, 128}, 0);

  private static final int ALL_LANES = 0xff;
  private static final int WIDTH = WideTree.WIDTH;

  /** Makes up for the rounding of slabs, some seven halves of an ulp at each end. */
  private static final float GROWTH = 1 + 0x1p-20f;

  /** The least component of a direction, relative to the largest. */
  private static final double LEAST = 0x1p-60;

  /** Beyond this distance an origin is moved nearer. */
  private static final double NEAR = 4;

  /** Beyond this distance all boxes and triangles are looked at. */
  private static final double REACH = 0x1p40;

  private static final int MAX_EXPONENT = 960;

  private final float[] nodes;
  private final int[] children;
  private final float[] leaves;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final UnitSpace space;
  private final double centreReach;

  VectorTraversal(WideTree tree) {
    nodes = tree.nodes();
    children = tree.children();
    leaves = tree.leaves();
    triangles = tree.triangles();
    shapes = tree.shapes();
    space = tree.space();
    centreReach = space.scale * Axes.largest(space.centreX, space.centreY, space.centreZ);
  }

  /** Returns how many floats a vector of this processor holds. */
  static int preferredLanes() {
    return FloatVector.SPECIES_PREFERRED.length();
  }

  /** {@inheritDoc} All state is in local variables on purpose. */
  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    // Move the ray to the hierarchy's space; its t is measured there in units of the longest axis.
    double x = (ox - space.centreX) * space.scale;
    double y = (oy - space.centreY) * space.scale;
    double z = (oz - space.centreZ) * space.scale;
    int exponent = Math.getExponent(Axes.largest(dx, dy, dz));
    double unit = power(-exponent);
    double ux = atLeast(dx * unit);
    double uy = atLeast(dy * unit);
    double uz = atLeast(dz * unit);
    double tScale = power(exponent + space.exponent);
    double reach = Axes.largest(x, y, z);
    double worldReach = Axes.largest(ox, oy, oz) * space.scale + centreReach;
    double start = 0;
    if (reach > NEAR && Math.abs(exponent) <= MAX_EXPONENT) {
      start = entry(x, y, z, ux, uy, uz, 2 + 0x1p-46 * worldReach);
      if (start < 0) {
        return false;
      }
      x += start * ux;
      y += start * uy;
      z += start * uz;
      reach = Axes.largest(x, y, z);
    }
    // What positions, edge functions of triangles of size 1, and those of size 0 may be wrong by.
    double size = 1 + reach + 0x1p-24 * worldReach;
    float slack = (float) (0x1p-22 * (1 + reach) + 0x1p-46 * worldReach);
    float tolerance = (float) (0x1p-17 * size);
    float floor = (float) (0x1p-37 * size * size);
    if (!(worldReach <= REACH && Math.abs(exponent) <= MAX_EXPONENT)) {
      // Out of the reach of floats: look at everything.
      ux = 1;
      uy = 1;
      uz = 1;
      x = 0;
      y = 0;
      z = 0;
      start = 0;
      tScale = Double.POSITIVE_INFINITY;
      slack = 0x1p60f;
      tolerance = 0;
      floor = Float.POSITIVE_INFINITY;
    }
    float ix = (float) (1 / ux);
    float iy = (float) (1 / uy);
    float iz = (float) (1 / uz);
    int nearX = WIDTH * Axes.sign(ux);
    int nearY = WIDTH * (2 + Axes.sign(uy));
    int nearZ = WIDTH * (4 + Axes.sign(uz));
    int farX = nearX ^ WIDTH;
    int farY = nearY ^ WIDTH;
    int farZ = nearZ ^ WIDTH;
    // Exits lie later by more than entries and exits are wrong.
    float jx = ix * GROWTH;
    float jy = iy * GROWTH;
    float jz = iz * GROWTH;
    float inX = -ix * (float) x - slack * Math.abs(ix);
    float inY = -iy * (float) y - slack * Math.abs(iy);
    float inZ = -iz * (float) z - slack * Math.abs(iz);
    float outX = slack * Math.abs(jx) - jx * (float) x;
    float outY = slack * Math.abs(jy) - jy * (float) y;
    float outZ = slack * Math.abs(jz) - jz * (float) z;
    // Shear the longest axis onto the ray; a branch for each choice would be mispredicted.
    double[] axes = nearest.axes;
    axes[0] = dx;
    axes[1] = dy;
    axes[2] = dz;
    axes[3] = ox;
    axes[4] = oy;
    axes[5] = oz;
    axes[6] = x;
    axes[7] = y;
    axes[8] = z;
    int kz = Axes.longest(dx, dy, dz);
    int kx = Axes.next(kz);
    int ky = Axes.next(kx);
    double sz = 1 / axes[kz];
    double sx = axes[kx] / axes[kz];
    double sy = axes[ky] / axes[kz];
    double okx = axes[3 + kx];
    double oky = axes[3 + ky];
    double okz = axes[3 + kz];
    float ukx = (float) axes[6 + kx];
    float uky = (float) axes[6 + ky];
    float ukz = (float) axes[6 + kz];
    float fsx = (float) sx;
    float fsy = (float) sy;
    boolean any = nearest.any;
    float[] boxes = nodes;
    int[] stack = nearest.stack;
    int[] stackNear = nearest.stackNear;
    int[] lanes = nearest.lanes;
    int bottom = nearest.stackTop;
    int top = bottom;
    boolean found = false;
    int bestBits = last(nearest.t * tScale, start);
    int node = 0;
    while (true) {
      if (node >= 0) {
        int at = node * WideTree.NODE_SIZE;
        IntVector near =
            FloatVector.fromArray(FLOATS, boxes, at + nearX)
                .lanewise(VectorOperators.FMA, ix, inX)
                .reinterpretAsInts()
                .max(
                    FloatVector.fromArray(FLOATS, boxes, at + nearY)
                        .lanewise(VectorOperators.FMA, iy, inY)
                        .reinterpretAsInts())
                .max(
                    FloatVector.fromArray(FLOATS, boxes, at + nearZ)
                        .lanewise(VectorOperators.FMA, iz, inZ)
                        .reinterpretAsInts()
                        .max(0));
        IntVector far =
            FloatVector.fromArray(FLOATS, boxes, at + farX)
                .lanewise(VectorOperators.FMA, jx, outX)
                .reinterpretAsInts()
                .min(
                    FloatVector.fromArray(FLOATS, boxes, at + farY)
                        .lanewise(VectorOperators.FMA, jy, outY)
                        .reinterpretAsInts())
                .min(
                    FloatVector.fromArray(FLOATS, boxes, at + farZ)
                        .lanewise(VectorOperators.FMA, jz, outZ)
                        .reinterpretAsInts()
                        .min(bestBits));
        int hits =
            ALL_LANES
                & ~far.sub(near)
                    .or(far)
                    .lanewise(VectorOperators.ASHR, 31)
                    .and(LANES)
                    .reduceLanes(VectorOperators.OR);
        int child = node * WIDTH;
        if (hits != 0) {
          if (any) {
            while ((hits & hits - 1) != 0) {
              stack[top++] = children[child + Integer.numberOfTrailingZeros(hits)];
              hits &= hits - 1;
            }
            node = children[child + Integer.numberOfTrailingZeros(hits)];
            continue;
          }
          if ((hits & hits - 1) == 0) {
            node = children[child + Integer.numberOfTrailingZeros(hits)];
            continue;
          }
          near.intoArray(lanes, 0);
          int first = top;
          do {
            int lane = Integer.numberOfTrailingZeros(hits);
            int distance = lanes[lane];
            int place = top++;
            while (place > first && stackNear[place - 1] < distance) {
              stackNear[place] = stackNear[place - 1];
              stack[place] = stack[place - 1];
              place--;
            }
            stackNear[place] = distance;
            stack[place] = children[child + lane];
            hits &= hits - 1;
          } while (hits != 0);
          node = stack[--top];
          continue;
        }
      } else if (LeafRef.isOfShapes(node)) {
        nearest.stackTop = top;
        if (shapes.intersect(node, nearest)) {
          found = true;
          bestBits = last(nearest.t * tScale, start);
          if (any) {
            break;
          }
        }
      } else {
        int first = LeafRef.first(node);
        int count = LeafRef.count(node);
        int candidates =
            candidates(first, count, kx, ky, kz, ukx, uky, ukz, fsx, fsy, tolerance, floor);
        while (candidates != 0) {
          int i = first + Integer.numberOfTrailingZeros(candidates);
          candidates &= candidates - 1;
          if (triangles.intersectInMesh(i, kx, ky, kz, okx, oky, okz, sx, sy, sz, nearest)) {
            found = true;
            bestBits = last(nearest.t * tScale, start);
          }
        }
        if (found && any) {
          break;
        }
      }
      // Take up the last node put aside that does not begin beyond the best hit.
      if (any) {
        top--;
      } else {
        do {
          top--;
        } while (top >= bottom && stackNear[top] > bestBits);
      }
      if (top < bottom) {
        break;
      }
      node = stack[top];
    }
    nearest.stackTop = bottom;
    return found;
  }

  /** Returns a bit for each triangle of a leaf that may be hit, whatever its t. */
  private int candidates(
      int first,
      int count,
      int kx,
      int ky,
      int kz,
      float ox,
      float oy,
      float oz,
      float sx,
      float sy,
      float tolerance,
      float floor) {
    float[] p = leaves;
    int base = first * WideTree.TRIANGLE_SIZE;
    int x = base + kx * count;
    int y = base + ky * count;
    int z = base + kz * count;
    int next = 3 * count;
    FloatVector az = FloatVector.fromArray(FLOATS, p, z).sub(oz);
    FloatVector bz = FloatVector.fromArray(FLOATS, p, z + next).sub(oz);
    FloatVector cz = FloatVector.fromArray(FLOATS, p, z + 2 * next).sub(oz);
    FloatVector ax = FloatVector.fromArray(FLOATS, p, x).sub(ox).sub(az.mul(sx));
    FloatVector ay = FloatVector.fromArray(FLOATS, p, y).sub(oy).sub(az.mul(sy));
    FloatVector bx = FloatVector.fromArray(FLOATS, p, x + next).sub(ox).sub(bz.mul(sx));
    FloatVector by = FloatVector.fromArray(FLOATS, p, y + next).sub(oy).sub(bz.mul(sy));
    FloatVector cx = FloatVector.fromArray(FLOATS, p, x + 2 * next).sub(ox).sub(cz.mul(sx));
    FloatVector cy = FloatVector.fromArray(FLOATS, p, y + 2 * next).sub(oy).sub(cz.mul(sy));
    FloatVector u = cx.mul(by).sub(cy.mul(bx));
    FloatVector v = ax.mul(cy).sub(ay.mul(cx));
    FloatVector w = bx.mul(ay).sub(by.mul(ax));
    FloatVector room = FloatVector.fromArray(FLOATS, p, base + 9 * count).mul(tolerance).add(floor);
    IntVector below = u.add(room).reinterpretAsInts().or(v.add(room).reinterpretAsInts());
    IntVector above = room.sub(u).reinterpretAsInts().or(room.sub(v).reinterpretAsInts());
    below = below.or(w.add(room).reinterpretAsInts());
    above = above.or(room.sub(w).reinterpretAsInts());
    int misses =
        below
            .and(above)
            .lanewise(VectorOperators.ASHR, 31)
            .and(LANES)
            .reduceLanes(VectorOperators.OR);
    return (1 << count) - 1 & ~misses;
  }

  /** Returns where a ray from afar enters the space [-room, room]³; negative if it never does. */
  private static double entry(
      double x, double y, double z, double dx, double dy, double dz, double room) {
    double nearX = (-Math.copySign(room, dx) - x) / dx;
    double nearY = (-Math.copySign(room, dy) - y) / dy;
    double nearZ = (-Math.copySign(room, dz) - z) / dz;
    double farX = (Math.copySign(room, dx) - x) / dx;
    double farY = (Math.copySign(room, dy) - y) / dy;
    double farZ = (Math.copySign(room, dz) - z) / dz;
    double near = Math.max(Math.max(nearX, nearY), Math.max(nearZ, 0));
    return near <= Math.min(farX, Math.min(farY, farZ)) ? near : -1;
  }

  /** Returns the bits of a t that no hit before the given one exceeds, even after rounding. */
  private static int last(double t, double start) {
    double rounded = (t - start) * GROWTH + 0x1p-48 * start;
    return Float.floatToRawIntBits(rounded < Float.MAX_VALUE ? (float) rounded : Float.MAX_VALUE);
  }

  /** Returns a power of two; infinity where double precision has none. */
  private static double power(int exponent) {
    return Math.abs(exponent) < 1023
        ? Double.longBitsToDouble(exponent + 1023L << 52)
        : Double.POSITIVE_INFINITY;
  }

  private static double atLeast(double d) {
    return Math.abs(d) < LEAST ? Math.copySign(LEAST, d) : d;
  }
}
