package io.github.lumbre.model.format.meshopt;

import io.github.lumbre.model.ModelFormatException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** How the bytes of a stream were compressed. */
public enum MeshoptMode {
  /** Elements of any meaning. */
  ATTRIBUTES,
  /** Corners of triangles, three unsigned integers each. */
  TRIANGLES,
  /** Unsigned integers. */
  INDICES;

  /** The smallest number of bytes that an element can have. */
  public static final int MIN_STRIDE = 2;

  /** The largest number of bytes that an element can have. */
  public static final int MAX_STRIDE = 256;

  /** The largest number of bytes of elements that one byte of attributes stands for. */
  private static final int MAX_RATIO = 1024;

  /** Returns whether elements can have a number of bytes. */
  public boolean fits(int stride) {
    return this == ATTRIBUTES
        ? stride % Integer.BYTES == 0 && stride > 0 && stride <= MAX_STRIDE
        : stride == Short.BYTES || stride == Integer.BYTES;
  }

  /**
   * Decodes a stream. The caller counts the memory of the elements.
   *
   * @param count of elements; divisible by 3 for triangles
   * @param stride bytes per element, which {@link #fits}
   * @param location of the stream in the file, for messages
   * @return all elements, little-endian
   * @throws ModelFormatException if the stream is damaged, or has another version of the bitstream
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public ByteBuffer decode(ByteBuffer stream, int count, int stride, String location)
      throws ModelFormatException {
    MeshoptInput input = new MeshoptInput(stream, location);
    input.requireAtLeast(minLength(count, stride));
    int size = Math.multiplyExact(count, stride);
    ByteBuffer target = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    switch (this) {
      case ATTRIBUTES -> AttributesDecoder.decode(input, target, stride);
      case TRIANGLES -> new TrianglesDecoder(input).decode(target, stride);
      case INDICES -> IndicesDecoder.decode(input, target, stride);
    }
    return target.flip();
  }

  /** Returns a lower bound of the length of a stream, so that short streams cost no memory. */
  private long minLength(int count, int stride) {
    return switch (this) {
      case ATTRIBUTES -> (long) count * stride / MAX_RATIO;
      case TRIANGLES -> count / 3;
      case INDICES -> count;
    };
  }
}
