package io.github.lumbre.scenefile.internal;

import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;

/**
 * A surface of a model in its scene. Primitives of one surface share one object; compared by
 * identity.
 *
 * @param node the part of the file that it belongs to
 * @param isOnePiece whether it is not divided into connected pieces
 * @param triangles the number of triangles
 * @param points the number of points
 */
public record PartSurface(ModelNode node, boolean isOnePiece, int triangles, int points) {
  public static PartSurface of(ModelPart part) {
    int points = part.geometry().isPoints() ? part.geometry().vertexCount() : 0;
    return new PartSurface(part.node(), part.isOnePiece(), part.geometry().triangleCount(), points);
  }
}
