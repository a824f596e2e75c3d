package io.github.lumbre.model.format.threemf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.XmlReader;
import io.github.lumbre.model.format.threemf.ThreeMfObject.Surface;
import io.github.lumbre.model.internal.Corners;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.TriangleList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads the mesh of an object: a surface for each material, group of colors or texture. Mutable.
 */
final class MeshReader {
  private static final double[] NONE = {};

  /** Attributes with the colors that PrusaSlicer and its descendants paint on triangles. */
  private static final List<String> PAINT = List.of("mmu_segmentation", "paint_color");

  /** The memory of a corner that shares its vertex with no other. */
  private static final long CORNER_BYTES = 100;

  /**
   * What the triangles of a surface have in common.
   *
   * @param group empty for triangles without a property
   * @param material the index of a material in its group; 0 for other properties
   */
  private record Key(Optional<PropertyGroup> group, int material) {}

  /**
   * The triangles of a surface.
   *
   * @param properties the indices of colors or of texture coordinates of three corners each
   */
  private record Slot(TriangleList triangles, TriangleList properties) {}

  private final XmlReader xml;
  private final ThreeMfFile file;
  private final Map<Integer, PropertyGroup> groups;
  private final int objectGroup;
  private final int objectProperty;
  private final Map<Key, Slot> slots = new LinkedHashMap<>();
  private Key lastKey = new Key(Optional.empty(), -1);
  private Slot lastSlot = new Slot(new TriangleList(0), new TriangleList(0));
  private double[] positions = new double[3 * 16];
  private int vertices;

  /**
   * @param xml at the mesh
   * @param groups by their ids
   * @param objectGroup the id of the group of triangles that state none; -1 if they have none
   * @param objectProperty the property of triangles that state none
   */
  MeshReader(
      XmlReader xml,
      ThreeMfFile file,
      Map<Integer, PropertyGroup> groups,
      int objectGroup,
      int objectProperty) {
    this.xml = xml;
    this.file = file;
    this.groups = groups;
    this.objectGroup = objectGroup;
    this.objectProperty = objectProperty;
  }

  /** Returns the surfaces of the mesh that have an area. */
  List<Surface> read() throws ModelFormatException {
    String location = xml.location();
    int depth = xml.depth();
    while (xml.nextWithin(depth)) {
      if (xml.is(ThreeMfExtensions.CORE, "vertices")) {
        readVertices();
      } else if (xml.is(ThreeMfExtensions.CORE, "triangles")) {
        readTriangles();
      } else {
        ThreeMfExtensions.warnOf(xml, file.warnings());
      }
    }
    TriangleList.clearBroken(positions);
    List<Surface> surfaces = new ArrayList<>();
    for (Map.Entry<Key, Slot> entry : slots.entrySet()) {
      if (entry.getValue().triangles.count() > 0) {
        surfaces.add(surface(entry.getKey(), entry.getValue(), location));
      }
    }
    return surfaces;
  }

  private void readVertices() throws ModelFormatException {
    int depth = xml.depth();
    while (xml.nextWithin(depth)) {
      if (xml.is(ThreeMfExtensions.CORE, "vertex")) {
        if (3 * vertices == positions.length) {
          ModelLimits.require(xml.location(), "vertices", ModelLimits.MAX_COUNT / 2, vertices);
          file.take(xml.location(), 2L * Double.BYTES * positions.length);
          positions = Arrays.copyOf(positions, 2 * positions.length);
        }
        positions[3 * vertices] = xml.number("x");
        positions[3 * vertices + 1] = xml.number("y");
        positions[3 * vertices + 2] = xml.number("z");
        vertices++;
      }
    }
  }

  private void readTriangles() throws ModelFormatException {
    int depth = xml.depth();
    int count = 0;
    while (xml.nextWithin(depth)) {
      if (xml.is(ThreeMfExtensions.CORE, "triangle")) {
        if ((++count & ModelLimits.INTERRUPT_MASK) == 0) {
          file.take(xml.location(), 2L * Integer.BYTES * 3 * ModelLimits.INTERRUPT_MASK);
          ModelLimits.requireTriangles(xml.location(), count, file.options().limits());
          ModelLimits.requireHeap(xml.location(), count);
        }
        readTriangle();
      }
    }
  }

  private void readTriangle() throws ModelFormatException {
    if (PAINT.stream().anyMatch(xml::hasLocal)) {
      file.tally().add("left out the colors of triangles painted in a slicer", xml.location());
    }
    int a = xml.integer("v1", vertices - 1L);
    int b = xml.integer("v2", vertices - 1L);
    int c = xml.integer("v3", vertices - 1L);
    boolean isStated = xml.has("p1");
    int id = xml.has("pid") ? xml.integer("pid", Integer.MAX_VALUE) : objectGroup;
    Optional<PropertyGroup> group = Optional.ofNullable(groups.get(id));
    if (group.isEmpty() && id >= 0) {
      file.tally().add("ignored properties of groups that are not known", xml.location());
    }
    if (group.isEmpty()) {
      add(new Key(group, 0), a, b, c, 0, 0, 0);
      return;
    }
    long last = group.get().count() - 1L;
    int p1 = isStated ? xml.integer("p1", last) : checkedProperty(last);
    int p2 = isStated && xml.has("p2") ? xml.integer("p2", last) : p1;
    int p3 = isStated && xml.has("p3") ? xml.integer("p3", last) : p1;
    boolean isMaterial = group.get().kind() == PropertyGroup.Kind.MATERIAL;
    add(new Key(group, isMaterial ? p1 : 0), a, b, c, p1, p2, p3);
  }

  private int checkedProperty(long last) throws ModelFormatException {
    if (objectProperty > last) {
      throw xml.error("expected a property from 0 to " + last + ", found " + objectProperty);
    }
    return objectProperty;
  }

  private void add(Key key, int a, int b, int c, int p1, int p2, int p3)
      throws ModelFormatException {
    if (!key.equals(lastKey)) {
      lastKey = key;
      lastSlot =
          slots.computeIfAbsent(key, k -> new Slot(new TriangleList(0), new TriangleList(0)));
      ModelLimits.require(xml.location(), "parts", ModelLimits.MAX_PARTS, slots.size());
    }
    boolean isAdded = lastSlot.triangles.addSound(positions, a, b, c, file.tally(), xml::location);
    boolean hasOwn = key.group.isPresent() && key.group.get().kind() != PropertyGroup.Kind.MATERIAL;
    if (isAdded && hasOwn) {
      lastSlot.properties.add(p1, p2, p3);
    }
  }

  private Surface surface(Key key, Slot slot, String location) throws ModelFormatException {
    int[] indices = slot.triangles.toArray();
    boolean hasOwn = slot.properties.count() > 0;
    if (slots.size() == 1 && !hasOwn) {
      double[] all = Arrays.copyOf(positions, 3 * vertices);
      return new Surface(geometry(all, NONE, new float[0], indices), material(key));
    }
    file.take(location, CORNER_BYTES * indices.length);
    Corners corners = new Corners();
    for (int i = 0; i < indices.length; i++) {
      indices[i] = corners.number(indices[i], hasOwn ? slot.properties.vertex(i) : 0, 0);
    }
    double[] used = corners.gather(0, positions, 3);
    if (!hasOwn) {
      return new Surface(geometry(used, NONE, new float[0], indices), material(key));
    }
    PropertyGroup group = key.group.orElseThrow();
    if (group.kind() == PropertyGroup.Kind.TEXTURE) {
      double[] uvs = corners.gather(1, group.values(), 2);
      return new Surface(geometry(used, uvs, new float[0], indices), material(key));
    }
    float[] colors = floats(corners.gather(1, group.values(), 4));
    return new Surface(geometry(used, NONE, colors, indices), PlainModel.material(colors));
  }

  private static ModelMaterial material(Key key) {
    return key.group
        .map(group -> group.material(key.material))
        .orElse(PlainModel.defaultMaterial());
  }

  private static ModelGeometry geometry(
      double[] positions, double[] uvs, float[] colors, int... indices) {
    return new ModelGeometry(positions, NONE, NONE, uvs, NONE, colors, indices);
  }

  private static float[] floats(double... values) {
    float[] floats = new float[values.length];
    for (int i = 0; i < values.length; i++) {
      floats[i] = (float) values[i];
    }
    return floats;
  }
}
