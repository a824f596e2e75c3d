package io.github.lumbre.difference;

import io.github.lumbre.difference.PartChange.Kind;
import io.github.lumbre.limit.internal.Interrupts;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.text.PrintableText;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.BiPredicate;
import java.util.function.Function;

/**
 * Pairs the parts of two models: by names that their files state, then by shape. The order of
 * parts, vertices and triangles does not matter, nor how a surface is divided into triangles.
 * Mutable; not reusable.
 */
public final class ModelDifference {
  /** The default tolerance, relative to the diagonal of the box around both models. */
  private static final double TOLERANCE = 5e-6;

  private final double tolerance;
  private final Set<PartShape> old;
  private final Set<PartShape> now;
  private final Map<String, List<PartShape>> byName = new HashMap<>();
  private final List<PartChange> changes = new ArrayList<>();
  private int same;

  private ModelDifference(List<PartShape> old, List<PartShape> now, double tolerance) {
    this.old = new LinkedHashSet<>(old);
    this.now = new LinkedHashSet<>(now);
    now.forEach(part -> byName.computeIfAbsent(part.stated(), n -> new ArrayList<>()).add(part));
    this.tolerance = tolerance;
  }

  /**
   * What was found.
   *
   * @param changes the added, removed, moved, changed and renamed parts, in this order
   * @param same the number of parts that are the same
   */
  public record Result(List<PartChange> changes, int same) {
    public Result {
      changes = List.copyOf(changes);
    }
  }

  /**
   * Compares two models.
   *
   * @param tolerance largest distance of vertices that count as the same, in world units, &gt; 0
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Result between(Model old, Model now, double tolerance) {
    return between(PartShapes.of(old), PartShapes.of(now), tolerance);
  }

  /** Returns a tolerance above the rounding of usual exporters: of the size of both models. */
  public static double tolerance(Model old, Model now) {
    Bounds3 box = PartShapes.box(old).union(PartShapes.box(now));
    return Math.max(Double.MIN_NORMAL, TOLERANCE * box.max().minus(box.min()).length());
  }

  /**
   * Compares the parts of two models.
   *
   * @param tolerance largest distance of vertices that count as the same, in world units, &gt; 0
   */
  static Result between(List<PartShape> old, List<PartShape> now, double tolerance) {
    return new ModelDifference(old, now, tolerance).result();
  }

  private Result result() {
    // Names that the files state come first, so that equal parts are not exchanged.
    BiPredicate<PartShape, PartShape> isLike = (a, b) -> a.isLike(b, tolerance);
    Rule reshaped = (a, b) -> Optional.of(reshaped(a, b));
    pair(this::namesakes, this::isNear, this::same);
    pair(this::namesakes, isLike, this::moved);
    pair(part -> now, this::isNear, this::same);
    pair(this::namesakes, ModelDifference::isNamesake, reshaped);
    pair(part -> now, isLike, this::moved);
    pair(part -> now, ModelDifference::isSamePlace, reshaped);
    old.forEach(part -> add(Kind.REMOVED, Optional.of(part), Optional.empty()));
    now.forEach(part -> add(Kind.ADDED, Optional.empty(), Optional.of(part)));
    changes.sort(Comparator.comparing(PartChange::kind).thenComparing(change -> change.name()));
    return new Result(changes, same);
  }

  private void add(Kind kind, Optional<PartShape> before, Optional<PartShape> after) {
    changes.add(
        new PartChange(
            kind, before.map(PartShape::name), after.map(PartShape::name), 0, 0, List.of()));
  }

  /** What happened to the parts of a pair; empty if they are none, absent if nothing happened. */
  private interface Rule extends BiFunction<PartShape, PartShape, Optional<Optional<PartChange>>> {}

  private Collection<PartShape> namesakes(PartShape part) {
    return part.stated().isEmpty() ? List.of() : byName.getOrDefault(part.stated(), List.of());
  }

  /**
   * Takes pairs out of the parts that are left, the nearest ones first.
   *
   * @param among returns the new parts that may be the same part as an old one
   * @param mayBe a quick test
   */
  private void pair(
      Function<PartShape, Collection<PartShape>> among,
      BiPredicate<PartShape, PartShape> mayBe,
      Rule rule) {
    boolean isComplete;
    int left;
    do {
      left = old.size();
      Candidates candidates = new Candidates(left);
      for (PartShape before : old) {
        candidates.add(
            before, among.apply(before), after -> now.contains(after) && mayBe.test(before, after));
      }
      candidates.nearestFirst().forEach(candidate -> pair(candidate, rule));
      isComplete = candidates.areComplete();
    } while (!isComplete && old.size() < left);
  }

  private void pair(Candidates.Candidate pair, Rule rule) {
    if (old.contains(pair.before()) && now.contains(pair.after())) {
      Interrupts.check();
      rule.apply(pair.before(), pair.after())
          .ifPresent(
              change -> {
                change.ifPresentOrElse(changes::add, () -> same++);
                old.remove(pair.before());
                now.remove(pair.after());
              });
    }
  }

  private static boolean isNamesake(PartShape a, PartShape b) {
    return !a.stated().isEmpty() && a.stated().equals(b.stated());
  }

  private static boolean isNameless(PartShape a, PartShape b) {
    return a.stated().isEmpty() || b.stated().isEmpty();
  }

  private boolean isNear(PartShape a, PartShape b) {
    return a.centroid().minus(b.centroid()).length() <= 4 * tolerance && a.isLike(b, tolerance);
  }

  private Optional<Optional<PartChange>> same(PartShape a, PartShape b) {
    return new ShapeMatch(a, b, tolerance).isInPlace()
        ? Optional.of(changed(a, b))
        : Optional.empty();
  }

  /** Returns what is different in two parts of the same shape at the same place. */
  private static Optional<PartChange> changed(PartShape a, PartShape b) {
    boolean isRecolored = a.isRecolored(b);
    boolean isRenamed = !isNameless(a, b) && !isNamesake(a, b);
    if (!isRecolored && !isRenamed) {
      return Optional.empty();
    }
    return Optional.of(
        new PartChange(
            isRecolored ? Kind.CHANGED : Kind.RENAMED,
            Optional.of(a.name()),
            Optional.of(b.name()),
            0,
            0,
            isRecolored ? List.of("another material") : List.of()));
  }

  private Optional<Optional<PartChange>> moved(PartShape a, PartShape b) {
    return new ShapeMatch(a, b, tolerance)
        .motion()
        .map(
            motion ->
                Optional.of(
                    new PartChange(
                        Kind.MOVED,
                        Optional.of(a.name()),
                        Optional.of(b.name()),
                        motion.shift().length(),
                        motion.degrees(),
                        a.isRecolored(b) ? List.of("another material") : List.of())));
  }

  private static Optional<PartChange> reshaped(PartShape a, PartShape b) {
    List<String> details = new ArrayList<>();
    addChange("triangles", "" + a.triangles(), "" + b.triangles(), details);
    addChange("size", size(a.bounds()), size(b.bounds()), details);
    addChange("area", number(a.area()), number(b.area()), details);
    if (details.isEmpty()) {
      details.add("another shape");
    }
    return Optional.of(
        new PartChange(
            Kind.CHANGED,
            Optional.of(a.name()),
            Optional.of(b.name()),
            b.centroid().minus(a.centroid()).length(),
            0,
            details));
  }

  private static void addChange(String name, String before, String after, List<String> details) {
    if (!before.equals(after)) {
      details.add(name + " " + before + " to " + after);
    }
  }

  private static String size(Bounds3 bounds) {
    Vec3 size = bounds.max().minus(bounds.min());
    return number(size.x()) + " x " + number(size.y()) + " x " + number(size.z());
  }

  private static String number(double value) {
    return PrintableText.number(rounded(value));
  }

  /** Rounds to five significant digits. */
  private static double rounded(double value) {
    return new BigDecimal(value, new MathContext(5)).doubleValue();
  }

  /** Returns whether parts without names have their centroids in each other's boxes. */
  private static boolean isSamePlace(PartShape a, PartShape b) {
    return isNameless(a, b)
        && contains(a.bounds(), b.centroid())
        && contains(b.bounds(), a.centroid());
  }

  private static boolean contains(Bounds3 box, Vec3 point) {
    return Bounds3.of(point).union(box).equals(box);
  }
}
