package io.github.lumbre.model.format;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/**
 * The bytes of one part of an archive, inflated block by block. Never more than the stated size is
 * inflated; at the end, size and checksum are compared. Mutable.
 */
public final class ZipInput implements XmlSource, AutoCloseable {
  private final String part;
  private final Inflater inflater = new Inflater(true);
  private final boolean isDeflated;
  private final ByteBuffer compressed;
  private final long size;
  private final long crc;
  private final CRC32 found = new CRC32();
  private long left;

  /**
   * @param part name of the part, for messages
   * @param size after inflating
   * @param crc the stated CRC-32 of the inflated bytes
   */
  public ZipInput(String part, boolean isDeflated, ByteBuffer compressed, long size, long crc) {
    this.part = part;
    this.isDeflated = isDeflated;
    this.compressed = compressed;
    this.size = size;
    this.crc = crc;
    left = size;
    inflater.setInput(compressed);
  }

  @Override
  public String part() {
    return part;
  }

  /** Returns the stated size in bytes. */
  public long size() {
    return size;
  }

  @Override
  public int read(byte[] target, int from) throws ModelFormatException {
    Interrupts.check();
    int count = (int) Math.min(left, target.length - from);
    if (count > 0) {
      count = isDeflated ? inflated(target, from, count) : stored(target, from, count);
      found.update(target, from, count);
      left -= count;
      if (left == 0) {
        checkEnd();
      }
    }
    return count;
  }

  private int stored(byte[] target, int from, int count) {
    compressed.get(target, from, count);
    return count;
  }

  private int inflated(byte[] target, int from, int count) throws ModelFormatException {
    try {
      int inflated = inflater.inflate(target, from, count);
      if (inflated == 0) {
        throw damaged("expected " + size + " bytes, found " + (size - left));
      }
      return inflated;
    } catch (DataFormatException e) {
      throw damaged("expected deflated bytes, found damaged ones");
    }
  }

  private void checkEnd() throws ModelFormatException {
    if (found.getValue() != crc) {
      throw damaged("expected the checksum %08x, found %08x".formatted(crc, found.getValue()));
    }
  }

  private ModelFormatException damaged(String message) {
    return Kind.MALFORMED.at(part, message);
  }

  @Override
  public void close() {
    inflater.end();
  }
}
