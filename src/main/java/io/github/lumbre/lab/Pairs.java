package io.github.lumbre.lab;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * Renders with two settings, in pairs.
 *
 * @param base renders of the baseline, in order
 * @param other renders of the other setting, as many
 */
public record Pairs(List<Trial.Outcome> base, List<Trial.Outcome> other) {
  /** Renders one picture with a setting. */
  public interface Side {
    /**
     * Renders once.
     *
     * @param pair number of the pair
     */
    Trial.Outcome render(int pair) throws InterruptedException;
  }

  /**
   * Renders pairs in alternating order, ABBA, which cancels a drift of the machine.
   *
   * @param from number of the first pair
   * @param to number after the last pair
   */
  public static Pairs of(int from, int to, Side base, Side other) throws InterruptedException {
    Pairs pairs = new Pairs(new ArrayList<>(), new ArrayList<>());
    for (int pair = from; pair < to; pair++) {
      if (pair % 2 == 0) {
        pairs.base.add(base.render(pair));
      }
      pairs.other.add(other.render(pair));
      if (pair % 2 == 1) {
        pairs.base.add(base.render(pair));
      }
    }
    return pairs;
  }

  /** Returns the ratio of a cost of each pair, other over baseline. */
  public List<Double> ratios(ToDoubleFunction<Cost> cost) {
    List<Double> over = others(cost);
    List<Double> under = bases(cost);
    return IntStream.range(0, under.size()).mapToObj(i -> over.get(i) / under.get(i)).toList();
  }

  /** Returns a cost of each render of the baseline. */
  public List<Double> bases(ToDoubleFunction<Cost> cost) {
    return values(base, cost);
  }

  /** Returns a cost of each render of the other setting. */
  public List<Double> others(ToDoubleFunction<Cost> cost) {
    return values(other, cost);
  }

  private static List<Double> values(List<Trial.Outcome> renders, ToDoubleFunction<Cost> cost) {
    return renders.stream().map(render -> cost.applyAsDouble(render.cost())).toList();
  }

  /** Returns whether the two pictures of each pair are bit-identical. */
  public boolean isSamePicture() {
    return IntStream.range(0, base.size())
        .allMatch(i -> Arrays.equals(base.get(i).picture().rgb(), other.get(i).picture().rgb()));
  }
}
