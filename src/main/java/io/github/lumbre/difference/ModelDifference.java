package io.github.lumbre.difference;

import io.github.lumbre.difference.PartChange.Kind;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;

/**
 * Pairs the parts of two models: by names that their files state, then by shape. The order of
 * parts, vertices and triangles does not matter, nor how a surface is divided into triangles.
 * Mutable; not reusable.
 */
public final class ModelDifference {
  /** The default tolerance, relative to the diagonal of both models. */
  public static final double TOLERANCE = 5e-6;

  private final double tolerance;
  private final Set<PartShape> old;
  private final Set<PartShape> now;
  private final List<PartChange> changes = new ArrayList<>();
  private int same;

  private ModelDifference(List<PartShape> old, List<PartShape> now, double tolerance) {
    this.old = new LinkedHashSet<>(old);
    this.now = new LinkedHashSet<>(now);
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
   */
  static Result between(List<PartShape> old, List<PartShape> now, double tolerance) {
    return new ModelDifference(old, now, tolerance).result();
  }

  private Result result() {
    // Names that the files state come first, so that equal parts are not exchanged.
    pair((a, b) -> isNamesake(a, b) && isSame(a, b) ? Optional.of(changed(a, b)) : none());
    pair((a, b) -> isNamesake(a, b) ? moved(a, b) : none());
    pair((a, b) -> isSame(a, b) ? Optional.of(changed(a, b)) : none());
    pair((a, b) -> isNamesake(a, b) ? Optional.of(reshaped(a, b)) : none());
    pair(this::moved);
    pair((a, b) -> isNameless(a, b) && overlaps(a, b) ? Optional.of(reshaped(a, b)) : none());
    old.forEach(part -> add(Kind.REMOVED, Optional.of(part), Optional.empty()));
    now.forEach(part -> add(Kind.ADDED, Optional.empty(), Optional.of(part)));
    changes.sort(Comparator.comparing(PartChange::kind).thenComparing(change -> change.name()));
    return new Result(changes, same);
  }

  private static Optional<Optional<PartChange>> none() {
    return Optional.empty();
  }

  private void add(Kind kind, Optional<PartShape> before, Optional<PartShape> after) {
    changes.add(
        new PartChange(
            kind, before.map(PartShape::name), after.map(PartShape::name), 0, 0, List.of()));
  }

  /**
   * Takes pairs out of the parts that are left.
   *
   * @param rule empty if two parts are no pair; else what happened, which is nothing if they are
   *     the same
   */
  private void pair(BiFunction<PartShape, PartShape, Optional<Optional<PartChange>>> rule) {
    for (PartShape before : List.copyOf(old)) {
      for (PartShape after : now) {
        Optional<Optional<PartChange>> found = rule.apply(before, after);
        if (found.isPresent()) {
          found.get().ifPresentOrElse(changes::add, () -> same++);
          old.remove(before);
          now.remove(after);
          break;
        }
      }
    }
  }

  private static boolean isNamesake(PartShape a, PartShape b) {
    return a.isNamed() && b.isNamed() && a.name().equals(b.name());
  }

  private static boolean isNameless(PartShape a, PartShape b) {
    return !(a.isNamed() && b.isNamed());
  }

  private boolean isSame(PartShape a, PartShape b) {
    return a.centroid().minus(b.centroid()).length() <= 4 * tolerance
        && a.isLike(b, tolerance)
        && new ShapeMatch(a, b, tolerance).isInPlace();
  }

  /** Returns what is different in two parts of the same shape at the same place. */
  private static Optional<PartChange> changed(PartShape a, PartShape b) {
    boolean isRecolored = !a.materials().equals(b.materials());
    boolean isRenamed = a.isNamed() && b.isNamed() && !a.name().equals(b.name());
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
    if (!a.isLike(b, tolerance)) {
      return Optional.empty();
    }
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
                        a.materials().equals(b.materials())
                            ? List.of()
                            : List.of("another material"))));
  }

  private static Optional<PartChange> reshaped(PartShape a, PartShape b) {
    List<String> details = new ArrayList<>();
    if (a.triangles() != b.triangles()) {
      details.add("triangles %d to %d".formatted(a.triangles(), b.triangles()));
    }
    Vec3 before = a.bounds().max().minus(a.bounds().min());
    Vec3 after = b.bounds().max().minus(b.bounds().min());
    if (!before.equals(after)) {
      details.add("size " + text(before) + " to " + text(after));
    }
    details.add("area %s to %s".formatted(number(a.area()), number(b.area())));
    return Optional.of(
        new PartChange(
            Kind.CHANGED,
            Optional.of(a.name()),
            Optional.of(b.name()),
            b.centroid().minus(a.centroid()).length(),
            0,
            details));
  }

  private static String text(Vec3 size) {
    return number(size.x()) + " x " + number(size.y()) + " x " + number(size.z());
  }

  private static String number(double value) {
    return io.github.lumbre.text.PrintableText.number(rounded(value));
  }

  /** Rounds to five significant digits. */
  private static double rounded(double value) {
    return new java.math.BigDecimal(value, new java.math.MathContext(5)).doubleValue();
  }

  private static boolean overlaps(PartShape a, PartShape b) {
    Bounds3 one = a.bounds();
    Bounds3 other = b.bounds();
    return one.min().x() <= other.max().x()
        && other.min().x() <= one.max().x()
        && one.min().y() <= other.max().y()
        && other.min().y() <= one.max().y()
        && one.min().z() <= other.max().z()
        && other.min().z() <= one.max().z();
  }
}
