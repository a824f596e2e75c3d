package io.github.lumbre.stage.thumbnail;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Models for the tests of thumbnails. */
final class ThumbnailModels {
  private ThumbnailModels() {}

  /** Returns an STL file of at least so many triangles: a hill over a square. */
  static byte[] stl(int triangles) {
    int side = (int) Math.ceil(Math.sqrt(triangles / 2.));
    int count = 2 * side * side;
    ByteBuffer stl = ByteBuffer.allocate(84 + 50 * count).order(ByteOrder.LITTLE_ENDIAN);
    stl.putInt(80, count);
    for (int i = 0; i < count; i++) {
      stl.position(84 + 50 * i + 12);
      int upper = i % 2;
      int x = i / 2 % side;
      int y = i / 2 / side;
      putCorner(stl, (x + upper) / (double) side, (y + upper) / (double) side);
      putCorner(stl, (x + 1 - upper) / (double) side, (y + upper) / (double) side);
      putCorner(stl, (x + upper) / (double) side, (y + 1 - upper) / (double) side);
    }
    return stl.array();
  }

  private static void putCorner(ByteBuffer stl, double x, double y) {
    double height = x * (1 - x) * y * (1 - y) * 8;
    stl.putFloat((float) x).putFloat((float) height).putFloat((float) y);
  }
}
