package io.github.lumbre.integrator;

import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.Specialization;
import java.util.Objects;

/** What the {@linkplain LightTechnique techniques} of a path tracer share. Immutable. */
final class LightSampling {
  final Scene scene;
  final PathOptions options;
  final DirectionStrategy directions;
  final MisHeuristic heuristic;

  /** The scene's emitters, as they are sampled where scattered rays can find their light, too. */
  final Light[] emitters;

  private final LightSampler selector;

  /** Whether there is more than one light to select from. */
  private final boolean selects;

  /**
   * Creates the shared part.
   *
   * @param selector selects among the scene's emitters
   * @param directions how paths leave their vertices
   */
  LightSampling(
      Scene scene, PathOptions options, LightSampler selector, DirectionStrategy directions) {
    this.scene = Objects.requireNonNull(scene, "scene");
    this.options = options;
    this.selector = Objects.requireNonNull(selector, "selector");
    this.directions = directions;
    heuristic = options.heuristic();
    emitters = scene.emitters().stream().map(LightSampling::besideBsdf).toArray(Light[]::new);
    selects = !SceneInside.of(scene).takes(Specialization.ONE_EMITTER);
  }

  private static Light besideBsdf(Light light) {
    return light instanceof EnvironmentLight environment ? environment.besideBsdf() : light;
  }

  /** Returns whether lights are sampled at all. */
  boolean isOn() {
    return selector.canChoose() && heuristic.samplesLights(scene.emitters());
  }

  /** Returns whether {@link #select} needs a random number. */
  boolean isRandom() {
    return selects && selector.isRandom();
  }

  /**
   * Selects an emitter at random.
   *
   * @param u uniform in [0,1)
   * @param choice has the receiving point; receives the emitter and its probability
   */
  void select(double u, LightChoice choice) {
    if (selects) {
      selector.choose(u, choice);
    } else {
      choice.setOnly();
    }
  }

  /** Returns the probability with which {@link #select} selects an emitter. */
  double probability(LightChoice choice, int emitter) {
    return selects ? selector.probability(choice, emitter) : 1;
  }

  /** Returns whether the vertex scatters nothing of the context's light sample. */
  static boolean isBlack(RenderContext context) {
    LightSample light = context.scratch.light;
    BsdfValue value = context.scratch.value;
    return value.r() * light.r() == 0 && value.g() * light.g() == 0 && value.b() * light.b() == 0;
  }

  /**
   * Adds what the vertex scatters of the context's light sample.
   *
   * @param source how it was sampled
   * @param lightPdf density of the sample; for a delta light, the probability of its selection
   * @param misWeight weight of multiple importance sampling
   * @param isBlocked whether a surface blocks it
   */
  static void add(
      Source source,
      int emitter,
      double lightPdf,
      double misWeight,
      boolean isBlocked,
      RenderContext context) {
    LightSample light = context.scratch.light;
    BsdfValue value = context.scratch.value;
    context.listener.lightSampled(source, emitter, light, value, lightPdf, misWeight, isBlocked);
    double r = value.r() * light.r();
    double g = value.g() * light.g();
    double b = value.b() * light.b();
    boolean isBlack = r == 0 && g == 0 && b == 0;
    if (!isBlack && !isBlocked) {
      double weight = misWeight / lightPdf;
      context.add(r * weight, g * weight, b * weight);
    }
  }
}
