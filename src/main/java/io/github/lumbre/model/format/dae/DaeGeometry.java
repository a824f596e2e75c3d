package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.internal.ModelGeometry;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The surfaces of a geometry: its primitives by their materials and kinds of vectors. Mutable. */
final class DaeGeometry {
  private static final Set<String> LINES = Set.of("lines", "linestrips");

  /**
   * Primitives that are one surface.
   *
   * @param symbol of their material; empty for none
   * @param sets the sets of texture coordinates that each has, in ascending order
   */
  private record Key(String symbol, List<Integer> sets, boolean hasNormals, boolean hasColors) {}

  /** Primitives that are one surface, whose triangles are made once. Mutable. */
  static final class Group {
    private final Key key;
    private final DaeGeometry owner;
    private final List<DaePrimitive> primitives = new ArrayList<>();
    private final Map<List<Integer>, ModelGeometry> made = new HashMap<>();

    Group(Key key, DaeGeometry owner) {
      this.key = key;
      this.owner = owner;
    }

    String symbol() {
      return key.symbol;
    }

    /** Returns the sets of texture coordinates, in ascending order. */
    List<Integer> sets() {
      return key.sets;
    }

    String location() {
      return primitives.get(0).location();
    }

    /** Returns whether a geometry states that its back faces are invisible. */
    boolean isOneSided() {
      return owner.isOneSided;
    }

    /**
     * Returns the triangles.
     *
     * @param used one or two of the sets, or none
     */
    ModelGeometry geometry(List<Integer> used) throws ModelFormatException {
      ModelGeometry known = made.get(used);
      if (known == null) {
        known = DaeSurface.geometry(primitives, used, owner.division, owner.file);
        made.put(used, known);
      }
      return known;
    }
  }

  private final PolygonDivision division;
  private final FormatFile file;
  private final Map<Key, Group> groups = new LinkedHashMap<>();
  private final boolean isOneSided;

  private DaeGeometry(DaeElement element, PolygonDivision division, FormatFile file) {
    this.division = division;
    this.file = file;
    isOneSided = element.below("double_sided").filter(e -> e.text().equals("0")).isPresent();
  }

  /**
   * Returns a geometry.
   *
   * @param division shared by all geometries of the file, whose work together is limited
   */
  static DaeGeometry of(
      DaeElement element, DaeDocument document, DaeSources sources, PolygonDivision division)
      throws ModelFormatException {
    DaeGeometry geometry = new DaeGeometry(element, division, document.file());
    for (DaeElement shape : element.children()) {
      if (shape.is("mesh") || shape.is("convex_mesh")) {
        geometry.addMesh(shape, document, sources);
      } else if (shape.is("spline") || shape.is("brep")) {
        document.file().warnings().add(shape.location(), "left out a " + shape.name());
      }
    }
    return geometry;
  }

  private void addMesh(DaeElement mesh, DaeDocument document, DaeSources sources)
      throws ModelFormatException {
    if (!mesh.attribute("convex_hull_of").isEmpty()) {
      file.warnings().add(mesh.location(), "left out the convex hull of another geometry");
    }
    DaeDocument scoped = document.within(mesh);
    for (DaeElement child : mesh.children()) {
      if (LINES.contains(child.name())) {
        file.tally().add("left out lines", child.location());
      } else if (child.indices().isPresent()) {
        add(DaePrimitive.of(child, scoped, sources.of(scoped)));
      }
    }
  }

  private void add(DaePrimitive primitive) {
    if (primitive.positions().isEmpty()) {
      file.warnings().add(primitive.location(), "left out faces without positions");
      return;
    }
    Key key =
        new Key(
            primitive.symbol(),
            List.copyOf(primitive.uvs().keySet()),
            primitive.normals().isPresent(),
            primitive.colors().isPresent());
    groups.computeIfAbsent(key, k -> new Group(k, this)).primitives.add(primitive);
  }

  /** Returns the surfaces in the order of the file. */
  List<Group> groups() {
    return List.copyOf(groups.values());
  }
}
