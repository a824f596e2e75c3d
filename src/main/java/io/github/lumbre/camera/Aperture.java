package io.github.lumbre.camera;

import io.github.lumbre.camera.internal.BokehCache;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.Warp;

/** The shape of a lens aperture, from which lens points are sampled. */
@FunctionalInterface
public interface Aperture {
  /** The unit disk, sampled with the concentric map. */
  Aperture DISK =
      new Aperture() {
        @Override
        public Point2 sample(Sampler sampler) {
          return Warp.concentricDisk(sampler.get2d(Sampler.LENS));
        }

        @Override
        public double area() {
          return Math.PI;
        }

        @Override
        public boolean contains(double x, double y) {
          return x * x + y * y <= 1;
        }
      };

  /**
   * Returns the shape of a black and white mask, one unit wide, one unit high and centered.
   *
   * @param white {@code [row][column]}, with row 0 at the <b>bottom</b>; all rows have the same
   *     length
   * @throws IllegalArgumentException if no texel is white
   */
  static Aperture mask(boolean[][] white) {
    return new BokehCache(white);
  }

  /**
   * Samples a uniform point of the lens with the camera dimensions of the current sample. In the
   * result, +x points to the camera's right and +y up, in units of the aperture.
   */
  Point2 sample(Sampler sampler);

  /**
   * Returns the area from which {@link #sample} draws, in squared units of the aperture; 0, the
   * default, if it is not known. Then lights are not sampled through the lens.
   */
  default double area() {
    return 0;
  }

  /** Returns whether {@link #sample} can draw a point, given in units of the aperture. */
  default boolean contains(double x, double y) {
    return false;
  }
}
