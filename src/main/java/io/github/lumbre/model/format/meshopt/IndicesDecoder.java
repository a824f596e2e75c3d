package io.github.lumbre.model.format.meshopt;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import java.nio.ByteBuffer;

/** Decodes unsigned integers, each from its difference to one of two before it. Stateless. */
final class IndicesDecoder {
  private static final int HEADER = 0xd1;
  private static final int TAIL = 4;

  private IndicesDecoder() {}

  /** Fills a buffer with integers of 2 or 4 bytes. */
  static void decode(MeshoptInput input, ByteBuffer target, int stride)
      throws ModelFormatException {
    input.requireHeader(HEADER);
    input.reserveTail(TAIL);
    int[] last = new int[2];
    for (int i = 0; target.hasRemaining(); i++) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      int code = input.varint();
      int baseline = code & 1;
      last[baseline] += MeshoptInput.signed(code >>> 1);
      put(target, stride, last[baseline]);
    }
    input.requireEnd();
  }

  /** Appends the lowest 2 or 4 bytes of an integer. */
  static void put(ByteBuffer target, int stride, int index) {
    if (stride == Short.BYTES) {
      target.putShort((short) index);
    } else {
      target.putInt(index);
    }
  }
}
