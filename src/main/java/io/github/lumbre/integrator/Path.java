package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Vec3;

/**
 * A path on its way from the camera: what it has gathered, what more light would count for, and the
 * vertex it left last. Mutable, in plain numbers, since every vertex changes all of it.
 */
final class Path {
  private double red, green, blue;
  private double throughputRed, throughputGreen, throughputBlue;
  private double fromX, fromY, fromZ;
  private double facingX, facingY, facingZ;
  private double pdf;

  /** Begins a path at the camera, whose ray light sampling could not have drawn. */
  void begin() {
    red = 0;
    green = 0;
    blue = 0;
    throughputRed = 1;
    throughputGreen = 1;
    throughputBlue = 1;
    pdf = Double.POSITIVE_INFINITY;
  }

  /**
   * Leaves a vertex.
   *
   * @param from the point of the surface
   * @param facing the normal there on the side that light comes from; zero if on both
   * @param newPdf density of the path's direction; infinite if light sampling could not have drawn
   *     it
   */
  void leave(Vec3 from, Vec3 facing, double newPdf) {
    fromX = from.x();
    fromY = from.y();
    fromZ = from.z();
    facingX = facing.x();
    facingY = facing.y();
    facingZ = facing.z();
    pdf = newPdf;
  }

  /** Returns the point of the surface that the ray left. */
  Vec3 from() {
    return new Vec3(fromX, fromY, fromZ);
  }

  /** Returns the normal there on the side that light comes from; zero if on both. */
  Vec3 facing() {
    return new Vec3(facingX, facingY, facingZ);
  }

  /** Returns the density of the ray's direction; infinite if light sampling could not draw it. */
  double pdf() {
    return pdf;
  }

  /** Adds light that arrives where the path is. */
  void gather(Rgb radiance) {
    red += throughputRed * radiance.r();
    green += throughputGreen * radiance.g();
    blue += throughputBlue * radiance.b();
  }

  /** Lets the rest of the path count for less, or more. */
  void weigh(Rgb weight) {
    throughputRed *= weight.r();
    throughputGreen *= weight.g();
    throughputBlue *= weight.b();
  }

  /** Returns the largest component of what more light counts for. */
  double throughput() {
    return Math.max(throughputRed, Math.max(throughputGreen, throughputBlue));
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
