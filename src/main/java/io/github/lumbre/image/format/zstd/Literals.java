package io.github.lumbre.image.format.zstd;

import io.github.lumbre.image.ImageFormatException;
import java.util.Arrays;
import java.util.Optional;

/** The literals of a block (RFC 8878, section 3.1.1.3.1). Mutable: blocks may reuse a code. */
final class Literals {
  private static final int RAW = 0;
  private static final int RUN = 1;
  private static final int COMPRESSED = 2;
  private static final int STREAMS = 4;

  private final byte[] bytes = new byte[Zstandard.MAX_BLOCK];
  private int size;
  private int at;
  private Optional<LiteralCode> code = Optional.empty();

  void read(ZstdInput in) throws ImageFormatException {
    int first = in.unsignedByte();
    int type = first & 3;
    int format = first >> 2 & 3;
    at = 0;
    if (type == RAW || type == RUN) {
      int more = format == 1 ? 1 : format == 3 ? 2 : 0;
      setSize(in, (first | in.number(more) << Byte.SIZE) >> (more == 0 ? 3 : 4));
      if (type == RAW) {
        System.arraycopy(in.bytes(), in.skip(size), bytes, 0, size);
      } else {
        Arrays.fill(bytes, 0, size, (byte) in.unsignedByte());
      }
      return;
    }
    int width = format < 2 ? 10 : format == 2 ? 14 : 18;
    long header = (first | in.number(width / 4) << Byte.SIZE) >> 4;
    setSize(in, header & (1 << width) - 1);
    ZstdInput part = in.part(header >> width);
    if (type == COMPRESSED) {
      code = Optional.of(LiteralCode.read(part));
    }
    if (code.isEmpty()) {
      throw in.malformed("expected a Huffman code, found none");
    }
    decode(code.get(), part, format == 0 ? 1 : STREAMS);
  }

  private void setSize(ZstdInput in, long found) throws ImageFormatException {
    if (found > bytes.length) {
      throw in.malformed("expected at most " + bytes.length + " literals, found " + found);
    }
    size = (int) found;
  }

  private void decode(LiteralCode by, ZstdInput in, int streams) throws ImageFormatException {
    int[] lengths = new int[streams - 1];
    for (int i = 0; i < lengths.length; i++) {
      lengths[i] = (int) in.number(Short.BYTES);
    }
    int share = (size + streams - 1) / streams;
    for (int i = 0; i < lengths.length; i++) {
      by.decode(
          in.part(lengths[i]), bytes, Math.min(i * share, size), Math.min((i + 1) * share, size));
    }
    by.decode(in, bytes, Math.min(lengths.length * share, size), size);
  }

  /** Writes the next literals. */
  void copy(ZstdInput in, ZstdOutput out, int count) throws ImageFormatException {
    if (count > size - at) {
      throw in.malformed("expected at most " + (size - at) + " more literals, found " + count);
    }
    out.copy(bytes, at, count);
    at += count;
  }

  /** Writes the literals that are left. */
  void copyRest(ZstdOutput out) throws ImageFormatException {
    out.copy(bytes, at, size - at);
  }
}
