package io.github.lumbre.model.format.dae;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;

/**
 * The values of several sources in one array. The only source is not copied. Mutable.
 */
final class DaePool {
  private final int size;
  private final Map<double[], Integer> starts = new IdentityHashMap<>();
  private double[] values = {};
  private int used;

  /** Whether the array is no source, and may be changed. */
  private boolean isOwn;

  /**
   * @param size the number of values of an element
   */
  DaePool(int size) {
    this.size = size;
  }

  /** Returns the number of the first element of a source, which is added if it is new. */
  int start(double... source) {
    Integer known = starts.get(source);
    if (known != null) {
      return known;
    }
    int start = used / size;
    starts.put(source, start);
    if (used == 0) {
      values = source;
      used = source.length;
      isOwn = false;
    } else {
      append(source);
    }
    return start;
  }

  /** Adds an element, and returns its number. */
  int add(double... element) {
    append(element);
    return used / size - 1;
  }

  private void append(double... more) {
    if (!isOwn || used + more.length > values.length) {
      values = Arrays.copyOf(values, Math.addExact(Math.max(16, 2 * used), more.length));
      isOwn = true;
    }
    System.arraycopy(more, 0, values, used, more.length);
    used += more.length;
  }

  /** Returns the values of all elements, perhaps with others behind them. */
  double[] values() {
    return values;
  }
}
