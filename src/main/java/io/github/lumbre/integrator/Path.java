package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Rgb;

/**
 * The state of a path: the light found so far, and the throughput by which further light is
 * multiplied. Mutable, in plain numbers, since every vertex changes all of it.
 */
final class Path {
  private double red, green, blue;
  private double throughputRed, throughputGreen, throughputBlue;
  private double pdf;

  private int branches;

  /** Number of the vertex where the path was split. */
  private int splitDepth;

  /** The throughput of each branch at that vertex. */
  private double splitRed, splitGreen, splitBlue;

  /** Starts a path at the camera, whose ray light sampling could not have drawn. */
  void begin() {
    red = 0;
    green = 0;
    blue = 0;
    throughputRed = 1;
    throughputGreen = 1;
    throughputBlue = 1;
    pdf = Double.POSITIVE_INFINITY;
    branches = 1;
  }

  /** Splits the path at a vertex: each branch has an equal share of the throughput. */
  void split(int depth, int newBranches) {
    branches = newBranches;
    splitDepth = depth;
    splitRed = throughputRed / branches;
    splitGreen = throughputGreen / branches;
    splitBlue = throughputBlue / branches;
  }

  /** Returns whether the path was split. */
  boolean isSplit() {
    return branches > 1;
  }

  /** Returns to the vertex where the path was split, keeping the light found; returns its number. */
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

  /** Adds light found where the path is, times the throughput. */
  void add(double r, double g, double b) {
    red += throughputRed * r;
    green += throughputGreen * g;
    blue += throughputBlue * b;
  }

  /** Multiplies the throughput. */
  void scale(double r, double g, double b) {
    throughputRed *= r;
    throughputGreen *= g;
    throughputBlue *= b;
  }

  /** Returns the largest component of the throughput, without the division by splitting. */
  double throughput() {
    return branches * Math.max(throughputRed, Math.max(throughputGreen, throughputBlue));
  }

  /** Reports a ray that was traced with the present throughput. */
  void reportRay(NearestHit ray, PathListener listener) {
    listener.rayTraced(ray, throughputRed, throughputGreen, throughputBlue);
  }

  /** Returns the light found so far. */
  Rgb radiance() {
    return new Rgb(red, green, blue);
  }
}
