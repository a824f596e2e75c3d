package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.function.Predicate;

/**
 * Parts that may be pairs. If there are too many, only the nearest ones of each old part are kept.
 * Mutable.
 */
final class Candidates {
  /** The most pairs that are kept at once. */
  private static final int MOST = 1_000_000;

  private final int mostOfEach;
  private final List<Candidate> all = new ArrayList<>();
  private boolean areComplete = true;

  /**
   * Two parts that may be a pair.
   *
   * @param order in which it was found
   */
  record Candidate(PartShape before, PartShape after, double distance, int order)
      implements Comparable<Candidate> {
    private static final Comparator<Candidate> NEAREST =
        Comparator.comparingDouble(Candidate::distance).thenComparingInt(Candidate::order);

    @Override
    public int compareTo(Candidate other) {
      return NEAREST.compare(this, other);
    }
  }

  /**
   * @param parts the number of old parts
   */
  Candidates(int parts) {
    mostOfEach = Math.max(1, MOST / Math.max(1, parts));
  }

  /**
   * Adds the pairs of an old part.
   *
   * @param among new parts
   * @param mayBe whether a new part may be the old one
   */
  void add(PartShape before, Collection<PartShape> among, Predicate<PartShape> mayBe) {
    Interrupts.check();
    PriorityQueue<Candidate> nearest = new PriorityQueue<>(Collections.reverseOrder());
    int order = all.size();
    for (PartShape after : among) {
      double distance = after.centroid().minus(before.centroid()).length();
      boolean isFull = nearest.size() == mostOfEach;
      if ((!isFull || areComplete || distance < nearest.peek().distance()) && mayBe.test(after)) {
        nearest.add(new Candidate(before, after, distance, order++));
        if (isFull) {
          nearest.remove();
          areComplete = false;
        }
      }
    }
    all.addAll(nearest);
  }

  /** Returns the pairs, the nearest ones first, and in the order in which they were added. */
  List<Candidate> nearestFirst() {
    Collections.sort(all);
    return all;
  }

  /** Returns whether no pair was left out. */
  boolean areComplete() {
    return areComplete;
  }
}
