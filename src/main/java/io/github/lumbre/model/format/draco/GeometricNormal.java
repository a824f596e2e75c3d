package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;
import static io.github.lumbre.model.format.draco.CornerTable.next;
import static io.github.lumbre.model.format.draco.CornerTable.previous;

import io.github.lumbre.model.ModelFormatException;

/** Predicts the sum of the normals of the faces around a vertex, weighted by area. */
final class GeometricNormal implements Prediction {
  /** The largest sum of the components of a normal, so that they fit into 32 bits. */
  private static final long MAX_SUM = 1 << 29;

  private final Entries entries;
  private final CornerTable table;
  private final Positions positions;
  private final OctahedralCorrection correction;
  private final RansBitDecoder flips;
  private final int[] normal = new int[3];
  private final int[] predicted = new int[2];

  private long x;
  private long y;
  private long z;

  private GeometricNormal(
      Entries entries,
      CornerTable table,
      Positions positions,
      OctahedralCorrection correction,
      RansBitDecoder flips) {
    this.entries = entries;
    this.table = table;
    this.positions = positions;
    this.correction = correction;
    this.flips = flips;
  }

  /** Reads which predictions point to the wrong side. */
  static GeometricNormal read(
      DracoInput input, Entries entries, CornerTable table, Positions positions)
      throws ModelFormatException {
    OctahedralCorrection correction = OctahedralCorrection.read(input);
    return new GeometricNormal(entries, table, positions, correction, RansBitDecoder.read(input));
  }

  @Override
  public void restore(int[] values) {
    for (int entry = 0; entry < entries.count(); entry++) {
      predict(entries.corner(entry));
      correction.octahedron().project(normal);
      if (flips.next()) {
        normal[0] = -normal[0];
        normal[1] = -normal[1];
        normal[2] = -normal[2];
      }
      correction.octahedron().unfold(normal, predicted);
      correction.apply(predicted, 0, values, 2 * entry);
    }
  }

  private void predict(int start) {
    x = 0;
    y = 0;
    z = 0;
    int center = positions.index(start);
    int corner = start;
    do {
      addFace(center, corner);
      corner = table.swingLeft(corner);
    } while (corner != NONE && corner != start);
    if (corner == NONE) {
      for (corner = table.swingRight(start); corner != NONE; corner = table.swingRight(corner)) {
        addFace(center, corner);
      }
    }
    long sum = sum(Math.abs(x), sum(Math.abs(y), Math.abs(z)));
    long divisor = sum > MAX_SUM ? sum / MAX_SUM : 1;
    normal[0] = (int) (x / divisor);
    normal[1] = (int) (y / divisor);
    normal[2] = (int) (z / divisor);
  }

  /** Adds the cross product of the edges of a face at a corner. */
  private void addFace(int center, int corner) {
    int[] p = positions.entries();
    int next = positions.index(next(corner));
    int previous = positions.index(previous(corner));
    long ax = (long) p[next] - p[center];
    long ay = (long) p[next + 1] - p[center + 1];
    long az = (long) p[next + 2] - p[center + 2];
    long bx = (long) p[previous] - p[center];
    long by = (long) p[previous + 1] - p[center + 1];
    long bz = (long) p[previous + 2] - p[center + 2];
    x += ay * bz - az * by;
    y += az * bx - ax * bz;
    z += ax * by - ay * bx;
  }

  private static long sum(long a, long b) {
    return a > Long.MAX_VALUE - b ? Long.MAX_VALUE : a + b;
  }
}
