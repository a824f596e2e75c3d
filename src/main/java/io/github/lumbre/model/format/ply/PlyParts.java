package io.github.lumbre.model.format.ply;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.TriangleList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The parts of a PLY file whose faces have the integer property {@code part}, which counts the
 * names that comments {@code PartName} state, from 0; so that programs without a format of scenes
 * can name parts. Files without such names have no parts. Mutable.
 */
final class PlyParts {
  /** The first word of a comment that names a part. */
  static final String COMMENT = "PartName";

  /** The property of faces. */
  static final String PROPERTY = "part";

  private final List<String> names;
  private int part;
  private int[] ofTriangles = {};
  private int triangles;

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

  void read(PlyProperty property, PlyBody body) throws ModelFormatException {
    long number = body.integer(property);
    if (number < 0 || number >= names.size()) {
      throw body.error("expected a part from 0 to " + (names.size() - 1) + ", found " + number);
    }
    part = (int) number;
    grow(triangles + 1);
  }

  /**
   * Ends a face.
   *
   * @param added the number of its triangles
   */
  void endFace(int added) {
    if (isUsed()) {
      grow(triangles + added);
      Arrays.fill(ofTriangles, triangles, triangles + added, part);
      triangles += added;
    }
  }

  private void grow(int count) {
    if (count > ofTriangles.length) {
      ofTriangles = Arrays.copyOf(ofTriangles, Math.max(count, 2 * ofTriangles.length));
    }
  }

  /** Returns whether the faces state their parts. */
  boolean isUsed() {
    return ofTriangles.length > 0;
  }

  /** Returns the triangles of each part in turn; all triangles if there are no parts. */
  List<TriangleList> split(TriangleList all) {
    if (!isUsed()) {
      return List.of(all);
    }
    List<TriangleList> split = new ArrayList<>();
    names.forEach(name -> split.add(new TriangleList(0)));
    for (int i = 0; i < all.count(); i++) {
      split
          .get(i < triangles ? ofTriangles[i] : 0)
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
