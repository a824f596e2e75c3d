package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;

/**
 * A path on its way from the camera: what it has gathered, and what more light would count for.
 * Mutable, in plain numbers, since every vertex changes all of it.
 */
final class Path {
  private double red, green, blue;
  private double throughputRed, throughputGreen, throughputBlue;
  private double pdf;

  private int ways;

  /** Number of the vertex where it was split. */
  private int splitDepth;

  /** What light counted for there, by each of the ways. */
  private double splitRed, splitGreen, splitBlue;

  /** Begins a path at the camera, whose ray light sampling could not have drawn. */
  void begin() {
    red = 0;
    green = 0;
    blue = 0;
    throughputRed = 1;
    throughputGreen = 1;
    throughputBlue = 1;
    pdf = Double.POSITIVE_INFINITY;
    ways = 1;
  }

  /** Splits the path at a vertex: light counts for an equal share by each of the ways. */
  void split(int depth, int newWays) {
    ways = newWays;
    splitDepth = depth;
    splitRed = throughputRed / ways;
    splitGreen = throughputGreen / ways;
    splitBlue = throughputBlue / ways;
  }

  /** Returns in how many ways the path goes on; 1 before it is split. */
  int ways() {
    return ways;
  }

  /** Tells whether the path was split. */
  boolean isSplit() {
    return ways > 1;
  }

  /**
   * Goes back to the vertex where the path was split, keeps what it gathered; returns its number.
   */
  int returnToSplit() {
    throughputRed = splitRed;
    throughputGreen = splitGreen;
    throughputBlue = splitBlue;
    return splitDepth;
  }

  /**
   * Leaves a vertex.
   *
   * @param newPdf density of the path's direction; infinite if light sampling could not have drawn
   *     it
   */
  void leave(double newPdf) {
    pdf = newPdf;
  }

  /** Returns the density of the ray's direction; infinite if light sampling could not draw it. */
  double pdf() {
    return pdf;
  }

  /** Adds light that arrives where the path is. */
  void gather(Rgb radiance) {
    gather(radiance.r(), radiance.g(), radiance.b());
  }

  /** Adds light, given by its components, that arrives where the path is. */
  void gather(double r, double g, double b) {
    red += throughputRed * r;
    green += throughputGreen * g;
    blue += throughputBlue * b;
  }

  /** Lets the rest of the path count for less, or more. */
  void weigh(double r, double g, double b) {
    throughputRed *= r;
    throughputGreen *= g;
    throughputBlue *= b;
  }

  /** Returns the largest component of what more light counts for, had the path not been split. */
  double throughput() {
    return ways * Math.max(throughputRed, Math.max(throughputGreen, throughputBlue));
  }

  /** Returns what more light counts for, by component. */
  Rgb weight() {
    return new Rgb(throughputRed, throughputGreen, throughputBlue);
  }

  /** Returns the light gathered so far. */
  Rgb radiance() {
    return new Rgb(red, green, blue);
  }
}
