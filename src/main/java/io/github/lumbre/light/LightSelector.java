package io.github.lumbre.light;

import io.github.lumbre.sampling.Distribution1d;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Which of a scene's emitters a point asks for light: a choice at random. Immutable.
 *
 * <p>Two or more emitters of limited reach are chosen by what may come from them to the point;
 * those that shine everywhere alike, and all the others as one, with the same probabilities at all
 * points.
 */
public final class LightSelector {
  /**
   * The share of fixed choices that all emitters have alike. What is near and weak can matter more
   * than what is far and strong; so no emitter is chosen less than half as often as by pure chance.
   */
  private static final double EVEN_SHARE = .5;

  /**
   * The least intensity in the tree, relative to the mean: a texture may shine where its sum, over
   * a grid, does not see it.
   */
  private static final double LEAST = 1e-3;

  /** Over the emitters of unlimited reach and, last, all the near ones as one. */
  private final Distribution1d distribution;

  /** The emitters of unlimited reach, or all if there are not two others. */
  private final int[] alone;

  /** Where in the distribution each emitter stands. */
  private final int[] places;

  private final Optional<NearLights> near;

  private LightSelector(
      Distribution1d distribution, int[] alone, int[] places, Optional<NearLights> near) {
    this.distribution = distribution;
    this.alone = alone;
    this.places = places;
    this.near = near;
  }

  /**
   * Returns the selector that makes half of its choices in proportion to power and half evenly, at
   * all points alike.
   *
   * @param powers at least one; each at least 0; if any is infinite, all choices are even
   */
  public static LightSelector byPower(double... powers) {
    int[] all = IntStream.range(0, powers.length).toArray();
    return new LightSelector(halfEven(powers), all, all, Optional.empty());
  }

  /**
   * Returns the selector for a scene's emitters, which it names by their places in the list.
   *
   * @param emitters may be empty; then nothing can be chosen
   * @param sceneRadius of a sphere around all that is finite in the scene, at least 0
   */
  public static LightSelector over(List<Light> emitters, double sceneRadius) {
    double[] powers = emitters.stream().mapToDouble(e -> e.power(sceneRadius)).toArray();
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    int[] alone = new int[emitters.size()];
    int[] places = new int[emitters.size()];
    double[] weights = new double[emitters.size() + 1];
    int count = 0;
    double powerOfNear = 0;
    for (int i = 0; i < powers.length; i++) {
      Optional<LightBounds> bounds = emitters.get(i).bounds();
      if (bounds.isPresent()) {
        items.add(new LightTreeBuilder.Item(i, bounds.get()));
        places[i] = -1;
        powerOfNear += powers[i];
      } else {
        places[i] = count;
        alone[count] = i;
        weights[count] = powers[i];
        count++;
      }
    }
    if (items.size() < 2) {
      return byPower(powers.length == 0 ? new double[1] : powers);
    }
    for (LightTreeBuilder.Item item : items) {
      places[item.emitter()] = count;
    }
    weights[count] = powerOfNear;
    return new LightSelector(
        halfEven(Arrays.copyOf(weights, count + 1)),
        Arrays.copyOf(alone, count),
        places,
        Optional.of(near(comparable(items), powers.length)));
  }

  private static NearLights near(List<LightTreeBuilder.Item> items, int count) {
    return items.size() <= FewLights.MOST
        ? new FewLights(items, count)
        : new LightTree(items, count);
  }

  /** Returns the emitters with intensities relative to their mean, and none too small. */
  private static List<LightTreeBuilder.Item> comparable(List<LightTreeBuilder.Item> items) {
    double mean =
        items.stream().mapToDouble(item -> item.bounds().intensity()).average().orElseThrow();
    boolean isKnown = mean > 0 && Double.isFinite(mean);
    List<LightTreeBuilder.Item> result = new ArrayList<>();
    for (LightTreeBuilder.Item item : items) {
      double relative = isKnown ? Math.max(LEAST, item.bounds().intensity() / mean) : 1;
      result.add(new LightTreeBuilder.Item(item.emitter(), item.bounds().withIntensity(relative)));
    }
    return result;
  }

  private static Distribution1d halfEven(double... powers) {
    double sum = Arrays.stream(powers).sum();
    boolean isKnown = sum > 0 && Double.isFinite(sum);
    double even = 1.0 / powers.length;
    return new Distribution1d(
        Arrays.stream(powers)
            .map(p -> EVEN_SHARE * even + (1 - EVEN_SHARE) * (isKnown ? p / sum : even))
            .toArray());
  }

  /** How emitters are chosen. */
  public enum Method {
    /** With the same probabilities at all points. */
    FIXED,
    /** By what each of a few may send to the point. */
    ONE_BY_ONE,
    /** By what halves of many may send to the point, and halves of those. */
    HIERARCHY
  }

  /** Tells how emitters of limited reach are chosen. */
  public Method method() {
    return near.map(n -> n instanceof LightTree ? Method.HIERARCHY : Method.ONE_BY_ONE)
        .orElse(Method.FIXED);
  }

  /**
   * Chooses an emitter that may light the point that asks.
   *
   * @param u uniform in [0,1)
   * @param choice holds the point, and takes the result
   */
  public void choose(double u, LightChoice choice) {
    if (alone.length == 0) {
      near.get().choose(u, choice);
      return;
    }
    int place = distribution.choose(u);
    double probability = distribution.probability(place);
    if (place < alone.length) {
      choice.set(alone[place], probability);
    } else {
      near.get().choose(distribution.remainder(place, u), choice);
      choice.set(choice.emitter(), probability * choice.probability());
    }
  }

  /**
   * Returns the probability with which {@link #choose} returns an emitter; positive unless it
   * cannot light the point that asks.
   */
  public double probability(LightChoice asked, int index) {
    int place = places[index];
    double probability = distribution.probability(place);
    return place < alone.length ? probability : probability * near.get().probability(asked, index);
  }
}
