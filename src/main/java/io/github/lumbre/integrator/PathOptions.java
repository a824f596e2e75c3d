package io.github.lumbre.integrator;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.Objects;
import java.util.Optional;

/**
 * The options of a {@link PathTracer}. Only the depth and the transparent background change the
 * expected image; the other options change noise and render time.
 *
 * @param maxDepth the largest number of scattering vertices of a path, at least 0: with 0 only
 *     emitters are visible, with 1 also direct light
 * @param heuristic how light sampling and BSDF sampling are weighted
 * @param lightSampler how a vertex selects a light
 * @param firstRoulette number of the first vertex at which Russian roulette may end a path, at
 *     least 0; the vertex that the camera sees is 0. Paths that have met mirrors and glass alone
 *     end from vertex 3 on at the earliest
 * @param split number of branches into which a path is split at its first non-specular vertex, at
 *     least 1; each branch gets an equal share of the throughput (PBRT 4e, sec. 2.2.5)
 * @param transparent whether the background is transparent: camera rays that hit nothing find no
 *     light but that of {@code backplate}. Lights out of focus are not sampled through the lens then, because alpha counts the
 *     camera rays that hit something
 * @param bySpecular whether surfaces also sample lamps by way of mirrors that are spheres, and
 *     through clear glass
 * @param backplate light that camera rays find instead of environment lights, although the
 *     background counts as transparent; rays that have passed straight through clear glass count as
 *     rays that hit something then. Empty if a transparent background is black
 */
public record PathOptions(
    int maxDepth,
    MisHeuristic heuristic,
    LightSamplerKind lightSampler,
    int firstRoulette,
    int split,
    boolean transparent,
    boolean bySpecular,
    Optional<Rgb> backplate) {
  /** The default number of the first vertex at which Russian roulette may end a path. */
  public static final int FIRST_ROULETTE = 1;

  public PathOptions {
    Objects.requireNonNull(heuristic, "heuristic");
    Objects.requireNonNull(lightSampler, "lightSampler");
    Objects.requireNonNull(backplate, "backplate");
    if (maxDepth < 0 || firstRoulette < 0) {
      throw new IllegalArgumentException(
          "maxDepth, firstRoulette: expected at least 0, found " + maxDepth + ", " + firstRoulette);
    }
    if (split < 1) {
      throw new IllegalArgumentException("split: expected at least 1, found " + split);
    }
  }

  /** Creates options without a backplate. */
  public PathOptions(
      int maxDepth,
      MisHeuristic heuristic,
      LightSamplerKind lightSampler,
      int firstRoulette,
      int split,
      boolean transparent,
      boolean bySpecular) {
    this(
        maxDepth,
        heuristic,
        lightSampler,
        firstRoulette,
        split,
        transparent,
        bySpecular,
        Optional.empty());
  }

  /** Returns the default options, for paths of at most {@code maxDepth} scattering vertices. */
  public static PathOptions toDepth(int maxDepth) {
    return new PathOptions(
        maxDepth, MisHeuristic.BOTH, LightSamplerKind.PLACE, FIRST_ROULETTE, 1, false, true);
  }

  public static PathOptions of(RenderSettings settings) {
    return toDepth(settings.maxTraceDepth())
        .splitInto(settings.split())
        .before(settings);
  }

  /** Returns the same options with another heuristic. */
  public PathOptions by(MisHeuristic newHeuristic) {
    return new PathOptions(
        maxDepth,
        newHeuristic,
        lightSampler,
        firstRoulette,
        split,
        transparent,
        bySpecular,
        backplate);
  }

  /** Returns the same options with another light sampler. */
  public PathOptions by(LightSamplerKind newSampler) {
    return new PathOptions(
        maxDepth,
        heuristic,
        newSampler,
        firstRoulette,
        split,
        transparent,
        bySpecular,
        backplate);
  }

  /** Returns the same options with another first vertex for Russian roulette. */
  public PathOptions rouletteFrom(int vertex) {
    return new PathOptions(
        maxDepth,
        heuristic,
        lightSampler,
        vertex,
        split,
        transparent,
        bySpecular,
        backplate);
  }

  /** Returns the same options with another number of branches. */
  public PathOptions splitInto(int ways) {
    return new PathOptions(
        maxDepth,
        heuristic,
        lightSampler,
        firstRoulette,
        ways,
        transparent,
        bySpecular,
        backplate);
  }

  /** Returns the same options for a background that is transparent, or is not. */
  public PathOptions transparent(boolean isTransparent) {
    return new PathOptions(
        maxDepth, heuristic, lightSampler, firstRoulette, split, isTransparent, bySpecular);
  }

  /** Returns what camera rays find in a scene instead of environment lights, if anything. */
  Optional<Backplate> backplateOf(Scene scene) {
    return backplate
        .map(Backplate::plain)
        .or(() -> transparent ? Optional.of(Backplate.plain(Rgb.BLACK)) : Optional.empty())
        .or(scene::backplate);
  }

  /** Returns the same options for the background of settings. */
  public PathOptions before(RenderSettings settings) {
    return new PathOptions(
        maxDepth,
        heuristic,
        lightSampler,
        firstRoulette,
        split,
        settings.countsCoverage(),
        bySpecular,
        settings.background());
  }

  /** Returns the same options without lamps that are sampled by way of specular surfaces. */
  public PathOptions withoutSpecularLinks() {
    return new PathOptions(
        maxDepth,
        heuristic,
        lightSampler,
        firstRoulette,
        split,
        transparent,
        false,
        backplate);
  }
}
