package io.github.lumbre.parser;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.SceneFormatException.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Walks the tree of objects, without recursion, and places each in the world. */
final class ObjectTree {
  /** Objects within each other. */
  static final int MAX_DEPTH = 2000;

  /** Keys that every object has. */
  static final Set<String> COMMON_KEYS =
      Set.of("type", "name", "id", "children", "localPosition", "localRotation", "localScale");

  private static final Vec3 ONE = new Vec3(1, 1, 1);

  /** What an object is. */
  enum Type {
    NONE,
    CAMERA,
    SHAPE,
    LIGHT
  }

  private static final Map<String, Type> TYPES = new LinkedHashMap<>();

  static {
    TYPES.put("None", Type.NONE);
    TYPES.put("Camera", Type.CAMERA);
    TYPES.put("Shape", Type.SHAPE);
    TYPES.put("Light", Type.LIGHT);
  }

  /**
   * An object in the world.
   *
   * @param toWorld parent · T · R · S, from the root down
   * @param rotation the same of the rotations alone
   */
  record Placed(JsonNode node, Type type, Transform toWorld, Transform rotation) {
    /** Returns the object's right, up and forward as the rotations alone turn them. */
    Frame axes() {
      return new Frame(rotation.vector(Vec3.X), rotation.vector(Vec3.Y), rotation.vector(Vec3.Z));
    }

    /** Returns where the object's origin is. */
    Vec3 position() {
      return toWorld.point(Vec3.ZERO);
    }
  }

  /** An object still to be visited. */
  private record Visit(JsonNode node, int depth, Transform toWorld, Transform rotation) {}

  private final List<Placed> objects = new ArrayList<>();
  private final Map<Integer, JsonNode> byId = new LinkedHashMap<>();
  private final Map<Integer, JsonNode> repeated = new LinkedHashMap<>();
  private final Deque<Visit> stack = new ArrayDeque<>();

  private ObjectTree() {}

  /** Returns all objects below the root, parents before children, in the order of the file. */
  static ObjectTree of(JsonNode root) {
    ObjectTree tree = new ObjectTree();
    tree.push(root.objects("objects"), 1, Transform.IDENTITY, Transform.IDENTITY);
    while (!tree.stack.isEmpty()) {
      tree.visit(tree.stack.pop());
    }
    return tree;
  }

  List<Placed> objects() {
    return objects;
  }

  /** Returns the second object that has an id, if there is one. */
  Optional<JsonNode> repetition(int id) {
    return Optional.ofNullable(repeated.get(id));
  }

  private void push(List<JsonNode> nodes, int depth, Transform toWorld, Transform rotation) {
    for (int i = nodes.size() - 1; i >= 0; i--) {
      stack.push(new Visit(nodes.get(i), depth, toWorld, rotation));
    }
  }

  private void visit(Visit visit) {
    JsonNode node = visit.node;
    if (visit.depth > MAX_DEPTH) {
      node.error(
          Kind.LIMIT, "expected at most " + MAX_DEPTH + " objects within each other, found more");
      return;
    }
    noteId(node);
    Transform turn = Transform.rotationDegrees(node.vec3("localRotation", Vec3.ZERO));
    Transform local =
        Transform.translation(node.vec3("localPosition", Vec3.ZERO))
            .times(turn)
            .times(Transform.scale(node.vec3("localScale", ONE)));
    Transform toWorld = visit.toWorld.times(local);
    if (!toWorld.isInvertible()) {
      node.error("singular transform: with its parents, it flattens or overflows the object");
      toWorld = visit.toWorld;
    }
    Transform rotation = visit.rotation.times(turn);
    objects.add(new Placed(node, node.choice("type", TYPES, Type.NONE), toWorld, rotation));
    push(node.objects("children"), visit.depth + 1, toWorld, rotation);
  }

  private void noteId(JsonNode node) {
    node.id("id")
        .ifPresent(
            id -> {
              JsonNode first = byId.putIfAbsent(id, node);
              if (first != null) {
                repeated.putIfAbsent(id, node);
                node.warn("id", () -> "object id " + id + " is also at " + first.path() + ".id");
              }
            });
  }
}
