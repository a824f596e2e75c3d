package io.github.lumbre.geometry;

import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.SurfacePoint;
import io.github.lumbre.texture.TexturePoint;
import java.util.Arrays;

/**
 * The data of a triangle mesh in its local space. Immutable.
 *
 * <p>The geometric normal of a triangle (a, b, c) points to its front: along (b − a) × (c − a), or
 * against it; see {@link Front}.
 */
public final class TriangleMesh {
  /** What decides which side of a triangle (a, b, c) is its front. */
  public enum Front {
    /** The sum of the vertex normals points to the front; without them, {@link #WINDING}. */
    NORMALS,

    /**
     * (b − a) × (c − a) points to the front, also in a mirroring transform. If the vertex normals
     * are reversed, so that their sum points to the back within 45° of the triangle's normal, all
     * three are negated for shading. Any other vertex normal on the back is reflected at the
     * triangle's plane.
     */
    WINDING
  }

  private final double[] positions;
  private final double[] normals;
  private final double[] uvs;
  private final int[] indices;
  private final MeshAttributes attributes;
  private final int droppedTriangles;
  private final MeshFronts fronts;

  /** Whether the mesh encloses a volume; null before it is asked for. */
  private volatile Boolean closed;

  /** The box around the triangles; null before it is asked for. */
  private volatile Bounds3 bounds;

  private TriangleMesh(
      double[] positions,
      double[] normals,
      double[] uvs,
      int[] indices,
      MeshAttributes attributes,
      Front front,
      int droppedTriangles) {
    this.positions = positions;
    this.normals = normals;
    this.uvs = uvs;
    this.indices = indices;
    this.attributes = attributes;
    this.droppedTriangles = droppedTriangles;
    fronts = MeshFronts.of(this, front);
  }

  private TriangleMesh(TriangleMesh source, Transform toWorld) {
    positions = new double[source.positions.length];
    normals = new double[source.normals.length];
    uvs = source.uvs;
    indices = source.indices;
    attributes = source.attributes.mapped(toWorld);
    droppedTriangles = source.droppedTriangles;
    fronts = source.fronts.baked(toWorld.isMirroring());
    for (int i = 0; i < source.vertexCount(); i++) {
      store(toWorld.point(source.position(i)), positions, i);
      if (source.hasNormals()) {
        store(mappedNormal(toWorld, source.normal(i)), normals, i);
      }
    }
  }

  /**
   * Returns a mesh with copies of the given arrays. Triangles without area are dropped.
   *
   * @param positions three coordinates per vertex in local space, all finite
   * @param normals three coordinates per vertex in local space, all finite; or empty
   * @param uvs two coordinates per vertex, all finite; or empty: then the vertices of each triangle
   *     have the coordinates (0,0), (1,0) and (0,1)
   * @param indices three vertex numbers per triangle, from 0
   * @throws IllegalArgumentException if an array has a wrong length, a number is not finite or an
   *     index is out of range
   */
  public static TriangleMesh of(double[] positions, double[] normals, double[] uvs, int[] indices) {
    return of(positions, normals, uvs, indices, MeshAttributes.NONE);
  }

  /**
   * Returns a mesh of flat triangles; see {@link #of(double[], double[], double[], int[])}. {@link
   * #withNormals} and {@link #withColors} add to it.
   */
  public static TriangleMesh of(double[] positions, int[] indices) {
    double[] none = {};
    return of(positions, none, none, indices);
  }

  /**
   * Returns this mesh with a copy of other vertex normals.
   *
   * @param newNormals three coordinates per vertex in local space, all finite; or empty for flat
   *     triangles
   * @throws IllegalArgumentException if the length is wrong, or a number is not finite
   */
  public TriangleMesh withNormals(double[] newNormals) {
    requireVertices(positions, newNormals, uvs, attributes);
    return with(newNormals.clone(), attributes);
  }

  /**
   * Returns this mesh with a copy of other colors of its vertices.
   *
   * @param colors four linear numbers per vertex: red, green, blue and alpha, each at least 0; or
   *     empty for none
   * @throws IllegalArgumentException if the length is wrong, or a number is negative or not finite
   */
  public TriangleMesh withColors(float[] colors) {
    MeshAttributes colored =
        new MeshAttributes(attributes.tangents(), attributes.uv1(), colors.clone());
    requireVertices(positions, normals, uvs, colored);
    return with(normals, colored);
  }

  private TriangleMesh with(double[] newNormals, MeshAttributes newAttributes) {
    return new TriangleMesh(
        positions, newNormals, uvs, indices, newAttributes, fronts.rule(), droppedTriangles);
  }

  /**
   * Returns a mesh with further vertex attributes; see {@link #of(double[], double[], double[],
   * int[])}.
   */
  public static TriangleMesh of(
      double[] positions,
      double[] normals,
      double[] uvs,
      int[] indices,
      MeshAttributes attributes) {
    return of(positions, normals, uvs, indices, attributes, Front.NORMALS);
  }

  /**
   * Returns a mesh with a rule for its front, which is otherwise {@link Front#NORMALS}; see {@link
   * #of(double[], double[], double[], int[])}.
   */
  public static TriangleMesh of(
      double[] positions,
      double[] normals,
      double[] uvs,
      int[] indices,
      MeshAttributes attributes,
      Front front) {
    requireVertices(positions, normals, uvs, attributes);
    requireMultiple("indices", indices.length, 3);
    int vertices = positions.length / 3;
    for (int i = 0; i < indices.length; i++) {
      if (indices[i] < 0 || indices[i] >= vertices) {
        throw new IllegalArgumentException(
            "indices[" + i + "]: expected 0 to " + (vertices - 1) + ", found " + indices[i]);
      }
    }
    int[] kept = withArea(positions, indices);
    int dropped = (indices.length - kept.length) / 3;
    return new TriangleMesh(
        positions.clone(), normals.clone(), uvs.clone(), kept, attributes, front, dropped);
  }

  /**
   * Returns points, which have attributes as vertices have: triangle i is vertex i three times.
   *
   * @throws IllegalArgumentException if an array has a wrong length, or a number is not finite
   */
  static TriangleMesh ofPoints(double[] positions, double[] uvs, MeshAttributes attributes) {
    double[] normals = {};
    requireVertices(positions, normals, uvs, attributes);
    int[] indices = new int[positions.length];
    Arrays.setAll(indices, i -> i / 3);
    return new TriangleMesh(
        positions.clone(), normals, uvs.clone(), indices, attributes, Front.WINDING, 0);
  }

  private static void requireVertices(
      double[] positions, double[] normals, double[] uvs, MeshAttributes attributes) {
    requireMultiple("positions", positions.length, 3);
    int vertices = positions.length / 3;
    requireLength("normals", normals.length, 3 * vertices);
    requireLength("uvs", uvs.length, 2 * vertices);
    requireFinite("positions", positions);
    requireFinite("normals", normals);
    requireFinite("uvs", uvs);
    requireLength("tangents", attributes.tangents().length, 4 * vertices);
    requireLength("uv1", attributes.uv1().length, 2 * vertices);
    requireLength("colors", attributes.colors().length, 4 * vertices);
    requireFinite("tangents", attributes.tangents());
    requireFinite("uv1", attributes.uv1());
    requireColors(attributes.colors());
  }

  private static void requireMultiple(String name, int length, int of) {
    if (length % of != 0) {
      throw new IllegalArgumentException(
          name + ": expected a length divisible by " + of + ", found " + length);
    }
  }

  private static void requireLength(String name, int length, int expected) {
    if (length != 0 && length != expected) {
      throw new IllegalArgumentException(
          name + ": expected a length of 0 or " + expected + ", found " + length);
    }
  }

  private static void requireFinite(String name, double[] values) {
    for (int i = 0; i < values.length; i++) {
      if (!Double.isFinite(values[i])) {
        throw new IllegalArgumentException(
            name + "[" + i + "]: expected a finite number, found " + values[i]);
      }
    }
  }

  private static void requireColors(float[] colors) {
    for (int i = 0; i < colors.length; i++) {
      if (!(colors[i] >= 0 && colors[i] <= Float.MAX_VALUE)) {
        throw new IllegalArgumentException(
            "colors[" + i + "]: expected a finite number of at least 0, found " + colors[i]);
      }
    }
  }

  private static int[] withArea(double[] positions, int[] indices) {
    int[] kept = new int[indices.length];
    int size = 0;
    for (int i = 0; i < indices.length; i += 3) {
      Vec3 a = load(positions, indices[i]);
      Vec3 b = load(positions, indices[i + 1]);
      Vec3 c = load(positions, indices[i + 2]);
      if (cross(b.minus(a), c.minus(a)).maxAbs() > 0) {
        System.arraycopy(indices, i, kept, size, 3);
        size += 3;
      }
    }
    return size == kept.length ? kept : Arrays.copyOf(kept, size);
  }

  /** Returns the cross product of two edges, up to a positive factor; zero for parallel edges. */
  static Vec3 cross(Vec3 e1, Vec3 e2) {
    Vec3 cross = e1.cross(e2);
    double size = cross.maxAbs();
    if (size > 0x1p-500 && size < 0x1p500) {
      return cross;
    }
    return e1.maxAbs() > 0 && e2.maxAbs() > 0 ? e1.normalized().cross(e2.normalized()) : Vec3.ZERO;
  }

  /**
   * Returns a mesh with some of this mesh's triangles and their vertices.
   *
   * @param triangles numbers of triangles, each less than {@link #triangleCount}
   */
  public TriangleMesh part(int[] triangles) {
    int[] corners = new int[3 * triangles.length];
    for (int i = 0; i < corners.length; i++) {
      corners[i] = indices[3 * triangles[i / 3] + i % 3];
    }
    int[] vertices = Arrays.stream(corners).sorted().distinct().toArray();
    Arrays.setAll(corners, i -> Arrays.binarySearch(vertices, corners[i]));
    return new TriangleMesh(
        selected(positions, vertices, 3),
        selected(normals, vertices, 3),
        selected(uvs, vertices, 2),
        corners,
        attributes.part(vertices),
        fronts.rule(),
        0);
  }

  /** Returns the values of some vertices; empty if there are none of any vertex. */
  static double[] selected(double[] values, int[] vertices, int perVertex) {
    if (values.length == 0) {
      return values;
    }
    double[] result = new double[perVertex * vertices.length];
    for (int i = 0; i < vertices.length; i++) {
      System.arraycopy(values, perVertex * vertices[i], result, perVertex * i, perVertex);
    }
    return result;
  }

  /** Returns this mesh in world space, with each vertex mapped once. */
  TriangleMesh baked(Transform toWorld) {
    return new TriangleMesh(this, toWorld);
  }

  /** Returns the world-space unit normal of a vertex normal; zero for zero. */
  static Vec3 mappedNormal(Transform toWorld, Vec3 n) {
    return n.maxAbs() > 0 ? toWorld.normal(n) : n;
  }

  /** Returns the number of triangles, without dropped ones. */
  public int triangleCount() {
    return indices.length / 3;
  }

  /** Returns the number of vertices. */
  public int vertexCount() {
    return positions.length / 3;
  }

  /** Returns the number of triangles that were dropped because they have no area. */
  public int droppedTriangles() {
    return droppedTriangles;
  }

  /** Returns the smallest local-space box around the triangles; empty without triangles. */
  public Bounds3 bounds() {
    Bounds3 known = bounds;
    if (known == null) {
      // Two threads may compute this at once; their results are equal.
      known = computeBounds();
      bounds = known;
    }
    return known;
  }

  private Bounds3 computeBounds() {
    double[] min = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    double[] max = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (int vertex : indices) {
      for (int axis = 0; axis < 3; axis++) {
        double x = positions[3 * vertex + axis];
        min[axis] = Math.min(min[axis], x);
        max[axis] = Math.max(max[axis], x);
      }
    }
    return new Bounds3(new Vec3(min[0], min[1], min[2]), new Vec3(max[0], max[1], max[2]));
  }

  /** Returns the vertex number at a corner, 0 to 2, of a triangle. */
  public int vertex(int triangle, int corner) {
    return indices[3 * triangle + corner];
  }

  /** Returns three coordinates per vertex; callers must not modify them. */
  double[] positions() {
    return positions;
  }

  /** Returns a vertex in local space. */
  public Vec3 position(int vertex) {
    return load(positions, vertex);
  }

  /** Returns whether the vertices have normals. */
  public boolean hasNormals() {
    return normals.length > 0;
  }

  /** Returns the normal of a vertex; requires {@link #hasNormals}. */
  public Vec3 normal(int vertex) {
    return load(normals, vertex);
  }

  /** Returns the vertex tangent at a corner, 0 to 2, of a triangle. */
  Vec3 tangent(int triangle, int corner) {
    double[] tangents = attributes.tangents();
    int i = 4 * vertex(triangle, corner);
    return new Vec3(tangents[i], tangents[i + 1], tangents[i + 2]);
  }

  double bitangentSign(int triangle) {
    double[] tangents = attributes.tangents();
    return Math.signum(
        tangents[4 * vertex(triangle, 0) + 3]
            + tangents[4 * vertex(triangle, 1) + 3]
            + tangents[4 * vertex(triangle, 2) + 3]);
  }

  /** Returns whether the vertices have texture coordinates. */
  public boolean hasUvs() {
    return uvs.length > 0;
  }

  /**
   * Returns whether the vertices have nothing but positions, normals and one set of uvs, and the
   * front of each triangle is decided as in {@link Front#NORMALS}.
   */
  public boolean isPlain() {
    return fronts.isPlain()
        && attributes.tangents().length == 0
        && attributes.uv1().length == 0
        && attributes.colors().length == 0;
  }

  /** Returns the further vertex attributes; their arrays must not be changed. */
  public MeshAttributes attributes() {
    return attributes;
  }

  /** Returns the texture coordinates at a corner, 0 to 2, of a triangle. */
  public TexturePoint uv(int triangle, int corner) {
    if (uvs.length == 0) {
      return new TexturePoint(corner == 1 ? 1 : 0, corner == 2 ? 1 : 0);
    }
    int vertex = vertex(triangle, corner);
    return new TexturePoint(uvs[2 * vertex], uvs[2 * vertex + 1]);
  }

  /** Returns the texture coordinates of a vertex; requires {@link #hasUvs}. */
  public TexturePoint uv(int vertex) {
    return new TexturePoint(uvs[2 * vertex], uvs[2 * vertex + 1]);
  }

  /** Returns the attributes of a triangle's point of barycentric weights (1 − b1 − b2, b1, b2). */
  public SurfacePoint point(int triangle, double b1, double b2) {
    MeshPoint point = new MeshPoint();
    point.moveTo(this, triangle, b1, b2);
    return point;
  }

  /** Returns whether the mesh encloses a volume; see {@link MeshEdges#isClosed}. */
  boolean isClosed() {
    Boolean known = closed;
    if (known == null) {
      // Two threads may compute this at once; their results are equal.
      known = MeshEdges.isClosed(this);
      closed = known;
    }
    return known;
  }

  /** Returns which side of each triangle is its front. */
  MeshFronts fronts() {
    return fronts;
  }

  /** Copies the nine coordinates of a triangle. */
  void copyVertices(int triangle, double[] target) {
    for (int corner = 0; corner < 3; corner++) {
      int at = 3 * vertex(triangle, corner);
      target[3 * corner] = positions[at];
      target[3 * corner + 1] = positions[at + 1];
      target[3 * corner + 2] = positions[at + 2];
    }
  }

  private static Vec3 load(double[] array, int vertex) {
    return new Vec3(array[3 * vertex], array[3 * vertex + 1], array[3 * vertex + 2]);
  }

  private static void store(Vec3 value, double[] array, int vertex) {
    array[3 * vertex] = value.x();
    array[3 * vertex + 1] = value.y();
    array[3 * vertex + 2] = value.z();
  }

  /** Returns the numbers of triangles and vertices, for people. */
  @Override
  public String toString() {
    return "TriangleMesh of " + triangleCount() + " triangles and " + vertexCount() + " vertices";
  }
}
