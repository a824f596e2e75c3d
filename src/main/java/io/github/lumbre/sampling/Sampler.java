package io.github.lumbre.sampling;

import io.github.lumbre.math.Point2;

/**
 * Addressed random numbers in [0,1): a pure function of seed, pixel, sample and dimension, so that
 * neither threads nor the order of work can change a picture. Mutable (it remembers the address)
 * and confined to one thread.
 *
 * <p>The order of dimensions is a contract: those of the camera are constants here, and each vertex
 * of a path owns {@link #VERTEX_STRIDE} dimensions from {@link #vertex} on, used or not.
 */
public interface Sampler {
  /** Two dimensions: where in the pixel. */
  int FILM = 0;

  /** Two dimensions: where on the lens. */
  int LENS = 2;

  /** Three dimensions: which texel of a lens mask, and where in it. */
  int MASK = 4;

  /** Offset within a vertex, one dimension: which light. */
  int LIGHT_CHOICE = 0;

  /** Offset within a vertex, two dimensions: where on the light. */
  int LIGHT_POINT = 1;

  /** Offset within a vertex, one dimension: which lobe of the surface. */
  int LOBE = 3;

  /** Offset within a vertex, two dimensions: the scattered direction. */
  int DIRECTION = 4;

  /** Offset within a vertex, one dimension: whether the path continues. */
  int ROULETTE = 6;

  int FIRST_VERTEX = 8;
  int VERTEX_STRIDE = 7;

  /** Beyond the dimensions of all vertices that a path can have. */
  int FIRST_PASSING = 1 << 30;

  /** Returns the first dimension of a path's vertex; the one that the camera sees is 0. */
  static int vertex(int number) {
    return FIRST_VERTEX + number * VERTEX_STRIDE;
  }

  /**
   * Returns the dimension that decides whether a ray passes straight through a surface.
   *
   * @param vertex number of the path's next vertex
   * @param layer how many surfaces the ray has passed since the last vertex
   */
  static int passing(int vertex, int layer) {
    return FIRST_PASSING + (vertex << 8) + layer;
  }

  /** Moves to a sample of a pixel of the full frame. */
  void startSample(int x, int y, int sample);

  /**
   * Moves to a part of the sample that was started last: from here on its numbers are those of
   * sample {@code sample * parts + part}, so that the parts of one sample, and of all the samples
   * of a pixel, are spread among each other as samples are. Numbers of samples are taken modulo
   * 2^32: beyond, they come again.
   *
   * @param part 0 to {@code parts - 1}
   * @param parts how many the sample has, the same for all samples of a pixel
   */
  void startPart(int part, int parts);

  /** Returns the number at one dimension of the current sample. */
  double get1d(int dimension);

  /** Returns a point of the unit square, at two consecutive dimensions of the current sample. */
  Point2 get2d(int dimension);
}
