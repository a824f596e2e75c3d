package io.github.lumbre.model.internal;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.explosion.Assembly;
import io.github.lumbre.scene.internal.Names;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * How the parts of a model move apart. Each node is one body, and so is each of its copies, and
 * each connected piece of a file without parts. Confined to one thread.
 */
public final class Explosion {
  private final Model assembled;
  private final Map<ModelNode, Vec3> moves = new IdentityHashMap<>();
  private final List<String> notes = new ArrayList<>();

  /** A node above others, by its name; a reader may have made two objects of one node. */
  private record Named(Optional<ModelNode> parent, String name) {}

  private Explosion(Model assembled) {
    this.assembled = assembled;
  }

  /**
   * Returns how the parts of a model move.
   *
   * @param model not cut
   * @throws ModelFormatException if it is in motion, and its parts would move apart
   */
  public static Explosion of(Model model, ModelOptions options) throws ModelFormatException {
    double factor = options.get(ModelOption.EXPLODE);
    if (factor == 0 || model.parts().isEmpty()) {
      return new Explosion(model);
    }
    if (!model.poses().isEmpty()) {
      throw Kind.MALFORMED.at(
          ModelOption.EXPLODE.name(),
          "expected a model that stands still, found one that moves while the picture is taken");
    }
    Explosion explosion = new Explosion(divided(PieceModel.of(model)));
    explosion.explode(factor);
    return explosion;
  }

  /** Returns a model in which each copy of a mesh at one node is a part of its own. */
  private static Model divided(Model model) {
    Names names = new Names("");
    model.parts().stream().map(ModelPart::node).distinct().forEach(n -> names.unused(n.label()));
    Map<ModelNode, Map<ModelGeometry, Integer>> counts = new IdentityHashMap<>();
    Map<ModelNode, List<ModelNode>> copies = new IdentityHashMap<>();
    List<ModelPart> parts = new ArrayList<>();
    for (ModelPart part : model.parts()) {
      ModelNode node = part.node();
      int copy =
          counts
              .computeIfAbsent(node, n -> new IdentityHashMap<>())
              .merge(part.geometry(), 0, (number, zero) -> number + 1);
      List<ModelNode> known = copies.computeIfAbsent(node, n -> new ArrayList<>(List.of(n)));
      if (copy == known.size()) {
        known.add(node.labeled(names.unused(node.label())));
      }
      parts.add(part.with(known.get(copy), part.geometry(), part.material()));
    }
    return model.with(parts);
  }

  private void explode(double factor) {
    Map<ModelNode, Bounds3> bodies = bodies(Frame.WORLD);
    List<ModelNode> nodes = List.copyOf(bodies.keySet());
    Assembly.Moves found =
        tilted(bodies).orElseGet(() -> assembly(bodies, bodies, Frame.WORLD).exploded());
    for (int i = 0; i < nodes.size(); i++) {
      moves.put(nodes.get(i), found.moves().get(i).times(factor));
    }
    note(nodes, found);
  }

  /**
   * Returns how parts move along the axes of a tilted assembly; empty if it is not tilted, or the
   * boxes around them along the axes of the file do not move apart this way.
   */
  private Optional<Assembly.Moves> tilted(Map<ModelNode, Bounds3> bodies) {
    if (bodies.size() < 2 || bodies.size() > Assembly.MOST_BODIES) {
      return Optional.empty();
    }
    return MainAxes.of(assembled.parts())
        .map(axes -> assembly(bodies, bodies(axes), axes).exploded())
        .filter(moves -> moves.overlaps() == 0)
        .flatMap(moves -> Assembly.apart(List.copyOf(bodies.values()), moves.moves()))
        .map(moves -> new Assembly.Moves(moves, List.of(), 0, 0));
  }

  /** Returns the box around each body along some axes. */
  private Map<ModelNode, Bounds3> bodies(Frame axes) {
    Map<ModelNode, Bounds3> bodies = new LinkedHashMap<>();
    for (ModelPart part : assembled.parts()) {
      Bounds3 box = box(part, axes);
      if (!box.isEmpty()) {
        bodies.merge(part.node(), box, Bounds3::union);
      }
    }
    return bodies;
  }

  private Bounds3 box(ModelPart part, Frame axes) {
    double radius = part.geometry().isPoints() ? assembled.pointRadius() : 0;
    Vec3 reach = new Vec3(radius, radius, radius);
    Bounds3 box = Bounds3.EMPTY;
    BitSet used = part.geometry().used();
    for (int v = used.nextSetBit(0); v >= 0; v = used.nextSetBit(v + 1)) {
      Vec3 at = axes.toLocal(part.position(v));
      box = radius > 0 ? box.union(at.minus(reach)).union(at.plus(reach)) : box.union(at);
    }
    return box;
  }

  private static Assembly assembly(
      Map<ModelNode, Bounds3> bodies, Map<ModelNode, Bounds3> turned, Frame axes) {
    Assembly assembly = new Assembly(axes);
    Map<ModelNode, Integer> groups = new IdentityHashMap<>();
    Map<Named, Integer> named = new HashMap<>();
    for (ModelNode body : bodies.keySet()) {
      List<ModelNode> above = new ArrayList<>();
      for (Optional<ModelNode> n = body.parent(); n.isPresent(); n = n.get().parent()) {
        above.add(n.get());
      }
      Collections.reverse(above);
      int group = Assembly.ROOT;
      for (ModelNode node : above) {
        Integer known = groups.get(node);
        group = known == null ? assembly.addGroup(group) : known;
        groups.put(node, group);
        named.putIfAbsent(new Named(node.parent(), node.name()), group);
      }
    }
    bodies.forEach(
        (body, box) -> {
          int outer = body.parent().map(groups::get).orElse(Assembly.ROOT);
          Integer own = named.get(new Named(body.parent(), body.name()));
          boolean isNamed = own != null && !body.name().isEmpty();
          assembly.addBody(
              groups.getOrDefault(body.whole(), isNamed ? own : outer), box, turned.get(body));
        });
    return assembly;
  }

  private void note(List<ModelNode> nodes, Assembly.Moves found) {
    if (nodes.size() < 2) {
      notes.add("explode: has no effect, because the model has only one part");
    } else if (found.moves().stream().allMatch(Vec3.ZERO::equals)) {
      notes.add("explode: has no effect, because no part is near another one");
    }
    if (found.level() > 0) {
      notes.add(
          "explode: of more than %s parts, only those of one level move apart: %s groups of %s"
              .formatted(Assembly.MOST_BODIES, found.level(), nodes.size()));
    }
    if (found.overlaps() > 0) {
      long more = found.overlaps() - found.overlapping().size();
      notes.add(
          "explode: the boxes around %s%s still overlap; apart, they would take more than %s times"
                  .formatted(
                      found.overlapping().stream()
                          .map(p -> name(p.get(0), nodes) + " and " + name(p.get(1), nodes))
                          .collect(Collectors.joining(", ")),
                      more > 0 ? " and " + more + " more pairs" : "",
                      Assembly.LARGEST)
              + " the longest side of the model");
    }
  }

  private static String name(int body, List<ModelNode> nodes) {
    return PrintableText.quoted(nodes.get(body).label());
  }

  /** Returns the model before its parts move, in which each body has a node of its own. */
  public Model assembled() {
    return assembled;
  }

  /** Returns whether the parts stay where they are. */
  public boolean isNone() {
    return moves.isEmpty();
  }

  /**
   * Returns a model with its parts moved.
   *
   * @param left what is left of {@link #assembled}, standing still
   */
  public Model moved(Model left) throws ModelFormatException {
    if (isNone()) {
      return left;
    }
    Model moved = left.with(left.parts().stream().map(this::moved).toList()).warning(notes);
    ModelReach.require(moved);
    return moved;
  }

  private ModelPart moved(ModelPart part) {
    Vec3 move = moves.getOrDefault(part.node(), Vec3.ZERO);
    return move.equals(Vec3.ZERO)
        ? part
        : new ModelPart(
            part.node(),
            part.location(),
            part.geometry(),
            part.material(),
            Transform.translation(move).times(part.toWorld()));
  }
}
