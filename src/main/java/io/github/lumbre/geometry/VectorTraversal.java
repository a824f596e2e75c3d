package io.github.lumbre.geometry;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The search by vectors of eight floats: a node's eight boxes, or a leaf's eight triangles, at a
 * time. Floats only choose what may be hit; each of these triangles is then tested in double
 * precision as everywhere. The only class that needs the module jdk.incubator.vector.
 *
 * <p>Its shape is what the compiler turns into good machine code, as docs/design.md tells: no
 * method takes or returns vectors, so that the test of a node stands here twice; no masks are used,
 * and no loop over nodes calls anything.
 */
final class VectorTraversal implements Traversal {
  private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
  private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;

  /** What a comparison makes of eight lanes: the bytes of a long, 1 or 0. */
  private static final VectorSpecies<Byte> BYTES = ByteVector.SPECIES_128;

  /** From a bit of that long to its lane. */
  private static final int LANE_SHIFT = 3;

  private static final int WIDTH = WideTree.WIDTH;
  private static final int CHILDREN = WideTree.CHILDREN;

  /**
   * What exits are put off by, in units of their last place: more than 2^-20 of a t, where the
   * rounding of slabs makes less than 2^-21 at each end.
   */
  private static final int EXIT_ULPS = 16;

  /** Below the stack: no node and no leaf. */
  private static final int NONE = Integer.MIN_VALUE;

  private final int[] nodes;
  private final float[] leaves;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final UnitSpace space;
  private final boolean hasTriangles;

  VectorTraversal(WideTree tree) {
    nodes = tree.nodes();
    leaves = tree.leaves();
    triangles = tree.triangles();
    shapes = tree.shapes();
    space = tree.space();
    hasTriangles = leaves.length > WIDTH;
  }

  /** Returns how many floats a vector of this processor holds. */
  static int preferredLanes() {
    return FloatVector.SPECIES_PREFERRED.length();
  }

  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    WideRay ray = nearest.wideRay();
    if (!ray.aim(space, hasTriangles, ox, oy, oz, dx, dy, dz)) {
      return false;
    }
    ray.endAt(nearest.t);
    int bottom = nearest.stackTop;
    nearest.stack[bottom] = NONE;
    nearest.stackNear[bottom] = Integer.MIN_VALUE;
    nearest.stackTop = bottom + 1;
    boolean found = nearest.any ? findAny(ray, nearest) : findNearest(ray, nearest);
    nearest.stackTop = bottom;
    return found;
  }

  private boolean findNearest(WideRay ray, NearestHit nearest) {
    boolean found = false;
    int node = 0;
    while (true) {
      if (node >= 0) {
        node = nearestLeaf(node, ray, nearest);
      }
      if (node == NONE) {
        return found;
      }
      if (intersect(node, ray, nearest)) {
        found = true;
        ray.endAt(nearest.t);
      }
      // Take up the last node put aside that does not begin beyond the best hit.
      int top = nearest.stackTop;
      do {
        top--;
      } while (nearest.stackNear[top] > ray.last);
      nearest.stackTop = top;
      node = nearest.stack[top];
    }
  }

  private boolean findAny(WideRay ray, NearestHit nearest) {
    int node = 0;
    while (true) {
      if (node >= 0) {
        node = anyLeaf(node, ray, nearest);
      }
      if (node == NONE) {
        return false;
      }
      if (intersect(node, ray, nearest)) {
        return true;
      }
      node = nearest.stack[--nearest.stackTop];
    }
  }

  /**
   * Goes down from a node to the nearest leaf and puts aside, the farthest first, what it passes.
   */
  private int nearestLeaf(int root, WideRay ray, NearestHit nearest) {
    int[] tree = nodes;
    int[] stack = nearest.stack;
    int[] stackNear = nearest.stackNear;
    int[] lanes = nearest.lanes;
    int top = nearest.stackTop;
    IntVector signX = IntVector.broadcast(INTS, ray.signX);
    IntVector signY = IntVector.broadcast(INTS, ray.signY);
    IntVector signZ = IntVector.broadcast(INTS, ray.signZ);
    FloatVector ix = FloatVector.broadcast(FLOATS, ray.ix);
    FloatVector iy = FloatVector.broadcast(FLOATS, ray.iy);
    FloatVector iz = FloatVector.broadcast(FLOATS, ray.iz);
    FloatVector inX = FloatVector.broadcast(FLOATS, ray.inX);
    FloatVector inY = FloatVector.broadcast(FLOATS, ray.inY);
    FloatVector inZ = FloatVector.broadcast(FLOATS, ray.inZ);
    FloatVector outX = FloatVector.broadcast(FLOATS, ray.outX);
    FloatVector outY = FloatVector.broadcast(FLOATS, ray.outY);
    FloatVector outZ = FloatVector.broadcast(FLOATS, ray.outZ);
    int last = ray.last;
    int node = root;
    while (node >= 0) {
      IntVector minX = IntVector.fromArray(INTS, tree, node);
      IntVector maxX = IntVector.fromArray(INTS, tree, node + WIDTH);
      IntVector minY = IntVector.fromArray(INTS, tree, node + 2 * WIDTH);
      IntVector maxY = IntVector.fromArray(INTS, tree, node + 3 * WIDTH);
      IntVector minZ = IntVector.fromArray(INTS, tree, node + 4 * WIDTH);
      IntVector maxZ = IntVector.fromArray(INTS, tree, node + 5 * WIDTH);
      IntVector near =
          minX.lanewise(VectorOperators.BITWISE_BLEND, maxX, signX)
              .reinterpretAsFloats()
              .fma(ix, inX)
              .reinterpretAsInts()
              .max(
                  minY.lanewise(VectorOperators.BITWISE_BLEND, maxY, signY)
                      .reinterpretAsFloats()
                      .fma(iy, inY)
                      .reinterpretAsInts())
              .max(
                  minZ.lanewise(VectorOperators.BITWISE_BLEND, maxZ, signZ)
                      .reinterpretAsFloats()
                      .fma(iz, inZ)
                      .reinterpretAsInts()
                      .max(0));
      IntVector far =
          maxX.lanewise(VectorOperators.BITWISE_BLEND, minX, signX)
              .reinterpretAsFloats()
              .fma(ix, outX)
              .reinterpretAsInts()
              .min(
                  maxY.lanewise(VectorOperators.BITWISE_BLEND, minY, signY)
                      .reinterpretAsFloats()
                      .fma(iy, outY)
                      .reinterpretAsInts())
              .min(
                  maxZ.lanewise(VectorOperators.BITWISE_BLEND, minZ, signZ)
                      .reinterpretAsFloats()
                      .fma(iz, outZ)
                      .reinterpretAsInts()
                      .min(last));
      long hits =
          ((ByteVector)
                  far.sub(near.sub(EXIT_ULPS))
                      .or(far)
                      .not()
                      .lanewise(VectorOperators.LSHR, 31)
                      .convertShape(VectorOperators.I2B, BYTES, 0))
              .reinterpretAsLongs()
              .lane(0);
      if (hits == 0) {
        do {
          top--;
        } while (stackNear[top] > last);
        node = stack[top];
        continue;
      }
      int lane = Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT;
      int child = tree[node + CHILDREN + lane];
      hits &= hits - 1;
      if (hits == 0) {
        node = child;
        continue;
      }
      near.intoArray(lanes, 0);
      int distance = lanes[lane];
      int other = Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT;
      int otherChild = tree[node + CHILDREN + other];
      int otherDistance = lanes[other];
      hits &= hits - 1;
      boolean ordered = distance <= otherDistance;
      int first = top;
      stack[top] = ordered ? otherChild : child;
      stackNear[top++] = Math.max(distance, otherDistance);
      if (hits == 0) {
        node = ordered ? child : otherChild;
        continue;
      }
      stack[top] = ordered ? child : otherChild;
      stackNear[top++] = Math.min(distance, otherDistance);
      do {
        lane = Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT;
        distance = lanes[lane];
        int place = top++;
        while (place > first && stackNear[place - 1] < distance) {
          stackNear[place] = stackNear[place - 1];
          stack[place] = stack[place - 1];
          place--;
        }
        stackNear[place] = distance;
        stack[place] = tree[node + CHILDREN + lane];
        hits &= hits - 1;
      } while (hits != 0);
      node = stack[--top];
    }
    nearest.stackTop = top;
    return node;
  }

  /** Goes down from a node to any leaf and puts aside what it passes. */
  private int anyLeaf(int root, WideRay ray, NearestHit nearest) {
    int[] tree = nodes;
    int[] stack = nearest.stack;
    int top = nearest.stackTop;
    IntVector signX = IntVector.broadcast(INTS, ray.signX);
    IntVector signY = IntVector.broadcast(INTS, ray.signY);
    IntVector signZ = IntVector.broadcast(INTS, ray.signZ);
    FloatVector ix = FloatVector.broadcast(FLOATS, ray.ix);
    FloatVector iy = FloatVector.broadcast(FLOATS, ray.iy);
    FloatVector iz = FloatVector.broadcast(FLOATS, ray.iz);
    FloatVector inX = FloatVector.broadcast(FLOATS, ray.inX);
    FloatVector inY = FloatVector.broadcast(FLOATS, ray.inY);
    FloatVector inZ = FloatVector.broadcast(FLOATS, ray.inZ);
    FloatVector outX = FloatVector.broadcast(FLOATS, ray.outX);
    FloatVector outY = FloatVector.broadcast(FLOATS, ray.outY);
    FloatVector outZ = FloatVector.broadcast(FLOATS, ray.outZ);
    int last = ray.last;
    int node = root;
    while (node >= 0) {
      IntVector minX = IntVector.fromArray(INTS, tree, node);
      IntVector maxX = IntVector.fromArray(INTS, tree, node + WIDTH);
      IntVector minY = IntVector.fromArray(INTS, tree, node + 2 * WIDTH);
      IntVector maxY = IntVector.fromArray(INTS, tree, node + 3 * WIDTH);
      IntVector minZ = IntVector.fromArray(INTS, tree, node + 4 * WIDTH);
      IntVector maxZ = IntVector.fromArray(INTS, tree, node + 5 * WIDTH);
      IntVector near =
          minX.lanewise(VectorOperators.BITWISE_BLEND, maxX, signX)
              .reinterpretAsFloats()
              .fma(ix, inX)
              .reinterpretAsInts()
              .max(
                  minY.lanewise(VectorOperators.BITWISE_BLEND, maxY, signY)
                      .reinterpretAsFloats()
                      .fma(iy, inY)
                      .reinterpretAsInts())
              .max(
                  minZ.lanewise(VectorOperators.BITWISE_BLEND, maxZ, signZ)
                      .reinterpretAsFloats()
                      .fma(iz, inZ)
                      .reinterpretAsInts()
                      .max(0));
      IntVector far =
          maxX.lanewise(VectorOperators.BITWISE_BLEND, minX, signX)
              .reinterpretAsFloats()
              .fma(ix, outX)
              .reinterpretAsInts()
              .min(
                  maxY.lanewise(VectorOperators.BITWISE_BLEND, minY, signY)
                      .reinterpretAsFloats()
                      .fma(iy, outY)
                      .reinterpretAsInts())
              .min(
                  maxZ.lanewise(VectorOperators.BITWISE_BLEND, minZ, signZ)
                      .reinterpretAsFloats()
                      .fma(iz, outZ)
                      .reinterpretAsInts()
                      .min(last));
      long hits =
          ((ByteVector)
                  far.sub(near.sub(EXIT_ULPS))
                      .or(far)
                      .not()
                      .lanewise(VectorOperators.LSHR, 31)
                      .convertShape(VectorOperators.I2B, BYTES, 0))
              .reinterpretAsLongs()
              .lane(0);
      if (hits == 0) {
        node = stack[--top];
        continue;
      }
      while ((hits & hits - 1) != 0) {
        stack[top++] = tree[node + CHILDREN + (Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT)];
        hits &= hits - 1;
      }
      node = tree[node + CHILDREN + (Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT)];
    }
    nearest.stackTop = top;
    return node;
  }

  /** Tests the items of a leaf; tells whether one had a hit, which is stored. */
  private boolean intersect(int leaf, WideRay ray, NearestHit nearest) {
    if (LeafRef.isOfShapes(leaf)) {
      return shapes.intersect(leaf, nearest);
    }
    int first = LeafRef.first(leaf);
    long candidates = candidates(first, LeafRef.count(leaf), ray);
    boolean found = false;
    while (candidates != 0) {
      int i = first + (Long.numberOfTrailingZeros(candidates) >>> LANE_SHIFT);
      candidates &= candidates - 1;
      found |= triangles.intersectOne(i, ray, nearest);
    }
    return found;
  }

  /** Returns a byte for each triangle of a leaf: 1 if it may be hit before the ray's end. */
  private long candidates(int first, int count, WideRay ray) {
    float[] p = leaves;
    int base = first * WideTree.TRIANGLE_SIZE;
    int x = base + ray.kx * count;
    int y = base + ray.ky * count;
    int z = base + ray.kz * count;
    int next = 3 * count;
    float ox = ray.x;
    float oy = ray.y;
    float oz = ray.z;
    float sx = (float) ray.sx;
    float sy = (float) ray.sy;
    FloatVector az = FloatVector.fromArray(FLOATS, p, z).sub(oz);
    FloatVector bz = FloatVector.fromArray(FLOATS, p, z + next).sub(oz);
    FloatVector cz = FloatVector.fromArray(FLOATS, p, z + 2 * next).sub(oz);
    FloatVector ax = FloatVector.fromArray(FLOATS, p, x).sub(ox).sub(az.mul(sx));
    FloatVector ay = FloatVector.fromArray(FLOATS, p, y).sub(oy).sub(az.mul(sy));
    FloatVector bx = FloatVector.fromArray(FLOATS, p, x + next).sub(ox).sub(bz.mul(sx));
    FloatVector by = FloatVector.fromArray(FLOATS, p, y + next).sub(oy).sub(bz.mul(sy));
    FloatVector cx = FloatVector.fromArray(FLOATS, p, x + 2 * next).sub(ox).sub(cz.mul(sx));
    FloatVector cy = FloatVector.fromArray(FLOATS, p, y + 2 * next).sub(oy).sub(cz.mul(sy));
    // The edge functions do not differ in sign by more than they are wrong by.
    FloatVector u = cx.mul(by).sub(cy.mul(bx));
    FloatVector v = ax.mul(cy).sub(ay.mul(cx));
    FloatVector w = bx.mul(ay).sub(by.mul(ax));
    FloatVector room =
        FloatVector.fromArray(FLOATS, p, base + 9 * count).mul(ray.tolerance).add(ray.floor);
    IntVector below = u.add(room).reinterpretAsInts().or(v.add(room).reinterpretAsInts());
    IntVector above = room.sub(u).reinterpretAsInts().or(room.sub(v).reinterpretAsInts());
    below = below.or(w.add(room).reinterpretAsInts());
    above = above.or(room.sub(w).reinterpretAsInts());
    // The hit lies neither behind the origin nor beyond the end, with depths times the determinant.
    IntVector determinant = u.add(v).add(w).reinterpretAsInts();
    IntVector size = determinant.and(Integer.MAX_VALUE);
    FloatVector along =
        cz.fma(w, bz.fma(v, az.mul(u)))
            .reinterpretAsInts()
            .lanewise(VectorOperators.XOR, determinant.sub(size))
            .lanewise(VectorOperators.XOR, ray.depthSign)
            .reinterpretAsFloats();
    FloatVector end = FloatVector.broadcast(FLOATS, ray.lastDepth);
    FloatVector slack = FloatVector.broadcast(FLOATS, ray.depthSlack);
    FloatVector depthRoom = room.mul(ray.depthRoom);
    IntVector behind =
        size.reinterpretAsFloats().fma(slack, depthRoom).add(along).reinterpretAsInts();
    IntVector beyond =
        size.reinterpretAsFloats().fma(end, depthRoom).sub(along).reinterpretAsInts();
    long hits =
        ((ByteVector)
                below
                    .and(above)
                    .or(behind)
                    .or(beyond)
                    .not()
                    .lanewise(VectorOperators.LSHR, 31)
                    .convertShape(VectorOperators.I2B, BYTES, 0))
            .reinterpretAsLongs()
            .lane(0);
    return hits & -1L >>> Long.SIZE - (count << LANE_SHIFT);
  }
}
