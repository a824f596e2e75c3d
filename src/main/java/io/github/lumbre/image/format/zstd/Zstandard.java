package io.github.lumbre.image.format.zstd;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;

/**
 * Decodes a Zstandard frame of known size (RFC 8878, section 3). A checksum is skipped, and a
 * dictionary is refused.
 */
public final class Zstandard {
  private static final int MAGIC = 0xfd2fb528;

  private static final int CHECKSUM = 1 << 2;
  private static final int RESERVED = 1 << 3;
  private static final int SINGLE_SEGMENT = 1 << 5;
  private static final int CHECKSUM_BYTES = 4;
  private static final int[] DICTIONARY_BYTES = {0, 1, 2, 4};
  private static final int[] SIZE_BYTES = {0, 2, 4, 8};

  private static final int RAW = 0;
  private static final int RUN = 1;
  private static final int COMPRESSED = 2;

  /** The largest number of bytes of a block, compressed or not. */
  static final int MAX_BLOCK = 1 << 17;

  private final ZstdInput in;
  private final ZstdOutput out;
  private final Literals literals = new Literals();
  private final Sequences sequences = new Sequences();

  private Zstandard(ZstdInput in, ZstdOutput out) {
    this.in = in;
    this.out = out;
  }

  /**
   * Decodes a frame. Allocates the result, and less than 300 KB besides.
   *
   * @param from index of the first byte of the frame
   * @param end index after its last byte
   * @param size of the decoded bytes; the caller checks that it is within the limits
   * @throws ImageFormatException if the frame is damaged or has another size
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static byte[] decode(byte[] file, int from, int end, int size)
      throws ImageFormatException {
    ZstdInput in = new ZstdInput(file, from, end);
    ZstdOutput out = new ZstdOutput(in, size);
    new Zstandard(in, out).readFrame();
    if (in.remaining() > 0) {
      throw in.malformed("expected one frame, found " + in.remaining() + " more bytes");
    }
    return out.complete();
  }

  private void readFrame() throws ImageFormatException {
    int magic = (int) in.number(Integer.BYTES);
    if (magic != MAGIC) {
      throw in.malformed("expected a frame, found %08x".formatted(magic));
    }
    boolean hasChecksum = readHeader();
    boolean isLast;
    do {
      Interrupts.check();
      int header = (int) in.number(3);
      isLast = (header & 1) != 0;
      readBlock(header >> 1 & 3, header >> 3);
    } while (!isLast);
    in.skip(hasChecksum ? CHECKSUM_BYTES : 0);
  }

  /** Skips the header of a frame; returns whether a checksum follows the blocks. */
  private boolean readHeader() throws ImageFormatException {
    int descriptor = in.unsignedByte();
    boolean isSingle = (descriptor & SINGLE_SEGMENT) != 0;
    if ((descriptor & RESERVED) != 0) {
      throw in.malformed("expected a reserved bit of 0, found 1");
    }
    in.skip(isSingle ? 0 : 1);
    long dictionary = in.number(DICTIONARY_BYTES[descriptor & 3]);
    if (dictionary != 0) {
      throw in.malformed("expected no dictionary, found number " + dictionary);
    }
    int sizeBytes = SIZE_BYTES[descriptor >> 6];
    in.skip(sizeBytes == 0 && isSingle ? 1 : sizeBytes);
    return (descriptor & CHECKSUM) != 0;
  }

  private void readBlock(int type, int size) throws ImageFormatException {
    if (size > MAX_BLOCK) {
      throw in.malformed("expected a block of at most " + MAX_BLOCK + " bytes, found " + size);
    }
    switch (type) {
      case RAW -> out.copy(in.bytes(), in.skip(size), size);
      case RUN -> out.fill((byte) in.unsignedByte(), size);
      case COMPRESSED -> readCompressed(in.part(size));
      default -> throw in.malformed("expected a block of type 0, 1 or 2, found 3");
    }
  }

  private void readCompressed(ZstdInput block) throws ImageFormatException {
    literals.read(block);
    sequences.decode(block, literals, out);
    literals.copyRest(out);
  }
}
