package io.github.lumbre.scenefile;

import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.internal.LightGroups;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Traverses the tree of objects without recursion, and computes each world transform. */
final class ObjectTree {
  /** The largest nesting depth of objects. */
  static final int MAX_DEPTH = 2000;

  enum Type {
    NONE,
    CAMERA,
    SHAPE,
    MODEL,
    LIGHT
  }

  /**
   * An object and its world transform.
   *
   * @param toWorld local to world space: the product of translation · rotation · scale (T · R · S)
   *     from the root down to the object
   * @param rotation the product of the rotations alone, from the root down
   */
  record Placed(JsonNode node, Type type, Transform toWorld, Transform rotation) {
    /**
     * Returns the object's right (x), up (y) and forward (z) axes in world space: unit vectors,
     * from the rotations alone.
     */
    Frame axes() {
      return new Frame(rotation.vector(Vec3.X), rotation.vector(Vec3.Y), rotation.vector(Vec3.Z));
    }

    <T> T get(Key<T> key) {
      return key.in(node);
    }

    <T> Optional<T> stated(Key<T> key) {
      return key.stated(node);
    }

    /** Returns the name of the light group of the object's light; empty for none. */
    String lightGroup() {
      String name = ObjectKeys.LIGHT_GROUP.in(node);
      if (!LightGroups.isName(name)) {
        ObjectKeys.LIGHT_GROUP.error(
            node, "expected letters, digits and underscores, found another name");
        return "";
      }
      return name;
    }

    /** Returns the object's origin in world space. */
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

  /** Returns the tree of all objects: parents before children, in the order of the file. */
  static ObjectTree of(JsonNode root) {
    ObjectTree tree = new ObjectTree();
    tree.push(root.objects(RootKeys.OBJECTS.name()), 1, Transform.IDENTITY, Transform.IDENTITY);
    while (!tree.stack.isEmpty()) {
      tree.visit(tree.stack.pop());
    }
    return tree;
  }

  List<Placed> objects() {
    return objects;
  }

  List<JsonNode> nodes(Type type) {
    return objects.stream().filter(object -> object.type() == type).map(Placed::node).toList();
  }

  /** Returns the second object with an id; empty if there is none. */
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
      node.error(Kind.LIMIT, "expected at most " + MAX_DEPTH + " nested objects, found more");
      return;
    }
    noteId(node);
    LocalTransform local = LocalTransform.of(node);
    // The outermost transform of a matrix is the matrix, bit for bit.
    boolean isOutermost = visit.depth == 1 && local.isMatrix();
    Transform toWorld = isOutermost ? local.transform() : visit.toWorld.times(local.transform());
    if (!toWorld.isInvertible()) {
      node.error(
          "singular transform: combined with those of its parents, it has no finite inverse");
      toWorld = visit.toWorld;
    }
    Transform rotation = isOutermost ? local.turn() : visit.rotation.times(local.turn());
    objects.add(new Placed(node, ObjectKeys.TYPE.in(node), toWorld, rotation));
    push(node.objects(ObjectKeys.CHILDREN.name()), visit.depth + 1, toWorld, rotation);
  }

  private void noteId(JsonNode node) {
    ObjectKeys.ID
        .stated(node)
        .ifPresent(
            id -> {
              JsonNode first = byId.putIfAbsent(id, node);
              if (first != null) {
                repeated.putIfAbsent(id, node);
                String key = ObjectKeys.ID.name();
                node.warn(key, () -> "object id " + id + " is also at " + first.path() + "." + key);
              }
            });
  }
}
