package io.github.lumbre.model.difference;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.difference.ShapeMatch.Motion;
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
   * A motion that may be the one.
   *
   * @param score the less, the better
   */
  private record Tried(Rigid rigid, boolean isInPlace, double score) {}

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
    List<Tried> all = new ArrayList<>();
    for (Vec3 offset : offsets(still)) {
      Rigid rigid = Rigid.shift(offset);
      boolean isInPlace = offset == still;
      // A part that did not move is not moved by the rounding of a fit.
      all.add(new Tried(rigid, isInPlace, farthest(rigid) * (isInPlace ? .5 : 1)));
    }
    all.sort(Comparator.comparingDouble(Tried::score));
    return all.stream()
        .flatMap(tried -> found(tried).stream())
        .findFirst()
        .or(this::rotated);
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

  /** Returns the largest distance of samples after a motion; infinite if one is too far. */
  private double farthest(Rigid rigid) {
    TriangleTree.Nearest nearest = new TriangleTree.Nearest();
    double most = 0;
    for (Vec3 sample : samples) {
      after.find(rigid.apply(sample), APART * size, nearest);
      if (nearest.triangle() < 0) {
        return Double.POSITIVE_INFINITY;
      }
      most = Math.max(most, nearest.distance());
    }
    return most;
  }

  /** Returns a motion of offsets from centroids, if it lays the surfaces on each other. */
  private Optional<Found> found(Tried tried) {
    if (tried.score == Double.POSITIVE_INFINITY) {
      return Optional.empty();
    }
    Rigid rigid = tried.rigid;
    OptionalDouble apart = apart(rigid);
    if (apart.isEmpty()) {
      return Optional.empty();
    }
    Vec3 shift = now.centroid().minus(old.centroid()).plus(rigid.offset());
    return Optional.of(
        new Found(
            rigid.motion(tried.isInPlace ? Vec3.ZERO : shift),
            apart.getAsDouble(),
            tried.isInPlace));
  }

  /** Returns a bound of the distance of the surfaces; empty if it is too large. */
  private OptionalDouble apart(Rigid rigid) {
    SurfaceDistance distance = new SurfaceDistance(APART * size, steps);
    OptionalDouble there = distance.of(before, rigid::apply, after);
    OptionalDouble back =
        there.isPresent() ? distance.of(after, rigid::inverse, before) : OptionalDouble.empty();
    steps = distance.left();
    return back.isEmpty()
        ? back
        : OptionalDouble.of(Math.max(there.getAsDouble(), back.getAsDouble()));
  }

  private Optional<Found> rotated() {
    double far = size / 4;
    List<Tried> all = new ArrayList<>();
    for (Rigid rigid : rotations(Inertia.of(before), Inertia.of(after))) {
      all.add(new Tried(rigid, false, Fit.score(samples, rigid, after, far)));
    }
    steps -= (long) samples.size() * (all.size() + MOST_REFINED * Fit.ROUNDS);
    all.sort(Comparator.comparingDouble(Tried::score));
    return all.stream()
        .limit(MOST_REFINED)
        .map(tried -> Fit.of(samples, tried.rigid, after, size, false))
        .flatMap(refined -> found(new Tried(refined, false, farthest(refined))).stream())
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
