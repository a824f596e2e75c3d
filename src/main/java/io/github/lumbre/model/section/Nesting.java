package io.github.lumbre.model.section;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelPart;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntPredicate;

/**
 * Finds which closed shells of a body are inside out. A shell with a negative volume is a cavity if
 * it lies in other shells; otherwise its triangles face inwards, and it is turned over. What lies
 * in a shell that is turned over counts by its depth: a cavity in a solid, a solid in a cavity.
 * Confined to one thread.
 */
final class Nesting {
  /** A shell lies in another one if less than this part of its area is outside. */
  private static final double OUTSIDE = .02;

  /** The most surfaces that rays pass; beyond, shells stay as they are. */
  private static final int MOST_PASSED = 10_000_000;

  /** The most triangles of a shell that are looked up. */
  private static final int MOST_SAMPLES = 200;

  /** A direction that is parallel to no edge of usual parts. */
  private static final Vec3 RAY = new Vec3(.4153, .7297, .5431).normalized();

  /** Beyond all shells, which have a size of 1. */
  private static final double FAR = 10;

  private final List<Solid> solids;
  private final Bvh tree;
  private final NearestHit hit = new NearestHit();
  private final BitSet turned = new BitSet();
  private boolean isContradicted;
  private int passed;

  /** A point in a triangle of some area, and the numbers of the other shells around it. */
  private record Sample(double area, Set<Integer> around) {}

  private Nesting(List<Solid> solids) {
    this.solids = solids;
    tree = Bvh.over(solids.stream().map(solid -> Mesh.of(solid.triangles())).toList());
  }

  /**
   * Which shells are inside out.
   *
   * @param turned the numbers of the shells
   * @param isGuess whether shells contradict each other, or are too many
   */
  record Result(BitSet turned, boolean isGuess) {}

  /** Finds the shells of a body that are inside out. */
  static Result of(List<ModelPart> meshes, Shells shells) {
    List<Solid> solids = Solid.of(meshes, shells);
    if (solids.isEmpty()) {
      return new Result(new BitSet(), false);
    }
    Nesting nesting = new Nesting(solids);
    nesting.turnOuter();
    if (!nesting.turned.isEmpty()) {
      nesting.turnInner();
    }
    BitSet turned = new BitSet();
    nesting.turned.stream().forEach(i -> turned.set(solids.get(i).shell()));
    return new Result(turned, nesting.isContradicted || nesting.passed == MOST_PASSED);
  }

  /** Turns shells over that are inside out and do not lie in others. */
  private void turnOuter() {
    for (int i = 0; i < solids.size() && passed < MOST_PASSED; i++) {
      if (solids.get(i).isInsideOut() && !isIn(samples(i), other -> true)) {
        turned.set(i);
      }
    }
  }

  /** Turns shells over that lie in these, unless they are cavities at odd depths. */
  private void turnInner() {
    BitSet outer = (BitSet) turned.clone();
    for (int i = 0; i < solids.size() && passed < MOST_PASSED; i++) {
      List<Sample> samples = outer.get(i) ? List.of() : samples(i);
      if (!samples.isEmpty() && isIn(samples, outer::get)) {
        long depth = Math.max(1, depth(samples));
        boolean isTurned = depth % 2 == 0 == solids.get(i).isInsideOut();
        turned.set(i, isTurned);
        // A file that is inside out as a whole has no other shells.
        isContradicted |= !isTurned;
      }
    }
  }

  /** Returns the number of shells around all samples. */
  private static long depth(List<Sample> samples) {
    return samples.stream()
        .flatMap(sample -> sample.around.stream())
        .distinct()
        .filter(shell -> isIn(samples, other -> other == shell))
        .count();
  }

  private static boolean isIn(List<Sample> samples, IntPredicate shells) {
    double all = 0;
    double outside = 0;
    for (Sample sample : samples) {
      all += sample.area;
      outside += sample.around.stream().noneMatch(shells::test) ? sample.area : 0;
    }
    return outside <= OUTSIDE * all;
  }

  /** Returns points just inside of a shell, with the other shells around them. */
  private List<Sample> samples(int shell) {
    Solid solid = solids.get(shell);
    int count = solid.triangles().triangleCount();
    int step = (count + MOST_SAMPLES - 1) / MOST_SAMPLES;
    List<Sample> samples = new ArrayList<>();
    for (int t = 0; t < count; t += step) {
      Interrupts.check();
      samples.add(new Sample(solid.normal(t).length(), around(solid.inside(t), shell)));
    }
    return samples;
  }

  private Set<Integer> around(Vec3 point, int shell) {
    Map<Integer, Integer> windings = new HashMap<>();
    hit.aim(point.x(), point.y(), point.z(), RAY.x(), RAY.y(), RAY.z(), FAR);
    while (passed < MOST_PASSED && tree.intersect(hit)) {
      passed++;
      int side = solids.get(hit.shape()).normal(hit.element()).dot(RAY) > 0 ? 1 : -1;
      windings.merge(hit.shape(), side, Integer::sum);
      hit.pass();
    }
    windings.remove(shell);
    windings.values().removeIf(winding -> winding == 0);
    return windings.keySet();
  }
}
