package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.guiding.GuideSample;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Vec3;

/**
 * Directions from a mixture of a guide and the BSDF (one-sample multiple importance sampling with
 * the balance heuristic: Veach 1997, sec. 9.2.4), where the guide has learned any.
 *
 * @param alone the strategy elsewhere
 */
record GuidedDirections(Guide guide, BsdfDirections alone) implements DirectionStrategy {
  @Override
  public void reach(Vertex vertex) {
    vertex.findIn(guide);
  }

  /**
   * The first random number also chooses between guide and BSDF, and is stretched. With a fraction
   * of one half, each of the two receives well distributed points.
   */
  @Override
  public void sample(Vertex vertex, double uLobe, double u, double v, RenderContext context) {
    if (!vertex.isGuided()) {
      alone.sample(vertex, uLobe, u, v, context);
      return;
    }
    context.path.expect(guide.mean(vertex.cell()));
    double fraction = guide.fraction(vertex.cell());
    if (u < fraction) {
      follow(vertex, u / fraction, v, fraction, context);
      return;
    }
    BsdfSample drawn = context.scratch.scattered;
    vertex.sample(uLobe, fraction == 0 ? u : (u - fraction) / (1 - fraction), v, drawn);
    if (fraction == 0 || drawn.isAbsorbed()) {
      return;
    }
    if (drawn.isSpecular()) {
      drawn.scale(1 / (1 - fraction));
      return;
    }
    drawn.mix(pdf(vertex.cell(), drawn.wi(), drawn.pdf()));
  }

  /** Samples a direction from the guide. */
  private void follow(Vertex vertex, double u, double v, double fraction, RenderContext context) {
    GuideSample guided = context.scratch.guided;
    BsdfValue value = context.scratch.value;
    guide.sample(vertex.cell(), u, v, guided);
    Vec3 wi = new Vec3(guided.x(), guided.y(), guided.z());
    vertex.evaluate(wi, value);
    // The BSDF decides, not its density: light sampling is weighted against the guide wherever
    // the BSDF is above 0.
    if (value.r() > 0 || value.g() > 0 || value.b() > 0) {
      double pdf = fraction * guided.pdf() + (1 - fraction) * value.pdf();
      Rgb weight = new Rgb(value.r() / pdf, value.g() / pdf, value.b() / pdf);
      context.scratch.scattered.setMixed(wi, weight, pdf, value.pdf());
    } else {
      context.scratch.scattered.absorb();
    }
  }

  @Override
  public void weigh(Vertex vertex, LightSample light, BsdfValue value) {
    if (vertex.isGuided()) {
      value.mix(pdf(vertex.cell(), light.wi(), value.pdf()));
    }
  }

  /** Returns the density of the mixture for a unit direction in world space. */
  private double pdf(int cell, Vec3 wi, double bsdfPdf) {
    double fraction = guide.fraction(cell);
    if (fraction == 0) {
      return bsdfPdf;
    }
    return fraction * guide.pdf(cell, wi.x(), wi.y(), wi.z()) + (1 - fraction) * bsdfPdf;
  }

  @Override
  public double survival(Vertex vertex, int depth, Path path) {
    return vertex.isGuided() ? path.expectedSurvival() : alone.survival(vertex, depth, path);
  }
}
