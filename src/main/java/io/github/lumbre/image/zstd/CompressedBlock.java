package io.github.lumbre.image.zstd;

import io.github.lumbre.image.ImageFormatException;

/** Decodes the compressed blocks of a frame, which may share codes. Mutable. */
final class CompressedBlock {
  private final Literals literals = new Literals();
  private final Sequences sequences = new Sequences();
  private final ZstdOutput out;

  CompressedBlock(ZstdOutput out) {
    this.out = out;
  }

  /** Decodes a block. */
  void decode(ZstdInput in) throws ImageFormatException {
    literals.read(in);
    sequences.decode(in, literals, out);
    literals.copyRest(out);
  }
}
