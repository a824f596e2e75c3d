package io.github.lumbre.model.format.obj;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Corners;
import io.github.lumbre.model.internal.Tally;
import io.github.lumbre.model.internal.TextScanner;
import io.github.lumbre.model.internal.Warnings;
import java.util.Arrays;

/**
 * Reads the vertices and faces of an OBJ text: {@code v}, {@code vt}, {@code vn} and {@code f}.
 * Polygons become triangle fans. If a file has no {@code vt} or no {@code vn}, indices into that
 * list are ignored; otherwise they are checked: in models, wrong ones of {@code vt} and {@code vn}
 * are as none. Mutable.
 */
final class ObjFaces {
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

  /** The normals of the file, then of faces and smoothing groups. */
  private double[] normals;

  private int normalCount;

  /** Whether vertices have normals, either from the file or from smoothing groups. */
  private final boolean hasNormals;

  private final boolean isModel;

  private final ObjColors colors;

  private final ObjSmoothing smoothing = new ObjSmoothing();
  private int[] face = new int[12];
  private final Tally tally = new Tally();

  /**
   * @param isModel whether colors of vertices are read, faces without normals in a smoothing group
   *     get smooth normals, and faces of one or two corners are ignored
   */
  ObjFaces(TextScanner scanner, ObjCensus census, boolean isModel) {
    this.scanner = scanner;
    totals = new int[] {census.positions(), census.uvs(), census.normals()};
    positions = new double[Math.multiplyExact(3, totals[POSITION])];
    uvs = Arrays.copyOf(BARYCENTRIC, BARYCENTRIC.length + 2 * totals[UV]);
    normals = new double[Math.multiplyExact(3, totals[NORMAL])];
    normalCount = totals[NORMAL];
    this.isModel = isModel;
    colors = new ObjColors(totals[POSITION]);
    hasNormals = normalCount > 0 || isModel && census.hasSmoothing();
  }

  /** Sets the smoothing group of the next faces; 0 for flat faces. */
  void smooth(int group) {
    smoothing.use(group);
  }

  /**
   * Reads the rest of the current line if it is a vertex, a texture coordinate, a normal or a face;
   * otherwise returns false.
   *
   * @param surface receives the triangles of a face
   */
  boolean read(ObjSurface surface) throws ModelFormatException {
    if (scanner.wordIs("v")) {
      readPosition();
    } else if (scanner.wordIs("vn")) {
      readVector(normals, 3 * counts[NORMAL]++);
    } else if (scanner.wordIs("vt")) {
      int to = BARYCENTRIC.length + 2 * counts[UV]++;
      uvs[to] = coordinate(0);
      uvs[to + 1] = coordinate(1);
    } else if (scanner.wordIs("f")) {
      readFace(surface);
    } else {
      return false;
    }
    return true;
  }

  private void readPosition() throws ModelFormatException {
    int to = 3 * counts[POSITION];
    for (int i = 0; i < 3; i++) {
      if (!scanner.nextWord()) {
        if (!isModel || i < 2) {
          throw scanner.error("expected a number, found the end of the line");
        }
        tally.add("took z for 0 in vertices of two numbers", scanner.location());
        break;
      }
      positions[to + i] = number();
    }
    if (isModel) {
      colors.read(scanner, counts[POSITION], tally);
    }
    counts[POSITION]++;
  }

  private void readVector(double[] target, int to) throws ModelFormatException {
    for (int i = 0; i < 3; i++) {
      target[to + i] = scanner.nextWord() ? number() : scanner.nextNumber();
    }
  }

  /** Returns the current word as a number; in models, NaN if it is not finite. */
  private double number() throws ModelFormatException {
    return isModel ? scanner.numberOrNan() : scanner.number();
  }

  /** Returns the next word as a texture coordinate; the second one may be missing. */
  private double coordinate(int index) throws ModelFormatException {
    if (!scanner.nextWord()) {
      return index == 0 ? scanner.nextNumber() : 0;
    }
    double number = number();
    if (Double.isNaN(number)) {
      tally.add("took texture coordinates that are not finite for 0", scanner.location());
      return 0;
    }
    return number;
  }

  private void readFace(ObjSurface surface) throws ModelFormatException {
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
    if (isBroken(count)) {
      return;
    }
    for (int k = 2; k < count; k++) {
      addTriangle(surface, 0, k - 1, k);
    }
  }

  /**
   * Reads the rest of a line of points.
   *
   * @param points receives each point once, as a corner
   */
  void readPoints(ObjSurface points) throws ModelFormatException {
    int[] corner = new int[3];
    while (scanner.nextWord()) {
      scanner.readIndices(corner);
      points.corners().number(resolved(corner[POSITION], POSITION), 0, 0);
    }
  }

  /** Adds all vertices as points. */
  void addAllTo(ObjSurface points) {
    for (int vertex = 0; vertex < counts[POSITION]; vertex++) {
      points.corners().number(vertex, 0, 0);
    }
  }

  /**
   * Returns whether a face is left out. Some tools write loose edges as faces of two corners.
   *
   * @throws ModelFormatException if the file is not a model
   */
  private boolean isBroken(int count) throws ModelFormatException {
    if (count < 3 && !isModel) {
      throw scanner.error("expected at least 3 corners per face, found " + count);
    }
    if (count < 3) {
      tally.add(Tally.NARROW, scanner.location());
      return true;
    }
    for (int k = 0; k < count; k++) {
      if (!position(face[3 * k]).isFinite()) {
        tally.add(Tally.BROKEN, scanner.location());
        return true;
      }
    }
    return false;
  }

  /** Returns a zero-based index, or NONE if it is missing or the file has no such list. */
  private int resolved(int index, int list) throws ModelFormatException {
    if (index == 0 || list != POSITION && totals[list] == 0) {
      return NONE;
    }
    int found = index > 0 ? index - 1 : counts[list] + index;
    boolean isInList = found >= 0 && found < totals[list];
    if (!isInList && isModel && list != POSITION) {
      String things = list == UV ? "texture coordinates" : "normals";
      tally.add("ignored indices of " + things + " beyond their list", scanner.location());
      return NONE;
    }
    if (!isInList) {
      throw scanner.error(
          "expected "
              + (list == POSITION ? "a vertex" : list == UV ? "a vt" : "a vn")
              + (index > 0 ? " from 1 to " + totals[list] : " from -" + counts[list] + " to -1")
              + ", found "
              + index);
    }
    // A normal that is not finite is as none.
    return list == NORMAL && !isFinite(normals, 3 * found) ? NONE : found;
  }

  private static boolean isFinite(double[] numbers, int at) {
    return Double.isFinite(numbers[at] + numbers[at + 1] + numbers[at + 2]);
  }

  private void addTriangle(ObjSurface surface, int... fan) {
    boolean faceHasUvs = true;
    boolean faceHasNormals = true;
    for (int k : fan) {
      faceHasUvs &= face[3 * k + UV] != NONE;
      faceHasNormals &= face[3 * k + NORMAL] != NONE;
    }
    int[] own = faceHasNormals || !hasNormals ? new int[] {NONE, NONE, NONE} : ownNormals(fan);
    int[] vertices = new int[3];
    for (int i = 0; i < 3; i++) {
      int k = 3 * fan[i];
      int uv = faceHasUvs ? 3 + face[k + UV] : i;
      vertices[i] =
          surface
              .corners()
              .number(
                  face[k], totals[UV] == 0 ? 0 : uv, faceHasNormals ? face[k + NORMAL] : own[i]);
    }
    surface.triangles().add(vertices[0], vertices[1], vertices[2]);
  }

  /**
   * Returns the numbers of the normals of a triangle without normals, in a file that has some.
   * Outside smoothing groups, it is the geometric normal, or (0, 1, 0) for a triangle of zero area.
   */
  private int[] ownNormals(int... fan) {
    Vec3 a = position(face[3 * fan[0]]);
    Vec3 cross = position(face[3 * fan[1]]).minus(a).cross(position(face[3 * fan[2]]).minus(a));
    if (smoothing.isFlat()) {
      int flat = addNormal(cross.normalized());
      return new int[] {flat, flat, flat};
    }
    int[] smooth = new int[3];
    for (int i = 0; i < 3; i++) {
      int vertex = face[3 * fan[i]];
      if (smoothing.isNew(vertex)) {
        smoothing.add(vertex, addNormal(Vec3.Y));
      }
      smooth[i] = smoothing.sum(vertex, cross);
    }
    return smooth;
  }

  private int addNormal(Vec3 normal) {
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

  /** Computes normals of smoothing groups and colors of vertices, after the last statement. */
  void finish(Warnings warnings) {
    smoothing.store(normals);
    colors.finish(warnings);
    tally.addTo(warnings);
  }

  /** Returns a surface's arrays, after {@link #finish}. */
  ObjMesh mesh(ObjSurface surface) {
    Corners corners = surface.corners();
    return new ObjMesh(
        corners.gather(POSITION, positions, 3),
        hasNormals ? corners.gather(NORMAL, normals, 3) : new double[0],
        totals[UV] == 0 ? new double[0] : corners.gather(UV, uvs, 2),
        surface.triangles().toArray());
  }

  /** Returns the positions of a surface's corners, three numbers each. */
  double[] positions(ObjSurface surface) {
    return surface.corners().gather(POSITION, positions, 3);
  }

  /**
   * Returns four color components per vertex of a surface, or an empty array if none has a color.
   *
   * @param otherwise gray of vertices without a color
   */
  float[] colors(ObjSurface surface, double otherwise) {
    return colors.of(surface.corners(), otherwise);
  }
}
