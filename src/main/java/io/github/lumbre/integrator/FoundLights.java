package io.github.lumbre.integrator;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.scene.Scene;
import java.util.Optional;

/**
 * The light that paths find by themselves: emission of surfaces that their rays meet, environment
 * lights, and ambient light. Where a {@link LightTechnique} might have sampled it as well, it is
 * weighted against the technique. Immutable.
 */
final class FoundLights {
  private final Scene scene;
  private final LightTechniques techniques;
  private final MisHeuristic heuristic;
  private final EnvironmentLight[] environments;

  /** What the camera sees instead of environment lights. */
  private final Optional<SeenBackplate> backplate;

  /** Whether samples that see the backplate through clear glass cover their pixel. */
  private final boolean isGlassSeen;

  private final boolean hasAmbient;

  FoundLights(Scene scene, PathOptions options, LightTechniques techniques) {
    this.scene = scene;
    this.techniques = techniques;
    heuristic = options.heuristic();
    environments =
        scene.environments().stream()
            .map(EnvironmentLight::besideBsdf)
            .toArray(EnvironmentLight[]::new);
    backplate = options.backplateOf(scene).map(seen -> new SeenBackplate(scene, seen));
    isGlassSeen = options.backplate().isPresent();
    hasAmbient = !scene.ambient().isBlack();
  }

  /**
   * Adds the emission of a surface towards the previous vertex.
   *
   * @param depth number of surfaces that scattered the path so far
   */
  void addEmission(Emission emission, SurfaceHit surface, int depth, RenderContext context) {
    Rgb emitted = emission.towards(surface.wo(), surface.geometricNormal(), surface);
    int emitter = scene.emitterAt(context.hit);
    double rayPdf = context.path.pdf();
    double lightPdf = 0;
    double weight = 1;
    if (emitter >= 0) {
      for (LightTechnique technique : techniques.all) {
        if (technique.mightFind(depth, context)) {
          rayPdf = technique.rayPdf(context);
          lightPdf = technique.pdf(emitter, surface, context);
          weight = heuristic.bsdfWeight(rayPdf, lightPdf);
        }
      }
    }
    context.listener.lightFound(
        Source.EMISSION, emitter, emitted.r(), emitted.g(), emitted.b(), lightPdf, rayPdf, weight);
    context.add(emitted.r() * weight, emitted.g() * weight, emitted.b() * weight);
  }

  /**
   * Adds the light of a ray that leaves the scene.
   *
   * @param depth number of surfaces that scattered the path so far
   */
  void addBackground(int depth, Sampler sampler, RenderContext context) {
    if (depth == 0 && backplate.isPresent()) {
      addBackplate(backplate.get().light(context), context);
    } else {
      addEnvironment(context, context.hit.direction());
    }
  }

  /** Adds the environment lights, each with its own weight. */
  private void addEnvironment(RenderContext context, Vec3 direction) {
    double rayPdf = context.path.pdf();
    double r = 0;
    double g = 0;
    double b = 0;
    for (int i = 0; i < environments.length; i++) {
      int emitter = scene.emitterOfEnvironment(i);
      double lightPdf = 0;
      double weight = 1;
      if (techniques.isOn && rayPdf != Double.POSITIVE_INFINITY) {
        lightPdf = techniques.direct.pdf(emitter, environments[i].pdf(direction), context);
        weight = heuristic.bsdfWeight(rayPdf, lightPdf);
      }
      Rgb light = environments[i].from(direction);
      r += light.r() * weight;
      g += light.g() * weight;
      b += light.b() * weight;
      context.listener.lightFound(
          Source.ENVIRONMENT, emitter, light.r(), light.g(), light.b(), lightPdf, rayPdf, weight);
    }
    context.add(r, g, b);
  }

  private void addBackplate(Rgb light, RenderContext context) {
    context.hitSomething |= isGlassSeen && context.passedGlass;
    context.listener.lightFound(
        Source.ENVIRONMENT, -1, light.r(), light.g(), light.b(), 0, Double.POSITIVE_INFINITY, 1);
    context.add(light.r(), light.g(), light.b());
  }

  /** Adds the light that ambient irradiance gives the diffuse part of a surface. */
  void addAmbient(Vertex vertex, RenderContext context) {
    if (hasAmbient) {
      Rgb light = scene.ambient().times(vertex.bsdf().diffuseAlbedo()).times(Elementary.INV_PI);
      context.listener.lightFound(Source.AMBIENT, -1, light.r(), light.g(), light.b(), 0, 0, 1);
      context.add(light.r(), light.g(), light.b());
    }
  }
}
