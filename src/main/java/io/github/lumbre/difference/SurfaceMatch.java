package io.github.lumbre.difference;

import io.github.lumbre.difference.ShapeMatch.Motion;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Finds the motion that lays one surface on another one that may be divided into other triangles:
 * a shift, or a rotation that the axes of inertia suggest. Mirrored surfaces are others. Confined
 * to one thread.
 */
final class SurfaceMatch {
  /** The largest distance of surfaces of the same part, relative to its size. */
  private static final double APART = 1e-3;

  /** Surfaces whose areas, or sizes, differ by more than this are not tried. */
  private static final double ALIKE = .02;

  /** Points that decide whether a motion is tried. */
  private static final int SAMPLES = 150;

  /** Moments of inertia within this part of each other have no axes of their own. */
  private static final double ROUND = .03;

  /** The angles that are tried about an axis of symmetry, in degrees. */
  private static final int STEP_DEGREES = 3;

  /** The rotations that are refined. */
  private static final int MOST_REFINED = 6;

  private final PartShape old;
  private final PartShape now;
  private final TriangleTree before;
  private final TriangleTree after;
  private final List<Vec3> samples;
  private final double size;
  private long steps;

  /**
   * A motion, with a bound of the distance of the surfaces after it.
   *
   * @param isInPlace whether the part did not move
   */
  record Found(Motion motion, double distance, boolean isInPlace) {}

  /**
   * @param before the triangles of the old part, relative to its centroid
   * @param after the triangles of the new part, relative to its centroid
   * @param steps the most work
   */
  SurfaceMatch(
      PartShape old, PartShape now, TriangleTree before, TriangleTree after, long steps) {
    this.old = old;
    this.now = now;
    this.before = before;
    this.after = after;
    this.steps = steps;
    size = Math.min(diagonal(old.bounds()), diagonal(now.bounds()));
    samples = samples(before);
  }

  private static double diagonal(Bounds3 box) {
    return box.max().minus(box.min()).length();
  }

  /** Returns whether surfaces may be the same after a motion: numbers of both are alike. */
  static boolean mayBe(PartShape a, PartShape b) {
    return a.triangles() > 0
        && b.triangles() > 0
        && isAlike(a.area(), b.area())
        && isAlike(a.spread(), b.spread());
  }

  private static boolean isAlike(double one, double other) {
    return Math.abs(one - other) <= ALIKE * Math.max(one, other);
  }

  private static List<Vec3> samples(TriangleTree tree) {
    int step = Math.max(1, tree.count() / SAMPLES);
    List<Vec3> samples = new ArrayList<>();
    for (int t = 0; t < tree.count(); t += step) {
      samples.add(tree.corner(t, 0));
      Vec3 sum = tree.corner(t, 0).plus(tree.corner(t, 1)).plus(tree.corner(t, 2));
      samples.add(sum.times(1. / 3));
    }
    return samples;
  }

  /** Returns how much work is left. */
  long steps() {
    return steps;
  }

  Optional<Found> find() {
    steps -= (long) samples.size() * Fit.ROUNDS;
    Vec3 still = old.centroid().minus(now.centroid());
    Optional<Found> best = Optional.empty();
    for (Vec3 offset : offsets(still)) {
      Optional<Found> found = found(Rigid.shift(offset), offset == still);
      boolean isBetter =
          found.isPresent()
              && (best.isEmpty()
                  || found.get().distance
                      < best.get().distance * (best.get().isInPlace ? .5 : 1));
      best = isBetter ? found : best;
    }
    return best.isPresent() ? best : rotated();
  }

  /** Returns the offsets that lay no motion, centroids, or sides of boxes on each other. */
  private List<Vec3> offsets(Vec3 still) {
    Vec3 low = now.bounds().min().minus(now.centroid());
    Vec3 high = now.bounds().max().minus(now.centroid());
    Vec3 oldLow = old.bounds().min().minus(old.centroid());
    Vec3 oldHigh = old.bounds().max().minus(old.centroid());
    Vec3 lows = low.minus(oldLow);
    Vec3 highs = high.minus(oldHigh);
    List<Vec3> offsets = new ArrayList<>(List.of(lows.plus(highs).times(.5), lows, highs));
    offsets.add(0, still);
    offsets.add(Vec3.ZERO);
    offsets.add(Fit.of(samples, Rigid.shift(Vec3.ZERO), after, size, true).offset());
    return offsets;
  }

  /** Returns a motion of offsets from centroids, if it lays the surfaces on each other. */
  private Optional<Found> found(Rigid rigid, boolean isInPlace) {
    double limit = APART * size;
    TriangleTree.Nearest nearest = new TriangleTree.Nearest();
    for (Vec3 sample : samples) {
      after.find(rigid.apply(sample), limit, nearest);
      if (nearest.triangle() < 0) {
        return Optional.empty();
      }
    }
    OptionalDouble apart = apart(rigid, limit);
    if (apart.isEmpty()) {
      return Optional.empty();
    }
    Vec3 shift = now.centroid().minus(old.centroid()).plus(rigid.offset());
    return Optional.of(
        new Found(
            rigid.motion(isInPlace ? Vec3.ZERO : shift),
            apart.getAsDouble(),
            isInPlace));
  }

  /** Returns a bound of the distance of the surfaces; empty if it is above a limit. */
  private OptionalDouble apart(Rigid rigid, double limit) {
    SurfaceDistance distance = new SurfaceDistance(limit, steps);
    OptionalDouble there = distance.of(before, rigid::apply, after);
    OptionalDouble back =
        there.isPresent() ? distance.of(after, rigid::inverse, before) : OptionalDouble.empty();
    steps = distance.left();
    return back.isEmpty()
        ? back
        : OptionalDouble.of(Math.max(there.getAsDouble(), back.getAsDouble()));
  }

  private Optional<Found> rotated() {
    record Tried(Rigid rigid, double score) {}
    double far = size / 4;
    List<Tried> all = new ArrayList<>();
    for (Rigid rigid : rotations(Inertia.of(before), Inertia.of(after))) {
      all.add(new Tried(rigid, Fit.score(samples, rigid, after, far)));
    }
    steps -= (long) samples.size() * (all.size() + MOST_REFINED * Fit.ROUNDS);
    all.sort(Comparator.comparingDouble(Tried::score));
    return all.stream()
        .limit(MOST_REFINED)
        .map(tried -> Fit.of(samples, tried.rigid, after, size, false))
        .flatMap(refined -> found(refined, false).stream())
        .min(Comparator.comparingDouble(found -> found.motion.degrees()));
  }

  /** Returns rotations that lay axes of inertia on each other. */
  private static List<Rigid> rotations(Inertia one, Inertia other) {
    List<Rigid> rotations = new ArrayList<>();
    Frame from = one.axes();
    Frame to = other.axes();
    int step = one.isRound(ROUND) ? STEP_DEGREES : 180;
    for (int flip = 0; flip < 2; flip++) {
      Vec3 axis = flip == 0 ? to.normal() : to.normal().negated();
      for (int degrees = 0; degrees < 360; degrees += step) {
        Vec3 x =
            to.tangent()
                .times(Elementary.cosDegrees(degrees))
                .plus(Elementary.sinDegrees(degrees), axis.cross(to.tangent()));
        rotations.add(new Rigid(from, new Frame(x, axis.cross(x), axis), Vec3.ZERO));
      }
    }
    return rotations;
  }
}
