package io.github.lumbre.scenefile.internal;

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
import java.util.Arrays;
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

  /** The part of each primitive that is not divided into pieces. */
  private final Map<Integer, Integer> ofPrimitives = new HashMap<>();

  /** The pieces, and the mesh of each primitive that is divided into them. */
  private final Pieces pieces;

  private final Map<Integer, Integer> meshes = new HashMap<>();
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

  private record Triangles(TriangleMesh mesh) implements Pieces.Source {
    @Override
    public int triangles() {
      return mesh.triangleCount();
    }

    @Override
    public int vertices() {
      return mesh.vertexCount();
    }

    @Override
    public int vertex(int triangle, int corner) {
      return mesh.vertex(triangle, corner);
    }

    @Override
    public Vec3 position(int vertex) {
      return mesh.position(vertex);
    }
  }

  private PartTable(Scene scene, Map<Integer, PartSurface> surfaces) {
    List<Triangles> divided = new ArrayList<>();
    for (int primitive = 0; primitive < scene.primitives().size(); primitive++) {
      PartSurface surface = surfaces.get(primitive);
      boolean isDivided = surface != null && !surface.node().isDivided() && !surface.isOnePiece();
      if (isDivided && scene.primitives().get(primitive).shape() instanceof Mesh mesh) {
        meshes.put(primitive, divided.size());
        divided.add(new Triangles(mesh.triangles()));
      }
    }
    pieces = Pieces.of(divided);
    while (pieceCount < pieces.count()) {
      piece();
    }
    addPieces(divided);
  }

  /**
   * Finds the parts.
   *
   * @param surfaces the surfaces of the model, by the numbers of their primitives
   */
  public static PartTable of(Scene scene, Map<Integer, PartSurface> surfaces) {
    PartTable table = new PartTable(scene, surfaces);
    Map<ModelNode, Integer> ofNodes = new HashMap<>();
    Map<PartSurface, Integer> ofSurfaces = new IdentityHashMap<>();
    for (int primitive = 0; primitive < scene.primitives().size(); primitive++) {
      PartSurface surface = surfaces.get(primitive);
      if (surface == null || table.meshes.containsKey(primitive)) {
        continue;
      }
      ModelNode node = surface.node();
      boolean isNew = !ofSurfaces.containsKey(surface);
      int part =
          node.isDivided()
              ? ofNodes.computeIfAbsent(node, n -> table.part(n.label()))
              : ofSurfaces.computeIfAbsent(surface, s -> table.piece());
      ofSurfaces.put(surface, part);
      table.ofPrimitives.put(primitive, part);
      Bounds3 box = box(scene.primitives().get(primitive).shape());
      table.parts.set(
          part,
          table
              .parts
              .get(part)
              .with(isNew ? surface.triangles() : 0, isNew ? surface.points() : 0, box));
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

  private void addPieces(List<Triangles> divided) {
    long[] triangles = new long[parts.size()];
    Bounds3[] boxes = new Bounds3[parts.size()];
    Arrays.fill(boxes, Bounds3.EMPTY);
    for (int i = 0; i < divided.size(); i++) {
      TriangleMesh mesh = divided.get(i).mesh;
      for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
        int part = Math.min(pieces.of(i, triangle), Pieces.LAST);
        triangles[part]++;
        for (int corner = 0; corner < 3; corner++) {
          boxes[part] = boxes[part].union(mesh.position(mesh.vertex(triangle, corner)));
        }
      }
    }
    for (int part = 0; part < triangles.length; part++) {
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

  public List<Part> parts() {
    return List.copyOf(parts);
  }

  /** Returns the part that a ray hits; {@link #NONE} if it hits none of the model. */
  public int at(NearestHit hit) {
    if (!hit.isHit()) {
      return NONE;
    }
    return at(hit.shape(), hit.element());
  }

  /** Returns the part of a triangle of a primitive; {@link #NONE} if it is none of the model. */
  public int at(int primitive, int triangle) {
    Integer mesh = meshes.get(primitive);
    return mesh == null
        ? ofPrimitives.getOrDefault(primitive, NONE)
        : Math.min(pieces.of(mesh, triangle), Pieces.LAST);
  }
}
