package io.github.lumbre.image.format.jpeg;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;

/**
 * The coefficients of a JPEG picture that its scans hold with all bits (ITU-T T.81, section G.1.1).
 * Mutable.
 */
final class JpegCoverage {
  private static final int PROGRESSIVE = 0xc2;
  private static final int LAST_COEFFICIENT = 63;

  private final boolean isProgressive;

  /** A bit for each coefficient of a component, by the components' numbers. */
  private final Map<Integer, Long> complete = new HashMap<>();

  /**
   * @param frame the segment of the frame from its precision on
   * @param marker of the frame
   */
  JpegCoverage(ByteBuffer frame, int marker) {
    isProgressive = marker == PROGRESSIVE;
    for (int i = 0; i < frame.get(5); i++) {
      complete.put((int) frame.get(6 + 3 * i), 0L);
    }
  }

  /**
   * Adds a scan.
   *
   * @param scan its segment from the number of components on; short ones count as empty
   */
  void add(ByteBuffer scan) {
    int components = scan.hasRemaining() ? scan.get(0) & 0xff : 0;
    if (scan.limit() < 4 + 2 * components) {
      return;
    }
    int from = scan.get(1 + 2 * components);
    int to = scan.get(2 + 2 * components);
    boolean isLast = (scan.get(3 + 2 * components) & 0xf) == 0;
    long held = -1;
    if (isProgressive) {
      boolean isSound = from >= 0 && from <= to && to <= LAST_COEFFICIENT && isLast;
      held = isSound ? -1L >>> LAST_COEFFICIENT - to + from << from : 0;
    }
    for (int i = 0; i < components; i++) {
      long added = held;
      complete.computeIfPresent((int) scan.get(1 + 2 * i), (id, known) -> known | added);
    }
  }

  /** Returns whether no further scan can change the picture. */
  boolean isComplete() {
    return complete.values().stream().allMatch(held -> held == -1);
  }
}
