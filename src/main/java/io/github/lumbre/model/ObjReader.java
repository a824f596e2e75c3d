package io.github.lumbre.model;

import io.github.lumbre.math.Vec3;
import java.util.Arrays;

/**
 * Reads Wavefront OBJ: {@code v}, {@code vt}, {@code vn} and {@code f}. Polygons become triangle
 * fans. All other statements are ignored. If a file has no {@code vt} or no {@code vn}, indices
 * into that list are ignored; otherwise they are checked. Not reusable.
 */
public final class ObjReader {
  private static final int POSITION = 0;
  private static final int UV = 1;
  private static final int NORMAL = 2;
  private static final int NONE = -1;

  /** Texture coordinates of triangles that have none, in a file that has some. */
  private static final double[] BARYCENTRIC = {0, 0, 1, 0, 0, 1};

  private final TextScanner scanner;
  private final int[] totals;
  private final int[] counts = new int[3];
  private final double[] positions;
  private final double[] uvs;
  private double[] normals;
  private int normalCount;
  private final int[] indices;
  private int indexCount;
  private final ObjCorners corners = new ObjCorners();
  private int[] face = new int[12];

  private ObjReader(byte[] text) throws ModelFormatException {
    ObjCensus census = ObjCensus.of(text);
    scanner = new TextScanner(text);
    totals = new int[] {census.positions(), census.uvs(), census.normals()};
    positions = new double[Math.multiplyExact(3, totals[POSITION])];
    uvs = Arrays.copyOf(BARYCENTRIC, BARYCENTRIC.length + 2 * totals[UV]);
    normals = new double[Math.multiplyExact(3, totals[NORMAL])];
    normalCount = totals[NORMAL];
    indices = new int[Math.toIntExact(3 * census.triangles())];
  }

  /**
   * Returns the mesh in an OBJ text.
   *
   * @throws ModelFormatException if the text is malformed, refers to missing vertices, or has no
   *     faces
   */
  public static ObjMesh read(byte[] text) throws ModelFormatException {
    return new ObjReader(text).read();
  }

  private ObjMesh read() throws ModelFormatException {
    while (scanner.hasMore()) {
      if (scanner.nextWord()) {
        readLine();
      }
      scanner.endLine();
    }
    if (indexCount == 0) {
      throw scanner.error("expected at least one face, found the end of the file");
    }
    return new ObjMesh(
        corners.gather(POSITION, positions, 3),
        totals[NORMAL] == 0 ? new double[0] : corners.gather(NORMAL, normals, 3),
        totals[UV] == 0 ? new double[0] : corners.gather(UV, uvs, 2),
        indices);
  }

  private void readLine() throws ModelFormatException {
    if (scanner.wordIs("v")) {
      readVector(positions, 3 * counts[POSITION]++);
    } else if (scanner.wordIs("vn")) {
      readVector(normals, 3 * counts[NORMAL]++);
    } else if (scanner.wordIs("vt")) {
      int to = BARYCENTRIC.length + 2 * counts[UV]++;
      uvs[to] = scanner.nextNumber();
      uvs[to + 1] = scanner.nextNumberOrZero();
    } else if (scanner.wordIs("f")) {
      readFace();
    }
  }

  private void readVector(double[] target, int to) throws ModelFormatException {
    for (int i = 0; i < 3; i++) {
      target[to + i] = scanner.nextNumber();
    }
  }

  private void readFace() throws ModelFormatException {
    int count = 0;
    int[] corner = new int[3];
    while (scanner.nextWord()) {
      scanner.readIndices(corner);
      if (3 * count + 3 > face.length) {
        face = Arrays.copyOf(face, 2 * face.length);
      }
      for (int list = 0; list < 3; list++) {
        face[3 * count + list] = resolved(corner[list], list);
      }
      count++;
    }
    if (count < 3) {
      throw scanner.error("expected at least 3 corners per face, found " + count);
    }
    for (int k = 2; k < count; k++) {
      addTriangle(0, k - 1, k);
    }
  }

  /** Returns a zero-based index, or NONE if it is missing or the file has no such list. */
  private int resolved(int index, int list) throws ModelFormatException {
    if (index == 0 || list != POSITION && totals[list] == 0) {
      return NONE;
    }
    int found = index > 0 ? index - 1 : counts[list] + index;
    if (found < 0 || found >= totals[list]) {
      throw scanner.error(
          "expected "
              + (list == POSITION ? "a vertex" : list == UV ? "a vt" : "a vn")
              + (index > 0 ? " from 1 to " + totals[list] : " from -" + counts[list] + " to -1")
              + ", found "
              + index);
    }
    return found;
  }

  private void addTriangle(int... fan) {
    boolean hasUvs = true;
    boolean hasNormals = true;
    for (int k : fan) {
      hasUvs &= face[3 * k + UV] != NONE;
      hasNormals &= face[3 * k + NORMAL] != NONE;
    }
    int flat = hasNormals || totals[NORMAL] == 0 ? NONE : addFaceNormal(fan);
    for (int i = 0; i < 3; i++) {
      int k = 3 * fan[i];
      int uv = hasUvs ? 3 + face[k + UV] : i;
      indices[indexCount++] =
          corners.number(face[k], totals[UV] == 0 ? 0 : uv, hasNormals ? face[k + NORMAL] : flat);
    }
  }

  /**
   * Adds the geometric normal of a triangle without normals, in a file that has some, and returns
   * its index. A triangle of zero area gets (0, 1, 0).
   */
  private int addFaceNormal(int... fan) {
    Vec3 a = position(face[3 * fan[0]]);
    Vec3 normal =
        position(face[3 * fan[1]]).minus(a).cross(position(face[3 * fan[2]]).minus(a)).normalized();
    if (3 * normalCount == normals.length) {
      normals = Arrays.copyOf(normals, Math.max(3 * 16, Math.multiplyExact(2, normals.length)));
    }
    boolean usable = normal.isFinite();
    normals[3 * normalCount] = usable ? normal.x() : 0;
    normals[3 * normalCount + 1] = usable ? normal.y() : 1;
    normals[3 * normalCount + 2] = usable ? normal.z() : 0;
    return normalCount++;
  }

  private Vec3 position(int vertex) {
    return new Vec3(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
  }
}
