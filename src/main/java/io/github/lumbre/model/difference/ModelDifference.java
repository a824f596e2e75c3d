package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.difference.PartChange.Kind;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelMotions;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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

  /** The work to find parts with other triangles: some seconds. */
  private static final long MOST_STEPS = 10_000_000;

  private final double tolerance;
  private final FileSpace space;
  private final List<PartShape> allOld;
  private final List<PartShape> allNow;
  private final Set<PartShape> old;
  private final Set<PartShape> now;
  private final Map<String, List<PartShape>> byName = new HashMap<>();
  private final List<PartChange> changes = new ArrayList<>();
  private final List<MovedGroups.Moved> moves = new ArrayList<>();
  private final Set<String> notCompared = new LinkedHashSet<>();
  private final Map<PartShape, TriangleTree> trees = new HashMap<>();
  private long steps = MOST_STEPS;
  private boolean hasLook = true;
  private int same;

  private ModelDifference(
      List<PartShape> old, List<PartShape> now, double tolerance, FileSpace space) {
    this.space = space;
    allOld = old;
    allNow = now;
    this.old = new LinkedHashSet<>(old);
    this.now = new LinkedHashSet<>(now);
    now.forEach(part -> byName.computeIfAbsent(part.stated(), n -> new ArrayList<>()).add(part));
    this.tolerance = tolerance;
  }

  /**
   * What was found.
   *
   * @param changes the added, removed, moved, changed and renamed parts, in this order
   * @param same the number of parts in which no change was found
   * @param space in which lengths are stated
   * @param notCompared what the files hold that was not compared, in words; empty if nothing is
   *     left
   */
  public record Result(
      List<PartChange> changes, int same, FileSpace space, List<String> notCompared) {
    public Result {
      changes = List.copyOf(changes);
      notCompared = List.copyOf(notCompared);
    }
  }

  /**
   * A model, and what its file holds beside it.
   *
   * @param motions what the file states of its motion
   */
  public record Side(Model model, ModelMotions motions) {
    private Set<String> notCompared() {
      Set<String> all = new LinkedHashSet<>();
      motions.deformations().forEach(each -> all.add(each + " beyond the pose that is shown"));
      if (motions.keys().size() < model.animations().size()) {
        all.add("keys of animations in archives");
      }
      if (!model.warnings().isEmpty()) {
        all.add("what the warnings name");
      }
      return all;
    }
  }

  /**
   * Compares two models.
   *
   * @param tolerance largest distance of vertices that count as the same, in world units, &gt; 0
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static Result between(Side old, Side now, double tolerance) {
    FileSpace space = space(now.model);
    ModelDifference difference =
        new ModelDifference(
            PartShapes.of(old.model), PartShapes.of(now.model), tolerance, space);
    difference.notCompared.addAll(old.notCompared());
    difference.notCompared.addAll(now.notCompared());
    difference.hasLook =
        isBare(old.model, difference.allOld) == isBare(now.model, difference.allNow);
    if (!difference.hasLook) {
      difference.notCompared.add("normals, textures, colors and materials, which one file lacks");
    }
    if (!old.model.variants().isEmpty() && !now.model.variants().isEmpty()) {
      difference.notCompared.add("materials of variants that are not shown");
    }
    difference.changes.addAll(
        FileItem.changes(
            FileItem.of(old.model, space, old.motions.keys(), tolerance),
            FileItem.of(now.model, space, now.motions.keys(), tolerance)));
    return difference.result();
  }

  /** Returns the axes and the unit of a model's file. */
  public static FileSpace space(Model model) {
    return new FileSpace(model.fromFile(), model.unit());
  }

  /** Returns whether a file states surfaces alone; formats that state a unit also have a look. */
  private static boolean isBare(Model model, List<PartShape> parts) {
    return model.unit().isEmpty() && parts.stream().allMatch(PartShape::isBare);
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
    return new ModelDifference(old, now, tolerance, FileSpace.WORLD).result();
  }

  private Result result() {
    // Names that the files state come first, so that equal parts are not exchanged.
    BiPredicate<PartShape, PartShape> isLike = (a, b) -> a.isLike(b, tolerance);
    pair(this::namesakes, this::isNear, this::same);
    pair(this::namesakes, isLike, this::moved);
    pair(part -> now, this::isNear, this::same);
    pair(this::namesakes, SurfaceMatch::mayBe, this::divided);
    pair(this::namesakes, ModelDifference::isNamesake, this::reshaped);
    pair(part -> now, isLike, this::moved);
    pair(part -> now, SurfaceMatch::mayBe, this::divided);
    pair(part -> now, ModelDifference::isSamePlace, this::reshaped);
    old.forEach(part -> add(Kind.REMOVED, Optional.of(part), Optional.empty()));
    now.forEach(part -> add(Kind.ADDED, Optional.empty(), Optional.of(part)));
    changes.addAll(new MovedGroups(tolerance, space).changes(moves, allOld, allNow));
    changes.sort(Comparator.comparing(PartChange::kind).thenComparing(change -> change.name()));
    return new Result(changes, same, space, List.copyOf(notCompared));
  }

  private void add(Kind kind, Optional<PartShape> before, Optional<PartShape> after) {
    changes.add(
        PartChange.ofPart(
            kind,
            before.map(PartShape::name),
            after.map(PartShape::name),
            Vec3.ZERO,
            0,
            List.of()));
  }

  /** Returns whether two parts are a pair, and adds the change between them to the result. */
  private interface Rule extends BiPredicate<PartShape, PartShape> {}

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
      if (rule.test(pair.before(), pair.after())) {
        old.remove(pair.before());
        now.remove(pair.after());
      }
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

  private boolean same(PartShape a, PartShape b) {
    boolean isSame = new ShapeMatch(a, b, tolerance).isInPlace();
    if (isSame) {
      noteLook(a, b);
    }
    return isSame;
  }

  /** Notes what is different in two parts of the same shape at the same place. */
  private void noteLook(PartShape a, PartShape b) {
    List<String> details = details(a, b, ShapeMatch.Motion.by(Vec3.ZERO));
    boolean isRenamed = !isNameless(a, b) && !isNamesake(a, b);
    if (details.isEmpty() && !isRenamed) {
      same++;
    } else {
      Kind kind = details.isEmpty() ? Kind.RENAMED : Kind.CHANGED;
      changes.add(change(kind, a, b, Vec3.ZERO, 0, details));
    }
  }

  private static PartChange change(
      Kind kind, PartShape a, PartShape b, Vec3 shift, double degrees, List<String> details) {
    return PartChange.ofPart(
        kind, Optional.of(a.name()), Optional.of(b.name()), shift, degrees, details);
  }

  /** Returns what the surfaces of a part state differently, in words. */
  private List<String> details(PartShape a, PartShape b, ShapeMatch.Motion motion) {
    List<String> details = new ArrayList<>();
    if (a.isRecolored(b)) {
      details.add("another material");
    }
    if (a.surfaces().isEmpty() || b.surfaces().isEmpty()) {
      return details;
    }
    Optional<Set<SurfaceValues.Kind>> kinds =
        SurfaceValues.differences(a, b, motion, tolerance, hasLook);
    if (kinds.isEmpty()) {
      notCompared.add("normals, textures and colors of parts with other triangles");
    }
    kinds.orElse(Set.of()).stream()
        .filter(kind -> kind != SurfaceValues.Kind.MATERIALS || details.isEmpty())
        .map(kind -> kind.change)
        .forEach(details::add);
    return details;
  }

  private boolean moved(PartShape a, PartShape b) {
    Optional<ShapeMatch.Motion> motion = new ShapeMatch(a, b, tolerance).motion();
    motion.ifPresent(by -> noteMove(a, b, by, details(a, b, by), 0));
    return motion.isPresent();
  }

  /**
   * Notes a move, which is grouped with others later.
   *
   * @param error of the shift, in world units
   */
  private void noteMove(
      PartShape a, PartShape b, ShapeMatch.Motion motion, List<String> details, double error) {
    Vec3 shift = space.rounded(space.vector(motion.shift()), space.length(error));
    PartChange change = change(Kind.MOVED, a, b, shift, motion.degrees(), details);
    moves.add(new MovedGroups.Moved(a, b, motion, change));
  }

  /** Notes parts whose surfaces are the same, up to their triangles. */
  private boolean divided(PartShape a, PartShape b) {
    if (a.surfaces().isEmpty() || b.surfaces().isEmpty()) {
      return false;
    }
    if (steps <= 0) {
      notCompared.add("parts with other triangles, because there are too many of them");
      return false;
    }
    SurfaceMatch match = new SurfaceMatch(a, b, tree(a), tree(b), steps);
    Optional<SurfaceMatch.Found> found = match.find();
    steps = match.steps() - 1;
    found.ifPresent(motion -> noteDivided(a, b, motion));
    return found.isPresent();
  }

  private TriangleTree tree(PartShape part) {
    return trees.computeIfAbsent(part, PartShape::tree);
  }

  private void noteDivided(PartShape a, PartShape b, SurfaceMatch.Found found) {
    List<String> details = new ArrayList<>();
    addChange("triangles", count(a.triangles()), count(b.triangles()), details);
    details.add("surfaces at most " + space.text(space.length(found.distance())) + " apart");
    if (a.isRecolored(b)) {
      details.add("another material");
    }
    if (hasLook && !(a.isBare() && b.isBare())) {
      notCompared.add("normals, textures and colors of parts with other triangles");
    }
    if (found.isInPlace()) {
      changes.add(change(Kind.CHANGED, a, b, Vec3.ZERO, 0, details));
    } else {
      noteMove(a, b, found.motion(), details, found.distance());
    }
  }

  private boolean reshaped(PartShape a, PartShape b) {
    List<String> details = new ArrayList<>();
    addChange("triangles", count(a.triangles()), count(b.triangles()), details);
    addChange("size", space.size(a), space.size(b), details);
    addChange("area", space.area(a), space.area(b), details);
    if (details.isEmpty()) {
      details.add("another shape");
    }
    if (a.isRecolored(b)) {
      details.add("another material");
    }
    Vec3 shift = space.vector(b.centroid().minus(a.centroid()));
    changes.add(change(Kind.CHANGED, a, b, shift, 0, details));
    return true;
  }

  private static String count(int number) {
    return String.format(Locale.ROOT, "%,d", number);
  }

  private static void addChange(String name, String before, String after, List<String> details) {
    if (!before.equals(after)) {
      details.add(name + " " + before + " to " + after);
    }
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
