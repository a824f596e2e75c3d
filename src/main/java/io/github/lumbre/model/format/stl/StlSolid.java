package io.github.lumbre.model.format.stl;

import io.github.lumbre.geometry.internal.PositionIndex;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.Warnings;
import java.util.Optional;

/** Collects the facets of one solid of an STL file. Mutable. */
final class StlSolid {
  private static final float[] NO_COLORS = {};
  private static final double[] NONE = {};

  private final String name;
  private final String location;
  private final PositionIndex positions = new PositionIndex();
  private final TriangleList triangles;
  private int contradictions;
  private int broken;

  /**
   * @param name empty if it has none
   * @param location in the file; empty for the only solid
   * @param expected the expected number of triangles
   */
  StlSolid(String name, String location, int expected) {
    this.name = name;
    this.location = location;
    triangles = new TriangleList(expected);
  }

  /**
   * Adds a facet. The order of its vertices decides which side is outside, as in other programs:
   * tools that mirror or turn meshes often leave the normals unchanged.
   *
   * @param facet the normal, then three vertices
   */
  void add(double[] facet) {
    for (int i = 3; i < facet.length; i++) {
      if (!Double.isFinite(facet[i])) {
        broken++;
        return;
      }
    }
    int a = positions.number(facet[3], facet[4], facet[5]);
    int b = positions.number(facet[6], facet[7], facet[8]);
    int c = positions.number(facet[9], facet[10], facet[11]);
    triangles.add(a, b, c);
    contradictions += side(facet) < 0 ? 1 : 0;
  }

  /** Returns the dot product of the stated normal and the normal by the vertices. */
  private static double side(double[] f) {
    double ux = f[6] - f[3];
    double uy = f[7] - f[4];
    double uz = f[8] - f[5];
    double vx = f[9] - f[3];
    double vy = f[10] - f[4];
    double vz = f[11] - f[5];
    return f[0] * (uy * vz - uz * vy) + f[1] * (uz * vx - ux * vz) + f[2] * (ux * vy - uy * vx);
  }

  /**
   * Returns the part; empty if no triangle has an area.
   *
   * @param number of the solid in the file, from 1; 0 for the only one
   */
  Optional<ModelPart> part(int number, ModelOptions options, Warnings warnings) {
    double[] points = positions.positions();
    int dropped = triangles.removeFlat(points);
    if (dropped > 0) {
      warnings.add(
          "triangles of zero area", location, "dropped triangles of zero area: " + dropped);
    }
    if (broken > 0) {
      warnings.add(Tally.BROKEN, location, Tally.BROKEN + ": " + broken);
    }
    if (contradictions > 0) {
      warnings.add(
          "normals that point to the back",
          location,
          "ignored normals that point to the back of their triangles: " + contradictions);
    }
    if (triangles.count() == 0) {
      return Optional.empty();
    }
    ModelGeometry geometry =
        new ModelGeometry(points, NONE, NONE, NONE, NONE, NO_COLORS, triangles.toArray());
    ModelNode node =
        number == 0
            ? ModelNode.undivided(name)
            : ModelNode.of(name, "solid " + number, Optional.empty());
    return Optional.of(
        new ModelPart(node, location, geometry, PlainModel.defaultMaterial(), options.toWorld()));
  }
}
