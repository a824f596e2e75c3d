package io.github.lumbre.model.internal;

import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Divides a model that its file does not divide: each connected piece is a part. Not reusable. */
public final class PieceModel {
  private final List<ModelPart> parts = new ArrayList<>();
  private final Map<Integer, ModelNode> nodes = new HashMap<>();

  private record Triangles(ModelGeometry mesh) implements Pieces.Source {
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
      return mesh.indices()[3 * triangle + corner];
    }

    @Override
    public Vec3 position(int vertex) {
      double[] all = mesh.positions();
      return new Vec3(all[3 * vertex], all[3 * vertex + 1], all[3 * vertex + 2]);
    }
  }

  private PieceModel() {}

  /** Returns a model with parts; the surfaces that the file divides stay as they are. */
  public static Model of(Model model) {
    PieceModel divided = new PieceModel();
    Pieces pieces =
        Pieces.of(
            model.parts().stream()
                .filter(part -> !part.node().isDivided() && !part.isOnePiece())
                .map(part -> new Triangles(part.geometry()))
                .toList());
    int mesh = 0;
    int whole = pieces.count();
    for (ModelPart part : model.parts()) {
      if (part.node().isDivided()) {
        divided.parts.add(part);
      } else if (part.isOnePiece()) {
        divided.add(part, part.geometry(), whole++);
      } else {
        divided.add(part, pieces, mesh++);
      }
    }
    return model.with(divided.parts);
  }

  private void add(ModelPart part, Pieces pieces, int mesh) {
    ModelGeometry geometry = part.geometry();
    int[] indices = geometry.indices();
    Map<Integer, TriangleList> triangles = new TreeMap<>();
    for (int i = 0; i < geometry.triangleCount(); i++) {
      triangles
          .computeIfAbsent(Math.min(pieces.of(mesh, i), Pieces.LAST), n -> new TriangleList(0))
          .add(indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]);
    }
    triangles.forEach((number, piece) -> add(part, geometry.part(piece.toArray()), number));
  }

  private void add(ModelPart part, ModelGeometry geometry, int number) {
    ModelNode node =
        nodes.computeIfAbsent(
            Math.min(number, Pieces.LAST), n -> part.node().labeled(Pieces.label(n)));
    parts.add(part.with(node, geometry, part.material()));
  }
}
