package io.github.lumbre.geometry;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The traversal with vectors of eight floats: it tests eight boxes of a node, or eight triangles of
 * a leaf, at a time. Floats only select candidates; each candidate is then tested in double
 * precision, as in the scalar kernel. This is the only class that needs the module
 * jdk.incubator.vector.
 *
 * <p>The code is structured so that the JIT compiles it well, as docs/design.md explains. No method
 * takes or returns vectors, so the test of a node appears twice. No masks are used on JVMs that
 * allocate them, and no loop over nodes calls another method.
 */
final class VectorTraversal implements Traversal {
  private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
  private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;

  /**
   * Whether the JIT creates masks without allocation. If so, a comparison of eight lanes yields the
   * bits of a long; otherwise it yields the bytes of a long, 1 or 0.
   */
  private static final boolean MASKS = Runtime.version().feature() >= 25;

  private static final VectorSpecies<Byte> BYTES = ByteVector.SPECIES_128;

  /** The right shift from a bit index of that long to its lane. */
  private static final int LANE_SHIFT = MASKS ? 0 : 3;

  private static final int WIDTH = WideTree.WIDTH;
  private static final int CHILDREN = WideTree.CHILDREN;

  /** All lanes, as the bytes of a long. */
  private static final long HITS = 0x0101010101010101L;

  /** The stack's end marker, which is neither a node nor a leaf. */
  private static final int NONE = Integer.MIN_VALUE;

  /** The bits of a stack entry's node. */
  private static final long LOW_HALF = 0xffffffffL;

  private final int[] nodes;
  private final float[] leaves;
  private final Triangles triangles;
  private final LeafShapes shapes;
  private final UnitSpace space;

  VectorTraversal(WideTree tree) {
    nodes = tree.nodes();
    leaves = tree.leaves();
    triangles = tree.triangles();
    shapes = tree.shapes();
    space = tree.space();
  }

  @Override
  public boolean traverse(
      double ox, double oy, double oz, double dx, double dy, double dz, NearestHit nearest) {
    WideRay ray = nearest.wideRay();
    if (!ray.aim(space, ox, oy, oz, dx, dy, dz)) {
      return false;
    }
    ray.endAt(nearest.t);
    ray.beginAt(nearest.passed.t);
    int bottom = nearest.stackTop;
    nearest.stack[bottom] = NONE;
    nearest.entries[bottom] = (long) Integer.MIN_VALUE << 32 | NONE & LOW_HALF;
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
      // Pop the last node that the ray does not enter beyond the best hit.
      int top = nearest.stackTop;
      long last = (long) ray.last << 32 | LOW_HALF;
      do {
        top--;
      } while (nearest.entries[top] > last);
      nearest.stackTop = top;
      node = (int) nearest.entries[top];
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
   * Descends from a node to the nearest leaf, and pushes the siblings that the ray also enters, the
   * farthest first. Returns the leaf, or {@link #NONE}. Floats are compared as integers: where both
   * are negative, their order is reversed, but then the box is behind the origin anyway.
   */
  private int nearestLeaf(int root, WideRay ray, NearestHit nearest) {
    int[] tree = nodes;
    long[] stack = nearest.entries;
    int[] lanes = nearest.lanes;
    int top = nearest.stackTop;
    FloatVector ix = FloatVector.broadcast(FLOATS, ray.ix);
    FloatVector iy = FloatVector.broadcast(FLOATS, ray.iy);
    FloatVector iz = FloatVector.broadcast(FLOATS, ray.iz);
    FloatVector shiftX = FloatVector.broadcast(FLOATS, ray.shiftX);
    FloatVector shiftY = FloatVector.broadcast(FLOATS, ray.shiftY);
    FloatVector shiftZ = FloatVector.broadcast(FLOATS, ray.shiftZ);
    int passed = ray.first;
    int end = ray.last;
    long last = (long) end << 32 | LOW_HALF;
    int node = root;
    while (node >= 0) {
      IntVector minX = IntVector.fromArray(INTS, tree, node);
      IntVector maxX = IntVector.fromArray(INTS, tree, node + WIDTH);
      IntVector minY = IntVector.fromArray(INTS, tree, node + 2 * WIDTH);
      IntVector maxY = IntVector.fromArray(INTS, tree, node + 3 * WIDTH);
      IntVector minZ = IntVector.fromArray(INTS, tree, node + 5 * WIDTH);
      IntVector maxZ = IntVector.fromArray(INTS, tree, node + 6 * WIDTH);
      IntVector tMinX = minX.reinterpretAsFloats().fma(ix, shiftX).reinterpretAsInts();
      IntVector tMaxX = maxX.reinterpretAsFloats().fma(ix, shiftX).reinterpretAsInts();
      IntVector tMinY = minY.reinterpretAsFloats().fma(iy, shiftY).reinterpretAsInts();
      IntVector tMaxY = maxY.reinterpretAsFloats().fma(iy, shiftY).reinterpretAsInts();
      IntVector tMinZ = minZ.reinterpretAsFloats().fma(iz, shiftZ).reinterpretAsInts();
      IntVector tMaxZ = maxZ.reinterpretAsFloats().fma(iz, shiftZ).reinterpretAsInts();
      IntVector near = tMinX.min(tMaxX).max(tMinY.min(tMaxY)).max(tMinZ.min(tMaxZ).max(passed));
      IntVector far = tMinX.max(tMaxX).min(tMinY.max(tMaxY)).min(tMinZ.max(tMaxZ).min(end));
      long hits =
          MASKS
              ? near.compare(VectorOperators.LE, far).toLong()
              : HITS
                  ^ ((ByteVector)
                          far.sub(near)
                              .or(far)
                              .lanewise(VectorOperators.LSHR, 31)
                              .convertShape(VectorOperators.I2B, BYTES, 0))
                      .reinterpretAsLongs()
                      .lane(0);
      if (hits == 0) {
        do {
          top--;
        } while (stack[top] > last);
        node = (int) stack[top];
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
      long first = (long) lanes[lane] << 32 | child & LOW_HALF;
      lane = Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT;
      long other = (long) lanes[lane] << 32 | tree[node + CHILDREN + lane] & LOW_HALF;
      hits &= hits - 1;
      int bottom = top;
      stack[top++] = first > other ? first : other;
      first = first > other ? other : first;
      while (hits != 0) {
        lane = Long.numberOfTrailingZeros(hits) >>> LANE_SHIFT;
        other = (long) lanes[lane] << 32 | tree[node + CHILDREN + lane] & LOW_HALF;
        hits &= hits - 1;
        long farther = first > other ? first : other;
        first = first > other ? other : first;
        int place = top++;
        while (place > bottom && stack[place - 1] < farther) {
          stack[place] = stack[place - 1];
          place--;
        }
        stack[place] = farther;
      }
      node = (int) first;
    }
    nearest.stackTop = top;
    return node;
  }

  /**
   * Descends from a node to any leaf, and pushes the siblings that the ray also enters. Returns the
   * leaf, or {@link #NONE}.
   */
  private int anyLeaf(int root, WideRay ray, NearestHit nearest) {
    int[] tree = nodes;
    int[] stack = nearest.stack;
    int top = nearest.stackTop;
    FloatVector ix = FloatVector.broadcast(FLOATS, ray.ix);
    FloatVector iy = FloatVector.broadcast(FLOATS, ray.iy);
    FloatVector iz = FloatVector.broadcast(FLOATS, ray.iz);
    FloatVector shiftX = FloatVector.broadcast(FLOATS, ray.shiftX);
    FloatVector shiftY = FloatVector.broadcast(FLOATS, ray.shiftY);
    FloatVector shiftZ = FloatVector.broadcast(FLOATS, ray.shiftZ);
    int last = ray.last;
    int node = root;
    while (node >= 0) {
      IntVector minX = IntVector.fromArray(INTS, tree, node);
      IntVector maxX = IntVector.fromArray(INTS, tree, node + WIDTH);
      IntVector minY = IntVector.fromArray(INTS, tree, node + 2 * WIDTH);
      IntVector maxY = IntVector.fromArray(INTS, tree, node + 3 * WIDTH);
      IntVector minZ = IntVector.fromArray(INTS, tree, node + 5 * WIDTH);
      IntVector maxZ = IntVector.fromArray(INTS, tree, node + 6 * WIDTH);
      IntVector tMinX = minX.reinterpretAsFloats().fma(ix, shiftX).reinterpretAsInts();
      IntVector tMaxX = maxX.reinterpretAsFloats().fma(ix, shiftX).reinterpretAsInts();
      IntVector tMinY = minY.reinterpretAsFloats().fma(iy, shiftY).reinterpretAsInts();
      IntVector tMaxY = maxY.reinterpretAsFloats().fma(iy, shiftY).reinterpretAsInts();
      IntVector tMinZ = minZ.reinterpretAsFloats().fma(iz, shiftZ).reinterpretAsInts();
      IntVector tMaxZ = maxZ.reinterpretAsFloats().fma(iz, shiftZ).reinterpretAsInts();
      IntVector near = tMinX.min(tMaxX).max(tMinY.min(tMaxY)).max(tMinZ.min(tMaxZ).max(0));
      IntVector far = tMinX.max(tMaxX).min(tMinY.max(tMaxY)).min(tMinZ.max(tMaxZ).min(last));
      long hits =
          MASKS
              ? near.compare(VectorOperators.LE, far).toLong()
              : HITS
                  ^ ((ByteVector)
                          far.sub(near)
                              .or(far)
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

  /** Tests the items of a leaf; returns whether a hit was found and stored. */
  private boolean intersect(int leaf, WideRay ray, NearestHit nearest) {
    if (LeafRef.isOfShapes(leaf)) {
      return shapes.intersect(leaf, nearest);
    }
    int first = LeafRef.first(leaf);
    int count = LeafRef.count(leaf);
    long candidates = candidates(first, count, ray);
    if (candidates == 0) {
      return false;
    }
    ray.shear();
    int start = first & -WIDTH;
    int block = WideTree.blockAt(first);
    boolean found = false;
    while (candidates != 0) {
      int lane = Long.numberOfTrailingZeros(candidates) >>> LANE_SHIFT;
      candidates &= candidates - 1;
      int a = Float.floatToRawIntBits(leaves[block + WideTree.CORNERS + lane]);
      int b = Float.floatToRawIntBits(leaves[block + WideTree.CORNERS + WIDTH + lane]);
      int c = Float.floatToRawIntBits(leaves[block + WideTree.CORNERS + 2 * WIDTH + lane]);
      found |= triangles.intersectOne(start + lane, a, b, c, ray, nearest);
    }
    return found;
  }

  /**
   * Returns, for each triangle of a leaf's block, whether it belongs to the leaf and the ray may
   * hit it before its end, in the encoding of {@link #MASKS}. The test follows Möller &amp;
   * Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection", without the division. Its
   * error bounds are derived in docs/design.md.
   */
  private long candidates(int first, int count, WideRay ray) {
    float[] p = leaves;
    int at = WideTree.blockAt(first);
    FloatVector dx = FloatVector.broadcast(FLOATS, ray.dx);
    FloatVector dy = FloatVector.broadcast(FLOATS, ray.dy);
    FloatVector dz = FloatVector.broadcast(FLOATS, ray.dz);
    FloatVector ax = FloatVector.fromArray(FLOATS, p, at).sub(ray.x);
    FloatVector ay = FloatVector.fromArray(FLOATS, p, at + WIDTH).sub(ray.y);
    FloatVector az = FloatVector.fromArray(FLOATS, p, at + 2 * WIDTH).sub(ray.z);
    FloatVector bx = FloatVector.fromArray(FLOATS, p, at + 3 * WIDTH);
    FloatVector by = FloatVector.fromArray(FLOATS, p, at + 4 * WIDTH);
    FloatVector bz = FloatVector.fromArray(FLOATS, p, at + 5 * WIDTH);
    FloatVector cx = FloatVector.fromArray(FLOATS, p, at + 6 * WIDTH);
    FloatVector cy = FloatVector.fromArray(FLOATS, p, at + 7 * WIDTH);
    FloatVector cz = FloatVector.fromArray(FLOATS, p, at + 8 * WIDTH);
    FloatVector spread = FloatVector.fromArray(FLOATS, p, at + 9 * WIDTH);
    FloatVector nx = by.mul(cz).sub(bz.mul(cy));
    FloatVector ny = bz.mul(cx).sub(bx.mul(cz));
    FloatVector nz = bx.mul(cy).sub(by.mul(cx));
    // The edge functions, and t times the determinant, with the sign that makes the determinant
    // positive.
    FloatVector rx = ay.mul(dz).sub(az.mul(dy));
    FloatVector ry = az.mul(dx).sub(ax.mul(dz));
    FloatVector rz = ax.mul(dy).sub(ay.mul(dx));
    IntVector signed = nz.fma(dz, ny.fma(dy, nx.mul(dx))).reinterpretAsInts();
    IntVector unsigned = signed.and(Integer.MAX_VALUE);
    IntVector sign = signed.sub(unsigned);
    FloatVector determinant = unsigned.reinterpretAsFloats();
    FloatVector v =
        rz.fma(cz, ry.fma(cy, rx.mul(cx)))
            .reinterpretAsInts()
            .lanewise(VectorOperators.XOR, sign)
            .reinterpretAsFloats();
    FloatVector minusW =
        rz.fma(bz, ry.fma(by, rx.mul(bx)))
            .reinterpretAsInts()
            .lanewise(VectorOperators.XOR, sign)
            .reinterpretAsFloats();
    FloatVector depth =
        az.fma(nz, ay.fma(ny, ax.mul(nx)))
            .reinterpretAsInts()
            .lanewise(VectorOperators.XOR, sign)
            .reinterpretAsFloats();
    // Within the error bounds, no edge function is negative and the depth is at most the depth of
    // the ray's end.
    FloatVector room = spread.mul(ray.edgeError).add(ray.edgeFloor);
    FloatVector depthRoom = spread.mul(spread).mul(ray.depthError).add(ray.depthFloor);
    FloatVector end = FloatVector.broadcast(FLOATS, ray.end);
    IntVector outside =
        v.add(room)
            .reinterpretAsInts()
            .or(room.sub(minusW).reinterpretAsInts())
            .or(determinant.sub(v).add(minusW).add(room.add(room)).reinterpretAsInts())
            .or(depth.add(depthRoom).reinterpretAsInts())
            .or(determinant.fma(end, depthRoom).sub(depth).reinterpretAsInts());
    long hits =
        MASKS
            ? outside.compare(VectorOperators.GE, 0).toLong()
            : HITS
                ^ ((ByteVector)
                        outside
                            .lanewise(VectorOperators.LSHR, 31)
                            .convertShape(VectorOperators.I2B, BYTES, 0))
                    .reinterpretAsLongs()
                    .lane(0);
    long lanes = -1L >>> Long.SIZE - (count << LANE_SHIFT);
    return hits & lanes << ((first & WIDTH - 1) << LANE_SHIFT);
  }
}
