package io.github.lumbre.thumbnail;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Models for the tests of thumbnails. */
final class ThumbnailModels {
  private ThumbnailModels() {}

  /** Returns an STL file of triangles on a grid of points of space. */
  static byte[] stl(int triangles) {
    ByteBuffer stl = ByteBuffer.allocate(84 + 50 * triangles).order(ByteOrder.LITTLE_ENDIAN);
    stl.putInt(80, triangles);
    for (int i = 0; i < triangles; i++) {
      for (int k = 0; k < 9; k++) {
        stl.putFloat(84 + 50 * i + 12 + 4 * k, (i * 7 + k * 13) % 101 * .1f);
      }
    }
    return stl.array();
  }
}
