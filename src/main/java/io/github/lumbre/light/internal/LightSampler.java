package io.github.lumbre.light.internal;

import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.sampling.internal.Distribution1d;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A light sampler: selects at random one of a scene's emitters to sample at a point. Immutable.
 *
 * <p>There are two groups of emitters: those whose irradiance decreases with distance (near) and
 * those that reach the whole scene equally (far). The sampler first selects a group by the
 * estimated irradiance of each at the point. Within the near group, it selects an emitter by its
 * estimated irradiance at the point. Within the far group, the probabilities are the same at all
 * points. Environment lights of constant radiance are in neither group and never selected, because
 * BSDF samples alone find them best.
 */
public final class LightSampler {
  /**
   * The fraction of fixed choices that is spread evenly over all emitters, because a weak light
   * nearby can matter more than a strong one far away. No emitter is therefore selected less than
   * half as often as by a uniform choice.
   */
  private static final double EVEN_SHARE = .5;

  /**
   * The smallest intensity in the tree, relative to the mean. An emission texture may be bright
   * between the grid points from which the intensity was estimated.
   */
  private static final double LEAST = 1e-3;

  /**
   * The smallest probability of the near group if its estimate is positive, because far lights may
   * be hidden, for example by a roof.
   */
  private static final double LEAST_NEAR = .25;

  /**
   * The smallest probability of the far group, because near lights may be hidden too, and BSDF
   * sampling misses small bright lights such as the sun.
   */
  private static final double LEAST_FAR = .125;

  private static final double BELOW_ONE = 0x1.fffffffffffffp-1;

  /** Marks, in {@link #places}, an emitter of the near group. */
  private static final int NEAR = -1;

  /** Marks, in {@link #places}, an emitter that is never selected. */
  private static final int NEVER = -2;

  /** The distribution over {@link #alone}. */
  private final Distribution1d distribution;

  /**
   * The emitters with fixed probabilities: the far group, or all emitters if there is no near
   * group.
   */
  private final int[] alone;

  /** The index in the distribution of each emitter, or {@link #NEAR} or {@link #NEVER}. */
  private final int[] places;

  private final Optional<NearLights> near;

  /** The number of emitters that are ever selected. */
  private final int selectable;

  /** One of them; -1 if there is none. */
  private final int only;

  /** The sum over the far group, in units of the near group's mean intensity. */
  private final double farIrradiance;

  /** Creates a sampler with the same probabilities at all points. */
  private LightSampler(Distribution1d distribution, int[] alone, int[] places) {
    this.distribution = distribution;
    this.alone = alone;
    this.places = places;
    near = Optional.empty();
    farIrradiance = 0;
    selectable = alone.length;
    only = selectable == 0 ? -1 : alone[0];
  }

  /**
   * Creates a sampler whose probabilities depend on the point.
   *
   * @param far indices of the far emitters
   * @param items the near emitters, at least one
   */
  private LightSampler(List<Light> emitters, int[] far, List<LightTreeBuilder.Item> items) {
    distribution = far(emitters, far);
    alone = far;
    places = places(emitters.size(), far);
    items.forEach(item -> places[item.emitter()] = NEAR);
    double unit =
        items.stream().mapToDouble(item -> item.bounds().intensity()).average().orElseThrow();
    near = Optional.of(near(comparable(items, unit), emitters.size()));
    farIrradiance =
        IntStream.of(far).mapToDouble(i -> emitters.get(i).farIrradiance()).sum() / unit;
    selectable = items.size() + far.length;
    only = items.get(0).emitter();
  }

  /** Returns the place in {@code far} of each of {@code count} emitters, {@link #NEVER} if none. */
  private static int[] places(int count, int[] far) {
    int[] places = new int[count];
    Arrays.fill(places, NEVER);
    for (int place = 0; place < far.length; place++) {
      places[far[place]] = place;
    }
    return places;
  }

  /**
   * Returns a sampler that makes half of its choices in proportion to power and half uniformly,
   * with the same probabilities at all points.
   *
   * @param powers at least one value; each at least 0; if any is infinite, all choices are uniform
   */
  public static LightSampler byPower(double... powers) {
    int[] all = IntStream.range(0, powers.length).toArray();
    double[] shares = new double[powers.length];
    Arrays.fill(shares, 1);
    return new LightSampler(halfEven(powers, shares), all, all);
  }

  /**
   * Returns a sampler for a scene's emitters, which it identifies by their indices in the list.
   *
   * @param emitters may be empty
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
    int[] far =
        IntStream.range(0, emitters.size())
            .filter(i -> emitters.get(i).bounds().isEmpty() && !isEven(emitters.get(i)))
            .toArray();
    if (!items.isEmpty()) {
      return new LightSampler(emitters, far, items);
    }
    return new LightSampler(far(emitters, far), far, places(emitters.size(), far));
  }

  /** Returns the distribution over the far group. */
  private static Distribution1d far(List<Light> emitters, int[] far) {
    return far.length == 0
        ? new Distribution1d(1)
        : halfEven(
            IntStream.of(far).mapToDouble(i -> emitters.get(i).farIrradiance()).toArray(),
            IntStream.of(far).mapToDouble(i -> choiceShare(emitters.get(i))).toArray());
  }

  private static double choiceShare(Light light) {
    return light instanceof EnvironmentLight environment ? environment.choiceShare() : 1;
  }

  private static boolean isEven(Light light) {
    return light instanceof EnvironmentLight environment && environment.isEven();
  }

  /** Returns whether there is an emitter to select. */
  public boolean canChoose() {
    return near.isPresent() || alone.length > 0;
  }

  /**
   * Returns whether the emitter that {@link #choose} selects depends on its random number: whether
   * there are several to select from.
   */
  public boolean isRandom() {
    return selectable > 1;
  }

  private static NearLights near(List<LightTreeBuilder.Item> items, int count) {
    return items.size() <= FewLights.MOST
        ? new FewLights(items, count)
        : new LightTree(items, count);
  }

  /** Returns the emitters with intensities relative to their mean, at least {@link #LEAST}. */
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

  /**
   * Returns a distribution, half of it by power.
   *
   * @param shares weights of the other half, at least one positive
   */
  private static Distribution1d halfEven(double[] powers, double[] shares) {
    double sum = Arrays.stream(powers).sum();
    boolean isKnown = sum > 0 && Double.isFinite(sum);
    double total = Arrays.stream(shares).sum();
    double[] weights = new double[powers.length];
    for (int i = 0; i < weights.length; i++) {
      double even = shares[i] / total;
      weights[i] = EVEN_SHARE * even + (1 - EVEN_SHARE) * (isKnown ? powers[i] / sum : even);
    }
    return new Distribution1d(weights);
  }

  /** How the emitters of the near group are selected. */
  public enum Method {
    /** With the same probabilities at all points; there is no near group. */
    FIXED,
    /** By the estimated irradiance of each of a few emitters at the point. */
    ONE_BY_ONE,
    /** By a tree of many emitters, using the estimated irradiance of each node at the point. */
    HIERARCHY
  }

  /** Returns how the emitters of the near group are selected. */
  public Method method() {
    return near.map(n -> n instanceof LightTree ? Method.HIERARCHY : Method.ONE_BY_ONE)
        .orElse(Method.FIXED);
  }

  /**
   * Selects an emitter that may light a point; only if {@link #canChoose}.
   *
   * @param u uniform in [0,1); any number in [0,1) unless {@link #isRandom}
   * @param choice holds the point and receives the result
   */
  public void choose(double u, LightChoice choice) {
    if (selectable == 1) {
      choice.setLazily(only, this);
      return;
    }
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
   * Returns the probability with which {@link #choose} selects an emitter for a point; positive
   * unless the emitter cannot light the point.
   */
  public double probability(LightChoice receiver, int index) {
    int place = places[index];
    if (place == NEVER) {
      return 0;
    }
    double share = nearShare(receiver);
    return place == NEAR
        ? share * near.get().probability(receiver, index)
        : (1 - share) * distribution.probability(place);
  }

  /** Returns the probability of selecting the near group. */
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
    // Both sums may be infinite, for example at a point light.
    return LEAST_NEAR + (1 - LEAST_NEAR - LEAST_FAR) * (share >= 0 ? share : .5);
  }
}
