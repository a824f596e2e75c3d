package io.github.lumbre.math.sampling;

import io.github.lumbre.math.Point2;

/**
 * Random numbers in [0,1) that are pure functions of seed, pixel, sample and dimension, so that
 * neither threads nor the order of work can change a picture. Mutable, because it stores the
 * current address, and confined to one thread.
 *
 * <p>The order of dimensions is fixed. The camera's dimensions are constants of this interface.
 * Each vertex of a path owns {@link #VERTEX_STRIDE} dimensions from {@link #vertex} on, whether it
 * uses them or not.
 */
public interface Sampler {
  /** Two dimensions: the position in the pixel. */
  int FILM = 0;

  /** Two dimensions: the position on the lens. */
  int LENS = 2;

  /** Three dimensions: the texel of a lens mask, and the position in it. */
  int MASK = 4;

  /** Offset within a vertex, one dimension: the selected light. */
  int LIGHT_CHOICE = 0;

  /** Offset within a vertex, two dimensions: the position on the light. */
  int LIGHT_POINT = 1;

  /** Offset within a vertex, one dimension: the selected lobe of the BSDF. */
  int LOBE = 3;

  /** Offset within a vertex, two dimensions: the scattered direction. */
  int DIRECTION = 4;

  /** Offset within a vertex, one dimension: Russian roulette. */
  int ROULETTE = 6;

  /** The first dimension of the vertex that the camera sees. */
  int FIRST_VERTEX = 8;

  /** The number of dimensions of a vertex. */
  int VERTEX_STRIDE = 7;

  /** Beyond the dimensions of all vertices that a path can have. */
  int FIRST_PASSING = 1 << 30;

  /** Beyond the dimensions of all passed surfaces. */
  int FIRST_CAUGHT = 3 << 29;

  /**
   * Three dimensions beyond all passed surfaces: the light that is sampled through the lens, and
   * the position on it.
   */
  int THROUGH_LENS = 7 << 28;

  /** Beyond all other dimensions: lights by way of specular surfaces. */
  int FIRST_MIRROR = 15 << 27;

  /** Returns the first dimension of a path's vertex; the one that the camera sees is 0. */
  static int vertex(int number) {
    return FIRST_VERTEX + number * VERTEX_STRIDE;
  }

  /**
   * Returns the dimension that decides whether a ray passes straight through a surface. From layer
   * 256 on it is negative, and vertices whose numbers differ by a multiple of 32768 share it.
   *
   * @param vertex number of the path's next vertex
   * @param layer how many surfaces the ray has passed since the last vertex, less than 65536
   */
  static int passing(int vertex, int layer) {
    return layer < 1 << 8
        ? FIRST_PASSING + (vertex << 8) + layer
        : Integer.MIN_VALUE | vertex << 16 | layer;
  }

  /**
   * Returns the first of five dimensions that decide whether a camera ray sees a shadow.
   *
   * @param layer how many surfaces the ray has passed
   */
  static int caught(int layer) {
    return FIRST_CAUGHT + (layer << 3);
  }

  /**
   * Returns the first of three dimensions of the light that a vertex samples in a mirror: the
   * mirror and the light, and the position on it.
   */
  static int mirror(int vertex) {
    return FIRST_MIRROR + (vertex << 2);
  }

  /** Returns the dimension that decides whether a vertex samples light through glass. */
  static int glass(int vertex) {
    return mirror(vertex) + 3;
  }

  /** Moves to a sample of a pixel of the full frame. */
  void startSample(int x, int y, int sample);

  /**
   * Moves to a part of the current sample, for example to a branch of a split path. It has the
   * numbers of sample {@code sample * parts + part}, so that all parts of all samples of a pixel
   * are distributed as evenly as samples are. That number is taken modulo 2^32, beyond which the
   * numbers repeat.
   *
   * @param part 0 to {@code parts - 1}
   * @param parts number of parts of a sample, the same for all samples of a pixel
   */
  void startPart(int part, int parts);

  /** Returns the number in [0,1) at a dimension of the current sample. */
  double get1d(int dimension);

  /** Returns a point in [0,1)² from a dimension of the current sample and the next one. */
  Point2 get2d(int dimension);
}
