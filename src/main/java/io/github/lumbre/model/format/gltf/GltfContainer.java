package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The two parts of a glTF file: JSON, and the binary chunk of a GLB file (glTF 2.0, section 4.4).
 *
 * @param json the text
 * @param binary bytes of the first buffer; empty if the file has none
 * @param warnings of what is wrong and has no effect
 */
record GltfContainer(ByteBuffer json, Optional<ByteBuffer> binary, List<String> warnings) {
  private static final int MAGIC = 0x46546c67;
  private static final int JSON = 0x4e4f534a;
  private static final int BIN = 0x004e4942;
  private static final int HEADER = 12;
  private static final int CHUNK_HEADER = 8;

  /**
   * Returns the parts of a file. Its first bytes decide whether it is a GLB file.
   *
   * @throws ModelFormatException if a GLB header or chunk is damaged
   */
  static GltfContainer of(byte[] content) throws ModelFormatException {
    ByteBuffer bytes = ByteBuffer.wrap(content).order(ByteOrder.LITTLE_ENDIAN);
    return content.length >= 4 && bytes.getInt(0) == MAGIC
        ? ofBinary(bytes)
        : new GltfContainer(bytes, Optional.empty(), List.of());
  }

  /**
   * Returns the JSON of a file; empty if the file is damaged, or its start does not hold all of it.
   *
   * @param size of the file
   */
  static Optional<ByteBuffer> json(byte[] start, long size) {
    ByteBuffer bytes = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
    if (start.length < HEADER + CHUNK_HEADER || bytes.getInt(0) != MAGIC) {
      return start.length == size ? Optional.of(bytes) : Optional.empty();
    }
    long length = Integer.toUnsignedLong(bytes.getInt(HEADER));
    return length <= start.length - HEADER - CHUNK_HEADER
        ? Optional.of(withoutPadding(bytes.slice(HEADER + CHUNK_HEADER, (int) length)))
        : Optional.empty();
  }

  private static GltfContainer ofBinary(ByteBuffer bytes) throws ModelFormatException {
    int size = checkedLength(bytes);
    ByteBuffer json = chunk(bytes, HEADER, size);
    if (bytes.getInt(HEADER + 4) != JSON) {
      throw malformed(HEADER, "expected a JSON chunk, found another one");
    }
    Optional<ByteBuffer> binary = Optional.empty();
    List<String> warnings = new ArrayList<>();
    int at = next(bytes, HEADER, json, warnings);
    while (at < size) {
      if (binary.isPresent() && size - at < CHUNK_HEADER) {
        warnings.add("byte " + at + ": ignored " + (size - at) + " bytes after the last chunk");
        break;
      }
      ByteBuffer chunk = chunk(bytes, at, size);
      if (binary.isEmpty() && bytes.getInt(at + 4) == BIN) {
        binary = Optional.of(chunk);
      }
      at = next(bytes, at, chunk, warnings);
    }
    return new GltfContainer(withoutPadding(json), binary, warnings);
  }

  private static int checkedLength(ByteBuffer bytes) throws ModelFormatException {
    if (bytes.limit() < HEADER + CHUNK_HEADER) {
      throw malformed(0, "expected a GLB header, found the end of the file");
    }
    int version = bytes.getInt(4);
    if (version != 2) {
      throw Kind.UNSUPPORTED.at(
          "byte 4", "expected GLB version 2, found " + Integer.toUnsignedString(version));
    }
    long length = Integer.toUnsignedLong(bytes.getInt(8));
    if (length < HEADER + CHUNK_HEADER || length > bytes.limit()) {
      throw malformed(8, "expected the length of the file, " + bytes.limit() + ", found " + length);
    }
    return (int) length;
  }

  private static ByteBuffer chunk(ByteBuffer bytes, int at, int size) throws ModelFormatException {
    int room = size - at - CHUNK_HEADER;
    if (room < 0) {
      throw malformed(at, "expected a chunk header, found the end of the file");
    }
    long length = Integer.toUnsignedLong(bytes.getInt(at));
    if (length > room) {
      throw malformed(at, "expected a chunk of at most " + room + " bytes, found " + length);
    }
    return bytes.slice(at + CHUNK_HEADER, (int) length).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Returns the offset after a chunk; chunks begin at multiples of 4, if they are padded. */
  private static int next(ByteBuffer bytes, int at, ByteBuffer chunk, List<String> warnings) {
    long end = (long) at + CHUNK_HEADER + chunk.limit();
    long padded = end + 3 & ~3L;
    if (end != padded && isBinary(bytes, end) && !isBinary(bytes, padded)) {
      warnings.add("byte " + at + ": expected a chunk that is padded to 4 bytes, found none");
      return (int) end;
    }
    return (int) Math.min(Integer.MAX_VALUE, padded);
  }

  private static boolean isBinary(ByteBuffer bytes, long at) {
    return at + CHUNK_HEADER <= bytes.limit() && bytes.getInt((int) at + 4) == BIN;
  }

  /** Returns a text without zeros at its end, with which some programs pad it. */
  private static ByteBuffer withoutPadding(ByteBuffer text) {
    int end = text.limit();
    while (end > 0 && text.get(end - 1) == 0) {
      end--;
    }
    return text.slice(0, end);
  }

  private static ModelFormatException malformed(int at, String message) {
    return Kind.MALFORMED.at("byte " + at, message);
  }
}
