package io.github.lumbre.integrator.guiding;

import java.util.Arrays;

/**
 * A learned distribution of directions for each place of a scene. Immutable and shared by all
 * threads.
 *
 * <p>A place is a position and the axis that the surface faces most. For each of the six axes there
 * is a binary tree over positions. Its leaves are <em>cells</em>; a cell has a quadtree over the
 * unit square of {@link Octahedron} directions. All trees are arrays, and lookups are loops.
 */
public final class Guide {
  /** The guide of a scene where nothing was learned: no place has a cell. */
  public static final Guide NONE =
      new Guide(new int[] {-1, -1, -1, -1, -1, -1}, new int[0], new int[0], new float[0]);

  /** What {@link #cell} returns where nothing was learned. */
  public static final int NO_CELL = -1;

  /** Ints of a node of a binary tree: the axis and the bits of the position, and two children. */
  static final int PLACE_STRIDE = 4;

  /**
   * Ints of a node of a quadtree: the bits of three probabilities (of the lower half in u, and of
   * the lower half in v for each half in u), four children, and a fraction in the root.
   */
  static final int SQUARE_STRIDE = 8;

  static final int CHILDREN = 3;
  static final int FRACTION = 7;

  /** Binary digits of a coordinate in the unit square: the largest number of its divisions. */
  static final int DIGITS = 12;

  /** Directions along the three coordinate axes. */
  static final int AXES = 6;

  /** The largest number of ints of all quadtrees: 32 MiB. */
  static final int MOST_INTS = 1 << 23;

  private final int[] roots;
  private final int[] places;
  private final int[] squares;
  private final float[] means;

  /**
   * Creates a guide, which owns the arrays.
   *
   * @param roots of the six binary trees: the index of a node, {@link #leaf} of a cell, or {@link
   *     #NO_CELL}
   * @param means the light that surfaces scatter, by the index of a cell over the stride
   * @param squares the nodes of quadtrees; the index of a cell is that of its root; a child below 0
   *     is a square without further division
   */
  Guide(int[] roots, int[] places, int[] squares, float[] means) {
    this.roots = roots;
    this.places = places;
    this.squares = squares;
    this.means = means;
  }

  /** Returns how a binary tree refers to a cell. */
  static int leaf(int cell) {
    return -2 - cell;
  }

  /** Returns whether nothing was learned anywhere. */
  public boolean isEmpty() {
    return squares.length == 0;
  }

  /** Returns the number of bytes of the trees. */
  public long bytes() {
    return 4L * (places.length + squares.length + means.length);
  }

  /** Returns a hash of all bits of the trees. */
  public int hash() {
    int hash = 31 * Arrays.hashCode(roots) + Arrays.hashCode(places);
    return 31 * (31 * hash + Arrays.hashCode(squares)) + Arrays.hashCode(means);
  }

  /** Returns the axis that a normal points along most: 0 to 5 for ±x, ±y, ±z. */
  static int axis(double nx, double ny, double nz) {
    double ax = Math.abs(nx);
    double ay = Math.abs(ny);
    double az = Math.abs(nz);
    if (ax >= ay && ax >= az) {
      return nx >= 0 ? 0 : 1;
    }
    if (ay >= az) {
      return ny >= 0 ? 2 : 3;
    }
    return nz >= 0 ? 4 : 5;
  }

  /**
   * Returns the cell of a place, or {@link #NO_CELL}.
   *
   * @param nx x coordinate of the unit normal on the side of the viewer
   */
  public int cell(double x, double y, double z, double nx, double ny, double nz) {
    int node = roots[axis(nx, ny, nz)];
    while (node >= 0) {
      int axis = places[node];
      double coordinate = axis == 0 ? x : axis == 1 ? y : z;
      boolean isHigh = coordinate >= Float.intBitsToFloat(places[node + 1]);
      node = places[node + (isHigh ? 3 : 2)];
    }
    return node == NO_CELL ? NO_CELL : leaf(node);
  }

  /** Returns the probability in (0,1) with which a cell's directions should be drawn. */
  public double fraction(int cell) {
    return Float.intBitsToFloat(squares[cell + FRACTION]);
  }

  /**
   * Returns the mean radiance that the surfaces of a cell scatter to a viewer, averaged over the
   * color channels. It may be 0 although they scatter some.
   */
  public double mean(int cell) {
    return means[cell / SQUARE_STRIDE];
  }

  /** Returns the density per solid angle of a unit direction. */
  public double pdf(int cell, double x, double y, double z) {
    // Digits of the coordinates select the squares: which half a direction lies in cannot be
    // predicted, so branches would be slow.
    int u = digits(Octahedron.u(x, y, z));
    int v = digits(Octahedron.v(x, y, z));
    double density = 1;
    int digit = DIGITS;
    int node = cell;
    do {
      digit--;
      int highU = u >> digit & 1;
      int highV = v >> digit & 1;
      double lowU = Float.intBitsToFloat(squares[node]);
      double lowV = Float.intBitsToFloat(squares[node + 1 + highU]);
      double inU = highU + (1 - 2 * highU) * lowU;
      double inV = highV + (1 - 2 * highV) * lowV;
      density *= 4 * inU * inV;
      node = squares[node + CHILDREN + highU + 2 * highV];
    } while (node >= 0);
    return density * Octahedron.stretch(x, y, z);
  }

  /** Returns the first binary digits of a number in [0,1]. */
  private static int digits(double x) {
    return Math.min((1 << DIGITS) - 1, (int) (x * (1 << DIGITS)));
  }

  /**
   * Samples a direction. The point of the unit square is warped as a whole, so that well
   * distributed points give well distributed directions.
   *
   * @param u uniform in [0,1), as is v
   */
  public void sample(int cell, double u, double v, GuideSample result) {
    double density = 1;
    double left = 0;
    double low = 0;
    double size = 1;
    int node = cell;
    do {
      size *= .5;
      double lowU = Float.intBitsToFloat(squares[node]);
      int quarter = 0;
      if (u < lowU) {
        u /= lowU;
        density *= lowU;
      } else {
        u = (u - lowU) / (1 - lowU);
        density *= 1 - lowU;
        left += size;
        quarter = 1;
      }
      double lowV = Float.intBitsToFloat(squares[node + 1 + quarter]);
      if (v < lowV) {
        v /= lowV;
        density *= lowV;
      } else {
        v = (v - lowV) / (1 - lowV);
        density *= 1 - lowV;
        low += size;
        quarter += 2;
      }
      density *= 4;
      node = squares[node + CHILDREN + quarter];
    } while (node >= 0);
    Octahedron.direction(left + size * u, low + size * v, result);
    result.setPdf(density * Octahedron.stretch(result.x(), result.y(), result.z()));
  }
}
