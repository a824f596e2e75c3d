package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.json.JsonTree;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelPart;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** Limits on the memory that the content of one glTF file may use. Mutable. */
final class GltfBudget {
  /** The largest number of elements of an accessor, and of all vertices or indices. */
  static final long MAX_COUNT = 1 << 27;

  /** The largest number of elements of an accessor that consists of zeros. */
  static final long MAX_ZEROS = 1 << 24;

  /** The largest number of nodes, and of parts. */
  static final int MAX_PARTS = 1 << 20;

  /** The largest depth of the node hierarchy. */
  static final int MAX_DEPTH = 2000;

  /** Heap bytes of a part: its two objects and its transform. */
  private static final int BYTES_PER_PART = 400;

  /** Heap bytes of a triangle or point in the hierarchy of one pose, with its vertices. */
  private static final long BYTES_PER_MOVED = 250;

  /** Heap bytes of a node and its transforms. */
  private static final long BYTES_PER_NODE = 500;

  private final Limits limits;
  private long items;
  private long bytes;
  private long vertices;
  private long indices;
  private long parts;

  /** The meshes of all poses of a model in motion, and their triangles after the first pose. */
  private final Map<ModelGeometry, Boolean> shapes = new IdentityHashMap<>();

  private long moved;

  /** Creates the budget of a file: at most three quarters of the heap, and within the limits. */
  GltfBudget(Limits limits) {
    this.limits = limits.withMemory(Math.min(limits.memory(), Limits.NONE.heap() / 4 * 3));
  }

  /** Adds the triangles or points of a part, whose arrays {@link #allocate} counts. */
  void addItems(String location, ModelGeometry geometry) throws ModelFormatException {
    items += geometry.itemCount();
    ModelLimits.requireItems(location, geometry, items, limits);
  }

  /**
   * Adds a pose of a model in motion.
   *
   * @param poses all so far; they share the meshes that keep their shape, but for lights that move
   * @param all number of poses that there will be
   * @throws ModelFormatException if their scenes, with as many new meshes in each pose to come as
   *     in those that were read, do not fit into the memory
   */
  void addPose(List<Model> poses, int all) throws ModelFormatException {
    List<ModelPart> now = poses.get(poses.size() - 1).parts();
    List<ModelPart> before = poses.size() > 1 ? poses.get(poses.size() - 2).parts() : now;
    for (int i = 0; i < now.size(); i++) {
      ModelPart part = now.get(i);
      boolean isNew = shapes.put(part.geometry(), true) == null;
      if ((isNew || part.isLight() && !isAt(part, i, before)) && poses.size() > 1) {
        moved += part.geometry().itemCount();
      }
    }
    if (poses.size() > 1) {
      long expected = moved / (poses.size() - 1) * (all - 1);
      String what = "animations: " + all + " poses";
      ModelLimits.requireMemory(what, bytes + BYTES_PER_MOVED * expected, limits);
    }
    items = 0;
    parts = 0;
  }

  /** Returns whether a part is where it was, if parts appear and vanish only behind it. */
  private static boolean isAt(ModelPart part, int index, List<ModelPart> before) {
    return index < before.size()
        && Arrays.equals(part.toWorld().toArray(), before.get(index).toWorld().toArray());
  }

  /** Returns the number of tokens of JSON that may be read. */
  long tokens() {
    return JsonTree.maxTokens(limits.heap() - bytes);
  }

  /** Adds nodes, and the bytes that they need. */
  void addNodes(long count) throws ModelFormatException {
    ModelLimits.require("nodes", "nodes", MAX_PARTS, count);
    allocate("nodes", BYTES_PER_NODE * count);
  }

  /** Adds vertices of a mesh, whose arrays {@link #allocate} counts. */
  void addVertices(String location, long count) throws ModelFormatException {
    vertices += count;
    ModelLimits.require(location, "vertices in the model", MAX_COUNT, vertices);
  }

  /** Adds indices, and the bytes that they need. */
  void addIndices(String location, long count) throws ModelFormatException {
    indices += count;
    ModelLimits.require(location, "indices in the model", MAX_COUNT, indices);
    allocate(location, Integer.BYTES * count);
    ModelLimits.requireHeap(location, indices / 3);
  }

  /** Adds a part, and the bytes that it needs. */
  void addPart(String location) throws ModelFormatException {
    ModelLimits.require(location, "parts in the model", MAX_PARTS, ++parts);
    allocate(location, BYTES_PER_PART);
  }

  /** Returns a copy of an array, whose memory is added. */
  double[] copy(String location, double... numbers) throws ModelFormatException {
    allocate(location, (long) Double.BYTES * numbers.length);
    return numbers.clone();
  }

  /**
   * Adds memory that is about to be allocated.
   *
   * @throws ModelFormatException if the sum exceeds the limit
   */
  void allocate(String location, long more) throws ModelFormatException {
    bytes += more;
    ModelLimits.requireMemory(location, bytes, limits);
  }
}
