package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;

/**
 * The sequences of a block (RFC 8878, sections 3.1.1.3.2 and 3.1.1.5). Mutable: blocks may reuse
 * tables and offsets.
 */
final class Sequences {
  private static final int LONG_COUNT = 0x7f00;

  private final SequenceNumber literalLengths = SequenceNumber.literalLengths();
  private final SequenceNumber offsets = SequenceNumber.offsets();
  private final SequenceNumber matchLengths = SequenceNumber.matchLengths();

  /** The last three offsets, which sequences can name by number. */
  private final long[] recent = {1, 4, 8};

  /** Executes the sequences of a block. */
  void decode(ZstdInput in, Literals literals, ZstdOutput out) throws ImageFormatException {
    int count = count(in);
    if (count == 0) {
      if (in.remaining() > 0) {
        throw in.malformed("expected the end of a block, found " + in.remaining() + " bytes");
      }
      return;
    }
    int modes = in.unsignedByte();
    literalLengths.readTable(in, modes >> 6);
    offsets.readTable(in, modes >> 4 & 3);
    matchLengths.readTable(in, modes >> 2 & 3);
    BackwardBits source = new BackwardBits(in);
    literalLengths.start(source);
    offsets.start(source);
    matchLengths.start(source);
    execute(in, source, literals, out);
    for (int i = 1; i < count; i++) {
      literalLengths.advance(source);
      matchLengths.advance(source);
      offsets.advance(source);
      execute(in, source, literals, out);
    }
    source.requireEnd();
  }

  private void execute(ZstdInput in, BackwardBits source, Literals literals, ZstdOutput out)
      throws ImageFormatException {
    long offset = offsets.value(source);
    long match = matchLengths.value(source);
    long literal = literalLengths.value(source);
    literals.copy(in, out, (int) literal);
    out.repeat(distance(offset, literal == 0), (int) match);
  }

  private static int count(ZstdInput in) throws ImageFormatException {
    int first = in.unsignedByte();
    if (first == 0xff) {
      return (int) in.number(Short.BYTES) + LONG_COUNT;
    }
    return first < 0x80 ? first : (first - 0x80 << Byte.SIZE) + in.unsignedByte();
  }

  /** Returns the distance of an offset value; updates the recent ones. */
  private long distance(long value, boolean isWithoutLiterals) {
    int shift = isWithoutLiterals ? 1 : 0;
    long distance = value - recent.length;
    int replaced = 2;
    if (value <= recent.length) {
      int index = (int) value - 1 + shift;
      distance = index < recent.length ? recent[index] : recent[0] - 1;
      replaced = Math.min(index, 2);
    }
    System.arraycopy(recent, 0, recent, 1, replaced);
    recent[0] = distance;
    return distance;
  }
}
