package io.github.lumbre.model.format.draco;

import static io.github.lumbre.model.format.draco.CornerTable.NONE;

import io.github.lumbre.model.ModelFormatException;
import java.util.Arrays;
import java.util.BitSet;

/** Predicts the mean of up to four parallelograms around a vertex, without those at creases. */
final class ConstrainedMultiParallelogram implements Prediction {
  private static final int MAX = 4;

  private final DracoInput input;
  private final Parallelogram single;

  /** Whether each edge is a crease, in one list for each number of parallelograms. */
  private final BitSet[] creases;

  private final int[] creaseCounts;
  private final int[] used = new int[MAX];

  private ConstrainedMultiParallelogram(
      DracoInput input, Parallelogram single, BitSet[] creases, int... creaseCounts) {
    this.input = input;
    this.single = single;
    this.creases = creases;
    this.creaseCounts = creaseCounts;
  }

  static ConstrainedMultiParallelogram read(
      DracoInput input, Entries entries, CornerTable table, int components)
      throws ModelFormatException {
    BitSet[] creases = new BitSet[MAX];
    int[] counts = new int[MAX];
    for (int i = 0; i < MAX; i++) {
      counts[i] = input.count("edges", table.vertices().length);
      input.allocate(counts[i] / Byte.SIZE);
      creases[i] = new BitSet(counts[i]);
      if (counts[i] > 0) {
        RansBitDecoder bits = RansBitDecoder.read(input);
        for (int k = 0; k < counts[i]; k++) {
          creases[i].set(k, bits.next());
        }
      }
    }
    Correction correction = WrappedCorrection.read(input, components);
    Parallelogram single = new Parallelogram(entries, table, components, correction);
    return new ConstrainedMultiParallelogram(input, single, creases, counts);
  }

  @Override
  public void restore(int[] values) throws ModelFormatException {
    int components = single.components();
    int[] predictions = new int[MAX * components];
    int[] mean = new int[components];
    for (int entry = 0; entry < single.entries().count(); entry++) {
      int at = entry * components;
      int found = entry == 0 ? 0 : predict(entry, values, predictions);
      if (mean(found, predictions, mean) || entry == 0) {
        single.correction().apply(mean, 0, values, at);
      } else {
        single.correction().apply(values, at - components, values, at);
      }
    }
  }

  /** Predicts from all faces across edges around a vertex, and returns their number. */
  private int predict(int entry, int[] values, int[] predictions) {
    CornerTable table = single.table();
    int start = single.entries().corner(entry);
    int corner = start;
    int found = 0;
    boolean isLeft = true;
    while (corner != NONE) {
      if (single.predict(entry, corner, values, predictions, found * single.components())
          && ++found == MAX) {
        break;
      }
      corner = isLeft ? table.swingLeft(corner) : table.swingRight(corner);
      if (corner == start) {
        break;
      }
      if (corner == NONE && isLeft) {
        isLeft = false;
        corner = table.swingRight(start);
      }
    }
    return found;
  }

  /** Computes the mean of predictions without creases; returns whether there are any. */
  private boolean mean(int found, int[] predictions, int[] mean) throws ModelFormatException {
    int components = mean.length;
    Arrays.fill(mean, 0);
    int count = 0;
    for (int i = 0; i < found; i++) {
      int context = found - 1;
      if (used[context] == creaseCounts[context]) {
        throw input.malformed(
            "expected more than " + creaseCounts[context] + " edges, found no more");
      }
      if (!creases[context].get(used[context]++)) {
        count++;
        for (int c = 0; c < components; c++) {
          mean[c] += predictions[i * components + c];
        }
      }
    }
    for (int c = 0; c < components && count > 1; c++) {
      mean[c] /= count;
    }
    return count > 0;
  }
}
