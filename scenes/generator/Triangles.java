package generator;

/**
 * Takes the triangles of a surface.
 *
 * @param <C> what stands for a corner
 */
interface Triangles<C> {
  /** Returns a corner with a position, texture coordinates and a normal. */
  C corner(Vec p, double u, double v, Vec n);

  /** Adds a triangle of three corners, counterclockwise as seen from outside. */
  void face(C a, C b, C c);
}
