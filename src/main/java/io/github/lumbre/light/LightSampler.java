package io.github.lumbre.light;

import io.github.lumbre.sampling.Distribution1d;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Selects at random one of a scene's emitters to sample at a point. Immutable.
 *
 * <p>Emitters of limited reach are chosen by what may come from them to the point, and so are all
 * of them against all that shine everywhere alike; among these the probabilities are the same at
 * all points.
 */
public final class LightSampler {
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

  /** The least share of all that is near together: what is far may be hidden, by a roof. */
  private static final double LEAST_NEAR = .25;

  /**
   * The least share of all that is far: near lights may be hidden too, and scattered rays miss
   * suns.
   */
  private static final double LEAST_FAR = .125;

  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  /** What stands in the place of an emitter that is not in the distribution. */
  private static final int NEAR = -1;

  /** Over the emitters that stand alone. */
  private final Distribution1d distribution;

  /** The emitters of unlimited reach, or all if there is but one. */
  private final int[] alone;

  /** Where in the distribution each emitter stands. */
  private final int[] places;

  private final Optional<NearLights> near;

  /** Of all that stand alone, in the unit of those that are near. */
  private final double farIrradiance;

  private final double leastFar;

  /** A selector with the same probabilities at all points. */
  private LightSampler(double[] weights, int[] alone, int[] places) {
    distribution = halfEven(weights);
    this.alone = alone;
    this.places = places;
    near = Optional.empty();
    farIrradiance = 0;
    leastFar = 0;
  }

  /**
   * A selector by place.
   *
   * @param far indices of emitters of unlimited reach
   * @param items all the others, at least one
   */
  private LightSampler(List<Light> emitters, int[] far, List<LightTreeBuilder.Item> items) {
    double[] weights =
        IntStream.of(far).mapToDouble(i -> emitters.get(i).farIrradiance()).toArray();
    distribution = halfEven(weights.length == 0 ? new double[1] : weights);
    alone = far;
    places = new int[emitters.size()];
    Arrays.fill(places, NEAR);
    for (int place = 0; place < far.length; place++) {
      places[far[place]] = place;
    }
    double unit =
        items.stream().mapToDouble(item -> item.bounds().intensity()).average().orElseThrow();
    near = Optional.of(near(comparable(items, unit), emitters.size()));
    farIrradiance = Arrays.stream(weights).sum() / unit;
    boolean isEven =
        IntStream.of(far)
            .allMatch(i -> emitters.get(i) instanceof EnvironmentLight dome && dome.isEven());
    leastFar = isEven ? 0 : LEAST_FAR;
  }

  /**
   * Returns the selector that makes half of its choices in proportion to power and half evenly, at
   * all points alike.
   *
   * @param powers at least one; each at least 0; if any is infinite, all choices are even
   */
  public static LightSampler byPower(double... powers) {
    int[] all = IntStream.range(0, powers.length).toArray();
    return new LightSampler(powers, all, all);
  }

  /**
   * Returns the selector for a scene's emitters, which it names by their places in the list.
   *
   * @param emitters may be empty; then nothing can be chosen
   */
  public static LightSampler over(List<Light> emitters) {
    List<LightTreeBuilder.Item> items = new ArrayList<>();
    for (int i = 0; i < emitters.size(); i++) {
      int emitter = i;
      emitters
          .get(i)
          .bounds()
          .ifPresent(bounds -> items.add(new LightTreeBuilder.Item(emitter, bounds)));
    }
    if (emitters.size() < 2) {
      return byPower(1);
    }
    if (items.isEmpty()) {
      return byPower(emitters.stream().mapToDouble(Light::farIrradiance).toArray());
    }
    int[] far =
        IntStream.range(0, emitters.size())
            .filter(i -> emitters.get(i).bounds().isEmpty())
            .toArray();
    return new LightSampler(emitters, far, items);
  }

  private static NearLights near(List<LightTreeBuilder.Item> items, int count) {
    return items.size() <= FewLights.MOST
        ? new FewLights(items, count)
        : new LightTree(items, count);
  }

  /** Returns the emitters with intensities relative to their mean, and none too small. */
  private static List<LightTreeBuilder.Item> comparable(
      List<LightTreeBuilder.Item> items, double mean) {
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

  /** Returns how emitters of limited reach are chosen. */
  public Method method() {
    return near.map(n -> n instanceof LightTree ? Method.HIERARCHY : Method.ONE_BY_ONE)
        .orElse(Method.FIXED);
  }

  /**
   * Chooses an emitter that may light a point.
   *
   * @param u uniform in [0,1)
   * @param choice holds the point, and takes the result
   */
  public void choose(double u, LightChoice choice) {
    if (alone.length == 0) {
      near.get().choose(u, choice);
      return;
    }
    double share = nearShare(choice);
    if (u < share) {
      near.get().choose(Math.min(u / share, BELOW_ONE), choice);
      choice.set(choice.emitter(), share * choice.probability());
    } else {
      double rest = share == 0 ? u : Math.min((u - share) / (1 - share), BELOW_ONE);
      int place = distribution.choose(rest);
      choice.set(alone[place], (1 - share) * distribution.probability(place));
    }
  }

  /**
   * Returns the probability with which {@link #choose} returns an emitter; positive unless it
   * cannot light the point.
   */
  public double probability(LightChoice receiver, int index) {
    int place = places[index];
    double share = nearShare(receiver);
    return place == NEAR
        ? share * near.get().probability(receiver, index)
        : (1 - share) * distribution.probability(place);
  }

  /** Returns the probability to choose one of those that are near. */
  private double nearShare(LightChoice receiver) {
    if (near.isEmpty()) {
      return 0;
    }
    if (alone.length == 0) {
      return 1;
    }
    double irradiance = near.get().irradiance(receiver);
    if (irradiance == 0) {
      return 0;
    }
    double share = irradiance / (irradiance + farIrradiance);
    // Lights of no size may be infinitely bright.
    return LEAST_NEAR + (1 - LEAST_NEAR - leastFar) * (share >= 0 ? share : .5);
  }
}
