package io.github.lumbre.model.internal;

import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Divides a model that its file does not divide: each connected piece is a part. Not reusable. */
final class PieceModel {
  private final List<ModelPart> parts = new ArrayList<>();
  private final Map<Integer, ModelNode> nodes = new HashMap<>();
  private int pieces;

  private PieceModel() {}

  /** Returns a model with parts; the surfaces that the file divides stay as they are. */
  static Model of(Model model) {
    PieceModel divided = new PieceModel();
    for (ModelPart part : model.parts()) {
      if (part.node().isDivided()) {
        divided.parts.add(part);
      } else if (part.isOnePiece()) {
        divided.add(part, part.geometry(), divided.pieces++);
      } else {
        divided.addPieces(part);
      }
    }
    return model.with(divided.parts);
  }

  private void addPieces(ModelPart part) {
    ModelGeometry mesh = part.geometry();
    double[] all = mesh.positions();
    int[] indices = mesh.indices();
    Pieces found =
        Pieces.of(
            mesh.triangleCount(),
            mesh.vertexCount(),
            (triangle, corner) -> indices[3 * triangle + corner],
            v -> new Vec3(all[3 * v], all[3 * v + 1], all[3 * v + 2]));
    Map<Integer, TriangleList> triangles = new TreeMap<>();
    for (int i = 0; i < mesh.triangleCount(); i++) {
      triangles
          .computeIfAbsent(Math.min(pieces + found.of(i), Pieces.LAST), n -> new TriangleList(0))
          .add(indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]);
    }
    triangles.forEach((number, piece) -> add(part, mesh.part(piece.toArray()), number));
    pieces += found.count();
  }

  private void add(ModelPart part, ModelGeometry geometry, int number) {
    ModelNode node =
        nodes.computeIfAbsent(
            Math.min(number, Pieces.LAST), n -> part.node().labeled(Pieces.label(n)));
    parts.add(part.with(node, geometry, part.material()));
  }
}
