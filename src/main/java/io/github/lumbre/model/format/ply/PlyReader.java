package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.HeapNeed;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TriangleList;
import io.github.lumbre.model.internal.Warnings;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Reads PLY files of all three formats (Turk 1994, "The PLY Polygon File Format"): elements {@code
 * vertex}, {@code face} and {@code tristrips} in any order. Polygons become triangle fans; without
 * faces, the vertices are points. Integer colors are sRGB-encoded, float colors linear. Not
 * reusable.
 */
public final class PlyReader {
  private static final List<String> INDEX_NAMES = List.of("vertex_indices", "vertex_index");

  private final ModelOptions options;
  private final PlyHeader header;
  private final PlyBody body;
  private final Warnings warnings = new Warnings();
  private final Tally tally = new Tally();
  private final PlyVertices vertices;
  private final int vertexCount;

  /** Whether there are no faces, so that all vertices are points. */
  private final boolean isCloud;

  private TriangleList triangles = new TriangleList(0);

  /** What the faces have besides their corners; empty if there are no faces. */
  private Optional<PlyFaceData> faceData = Optional.empty();

  private final PlyParts parts;

  private PlyReader(byte[] file, ModelOptions options) throws ModelFormatException {
    this.options = options;
    header = PlyHeader.read(file, warnings);
    body =
        header.format() == PlyHeader.Format.TEXT
            ? new PlyTextBody(file, header, tally)
            : new PlyBinaryBody(file, header);
    requireBytes();
    parts = new PlyParts(header.comments().parts());
    Optional<PlyElement> vertex =
        header.elements().stream().filter(PlyElement::isVertex).findFirst();
    if (vertex.isEmpty()) {
      throw Kind.MALFORMED.at("", "expected an element vertex, found none");
    }
    vertexCount = vertex.get().count();
    isCloud = header.elements().stream().noneMatch(e -> isFace(e) && e.count() > 0);
    if (isCloud) {
      ModelLimits.require("element vertex", "points", options.limits().triangles(), vertexCount);
      ModelLimits.requireHeapOfPoints("element vertex", vertexCount);
    } else {
      requireFaces();
    }
    vertices = new PlyVertices(vertex.get(), options.limits(), warnings, tally);
  }

  /** Returns whether a file begins like a PLY file. */
  public static boolean startsIn(byte[] start, long size) {
    return FileContent.describe(start).equals(Optional.of("PLY"));
  }

  /**
   * Returns the triangles that a header states, if all faces of a binary file have as many corners;
   * without faces, the vertices.
   */
  public static HeapNeed need(byte[] start, long size) {
    PlyHeader header;
    try {
      header = PlyHeader.read(start, new Warnings());
    } catch (ModelFormatException e) {
      return HeapNeed.UNKNOWN; // Reading the file reports what is wrong with it.
    }
    List<PlyElement> elements = header.elements();
    Optional<PlyElement> faces =
        elements.stream().filter(e -> indexProperty(e).isPresent() && e.count() > 0).findFirst();
    if (faces.isEmpty()) {
      return HeapNeed.ofPoints(
          elements.stream().filter(PlyElement::isVertex).mapToLong(PlyElement::count).sum());
    }
    long least = elements.stream().mapToLong(e -> e.minBinaryBytes() * e.count()).sum();
    long lists =
        elements.stream()
            .flatMap(element -> element.properties().stream())
            .filter(PlyProperty::isList)
            .count();
    long bytes = indexProperty(faces.get()).orElseThrow().type().bytes();
    long count = faces.get().count();
    return HeapNeed.ofTriangles(
        lists == 1 && header.format() != PlyHeader.Format.TEXT
            ? Math.max(count, (size - header.bodyOffset() - least) / bytes - 2 * count)
            : count);
  }

  public static Model read(byte[] file, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    return new PlyReader(file, options).read(folder);
  }

  /** Checks that the file is as large as its header requires, before memory is allocated. */
  private void requireBytes() throws ModelFormatException {
    long left = body.remainingBytes();
    for (PlyElement element : header.elements()) {
      long min = body.minBytes(element);
      if (min * element.count() > left) {
        throw Kind.MALFORMED.at(
            "element " + PrintableText.shortened(element.name()),
            "expected %d items of at least %d bytes, found %d bytes"
                .formatted(element.count(), min, left));
      }
      left -= min * element.count();
    }
  }

  private void requireFaces() throws ModelFormatException {
    if (header.elements().stream().noneMatch(e -> indexProperty(e).isPresent())) {
      throw Kind.UNSUPPORTED.at(
          "", "expected an element face or tristrips with a list vertex_indices, found none");
    }
  }

  private static boolean isFace(PlyElement element) {
    return element.name().equals("face") || element.name().equals("tristrips");
  }

  private static Optional<PlyProperty> indexProperty(PlyElement element) {
    return isFace(element)
        ? element.properties().stream()
            .filter(p -> p.isList() && p.type().isInteger() && INDEX_NAMES.contains(p.name()))
            .findFirst()
        : Optional.empty();
  }

  private Model read(ModelFolder folder) throws ModelFormatException, IOException {
    for (PlyElement element : header.elements()) {
      if (element.isVertex()) {
        vertices.read(body);
      } else if (!element.properties().isEmpty()) {
        readOther(element);
      }
    }
    if (header.format() != PlyHeader.Format.TEXT && body.remainingBytes() > 0) {
      warnings.add("", "ignored " + body.remainingBytes() + " bytes after the last element");
    }
    return isCloud ? cloud() : mesh(folder);
  }

  private Model cloud() {
    tally.addTo(warnings);
    if (!header.comments().textures().isEmpty()) {
      warnings.add("comment TextureFile", "ignored, since points have no textures");
    }
    parts.warn(0, warnings);
    ModelGeometry all = vertices.geometry(new int[0]);
    return PlainModel.cloud("element vertex", all, options.toWorld(), warnings);
  }

  private Model mesh(ModelFolder folder) throws ModelFormatException, IOException {
    if (faceData.isPresent() && faceData.get().isUsed()) {
      separateTriangles(faceData.get());
    }
    tally.addTo(warnings);
    parts.warn(triangles.count(), warnings);
    List<TriangleList> split = soundTriangles();
    ModelGeometry mesh = vertices.geometry(triangles.toArray());
    PlainModel.showInvisible("element vertex", mesh.colors(), warnings);
    return PlainModel.of(surfaces(mesh, split, folder), warnings.all());
  }

  /** Returns the triangles of each part without broken ones, which are left out of all, too. */
  private List<TriangleList> soundTriangles() {
    List<TriangleList> split = parts.split(triangles);
    int broken = split.stream().mapToInt(list -> list.removeBroken(vertices.positions())).sum();
    if (broken > 0) {
      warnings.add("", "left out triangles with a vertex that is not a finite number: " + broken);
    }
    int dropped = split.stream().mapToInt(list -> list.removeFlat(vertices.positions())).sum();
    if (dropped > 0) {
      warnings.add("", "dropped triangles of zero area: " + dropped);
    }
    triangles = TriangleList.joined(split);
    vertices.repair(triangles, broken > 0, warnings);
    return split;
  }

  private List<ModelPart> surfaces(
      ModelGeometry mesh, List<TriangleList> split, ModelFolder folder)
      throws ModelFormatException, IOException {
    ModelMaterial material = PlainModel.material(mesh.colors());
    PlyTextures textures = textures(mesh, folder);
    if (textures.isPresent()) {
      if (parts.isUsed()) {
        warnings.add("", "ignored the parts, since there is a texture");
      }
      return textures.parts(mesh, material, this::textureOf, options);
    }
    return parts.isUsed()
        ? parts.of(mesh, split, options)
        : List.of(new ModelPart(ModelNode.undivided(""), "", mesh, material, options.toWorld()));
  }

  private void separateTriangles(PlyFaceData faces) throws ModelFormatException {
    int count = triangles.count();
    faces.cover(count);
    faces.warnOfIncomplete(count, warnings);
    vertices.separate(triangles.toArray(), faces);
    triangles = new TriangleList(count);
    for (int i = 0; i < count; i++) {
      triangles.add(3 * i, 3 * i + 1, 3 * i + 2);
    }
  }

  /** Returns the number of the texture of the triangle that has a vertex. */
  private int textureOf(int vertex) {
    return faceData.filter(PlyFaceData::isUsed).map(f -> f.texture(vertex / 3)).orElse(0);
  }

  private PlyTextures textures(ModelGeometry mesh, ModelFolder folder)
      throws ModelFormatException, IOException {
    boolean isUsed = mesh.uv0().length > 0;
    if (!isUsed && !header.comments().textures().isEmpty()) {
      warnings.add("comment TextureFile", "ignored, since there are no texture coordinates");
    }
    PlyTextures textures =
        new PlyTextures(
            isUsed ? header.comments().textures() : List.of(),
            new ModelFiles(folder, options.limits(), warnings),
            options,
            warnings);
    if (textures.isPresent() && mesh.colors().length > 0) {
      warnings.add("", "ignored the colors, since there is a texture");
    }
    return textures;
  }

  private void readOther(PlyElement element) throws ModelFormatException {
    Optional<PlyProperty> indices = indexProperty(element);
    boolean isStrip = element.name().equals("tristrips");
    Optional<PlyFaceData> data =
        indices.isPresent() && !isStrip
            ? Optional.of(new PlyFaceData(element, !vertices.hasColors(), options.limits(), tally))
            : Optional.empty();
    if (indices.isPresent()) {
      if (data.isPresent()) {
        faceData = data;
        parts.begin(element);
      }
      List<String> ignored =
          element.properties().stream()
              .filter(p -> p != indices.get() && data.filter(d -> d.uses(p)).isEmpty())
              .filter(p -> isStrip || !parts.uses(p))
              .map(PlyProperty::name)
              .collect(Collectors.toList());
      warnIgnored(element, ignored, warnings);
      // Most meshes consist of triangles or of quadrilaterals, and 12 bytes are few.
      // A face has at least one triangle, unless it is empty.
      ModelLimits.requireTriangles("element face", isStrip ? 0 : element.count(), options.limits());
      long bytes = !header.comments().parts().isEmpty() ? 28L : 12L;
      ModelLimits.requireMemory("element face", bytes * element.count(), options.limits());
      ModelLimits.requireHeap("element face", isStrip ? 0 : element.count());
      triangles = triangles.count() == 0 ? new TriangleList(element.count()) : triangles;
    }
    for (int i = 0; i < element.count(); i++) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      body.beginItem(element, i);
      int before = triangles.count();
      for (PlyProperty property : element.properties()) {
        if (indices.isPresent() && property == indices.get()) {
          readIndices(property, isStrip);
        } else if (data.isPresent() && data.get().uses(property)) {
          data.get().read(property, body);
        } else if (data.isPresent() && parts.uses(property)) {
          parts.read(property, body);
        } else if (property.isList()) {
          skipList(property, body);
        } else {
          body.number(property);
        }
      }
      body.endItem();
      if (data.isPresent()) {
        data.get().endFace(before, triangles.count());
        parts.endFace(before, triangles.count());
      }
    }
  }

  private void readIndices(PlyProperty property, boolean isStrip) throws ModelFormatException {
    int length = body.listLength(property);
    if (isStrip) {
      readStrip(property, length);
      return;
    }
    if (length < 3) {
      tally.add(Tally.NARROW, body.location());
      for (int i = 0; i < length; i++) {
        body.integer(property);
      }
      return;
    }
    int first = vertex(body.integer(property));
    int previous = vertex(body.integer(property));
    for (int i = 2; i < length; i++) {
      int next = vertex(body.integer(property));
      addTriangle(first, previous, next);
      previous = next;
    }
  }

  /** Reads strips that end with -1: every second triangle has the opposite order. */
  private void readStrip(PlyProperty property, int length) throws ModelFormatException {
    int before = 0;
    int previous = 0;
    int size = 0;
    for (int i = 0; i < length; i++) {
      long index = body.integer(property);
      if (index == -1) {
        size = 0;
        continue;
      }
      int next = vertex(index);
      if (size >= 2) {
        boolean even = size % 2 == 0;
        addTriangle(even ? before : previous, even ? previous : before, next);
      }
      before = previous;
      previous = next;
      size++;
    }
  }

  private void addTriangle(int a, int b, int c) throws ModelFormatException {
    if (triangles.count() == ModelLimits.MAX_COUNT) {
      throw Kind.TOO_LARGE.at("", "expected at most " + ModelLimits.MAX_COUNT + " triangles");
    }
    triangles.add(a, b, c);
  }

  private int vertex(long index) throws ModelFormatException {
    if (index < 0 || index >= vertexCount) {
      throw body.error("expected a vertex from 0 to " + (vertexCount - 1) + ", found " + index);
    }
    return (int) index;
  }

  /** Reads a list whose content is not used. */
  static void skipList(PlyProperty property, PlyBody body) throws ModelFormatException {
    int length = body.listLength(property);
    for (int i = 0; i < length; i++) {
      body.number(property);
    }
  }

  /** Adds a warning of properties that are not used. */
  static void warnIgnored(PlyElement element, List<String> names, Warnings warnings) {
    if (!names.isEmpty()) {
      warnings.add(
          "element " + element.name(),
          "ignored the properties " + PrintableText.shortened(String.join(", ", names)));
    }
  }
}
