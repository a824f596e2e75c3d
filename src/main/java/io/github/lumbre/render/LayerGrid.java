package io.github.lumbre.render;

import io.github.lumbre.scene.Layer;

/** How a film stores a layer. All sums are exact, so that their order does not matter. */
enum LayerGrid {
  /** Nothing is stored: the layer follows from other sums. */
  NONE(0),
  /** Signed sums of multiples of 2^-32 in [-1,1], in 64 bits. */
  UNIT(Long.BYTES),
  /** As {@link #UNIT}, and the mean of the first half of the samples. */
  GUIDE(Long.BYTES),
  /** Signed sums of multiples of 2^-64 in ±2^31, in 128 bits. */
  WIDE(2 * Long.BYTES),
  /** The number of samples of each primitive. */
  COUNTS(0);

  private final int bytes;

  LayerGrid(int bytes) {
    this.bytes = bytes;
  }

  /** Returns the number of bytes of one sum. */
  int bytes() {
    return bytes;
  }

  /** Returns how a film stores a layer. */
  static LayerGrid of(Layer layer) {
    return switch (layer) {
      case ALBEDO, NORMAL, GEOMETRIC_NORMAL -> UNIT;
      case POSITION, DEPTH, UV, DIRECT, LIGHTS -> WIDE;
      case OBJECT, MATERIAL -> COUNTS;
      case SAMPLES, VARIANCE, INDIRECT -> NONE;
      case DENOISING_ALBEDO, DENOISING_NORMAL, DENOISING_ALPHA -> GUIDE;
    };
  }
}
