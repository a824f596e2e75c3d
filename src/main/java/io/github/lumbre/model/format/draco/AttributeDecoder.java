package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/** Decodes an attribute, step by step in the order of the stream. Mutable. */
final class AttributeDecoder {
  private static final int POSITION = 0;
  private static final int GENERIC = 0;
  private static final int INTEGER = 1;
  private static final int QUANTIZED = 2;
  private static final int NORMAL = 3;

  private final DracoInput input;
  private final int meaning;
  private final DracoType type;
  private final int components;
  private final boolean isNormalized;
  private final long id;
  private int method;
  private int[] entries = {};
  private int rawStart;
  private ValueFormat format = (values, at, target) -> {};

  /** Reads the description of an attribute. */
  AttributeDecoder(DracoInput input) throws ModelFormatException {
    this.input = input;
    meaning = input.unsignedByte();
    int code = input.unsignedByte();
    if (code < 1 || code > DracoType.values().length) {
      throw input.malformed("expected a type of numbers from 1 to 11, found " + code);
    }
    type = DracoType.values()[code - 1];
    components = input.unsignedByte();
    if (components == 0) {
      throw input.malformed("expected at least one number per value, found none");
    }
    isNormalized = input.unsignedByte() != 0;
    id = input.varint();
  }

  /** Reads how the attribute is coded. */
  void readMethod() throws ModelFormatException {
    method = input.unsignedByte();
    boolean isKnown =
        switch (method) {
          case GENERIC -> true;
          case INTEGER -> type.isInteger();
          case QUANTIZED -> type == DracoType.FLOAT32;
          case NORMAL -> type == DracoType.FLOAT32 && components == 3;
          default -> false;
        };
    if (!isKnown) {
      throw input.unsupported(
          "expected a method for %d numbers of %s, found %d".formatted(components, type, method));
    }
  }

  /** Returns whether the values are positions that other attributes are predicted from. */
  boolean isPosition() {
    return meaning == POSITION && method != GENERIC && components == 3;
  }

  /** Returns the decoded entries as integers. */
  int[] entries() {
    return entries;
  }

  /** Reads the values, without what {@link #readFormat} reads. */
  void decodeEntries(Entries order, Optional<Positions> positions) throws ModelFormatException {
    if (method == GENERIC) {
      rawStart = input.skip((long) order.count() * components * type.size());
    } else {
      int stored = method == NORMAL ? 2 : components;
      entries = new IntegerValues(input, stored, method == NORMAL, order, positions).decode();
    }
  }

  /** Reads how integers become values. */
  void readFormat() throws ModelFormatException {
    switch (method) {
      case INTEGER -> format = ValueFormat.integers(type, components);
      case QUANTIZED -> format = ValueFormat.readQuantized(input, components);
      case NORMAL -> format = ValueFormat.readNormals(input);
      default -> {}
    }
  }

  /**
   * Returns the attribute.
   *
   * @param ofPoints the entries of all points
   */
  DracoAttribute attribute(int... ofPoints) throws ModelFormatException {
    int size = components * type.size();
    long bytes = (long) ofPoints.length * size;
    input.allocate(bytes);
    if (bytes > Integer.MAX_VALUE - 8) {
      throw input.malformed("expected at most 2147483639 bytes of values, found " + bytes);
    }
    ByteBuffer values = ByteBuffer.allocate((int) bytes).order(ByteOrder.LITTLE_ENDIAN);
    if (method == GENERIC) {
      for (int entry : ofPoints) {
        values.put(input.bytes(), rawStart + entry * size, size);
      }
    } else {
      int stored = method == NORMAL ? 2 : components;
      for (int entry : ofPoints) {
        format.put(entries, entry * stored, values);
      }
    }
    return new DracoAttribute(id, type, components, isNormalized, values.rewind());
  }
}
