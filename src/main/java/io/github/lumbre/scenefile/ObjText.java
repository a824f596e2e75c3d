package io.github.lumbre.scenefile;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.TexturePoint;
import java.nio.charset.StandardCharsets;

/** Writes meshes as OBJ files whose numbers have all their bits. */
final class ObjText {
  private ObjText() {}

  static byte[] of(TriangleMesh mesh) {
    if (mesh.triangleCount() == 0) {
      throw new Unwritable("a mesh with triangles", "one without");
    }
    if (!mesh.isPlain()) {
      throw new Unwritable(
          "a mesh with positions, normals on the front and one set of texture coordinates",
          "one with more, or with normals on the back");
    }
    StringBuilder text = new StringBuilder(64 * mesh.vertexCount());
    for (int i = 0; i < mesh.vertexCount(); i++) {
      line(text, "v", mesh.position(i));
    }
    if (mesh.hasUvs()) {
      uvs(text, mesh);
    }
    for (int i = 0; mesh.hasNormals() && i < mesh.vertexCount(); i++) {
      line(text, "vn", mesh.normal(i));
    }
    for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
      text.append('f');
      for (int corner = 0; corner < 3; corner++) {
        int number = mesh.vertex(triangle, corner) + 1;
        text.append(' ').append(number);
        if (mesh.hasUvs() || mesh.hasNormals()) {
          text.append('/').append(mesh.hasUvs() ? "" + number : "");
        }
        if (mesh.hasNormals()) {
          text.append('/').append(number);
        }
      }
      text.append('\n');
    }
    return text.toString().getBytes(StandardCharsets.US_ASCII);
  }

  private static void uvs(StringBuilder text, TriangleMesh mesh) {
    for (int i = 0; i < mesh.vertexCount(); i++) {
      TexturePoint uv = mesh.uv(i);
      text.append("vt ").append(uv.u()).append(' ').append(uv.v()).append('\n');
    }
  }

  private static void line(StringBuilder text, String key, Vec3 v) {
    text.append(key).append(' ').append(v.x()).append(' ').append(v.y());
    text.append(' ').append(v.z()).append('\n');
  }
}
