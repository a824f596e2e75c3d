package io.github.lumbre.model.format.off;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.HeapNeed;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.Warnings;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Reads OFF texts (Geomview manual, "OFF: Object File Format"), with normals, colors and texture
 * coordinates of vertices, and colors of faces. Polygons become triangle fans. Colors of vertices
 * win over those of faces. Without faces, the vertices are points. A text that is not laid out in
 * lines is read by its numbers alone, see {@link OffLayout}. Not reusable.
 */
public final class OffReader {
  /** The fewest bytes of a triangle: {@code 3 0 1 2} with a line end. */
  private static final int TRIANGLE_BYTES = 8;

  /** The memory of a corner that shares its vertex with no other. */
  private static final long PAINTED_BYTES = 100;

  private static final int MOST_COLORS = 4;

  private final TextScanner scanner;
  private final int size;
  private final OffLayout layout;
  private final ModelOptions options;
  private final Warnings warnings = new Warnings();
  private final Tally tally = new Tally();
  private final OffHeader header;
  private final OffVertices vertices;
  private final OffColors colors;
  private final TriangleList triangles;

  /** The number of the face of each triangle. */
  private int[] faces;

  private OffReader(byte[] file, ModelOptions options, OffLayout layout)
      throws ModelFormatException {
    this.options = options;
    this.layout = layout;
    size = file.length;
    scanner = new TextScanner(file);
    header = OffHeader.read(scanner, size, layout);
    vertices = new OffVertices(header, layout, options.limits());
    colors = new OffColors(header.faces());
    if (header.faces() == 0) {
      ModelLimits.require("", "points", options.limits().triangles(), header.vertices());
      ModelLimits.requireHeapOfPoints("", header.vertices());
    }
    int expected = Math.min(header.faces(), size / TRIANGLE_BYTES);
    ModelLimits.requireTriangles("", expected, options.limits());
    ModelLimits.requireMemory("", 16L * expected, options.limits());
    ModelLimits.requireHeap("", expected);
    triangles = new TriangleList(expected);
    faces = new int[expected];
  }

  /** Returns whether a file begins like an OFF file. */
  public static boolean startsIn(byte[] start, long size) {
    return FileContent.describe(start).equals(Optional.of("OFF"));
  }

  /** Returns the faces that a header states; without any, the vertices. */
  public static HeapNeed need(byte[] start, long size) {
    for (OffLayout layout : OffLayout.values()) {
      try {
        int bytes = (int) Math.min(size, Integer.MAX_VALUE);
        OffHeader header = OffHeader.read(new TextScanner(start), bytes, layout);
        return header.faces() == 0
            ? HeapNeed.ofPoints(header.vertices())
            : HeapNeed.ofTriangles(header.faces());
      } catch (ModelFormatException e) {
        continue; // Reading the file reports what is wrong with it.
      }
    }
    return HeapNeed.UNKNOWN;
  }

  /** Returns the triangles of an OFF text. */
  public static Model read(byte[] file, ModelFolder folder, ModelOptions options)
      throws ModelFormatException {
    Optional<ModelFormatException> first = Optional.empty();
    for (OffLayout layout : OffLayout.values()) {
      try {
        return new OffReader(file, options, layout).read();
      } catch (ModelFormatException e) {
        if (first.isEmpty() && e.kind() != Kind.MALFORMED) {
          throw e;
        }
        first = first.or(() -> Optional.of(e));
      }
    }
    throw first.orElseThrow();
  }

  private Model read() throws ModelFormatException {
    vertices.read(scanner, tally);
    for (int i = 0; i < header.faces(); i++) {
      if (!scanner.nextWordOfText()) {
        throw scanner.error("expected " + header.faces() + " faces, found " + i);
      }
      readFace(i);
      layout.end(scanner);
    }
    if (scanner.nextWordOfText()) {
      if (layout != OffLayout.LINES) {
        throw scanner.error("expected the end of the file after the last face, found more");
      }
      warnings.add(scanner.location(), "ignored what follows the last face");
    }
    tally.addTo(warnings);
    return header.faces() == 0
        ? PlainModel.cloud("", vertices.geometry(), options.toWorld(), warnings)
        : PlainModel.of(List.of(part()), warnings.all());
  }

  private void readFace(int face) throws ModelFormatException {
    int corners = (int) scanner.integer(layout.isTokens() ? 3 : 0, size);
    if (corners < 3) {
      tally.add(Tally.NARROW, scanner.location());
      return;
    }
    int first = vertex();
    int previous = vertex();
    for (int i = 2; i < corners; i++) {
      int next = vertex();
      add(face, first, previous, next);
      previous = next;
    }
    double[] color = new double[layout.isTokens() ? 0 : MOST_COLORS + 1];
    int found = 0;
    while (found < color.length && scanner.nextWord()) {
      color[found++] = scanner.numberOrNan();
    }
    if (found > 0) {
      colors.put(face, color, 0, found, scanner, tally);
    }
  }

  private int vertex() throws ModelFormatException {
    if (!layout.next(scanner)) {
      throw scanner.error("expected a vertex, found the end of the line");
    }
    return (int) scanner.integer(0, header.vertices() - 1L);
  }

  private void add(int face, int a, int b, int c) throws ModelFormatException {
    int count = triangles.count();
    if (count == ModelLimits.MAX_COUNT) {
      scanner.require("triangles", count, count + 1L);
    }
    if (count == faces.length) {
      faces = Arrays.copyOf(faces, (int) Math.min(2L * count + 4, ModelLimits.MAX_COUNT));
    }
    faces[count] = face;
    triangles.addSound(vertices.positions(), a, b, c, tally, scanner::location);
  }

  private ModelPart part() throws ModelFormatException {
    vertices.repair(warnings);
    int[] indices = triangles.toArray();
    boolean isPainted = colors.isPresent() && !vertices.hasColors();
    ModelLimits.requireMemory("", isPainted ? PAINTED_BYTES * indices.length : 0, options.limits());
    ModelGeometry mesh =
        isPainted ? vertices.geometry(indices, faces, colors) : vertices.geometry(indices);
    PlainModel.showInvisible("", mesh.colors(), warnings);
    return new ModelPart(
        ModelNode.undivided(""), "", mesh, PlainModel.material(mesh.colors()), options.toWorld());
  }
}
