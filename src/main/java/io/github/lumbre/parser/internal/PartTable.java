package io.github.lumbre.parser.internal;

import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.Pieces;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * The parts of a model in its scene, numbered from 0 in the order of the file: those of the file,
 * or connected pieces if the file does not divide the model. Immutable.
 */
public final class PartTable {
  /** The number of a hit that shows no part of the model. */
  public static final int NONE = -1;

  private final List<Part> parts = new ArrayList<>();

  /** The part of each primitive; of one that is divided into pieces, the first. */
  private final Map<Integer, Integer> firstParts = new HashMap<>();

  private final Map<Integer, Pieces> pieces = new HashMap<>();
  private int pieceCount;

  /**
   * A part.
   *
   * @param name its label; no two parts have one
   * @param triangles the number of triangles, each instance counted
   * @param points the number of points, each instance counted
   * @param box in the model's world space, which is right-handed
   */
  public record Part(String name, long triangles, long points, Bounds3 box) {
    private Part with(long moreTriangles, long morePoints, Bounds3 more) {
      return new Part(name, triangles + moreTriangles, points + morePoints, box.union(more));
    }
  }

  private PartTable() {}

  /**
   * Finds the parts.
   *
   * @param surfaces the surfaces of the model, by the numbers of their primitives
   */
  public static PartTable of(Scene scene, Map<Integer, PartSurface> surfaces) {
    PartTable table = new PartTable();
    Map<ModelNode, Integer> ofNodes = new HashMap<>();
    Map<PartSurface, Integer> ofSurfaces = new IdentityHashMap<>();
    for (int primitive = 0; primitive < scene.primitives().size(); primitive++) {
      PartSurface surface = surfaces.get(primitive);
      if (surface == null) {
        continue;
      }
      Shape shape = scene.primitives().get(primitive).shape();
      ModelNode node = surface.node();
      if (!node.isDivided() && !surface.isOnePiece() && shape instanceof Mesh mesh) {
        table.addPieces(primitive, mesh.triangles());
        continue;
      }
      boolean isNew = !ofSurfaces.containsKey(surface);
      int part =
          node.isDivided()
              ? ofNodes.computeIfAbsent(node, n -> table.part(n.label()))
              : ofSurfaces.computeIfAbsent(surface, s -> table.piece());
      ofSurfaces.put(surface, part);
      table.firstParts.put(primitive, part);
      Part grown =
          table
              .parts
              .get(part)
              .with(isNew ? surface.triangles() : 0, isNew ? surface.points() : 0, box(shape));
      table.parts.set(part, grown);
    }
    return table;
  }

  private int part(String label) {
    parts.add(new Part(label, 0, 0, Bounds3.EMPTY));
    return parts.size() - 1;
  }

  /** Returns the part of the next connected piece. */
  private int piece() {
    int piece = Math.min(pieceCount++, Pieces.LAST);
    return piece < parts.size() ? piece : part(Pieces.label(piece));
  }

  private void addPieces(int primitive, TriangleMesh mesh) {
    Pieces found =
        Pieces.of(mesh.triangleCount(), mesh.vertexCount(), mesh::vertex, mesh::position);
    int first = pieceCount;
    firstParts.put(primitive, first);
    pieces.put(primitive, found);
    for (int i = 0; i < found.count(); i++) {
      piece();
    }
    long[] triangles = new long[parts.size()];
    Bounds3[] boxes = new Bounds3[parts.size()];
    for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
      int part = Math.min(first + found.of(triangle), Pieces.LAST);
      triangles[part]++;
      Bounds3 box = boxes[part] == null ? Bounds3.EMPTY : boxes[part];
      for (int corner = 0; corner < 3; corner++) {
        box = box.union(mesh.position(mesh.vertex(triangle, corner)));
      }
      boxes[part] = box;
    }
    for (int part = Math.min(first, Pieces.LAST); part < triangles.length; part++) {
      parts.set(part, parts.get(part).with(triangles[part], 0, mirrored(boxes[part])));
    }
  }

  /** Returns the box around a shape, in the model's world space. */
  private static Bounds3 box(Shape shape) {
    if (shape instanceof Mesh mesh) {
      return mirrored(box(mesh.triangles(), Transform.IDENTITY));
    }
    return mirrored(
        shape instanceof MeshInstance instance
            ? box(instance.shared().mesh(), instance.toWorld())
            : shape.bounds());
  }

  private static Bounds3 box(TriangleMesh mesh, Transform toWorld) {
    Bounds3 box = Bounds3.EMPTY;
    for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
      for (int corner = 0; corner < 3; corner++) {
        box = box.union(toWorld.point(mesh.position(mesh.vertex(triangle, corner))));
      }
    }
    return box;
  }

  private static Bounds3 mirrored(Bounds3 box) {
    return new Bounds3(
        new Vec3(box.min().x(), box.min().y(), 0 - box.max().z()),
        new Vec3(box.max().x(), box.max().y(), 0 - box.min().z()));
  }

  /** Returns the parts. */
  public List<Part> parts() {
    return List.copyOf(parts);
  }

  /** Returns the part that a ray hits; {@link #NONE} if it hits none of the model. */
  public int at(NearestHit hit) {
    if (!hit.isHit()) {
      return NONE;
    }
    int first = firstParts.getOrDefault(hit.shape(), NONE);
    Pieces divided = pieces.get(hit.shape());
    return divided == null ? first : Math.min(first + divided.of(hit.element()), Pieces.LAST);
  }
}
