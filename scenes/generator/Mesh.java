package generator;

/**
 * Triangles over shared positions; each position belongs to the surface of one body.
 *
 * @param positions the vertices
 * @param triangles three vertices for each triangle
 * @param bodies the body of each vertex
 */
record Mesh(Vec[] positions, int[] triangles, int[] bodies) {

  int triangleCount() {
    return triangles.length / 3;
  }

  Vec corner(int triangle, int corner) {
    return positions[triangles[3 * triangle + corner]];
  }

  int bodyOf(int triangle) {
    return bodies[triangles[3 * triangle]];
  }

  /** e1 x e2: twice the area, along the outward normal. */
  Vec areaVector(int triangle) {
    Vec a = corner(triangle, 0);
    return corner(triangle, 1).minus(a).cross(corner(triangle, 2).minus(a));
  }
}
