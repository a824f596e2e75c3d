package io.github.lumbre.model.format.meshopt;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import java.nio.ByteBuffer;

/**
 * Decodes the corners of triangles: one code per triangle tells from which recent edge and corners
 * it is made. Mutable.
 */
final class TrianglesDecoder {
  private static final int HEADER = 0xe1;
  private static final int TABLE = 16;
  private static final int CORNERS = 3;

  /** The high four bits of the codes of triangles without a recent edge. */
  private static final int NO_EDGE = 0xf;

  /** In place of the age of a corner: the corner is the next unused index. */
  private static final int NEXT = 0;

  /** In place of the age of a corner: the corner is the last explicit index, minus or plus 1. */
  private static final int BEFORE_LAST = 0xd;

  private static final int AFTER_LAST = 0xe;

  /** In place of the age of a corner: the difference to the last explicit index follows. */
  private static final int EXPLICIT = 0xf;

  private final MeshoptInput input;
  private final RecentIndices edges = new RecentIndices();
  private final RecentIndices corners = new RecentIndices();
  private int next;
  private int last;

  TrianglesDecoder(MeshoptInput input) {
    this.input = input;
  }

  /** Fills a buffer with corners of 2 or 4 bytes. */
  void decode(ByteBuffer target, int stride) throws ModelFormatException {
    input.requireHeader(HEADER);
    int table = input.reserveTail(TABLE);
    int triangles = target.limit() / stride / CORNERS;
    int codes = input.skip(triangles);
    for (int i = 0; i < triangles; i++) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      int code = input.unsignedByte(codes + i);
      int low = code & 0xf;
      if (code >> 4 < NO_EDGE) {
        decodeAtEdge(target, stride, code >> 4, low);
      } else if (low < AFTER_LAST) {
        decodeCorners(target, stride, NEXT, input.unsignedByte(table + low));
      } else {
        int rest = input.unsignedByte();
        next = rest == 0 ? 0 : next;
        decodeCorners(target, stride, low == EXPLICIT ? EXPLICIT : NEXT, rest);
      }
    }
    input.requireEnd();
  }

  private void decodeAtEdge(ByteBuffer target, int stride, int age, int third)
      throws ModelFormatException {
    long edge = edges.get(age, input);
    int a = (int) (edge >>> Integer.SIZE);
    int b = (int) edge;
    int c =
        switch (third) {
          case BEFORE_LAST -> --last;
          case AFTER_LAST -> ++last;
          case NEXT, EXPLICIT -> corner(third);
          default -> (int) corners.get(third, input);
        };
    if (third == NEXT || third >= BEFORE_LAST) {
      corners.add(c);
    }
    addEdge(c, b);
    addEdge(a, c);
    put(target, stride, a, b, c);
  }

  /**
   * Decodes a triangle whose edges are all new.
   *
   * @param first tells the first corner
   * @param rest tells the other corners: in its high four bits the second, in the low ones the
   *     third
   */
  private void decodeCorners(ByteBuffer target, int stride, int first, int rest)
      throws ModelFormatException {
    int second = rest >> 4;
    int third = rest & 0xf;
    int a = corner(first);
    int b = corner(second);
    int c = corner(third);
    addEdge(b, a);
    addEdge(c, b);
    addEdge(a, c);
    corners.add(a);
    if (isNew(second)) {
      corners.add(b);
    }
    if (isNew(third)) {
      corners.add(c);
    }
    put(target, stride, a, b, c);
  }

  private int corner(int code) throws ModelFormatException {
    return switch (code) {
      case NEXT -> next++;
      case EXPLICIT -> last += MeshoptInput.signed(input.varint());
      default -> (int) corners.get(code - 1, input);
    };
  }

  private static boolean isNew(int code) {
    return code == NEXT || code == EXPLICIT;
  }

  private void addEdge(int from, int to) {
    edges.add((long) from << Integer.SIZE | Integer.toUnsignedLong(to));
  }

  private static void put(ByteBuffer target, int stride, int a, int b, int c) {
    IndicesDecoder.put(target, stride, a);
    IndicesDecoder.put(target, stride, b);
    IndicesDecoder.put(target, stride, c);
  }

  /** The last 16 values of a kind. Mutable. */
  private static final class RecentIndices {
    private static final int CAPACITY = 16;

    private final long[] values = new long[CAPACITY];
    private int added;

    void add(long value) {
      values[added++ % CAPACITY] = value;
    }

    /**
     * Returns a value.
     *
     * @param age in [0, 16): 0 is the last value
     * @param input for messages
     */
    long get(int age, MeshoptInput input) throws ModelFormatException {
      if (age >= added) {
        throw input.malformed("expected one of " + added + " recent values, found " + age);
      }
      return values[(added - 1 - age) % CAPACITY];
    }
  }
}
