package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TriangleList;
import java.util.BitSet;
import java.util.stream.IntStream;

/** Makes triangle lists of the other triangle modes (glTF 2.0, section 3.7.2.1). */
final class GltfTriangles {
  /** The mode of triangle lists. */
  static final int LIST = 4;

  private static final int STRIP = 5;

  private GltfTriangles() {}

  /** Returns the number of triangles that a number of corners forms. */
  static int count(int mode, int corners) {
    return mode == LIST ? corners / 3 : Math.max(0, corners - 2);
  }

  /** Returns the corners of a list, strip or fan as a list; whole lists are not copied. */
  static int[] list(int mode, int[] corners) {
    int count = count(mode, corners.length);
    if (mode == LIST && corners.length == 3 * count) {
      return corners;
    }
    int[] list = new int[3 * count];
    if (mode == LIST) {
      System.arraycopy(corners, 0, list, 0, list.length);
      return list;
    }
    for (int i = 0, to = 0; i < count; i++) {
      if (mode == STRIP) {
        list[to++] = corners[i];
        list[to++] = corners[i + 1 + i % 2];
        list[to++] = corners[i + 2 - i % 2];
      } else {
        list[to++] = corners[i + 1];
        list[to++] = corners[i + 2];
        list[to++] = corners[0];
      }
    }
    return list;
  }

  /** Returns the triangles of a list without broken vertices; warns if there are others. */
  static int[] whole(GltfDocument document, GltfJson primitive, BitSet broken, int... list)
      throws ModelFormatException {
    if (broken.isEmpty() || IntStream.of(list).noneMatch(broken::get)) {
      return list;
    }
    document.budget().allocate(primitive.location(), (long) Integer.BYTES * list.length);
    TriangleList kept = new TriangleList(list.length / 3);
    for (int i = 0; i < list.length; i += 3) {
      if (!broken.get(list[i]) && !broken.get(list[i + 1]) && !broken.get(list[i + 2])) {
        kept.add(list[i], list[i + 1], list[i + 2]);
      }
    }
    int lost = list.length / 3 - kept.count();
    document.warnings().add(Tally.BROKEN, primitive.location(), Tally.BROKEN + ": " + lost);
    return kept.toArray();
  }

  /** Returns triangles with the opposite winding. */
  static int[] reversed(int... list) {
    int[] reversed = list.clone();
    for (int i = 0; i < list.length; i += 3) {
      reversed[i + 1] = list[i + 2];
      reversed[i + 2] = list[i + 1];
    }
    return reversed;
  }
}
