package io.github.lumbre.model.difference;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.difference.PartChange.Kind;
import io.github.lumbre.model.difference.PartChange.Subject;
import io.github.lumbre.model.internal.ModelNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Finds nodes all of whose parts moved together, as one rigid body, so that one change stands for
 * all of them. Confined to one thread.
 */
final class MovedGroups {
  /** The parts of a node whose motions are tried for all of them. */
  private static final int MOST_TRIED = 4;

  private final double tolerance;
  private final FileSpace space;

  /** A part that moved. */
  record Moved(PartShape before, PartShape after, ShapeMatch.Motion motion, PartChange change) {
    /** Returns whether nothing but the place of the part changed. */
    private boolean isPlain() {
      return change.details().isEmpty() && change.old().equals(change.now());
    }
  }

  MovedGroups(double tolerance, FileSpace space) {
    this.tolerance = tolerance;
    this.space = space;
  }

  /**
   * Returns changes for parts that moved: one for each node whose parts all moved together.
   *
   * @param old all parts of the old model
   * @param now all parts of the new model
   */
  List<PartChange> changes(List<Moved> moved, List<PartShape> old, List<PartShape> now) {
    Map<ModelNode, Set<PartShape>> below = below(old);
    Map<ModelNode, Set<PartShape>> belowNow = below(now);
    Map<PartShape, Moved> left = new HashMap<>();
    moved.stream().filter(Moved::isPlain).forEach(m -> left.put(m.before, m));
    List<ModelNode> largest =
        below.keySet().stream()
            .filter(node -> below.get(node).size() > 1)
            .sorted(Comparator.comparingInt((ModelNode node) -> -below.get(node).size()))
            .toList();
    List<PartChange> changes = new ArrayList<>();
    Set<PartShape> grouped = new HashSet<>();
    for (ModelNode node : largest) {
      Set<PartShape> parts = below.get(node);
      if (left.keySet().containsAll(parts)) {
        List<Moved> members = old.stream().filter(parts::contains).map(left::get).toList();
        group(node, members, belowNow)
            .ifPresent(
                change -> {
                  changes.add(change);
                  grouped.addAll(parts);
                  parts.forEach(left::remove);
                });
      }
    }
    moved.stream().filter(m -> !grouped.contains(m.before)).forEach(m -> changes.add(m.change));
    return changes;
  }

  /** Returns all parts of each node and of the nodes below it. */
  private static Map<ModelNode, Set<PartShape>> below(List<PartShape> parts) {
    Map<ModelNode, Set<PartShape>> below = new LinkedHashMap<>();
    for (PartShape part : parts) {
      for (Optional<ModelNode> n = parent(part); n.isPresent(); n = n.get().parent()) {
        below.computeIfAbsent(n.get(), node -> new LinkedHashSet<>()).add(part);
      }
    }
    // A node's own surfaces are a part beside it.
    Map<String, List<ModelNode>> named =
        below.keySet().stream().collect(Collectors.groupingBy(ModelNode::name));
    for (PartShape part : parts) {
      List<ModelNode> own =
          named.getOrDefault(part.stated(), List.of()).stream()
              .filter(node -> isOwn(part, node))
              .toList();
      if (own.size() == 1) {
        below.get(own.get(0)).add(part);
      }
    }
    return below;
  }

  private static Optional<ModelNode> parent(PartShape part) {
    return part.node().flatMap(ModelNode::parent);
  }

  /** Returns whether a part of the same name as a node is this node. */
  private static boolean isOwn(PartShape part, ModelNode node) {
    return !node.name().isEmpty() && parent(part).equals(node.parent());
  }

  private Optional<PartChange> group(
      ModelNode node, List<Moved> members, Map<ModelNode, Set<PartShape>> belowNow) {
    Set<PartShape> after = new HashSet<>();
    members.forEach(m -> after.add(m.after));
    boolean isNode =
        belowNow.entrySet().stream()
            .anyMatch(
                other ->
                    other.getKey().label().equals(node.label()) && other.getValue().equals(after));
    if (!isNode) {
      return Optional.empty();
    }
    return members.stream()
        .sorted(Comparator.comparingInt((Moved m) -> -m.before.vertexCount()))
        .limit(MOST_TRIED)
        .filter(m -> members.stream().allMatch(each -> moves(m, each)))
        .findFirst()
        .map(m -> change(node, m, members));
  }

  /** Returns whether the motion of one part moves another one to its place. */
  private boolean moves(Moved by, Moved part) {
    Interrupts.check();
    return new ShapeMatch(part.before, part.after, tolerance)
        .isMatch(p -> moved(by, p));
  }

  private static Vec3 moved(Moved by, Vec3 p) {
    return by.after.centroid().plus(by.motion.rotated(p.minus(by.before.centroid())));
  }

  private PartChange change(ModelNode node, Moved by, List<Moved> members) {
    Vec3 sum = Vec3.ZERO;
    double weight = 0;
    for (Moved m : members) {
      double area = Math.max(m.before.area(), Double.MIN_NORMAL);
      sum = sum.plus(area, m.before.centroid());
      weight += area;
    }
    Vec3 middle = sum.times(1 / weight);
    return new PartChange(
        Kind.MOVED,
        Subject.PART,
        Optional.of(node.label()),
        Optional.of(node.label()),
        space.vector(moved(by, middle).minus(middle)),
        by.motion.degrees(),
        List.of(members.size() + " parts"),
        members.stream().map(m -> m.before.name()).toList(),
        members.stream().map(m -> m.after.name()).toList());
  }
}
