package io.github.lumbre.model.format.obj;

import io.github.lumbre.model.internal.Corners;
import io.github.lumbre.model.internal.TriangleList;

/** The triangles of one part of an OBJ file. Mutable. */
final class ObjSurface {
  private final Corners corners = new Corners();
  private final TriangleList triangles;

  /**
   * @param expected the expected number of triangles
   */
  ObjSurface(int expected) {
    triangles = new TriangleList(expected);
  }

  Corners corners() {
    return corners;
  }

  TriangleList triangles() {
    return triangles;
  }
}
