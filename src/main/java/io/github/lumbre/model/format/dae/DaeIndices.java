package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.internal.ModelLimits;
import java.util.Arrays;
import java.util.BitSet;

/**
 * The indices of a list of triangles, strips, fans or polygons: loops of corners, each of several
 * indices, and the numbers of corners of polygons. What is no index is -1. Mutable.
 */
final class DaeIndices {
  private final FormatFile file;
  private int[] values = new int[16];
  private int size;

  /** The end of each loop in the values. */
  private int[] ends = new int[4];

  private int loops;
  private final BitSet holes = new BitSet();
  private int[] counts = new int[0];
  private int polygons;

  DaeIndices(FormatFile file) {
    this.file = file;
  }

  /**
   * Reads the indices of the current element as a loop.
   *
   * @param isHole whether it is a hole of the last loop that is none
   */
  void readLoop(XmlReader xml, boolean isHole) throws ModelFormatException {
    while (xml.nextWord()) {
      if (size == values.length) {
        values = grown(values, xml.location());
      }
      values[size++] = xml.wordIndex();
    }
    if (loops == ends.length) {
      ends = grown(ends, xml.location());
    }
    holes.set(loops, isHole);
    ends[loops++] = size;
  }

  /** Reads the numbers of corners of polygons. */
  void readCounts(XmlReader xml) throws ModelFormatException {
    while (xml.nextWord()) {
      if (polygons == counts.length) {
        counts = grown(counts, xml.location());
      }
      counts[polygons++] = xml.wordIndex();
    }
  }

  private int[] grown(int[] list, String location) throws ModelFormatException {
    ModelLimits.require(location, "indices", ModelLimits.MAX_COUNT, list.length);
    file.take(location, (long) Integer.BYTES * list.length);
    int length = (int) Math.min(Math.max(16, 2L * list.length), 3L * ModelLimits.MAX_COUNT);
    return Arrays.copyOf(list, length);
  }

  /** Returns an index; -1 if it is none. */
  int value(int at) {
    return values[at];
  }

  int size() {
    return size;
  }

  int loops() {
    return loops;
  }

  /** Returns where a loop begins in the values. */
  int start(int loop) {
    return loop == 0 ? 0 : ends[loop - 1];
  }

  int end(int loop) {
    return ends[loop];
  }

  boolean isHole(int loop) {
    return holes.get(loop);
  }

  /** Returns the number of polygons whose numbers of corners are stated. */
  int polygons() {
    return polygons;
  }

  /** Returns the number of corners of a polygon; -1 if it is none. */
  int corners(int polygon) {
    return counts[polygon];
  }
}
