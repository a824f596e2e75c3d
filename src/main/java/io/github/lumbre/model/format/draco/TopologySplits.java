package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/**
 * Where the traversal returns to a part of the mesh that is already coded, from another side, as
 * around a handle. Mutable: splits are taken once, the last first.
 */
final class TopologySplits {
  private final DracoInput input;
  private final int[] sources;
  private final int[] targets;
  private final boolean[] isRight;
  private int count;

  private TopologySplits(DracoInput input, int count) throws ModelFormatException {
    this.input = input;
    this.count = count;
    sources = input.integers(count);
    targets = input.integers(count);
    isRight = new boolean[count];
  }

  /**
   * Reads all splits.
   *
   * @param symbols number of symbols of the traversal
   */
  static TopologySplits read(DracoInput input, int symbols) throws ModelFormatException {
    // A split has at least two bytes.
    int max = Math.min(symbols, input.remaining() / 2);
    TopologySplits splits = new TopologySplits(input, input.count("topology splits", max));
    long source = 0;
    for (int i = 0; i < splits.count; i++) {
      source += input.varint();
      if (source >= symbols) {
        throw input.malformed("expected a split of " + symbols + " symbols, found " + source);
      }
      splits.sources[i] = (int) source;
      splits.targets[i] = (int) source - input.count("symbols before a split", source);
    }
    int position = input.position();
    BitReader bits = new BitReader(input.bytes(), position, position + input.remaining());
    for (int i = 0; i < splits.count; i++) {
      splits.isRight[i] = bits.read(1) == 1;
    }
    input.skip((long) bits.position() - position);
    return splits;
  }

  /** Returns whether there is a split at a symbol of the encoder, which {@link #take} removes. */
  boolean isAt(int symbol) throws ModelFormatException {
    if (count > 0 && sources[count - 1] > symbol) {
      throw input.malformed("expected no split at symbol " + sources[count - 1] + ", found one");
    }
    return count > 0 && sources[count - 1] == symbol;
  }

  /** Returns whether the edge of the next split is the right one of its face. */
  boolean isRight() {
    return isRight[count - 1];
  }

  /** Returns the encoder's symbol that this split joins, and goes on to the split before it. */
  int take() {
    return targets[--count];
  }
}
