package io.github.lumbre.integrator;

import io.github.lumbre.guiding.Guide;
import io.github.lumbre.guiding.GuideSample;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Vec3;

/**
 * Samples directions from a mixture of a guide and the BSDF (one-sample multiple importance
 * sampling with the balance heuristic: Veach 1997, sec. 9.2.4). Mutable: each thread reuses one
 * instance.
 */
final class Guiding {
  private final GuideSample guided = new GuideSample();
  private final BsdfValue value = new BsdfValue();

  /**
   * Samples a direction at a vertex that has a cell.
   *
   * <p>The first random number also chooses between guide and BSDF, and is stretched. With a
   * fraction of one half, each of the two receives well distributed points.
   *
   * @param u uniform in [0,1), as is v
   * @param drawn receives the direction, in world space, with its weight and density; a delta lobe
   *     has an infinite density
   */
  void sample(Guide guide, Vertex vertex, double uLobe, double u, double v, BsdfSample drawn) {
    int cell = vertex.cell();
    double fraction = guide.fraction(cell);
    if (fraction == 0) {
      vertex.sample(uLobe, u, v, drawn);
      return;
    }
    if (u < fraction) {
      guide.sample(cell, u / fraction, v, guided);
      Vec3 wi = new Vec3(guided.x(), guided.y(), guided.z());
      vertex.evaluate(wi, value);
      // The BSDF decides, not its density: light sampling is weighted against the guide wherever
      // the BSDF is above 0.
      if (value.r() > 0 || value.g() > 0 || value.b() > 0) {
        double pdf = fraction * guided.pdf() + (1 - fraction) * value.pdf();
        Rgb weight = new Rgb(value.r() / pdf, value.g() / pdf, value.b() / pdf);
        drawn.setMixed(wi, weight, pdf, value.pdf());
      } else {
        drawn.absorb();
      }
      return;
    }
    vertex.sample(uLobe, (u - fraction) / (1 - fraction), v, drawn);
    if (drawn.isAbsorbed()) {
      return;
    }
    if (drawn.isSpecular()) {
      drawn.scale(1 / (1 - fraction));
      return;
    }
    drawn.mix(pdf(guide, cell, drawn.wi(), drawn.pdf()));
  }

  /**
   * Returns the density of the mixture.
   *
   * @param wi unit direction in world space
   */
  static double pdf(Guide guide, int cell, Vec3 wi, double bsdfPdf) {
    double fraction = guide.fraction(cell);
    if (fraction == 0) {
      return bsdfPdf;
    }
    return fraction * guide.pdf(cell, wi.x(), wi.y(), wi.z()) + (1 - fraction) * bsdfPdf;
  }
}
