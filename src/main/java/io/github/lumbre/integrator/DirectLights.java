package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.internal.Facing;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.sampling.Sampler;

/**
 * The lights that surfaces see directly: next-event estimation (Kajiya 1986; PBRT 4e, sec. 13.4).
 * It stores in the context whether the sampled light is blocked or reflects nothing, so that a
 * technique for light through glass samples from the same point. Immutable.
 */
final class DirectLights implements LightTechnique {
  private final LightSampling shared;
  private final Light[] emitters;

  /** The test for points that an emitter cannot light, by emitter. */
  private final Facing[] facings;

  private final boolean isRandom;

  DirectLights(LightSampling shared) {
    this.shared = shared;
    emitters = shared.emitters;
    facings = shared.scene.emitters().stream().map(Facing::of).toArray(Facing[]::new);
    isRandom = shared.isRandom();
  }

  @Override
  public void add(int depth, Sampler sampler, RenderContext context) {
    Vertex vertex = context.vertex;
    LightChoice choice = context.choice;
    RenderContext.Scratch scratch = context.scratch;
    LightSample light = scratch.light;
    scratch.isLightMissed = false;
    int dimension = Sampler.vertex(depth);
    vertex.receiveFrom(choice);
    shared.select(isRandom ? sampler.get1d(dimension + Sampler.LIGHT_CHOICE) : 0, choice);
    // Recorded paths contain light that does not arrive, too.
    if (facings[choice.emitter()].isAway(choice) && !context.isRecorded()) {
      return;
    }
    Point2 uLight = sampler.get2d(dimension + Sampler.LIGHT_POINT);
    Light emitter = emitters[choice.emitter()];
    emitter.sample(choice.x(), choice.y(), choice.z(), uLight.x(), uLight.y(), light);
    if (light.isEmpty()) {
      return;
    }
    vertex.evaluate(light, scratch.value);
    boolean isBlack = LightSampling.isBlack(context);
    // A transparent surface dims the sample.
    boolean isBlocked = !isBlack && context.isOccluded(shared.scene, vertex.surface());
    boolean arrives = !isBlack && !isBlocked;
    if (arrives || context.isRecorded()) {
      weigh(choice, light, isBlocked, context);
    }
    scratch.isLightMissed = !arrives;
  }

  private void weigh(
      LightChoice choice, LightSample light, boolean isBlocked, RenderContext context) {
    BsdfValue value = context.scratch.value;
    double lightPdf = choice.probability();
    double misWeight = 1;
    if (!light.isDelta()) {
      lightPdf *= light.pdf();
      shared.directions.weigh(context.vertex, light, value);
      misWeight = shared.heuristic.lightWeight(lightPdf, value.pdf());
    }
    LightSampling.add(Source.LIGHT, choice.emitter(), lightPdf, misWeight, isBlocked, context);
  }

  /** Light sampling draws no rays of delta lobes and no rays of the camera. */
  @Override
  public boolean mightFind(int depth, RenderContext context) {
    return rayPdf(context) != Double.POSITIVE_INFINITY;
  }

  @Override
  public double rayPdf(RenderContext context) {
    return context.path.pdf();
  }

  @Override
  public double pdf(int emitter, SurfaceHit hit, RenderContext context) {
    return pdf(emitter, emitters[emitter].pdf(context.choice.point(), hit), context);
  }

  /**
   * Returns the density, per solid angle, with which {@link #add} would have drawn the path's ray.
   * It is the density at the vertex that last sampled a light: the path leaves every later vertex
   * by a delta lobe.
   *
   * @param pdf density with which the emitter itself draws the ray
   */
  double pdf(int emitter, double pdf, RenderContext context) {
    return shared.probability(context.choice, emitter) * pdf;
  }
}
