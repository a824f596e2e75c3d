package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Reads the numbers of a binary PLY file. Mutable. */
final class PlyBinaryBody implements PlyBody {
  private final ByteBuffer in;
  private String element = "";
  private int item;

  PlyBinaryBody(byte[] file, PlyHeader header) {
    in =
        ByteBuffer.wrap(file)
            .order(
                header.format() == PlyHeader.Format.BIG_ENDIAN
                    ? ByteOrder.BIG_ENDIAN
                    : ByteOrder.LITTLE_ENDIAN)
            .position(header.bodyOffset());
  }

  @Override
  public long remainingBytes() {
    return in.remaining();
  }

  @Override
  public long minBytes(PlyElement of) {
    return of.minBinaryBytes();
  }

  @Override
  public void beginItem(PlyElement of, int number) {
    element = of.name();
    item = number;
  }

  @Override
  public double number(PlyProperty property) throws ModelFormatException {
    requireBytes(property.type().bytes());
    return switch (property.type()) {
      case FLOAT32 -> in.getFloat();
      case FLOAT64 -> in.getDouble();
      default -> next(property.type());
    };
  }

  @Override
  public long integer(PlyProperty property) throws ModelFormatException {
    requireBytes(property.type().bytes());
    return next(property.type());
  }

  private long next(PlyType type) {
    return switch (type) {
      case INT8 -> in.get();
      case UINT8 -> in.get() & 0xff;
      case INT16 -> in.getShort();
      case UINT16 -> in.getShort() & 0xffff;
      case INT32 -> in.getInt();
      case UINT32 -> in.getInt() & 0xffffffffL;
      case FLOAT32, FLOAT64 -> throw new AssertionError(type);
    };
  }

  @Override
  public int listLength(PlyProperty property) throws ModelFormatException {
    PlyType type = property.countType().orElseThrow();
    requireBytes(type.bytes());
    long length = next(type);
    int most = in.remaining() / property.type().bytes();
    if (length < 0 || length > most) {
      throw error(
          "expected a list of 0 to %s items for %s, found one of %s"
              .formatted(most, PrintableText.shortened(property.name()), length));
    }
    return (int) length;
  }

  private void requireBytes(int count) throws ModelFormatException {
    if (in.remaining() < count) {
      throw error("expected more numbers, found the end of the file");
    }
  }

  @Override
  public void endItem() {
    // Items have no separators.
  }

  @Override
  public String location() {
    return element.isEmpty() ? "" : "element " + PrintableText.shortened(element) + " " + item;
  }

  @Override
  public ModelFormatException error(String message) {
    return Kind.MALFORMED.at(location(), message);
  }
}
