package io.github.lumbre.model.format.ply;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.Warnings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The parts of a PLY file whose faces have the integer property {@code part}, which counts the
 * names that comments {@code PartName} state, from 0; so that programs without a format of scenes
 * can name parts. Files without such names have no parts. Triangles of strips are in the first
 * part. Mutable.
 */
final class PlyParts {
  /** The first word of a comment that names a part. */
  static final String COMMENT = "PartName";

  /** The property of faces. */
  static final String PROPERTY = "part";

  private final List<String> names;
  private boolean isUsed;
  private int part;
  private int[] ofTriangles = {};

  /** The number of triangles whose part is stated. */
  private int stated;

  /**
   * @param names of the parts, in their order; empty if the file is not divided
   */
  PlyParts(List<String> names) {
    this.names = names;
  }

  /** Returns whether a property of the faces is read here. */
  boolean uses(PlyProperty property) {
    return !names.isEmpty()
        && !property.isList()
        && property.type().isInteger()
        && property.name().equals(PROPERTY);
  }

  /** Begins an element of faces. */
  void begin(PlyElement faces) {
    isUsed |= faces.properties().stream().anyMatch(this::uses);
  }

  void read(PlyProperty property, PlyBody body) throws ModelFormatException {
    long number = body.integer(property);
    if (number < 0 || number >= names.size()) {
      throw body.error("expected a part from 0 to " + (names.size() - 1) + ", found " + number);
    }
    part = (int) number;
  }

  /**
   * Ends a face.
   *
   * @param first the number of its first triangle, among all of the file
   * @param end the number after its last one
   */
  void endFace(int first, int end) {
    if (isUsed) {
      if (end > ofTriangles.length) {
        ofTriangles = Arrays.copyOf(ofTriangles, Math.max(end, 2 * ofTriangles.length));
      }
      Arrays.fill(ofTriangles, first, end, part);
      stated += end - first;
    }
  }

  /** Returns whether the faces state their parts. */
  boolean isUsed() {
    return isUsed;
  }

  /**
   * Warns of names that no face uses, and of triangles without a part.
   *
   * @param triangles the number of all triangles
   */
  void warn(int triangles, Warnings warnings) {
    if (!isUsed && !names.isEmpty()) {
      warnings.add(
          "comment " + COMMENT, "ignored, since no face has the integer property " + PROPERTY);
    } else if (isUsed && stated < triangles) {
      warnings.add(
          "element tristrips",
          "triangles without a part, which are in the first one: " + (triangles - stated));
    }
  }

  /** Returns the triangles of each part in turn; all triangles if there are no parts. */
  List<TriangleList> split(TriangleList all) {
    if (!isUsed) {
      return List.of(all);
    }
    List<TriangleList> split = new ArrayList<>();
    names.forEach(name -> split.add(new TriangleList(0)));
    for (int i = 0; i < all.count(); i++) {
      split
          .get(i < ofTriangles.length ? ofTriangles[i] : 0)
          .add(all.vertex(3 * i), all.vertex(3 * i + 1), all.vertex(3 * i + 2));
    }
    return split;
  }

  /**
   * Returns the parts that have triangles.
   *
   * @param mesh all triangles
   * @param split the triangles of each part
   */
  List<ModelPart> of(ModelGeometry mesh, List<TriangleList> split, ModelOptions options) {
    List<ModelPart> parts = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      if (split.get(i).count() > 0) {
        ModelGeometry geometry = mesh.part(split.get(i).toArray());
        ModelNode node = ModelNode.of(names.get(i), "part " + i, Optional.empty());
        parts.add(
            new ModelPart(
                node,
                PROPERTY + " " + i,
                geometry,
                PlainModel.material(geometry.colors()),
                options.toWorld()));
      }
    }
    return parts;
  }
}
