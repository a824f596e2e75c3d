package io.github.lumbre.scenefile.internal;

import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PartSelection;
import io.github.lumbre.model.section.Hatch;
import java.util.Optional;

/**
 * A surface of a model in its scene. Primitives of one surface share one object; compared by
 * identity.
 *
 * @param node the part of the file that it belongs to
 * @param isOnePiece whether it is not divided into connected pieces
 * @param triangles the number of triangles
 * @param points the number of points
 * @param isPaper whether it is white in drawings
 * @param hatch the lines on it, if a section cuts there
 */
public record PartSurface(
    ModelNode node,
    boolean isOnePiece,
    int triangles,
    int points,
    boolean isPaper,
    Optional<Hatch> hatch) {
  public static PartSurface of(ModelPart part) {
    int points = part.geometry().isPoints() ? part.geometry().vertexCount() : 0;
    return new PartSurface(
        part.node(),
        part.isOnePiece(),
        part.geometry().triangleCount(),
        points,
        part.material().flat() || PartSelection.isPale(part.material()),
        part.material().hatch().filter(Hatch.class::isInstance).map(Hatch.class::cast));
  }
}
