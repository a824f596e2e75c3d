package generator;

import java.io.IOException;
import java.nio.file.Path;

/** Turns sculptures into files. */
final class Workshop {
  private static final int TEXTURE_SIZE = 1024;
  private static final double LEAST_COSINE = .35;

  private final Path folder;

  Workshop(Path folder) {
    this.folder = folder;
  }

  /**
   * Writes {@code name.obj}, {@code name.png} and, for a positive step, {@code name-normal.png}.
   *
   * @param reliefStep half the distance over which slopes of the relief are taken; 0 for no relief
   */
  void write(String name, String title, Sculpture sculpture, int triangles, double reliefStep)
      throws IOException {
    Mesh mesh = sculpture.mesh(triangles);
    Vec[] normals = normals(sculpture, mesh);
    Atlas atlas = new Atlas(mesh, sculpture, TEXTURE_SIZE);
    ObjFile obj = new ObjFile(4);
    for (int t = 0; t < mesh.triangleCount(); t++) {
      String[] corners = new String[3];
      for (int c = 0; c < 3; c++) {
        int i = 3 * t + c;
        corners[c] =
            obj.corner(mesh.corner(t, c), atlas.uv[2 * i], atlas.uv[2 * i + 1], normals[i]);
      }
      obj.face(corners[0], corners[1], corners[2]);
    }
    obj.write(folder.resolve(name + ".obj"), title);
    Baker baker =
        new Baker(sculpture, mesh, normals, atlas, TEXTURE_SIZE, Math.max(reliefStep, 1e-4));
    Png.write(folder.resolve(name + ".png"), baker.colours);
    if (reliefStep > 0) {
      Png.write(folder.resolve(name + "-normal.png"), baker.relief);
    }
    System.out.println(name + ": " + obj.triangles() + " triangles");
  }

  /**
   * The normal at each corner of each triangle: the body's, or the triangle's where a sharp edge
   * makes the body's point away from it.
   */
  private static Vec[] normals(Sculpture sculpture, Mesh mesh) {
    Vec[] smooth = new Vec[mesh.positions().length];
    for (int v = 0; v < smooth.length; v++) {
      smooth[v] = sculpture.normal(mesh.bodies()[v], mesh.positions()[v]);
    }
    Vec[] normals = new Vec[mesh.triangles().length];
    for (int i = 0; i < normals.length; i++) {
      Vec flat = mesh.areaVector(i / 3).normalized();
      Vec n = smooth[mesh.triangles()[i]];
      normals[i] = n.dot(flat) < LEAST_COSINE ? flat : n;
    }
    return normals;
  }
}
