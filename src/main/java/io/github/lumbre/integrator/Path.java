package io.github.lumbre.integrator;

import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Rgb;

/**
 * The state of a path: its throughput and the radiance found so far. Mutable; it stores plain
 * numbers because every vertex changes all of them.
 */
final class Path {
  /** The smallest probability with which roulette continues a guided path. */
  private static final double LEAST_SURVIVAL = .1;

  /** Part of the expected light, as a divisor, below which roulette may end a guided path. */
  private static final double SLACK = 3;

  /**
   * Number of the first vertex, from 0, at which roulette may end a path that has met mirrors and
   * glass alone. What is seen through dark glass therefore has no noise by roulette.
   */
  private static final int FIRST_SPECULAR = 3;

  /** Part of the throughput behind the first surface, as a divisor, below which roulette begins. */
  private static final double SURFACE_SLACK = 2;

  private double red, green, blue;
  private double throughputRed, throughputGreen, throughputBlue;
  private double pdf;

  /** Light that the path was expected to find at its first guided vertex; below 0 before it. */
  private double expected;

  /** The probability that {@link #expect} found. */
  private double expectedSurvival;

  /** Whether the path has left a non-specular vertex. */
  private boolean isScattered;

  /** The largest component of the throughput with which it left the first one. */
  private double first;

  private int branches;

  /** Number of the vertex where the path was split, from 0. */
  private int splitDepth;

  /** The throughput of each branch at that vertex. */
  private double splitRed, splitGreen, splitBlue;

  /**
   * Starts a path at the camera. Its first ray has an infinite density: light sampling cannot draw
   * it.
   */
  void begin() {
    red = 0;
    green = 0;
    blue = 0;
    throughputRed = 1;
    throughputGreen = 1;
    throughputBlue = 1;
    pdf = Double.POSITIVE_INFINITY;
    expected = -1;
    isScattered = false;
    branches = 1;
  }

  /** Splits the path at a vertex. Each branch gets an equal share of the throughput. */
  void split(int depth, int newBranches) {
    branches = newBranches;
    splitDepth = depth;
    splitRed = throughputRed / branches;
    splitGreen = throughputGreen / branches;
    splitBlue = throughputBlue / branches;
  }

  boolean isSplit() {
    return branches > 1;
  }

  /**
   * Goes back to the vertex where the path was split and keeps the light found so far. Returns the
   * number of that vertex.
   */
  int returnToSplit() {
    throughputRed = splitRed;
    throughputGreen = splitGreen;
    throughputBlue = splitBlue;
    isScattered = false;
    return splitDepth;
  }

  /**
   * Leaves a vertex in a sampled direction, with the throughput behind it.
   *
   * @param newPdf density of that direction per solid angle; infinite if light sampling cannot draw
   *     it
   */
  void leave(double newPdf) {
    pdf = newPdf;
    if (!isScattered && newPdf != Double.POSITIVE_INFINITY) {
      isScattered = true;
      first = throughput();
    }
  }

  /**
   * Returns the density of the current ray's direction per solid angle; infinite if light sampling
   * cannot draw it.
   */
  double pdf() {
    return pdf;
  }

  /** Adds radiance found at the current vertex, times the throughput. */
  void add(double r, double g, double b) {
    red += throughputRed * r;
    green += throughputGreen * g;
    blue += throughputBlue * b;
  }

  /** Multiplies the throughput by a color. */
  void scale(double r, double g, double b) {
    throughputRed *= r;
    throughputGreen *= g;
    throughputBlue *= b;
  }

  /**
   * Arrives at a guided vertex. Finds the probability with which roulette should continue the path
   * there, by the light that the path is expected to find beyond it, compared with its first vertex
   * (Vorba and Krivanek 2016, "Adjoint-Driven Russian Roulette and Splitting"). A guided path has a
   * low throughput where much light is, so that the throughput alone would end the wrong paths.
   *
   * @param mean mean radiance that the vertex scatters
   */
  void expect(double mean) {
    double now = mean * branches * (throughputRed + throughputGreen + throughputBlue);
    if (expected < 0) {
      expected = now;
    }
    expectedSurvival =
        expected > 0 ? Math.max(LEAST_SURVIVAL, Math.min(1, SLACK * now / expected)) : 1;
  }

  /** Returns the probability with which roulette should continue the path at a guided vertex. */
  double expectedSurvival() {
    return expectedSurvival;
  }

  /**
   * Returns the probability with which roulette should continue an unguided path at a vertex, by
   * its throughput compared with that behind its first non-specular vertex. The pixel shows the
   * color of that surface, so that behind a dark one, weak paths count as much as strong ones
   * behind a bright one. The slack spares paths that would end often and save little.
   *
   * @param depth number of the vertex, from 0
   */
  double survival(int depth) {
    if (!isScattered) {
      return depth < FIRST_SPECULAR ? 1 : Math.min(1, throughput());
    }
    double now = SURFACE_SLACK * throughput();
    return now > 0 ? Math.min(1, now / first) : 0;
  }

  /** Returns the throughput per color. */
  Rgb colors() {
    return new Rgb(throughputRed, throughputGreen, throughputBlue);
  }

  /** Returns the largest component of the throughput, not divided by the number of branches. */
  double throughput() {
    return branches * Math.max(throughputRed, Math.max(throughputGreen, throughputBlue));
  }

  /** Reports a ray that was traced, with the current throughput. */
  void reportRay(NearestHit ray, int depth, PathListener listener) {
    listener.rayTraced(ray, depth, throughputRed, throughputGreen, throughputBlue);
  }

  /** Makes the radiance NaN. */
  void reject() {
    red = Double.NaN;
  }

  /** Returns the radiance found so far, in linear RGB. */
  Rgb radiance() {
    return new Rgb(red, green, blue);
  }
}
