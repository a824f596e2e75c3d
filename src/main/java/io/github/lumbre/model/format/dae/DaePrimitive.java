package io.github.lumbre.model.format.dae;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.internal.Tally;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A list of triangles, strips, fans or polygons, and the vectors of its corners. Mutable.
 */
final class DaePrimitive {
  /** More inputs of vertices are not needed. */
  private static final int MAX_INPUTS = 64;

  /** More indices of a corner are not needed. */
  private static final int MAX_OFFSET = 1000;

  /**
   * What a corner has an index of.
   *
   * @param offset of the index among those of a corner
   * @param vectors three numbers each, or two, or four
   */
  record Input(int offset, double[] vectors) {}

  private final DaeElement element;
  private final DaeIndices indices;
  private final FormatFile file;
  private int stride = 1;
  private Optional<Input> positions = Optional.empty();
  private Optional<Input> normals = Optional.empty();
  private Optional<Input> colors = Optional.empty();
  private final TreeMap<Integer, Input> uvs = new TreeMap<>();

  private DaePrimitive(DaeElement element, FormatFile file) {
    this.element = element;
    indices = element.indices().orElseThrow();
    this.file = file;
  }

  /** Returns the primitive of an element; it has no positions if its sources are missing. */
  static DaePrimitive of(DaeElement element, DaeDocument document, DaeSources sources)
      throws ModelFormatException {
    DaePrimitive primitive = new DaePrimitive(element, document.file());
    for (DaeElement input : element.children("input")) {
      int offset = input.integer("offset", 0);
      if (offset > MAX_OFFSET) {
        document.file().warnings().add(input.location(), "left out an input beyond offset 1000");
        continue;
      }
      primitive.stride = Math.max(primitive.stride, offset + 1);
      if (input.attribute("semantic").equals("VERTEX")) {
        Optional<DaeElement> vertices =
            document.find("vertices", input.attribute("source"), input.location());
        List<DaeElement> inputs = vertices.map(v -> v.children("input")).orElse(List.of());
        for (DaeElement each : inputs.subList(0, Math.min(MAX_INPUTS, inputs.size()))) {
          primitive.add(each, offset, sources, false);
        }
      } else {
        primitive.add(input, offset, sources, true);
      }
    }
    return primitive;
  }

  /**
   * Adds an input.
   *
   * @param isOwn whether it wins over that of the vertices
   */
  private void add(DaeElement input, int offset, DaeSources sources, boolean isOwn)
      throws ModelFormatException {
    String source = input.attribute("source");
    String location = input.location();
    switch (input.attribute("semantic")) {
      case "POSITION" ->
          positions = better(positions, offset, sources.vectors(source, location), isOwn);
      case "NORMAL" -> normals = better(normals, offset, sources.vectors(source, location), isOwn);
      case "COLOR" -> colors = better(colors, offset, sources.colors(source, location), isOwn);
      case "TEXCOORD" -> {
        int set = input.integer("set", 0);
        better(Optional.ofNullable(uvs.get(set)), offset, sources.uvs(source, location), isOwn)
            .ifPresent(best -> uvs.put(set, best));
      }
      default -> {
        // Tangents are computed, and others have no effect.
      }
    }
  }

  /** Returns the old input, or a new one if it has vectors and wins. */
  private static Optional<Input> better(
      Optional<Input> old, int offset, double[] vectors, boolean isOwn) {
    return vectors.length == 0 || old.isPresent() && !isOwn
        ? old
        : Optional.of(new Input(offset, vectors));
  }

  String symbol() {
    return element.attribute("material");
  }

  String location() {
    return element.location();
  }

  Optional<Input> positions() {
    return positions;
  }

  Optional<Input> normals() {
    return normals;
  }

  Optional<Input> colors() {
    return colors;
  }

  /** Returns the texture coordinates by the numbers of their sets. */
  TreeMap<Integer, Input> uvs() {
    return uvs;
  }

  /**
   * Returns the index of a corner; -1 if it is none, or beyond its vectors.
   *
   * @param corner the place of its first index
   * @param size the numbers of a vector
   */
  int index(Input input, int corner, int size) {
    int index = indices.value(corner + input.offset);
    return index < input.vectors.length / size ? index : -1;
  }

  /**
   * Divides the primitive into triangles of corners.
   *
   * @param polygons receives polygons, and passes triangles on
   */
  void divide(PolygonDivision polygons) throws ModelFormatException {
    int found =
        switch (element.name()) {
          case "triangles" -> triangles(polygons);
          case "polylist" -> polylist(polygons);
          case "polygons" -> polygons(polygons);
          default -> strips(polygons);
        };
    int stated = element.integer("count", found);
    if (found < stated) {
      file.warnings()
          .add(
              "fewer elements than stated",
              location(),
              "expected %d in <%s>, found %d".formatted(stated, element.name(), found));
    }
  }

  /** Returns the number of whole corners between two places. */
  private int corners(int from, int to) {
    if ((to - from) % stride != 0) {
      file.tally().add("ignored indices behind the last whole corner", location());
    }
    return (to - from) / stride;
  }

  private int triangles(PolygonDivision polygons) throws ModelFormatException {
    int corners = corners(0, indices.size());
    for (int k = 0; k + 2 < corners; k += 3) {
      int first = k * stride;
      polygons.triangle(first, first + stride, first + 2 * stride);
    }
    if (corners % 3 != 0) {
      file.tally().add(Tally.NARROW, location());
    }
    return corners / 3;
  }

  private int polylist(PolygonDivision polygons) throws ModelFormatException {
    int at = 0;
    int polygon = 0;
    for (; polygon < indices.polygons(); polygon++) {
      long end = at + (long) stride * indices.corners(polygon);
      if (end < at || end > indices.size()) {
        file.tally().add("left out polygons whose number of corners is wrong", location());
        return polygon;
      }
      polygons.begin();
      addLoop(polygons, at, (int) end);
      polygons.finish();
      at = (int) end;
    }
    if (at < indices.size()) {
      file.tally().add("ignored indices behind the last polygon", location());
    }
    return polygon;
  }

  private int polygons(PolygonDivision polygons) throws ModelFormatException {
    int count = 0;
    for (int loop = 0; loop < indices.loops(); count++) {
      polygons.begin();
      addLoop(polygons, indices.start(loop), indices.end(loop));
      for (loop++; loop < indices.loops() && indices.isHole(loop); loop++) {
        addLoop(polygons, indices.start(loop), indices.end(loop));
      }
      polygons.finish();
    }
    return count;
  }

  private void addLoop(PolygonDivision polygons, int from, int to) throws ModelFormatException {
    int corners = corners(from, to);
    for (int k = 0; k < corners; k++) {
      polygons.add(from + k * stride);
    }
    polygons.endLoop();
  }

  private int strips(PolygonDivision polygons) throws ModelFormatException {
    for (int loop = 0; loop < indices.loops(); loop++) {
      int start = indices.start(loop);
      int corners = corners(start, indices.end(loop));
      if (corners < 3) {
        file.tally().add(Tally.NARROW, location());
      }
      for (int k = 2; k < corners; k++) {
        int last = start + k * stride;
        if (element.is("trifans")) {
          polygons.triangle(start, last - stride, last);
        } else if (k % 2 == 0) {
          polygons.triangle(last - 2 * stride, last - stride, last);
        } else {
          polygons.triangle(last - stride, last - 2 * stride, last);
        }
      }
    }
    return indices.loops();
  }
}
