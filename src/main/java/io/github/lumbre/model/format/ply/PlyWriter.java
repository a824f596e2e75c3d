package io.github.lumbre.model.format.ply;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.PlainModel;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.List;
import java.util.SortedMap;

/**
 * Writes triangles as binary PLY files, which keep the bits of positions, normals and colors.
 * Stateless.
 */
public final class PlyWriter {
  private static final String LINE = "property double %s\nproperty double %s\nproperty double %s\n";
  private static final int FACE_BYTES = 1 + 3 * Integer.BYTES;
  private static final int MAX_BYTES = Integer.MAX_VALUE - 8;

  private final List<TriangleMesh> meshes;
  private final List<String> names;
  private final boolean hasNormals;
  private final boolean hasColors;

  private PlyWriter(Collection<TriangleMesh> meshes, Collection<String> names) {
    // Vertices alone would be read as points.
    boolean hasFaces = meshes.stream().anyMatch(mesh -> faces(mesh) > 0);
    this.meshes = hasFaces ? List.copyOf(meshes) : List.of();
    this.names = List.copyOf(names);
    hasNormals = meshes.stream().anyMatch(TriangleMesh::hasNormals);
    hasColors = meshes.stream().anyMatch(PlyWriter::isColored);
  }

  /** Returns the file of a mesh that is not divided into parts. */
  public static byte[] write(TriangleMesh mesh) {
    return new PlyWriter(List.of(mesh), List.of()).bytes();
  }

  /**
   * Returns the file of meshes that are parts, each with its name. Beside parts with normals, one
   * without them has zeros, which are flat triangles; beside colored parts, one without colors is
   * light gray.
   *
   * @throws IllegalArgumentException if a name is not of words with single spaces between them
   */
  public static byte[] write(SortedMap<String, TriangleMesh> parts) {
    for (String name : parts.keySet()) {
      boolean isSound = !name.isBlank() && name.equals(String.join(" ", name.trim().split("\\s+")));
      if (!isSound || name.codePoints().anyMatch(PlyWriter::isUnwritable)) {
        throw new IllegalArgumentException(
            "parts: expected names of words with single spaces between them, found "
                + PrintableText.quoted(name));
      }
    }
    return new PlyWriter(parts.values(), parts.keySet()).bytes();
  }

  /** Returns whether a character ends a line, or is half a character, which UTF-8 has not. */
  private static boolean isUnwritable(int character) {
    return Character.isISOControl(character)
        || Character.getType(character) == Character.SURROGATE;
  }

  private static boolean isColored(TriangleMesh mesh) {
    return mesh.attributes().colors().length > 0;
  }

  private static long faces(TriangleMesh mesh) {
    return (long) mesh.triangleCount() + mesh.droppedTriangles();
  }

  private byte[] bytes() {
    long vertices = meshes.stream().mapToLong(TriangleMesh::vertexCount).sum();
    long faces = meshes.stream().mapToLong(PlyWriter::faces).sum();
    byte[] header = header(vertices, faces);
    long size =
        header.length
            + vertices * ((hasNormals ? 48 : 24) + (hasColors ? 16 : 0))
            + faces * (FACE_BYTES + (names.isEmpty() ? 0 : Short.BYTES));
    if (size > MAX_BYTES) {
      throw new IllegalArgumentException(
          "triangles: expected at most %d bytes as a file, found %d".formatted(MAX_BYTES, size));
    }
    ByteBuffer out = ByteBuffer.allocate((int) size).order(ByteOrder.LITTLE_ENDIAN);
    out.put(header);
    meshes.forEach(mesh -> putVertices(mesh, out));
    int first = 0;
    for (int i = 0; i < meshes.size(); i++) {
      putFaces(meshes.get(i), first, i, out);
      first += meshes.get(i).vertexCount();
    }
    return out.array();
  }

  private byte[] header(long vertices, long faces) {
    StringBuilder text = new StringBuilder("ply\nformat binary_little_endian 1.0\n");
    names.forEach(n -> text.append("comment " + PlyParts.COMMENT + " ").append(n).append('\n'));
    text.append("element vertex ").append(vertices).append('\n');
    text.append(LINE.formatted("x", "y", "z"));
    text.append(hasNormals ? LINE.formatted("nx", "ny", "nz") : "");
    for (String color : hasColors ? List.of("red", "green", "blue", "alpha") : List.<String>of()) {
      text.append("property float ").append(color).append('\n');
    }
    text.append("element face ").append(faces).append('\n');
    text.append("property list uchar int vertex_indices\n");
    text.append(names.isEmpty() ? "" : "property ushort " + PlyParts.PROPERTY + "\n");
    return text.append("end_header\n").toString().getBytes(StandardCharsets.UTF_8);
  }

  private void putVertices(TriangleMesh mesh, ByteBuffer out) {
    float[] colors = mesh.attributes().colors();
    for (int i = 0; i < mesh.vertexCount(); i++) {
      put(mesh.position(i), out);
      if (hasNormals) {
        put(mesh.hasNormals() ? mesh.normal(i) : Vec3.ZERO, out);
      }
      for (int channel = 0; hasColors && channel < 4; channel++) {
        float gray = channel == 3 ? 1 : (float) PlainModel.ALBEDO;
        out.putFloat(colors.length > 0 ? colors[4 * i + channel] : gray);
      }
    }
  }

  private static void put(Vec3 v, ByteBuffer out) {
    out.putDouble(v.x()).putDouble(v.y()).putDouble(v.z());
  }

  /**
   * Writes the triangles of a part; for each that the mesh has dropped one without area, which
   * readers report.
   */
  private void putFaces(TriangleMesh mesh, int first, int part, ByteBuffer out) {
    int triangles = mesh.triangleCount();
    for (int i = 0; i < triangles + mesh.droppedTriangles(); i++) {
      out.put((byte) 3);
      for (int corner = 0; corner < 3; corner++) {
        out.putInt(first + (i < triangles ? mesh.vertex(i, corner) : 0));
      }
      if (!names.isEmpty()) {
        out.putShort((short) part);
      }
    }
  }
}
