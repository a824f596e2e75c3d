package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.next;
import static io.github.lumbre.model.format.draco.CornerTable.previous;

import io.github.lumbre.model.ModelFormatException;
import java.util.BitSet;

/**
 * Predicts texture coordinates from the other two corners of a face, such that the triangle has the
 * same shape in the texture as in space (M. Isenburg and J. Snoeyink, Compressing Texture
 * Coordinates with Selective Linear Predictions, 2003).
 */
final class TextureCoordinates implements Prediction {
  private final DracoInput input;
  private final Entries entries;
  private final CornerTable table;
  private final Positions positions;
  private final Correction correction;

  /** On which side of the edge the third corner is, in the texture; the last one is used first. */
  private final BitSet sides;

  private int sideCount;
  private final int[] predicted = new int[2];

  private TextureCoordinates(
      DracoInput input,
      Entries entries,
      CornerTable table,
      Positions positions,
      BitSet sides,
      int sideCount)
      throws ModelFormatException {
    this.input = input;
    this.entries = entries;
    this.table = table;
    this.positions = positions;
    this.sides = sides;
    this.sideCount = sideCount;
    correction = WrappedCorrection.read(input, 2);
  }

  static TextureCoordinates read(
      DracoInput input, Entries entries, CornerTable table, Positions positions)
      throws ModelFormatException {
    int count = input.integer();
    if (count < 0 || count > entries.count()) {
      throw input.malformed(
          "expected at most " + entries.count() + " orientations, found " + count);
    }
    RansBitDecoder bits = RansBitDecoder.read(input);
    input.allocate(count / Byte.SIZE);
    BitSet sides = new BitSet(count);
    boolean side = true;
    for (int i = 0; i < count; i++) {
      side = side == bits.next();
      sides.set(i, side);
    }
    return new TextureCoordinates(input, entries, table, positions, sides, count);
  }

  @Override
  public void restore(int[] values) throws ModelFormatException {
    for (int entry = 0; entry < entries.count(); entry++) {
      predict(entry, values);
      correction.apply(predicted, 0, values, 2 * entry);
    }
  }

  private void predict(int entry, int[] values) throws ModelFormatException {
    int corner = entries.corner(entry);
    int next = entries.of(table.vertices()[next(corner)]);
    int previous = entries.of(table.vertices()[previous(corner)]);
    int known = next < entry ? next : entry - 1;
    if (next < entry && previous < entry) {
      boolean isPoint =
          values[2 * next] == values[2 * previous]
              && values[2 * next + 1] == values[2 * previous + 1];
      if (!isPoint && predictTriangle(corner, 2 * next, 2 * previous, values)) {
        return;
      }
    }
    predicted[0] = known < 0 ? 0 : values[2 * known];
    predicted[1] = known < 0 ? 0 : values[2 * known + 1];
  }

  /** Predicts the tip of a triangle; returns false if the edge opposite to it has no length. */
  private boolean predictTriangle(int corner, int next, int previous, int... values)
      throws ModelFormatException {
    int[] p = positions.entries();
    int tip = positions.index(corner);
    int from = positions.index(next(corner));
    int to = positions.index(previous(corner));
    long edgeX = (long) p[to] - p[from];
    long edgeY = (long) p[to + 1] - p[from + 1];
    long edgeZ = (long) p[to + 2] - p[from + 2];
    long edgeSquared = edgeX * edgeX + edgeY * edgeY + edgeZ * edgeZ;
    if (edgeSquared == 0) {
      return false;
    }
    long tipX = (long) p[tip] - p[from];
    long tipY = (long) p[tip + 1] - p[from + 1];
    long tipZ = (long) p[tip + 2] - p[from + 2];
    // The foot of the height is at this fraction of the edge, times its squared length.
    long foot = edgeX * tipX + edgeY * tipY + edgeZ * tipZ;
    long heightX = tipX - foot * edgeX / edgeSquared;
    long heightY = tipY - foot * edgeY / edgeSquared;
    long heightZ = tipZ - foot * edgeZ / edgeSquared;
    long heightSquared = heightX * heightX + heightY * heightY + heightZ * heightZ;
    long height = squareRoot(heightSquared * edgeSquared);
    long side = nextSide() ? height : -height;
    long edgeU = (long) values[previous] - values[next];
    long edgeV = (long) values[previous + 1] - values[next + 1];
    predicted[0] = (int) ((values[next] * edgeSquared + foot * edgeU + edgeV * side) / edgeSquared);
    predicted[1] =
        (int) ((values[next + 1] * edgeSquared + foot * edgeV - edgeU * side) / edgeSquared);
    return true;
  }

  private boolean nextSide() throws ModelFormatException {
    if (sideCount == 0) {
      throw input.malformed("expected another orientation of a triangle, found none");
    }
    return sides.get(--sideCount);
  }

  /** Returns the square root of an unsigned integer, rounded down. */
  private static long squareRoot(long number) {
    if (number == 0) {
      return 0;
    }
    // Newton's method; the division by 2 keeps the number positive.
    long root = (long) Math.sqrt(2. * (number >>> 1)) + 1;
    do {
      root = root + Long.divideUnsigned(number, root) >>> 1;
    } while (Long.compareUnsigned(root * root, number) > 0);
    return root;
  }
}
