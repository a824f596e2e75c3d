package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;

/** Decodes bits of one probability. Mutable. */
final class RansBitDecoder {
  private static final int BASE = 4096;
  private static final int PRECISION = 256;

  private final RansState state;
  private final int probability;

  private RansBitDecoder(RansState state, int probability) {
    this.state = state;
    this.probability = probability;
  }

  /** Reads the probability of 0 in 256ths, and the bytes of all bits. */
  static RansBitDecoder read(DracoInput input) throws ModelFormatException {
    int probability = PRECISION - input.unsignedByte();
    return new RansBitDecoder(RansState.read(input, BASE), probability);
  }

  /** Returns the next bit; any value after the last. */
  boolean next() {
    state.refill();
    int whole = state.value / PRECISION * probability;
    int rest = state.value % PRECISION;
    boolean bit = rest < probability;
    state.value = bit ? whole + rest : state.value - whole - probability;
    return bit;
  }
}
