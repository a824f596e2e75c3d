package io.github.lumbre.render.denoise.internal;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.Scene;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Where the triangles of a scene's meshes are, and where the camera sees them. It keeps positions
 * alone, of meshes that differ from those of another pose. Immutable.
 */
final class PosedSurfaces {
  private static final int NONE = -1;

  private final Camera camera;

  /** The meshes of the primitives; empty for other shapes. */
  private final List<Optional<Placed>> placed;

  /** The object and the material of each primitive. */
  private final List<Name> names;

  /** The primitives, by which poses of one model that stands still are recognized. */
  private final WeakReference<List<Primitive>> source;

  private record Name(String object, String material) {}

  /** A mesh at its place. */
  private record Placed(Corners corners, Transform toWorld) {
    /** Returns a corner of a triangle in world space. */
    Vec3 corner(int triangle, int corner) {
      Vec3 local = corners.corner(triangle, corner);
      return toWorld == Transform.IDENTITY ? local : toWorld.point(local);
    }
  }

  /**
   * The corners of the triangles of a mesh.
   *
   * @param center from which the points are measured, so that floats are exact enough
   * @param points three coordinates for each vertex
   * @param vertices three numbers for each triangle
   */
  private record Corners(Vec3 center, float[] points, int[] vertices) {
    static Corners of(TriangleMesh mesh) {
      Vec3 center = mesh.vertexCount() == 0 ? Vec3.ZERO : mesh.position(0);
      float[] points = new float[3 * mesh.vertexCount()];
      for (int i = 0; i < mesh.vertexCount(); i++) {
        Vec3 from = mesh.position(i).minus(center);
        points[3 * i] = (float) from.x();
        points[3 * i + 1] = (float) from.y();
        points[3 * i + 2] = (float) from.z();
      }
      int[] vertices = new int[3 * mesh.triangleCount()];
      Arrays.setAll(vertices, i -> mesh.vertex(i / 3, i % 3));
      return new Corners(center, points, vertices);
    }

    /** Returns the same corners, with the arrays of another pose where these are equal. */
    Corners like(Corners other) {
      boolean areSame = center.equals(other.center) && Arrays.equals(points, other.points);
      return new Corners(
          center,
          areSame ? other.points : points,
          Arrays.equals(vertices, other.vertices) ? other.vertices : vertices);
    }

    /** Returns whether the triangles of two poses have the same vertices. */
    boolean isOf(Corners other) {
      return points.length == other.points.length
          && (vertices == other.vertices || Arrays.equals(vertices, other.vertices));
    }

    Vec3 corner(int triangle, int corner) {
      int at = 3 * vertices[3 * triangle + corner];
      return new Vec3(
          center.x() + points[at], center.y() + points[at + 1], center.z() + points[at + 2]);
    }
  }

  private PosedSurfaces(
      Camera camera,
      List<Optional<Placed>> placed,
      List<Name> names,
      WeakReference<List<Primitive>> source) {
    this.camera = camera;
    this.placed = placed;
    this.names = names;
    this.source = source;
  }

  /**
   * Returns the surfaces of a scene.
   *
   * @param like of the frame before, whose memory is shared where nothing moved
   */
  static PosedSurfaces of(Scene scene, Optional<PosedSurfaces> like) {
    List<Primitive> primitives = scene.primitives();
    if (like.isPresent() && like.get().source.get() == primitives) {
      PosedSurfaces same = like.get();
      return new PosedSurfaces(scene.camera(), same.placed, same.names, same.source);
    }
    List<Optional<Placed>> placed = new ArrayList<>();
    List<Name> names = new ArrayList<>();
    Map<TriangleMesh, Corners> known = new IdentityHashMap<>();
    for (int i = 0; i < primitives.size(); i++) {
      names.add(new Name(scene.objectName(i), scene.materialName(i)));
      Optional<Corners> before = like.flatMap(other -> other.corners(names.size() - 1));
      placed.add(placed(primitives.get(i), known, before));
    }
    return new PosedSurfaces(
        scene.camera(), placed, names, new WeakReference<>(primitives));
  }

  private Optional<Corners> corners(int primitive) {
    return primitive < placed.size()
        ? placed.get(primitive).map(Placed::corners)
        : Optional.empty();
  }

  private static Optional<Placed> placed(
      Primitive primitive, Map<TriangleMesh, Corners> known, Optional<Corners> before) {
    if (primitive.material().catchesShadows()) {
      return Optional.empty();
    }
    if (primitive.shape() instanceof Mesh mesh) {
      return Optional.of(new Placed(corners(mesh.triangles(), known, before), Transform.IDENTITY));
    }
    if (primitive.shape() instanceof MeshInstance instance) {
      TriangleMesh mesh = instance.shared().mesh();
      return Optional.of(new Placed(corners(mesh, known, before), instance.toWorld()));
    }
    return Optional.empty();
  }

  private static Corners corners(
      TriangleMesh mesh, Map<TriangleMesh, Corners> known, Optional<Corners> before) {
    return known.computeIfAbsent(
        mesh,
        of -> {
          Corners corners = Corners.of(of);
          return before.map(corners::like).orElse(corners);
        });
  }

  /** Returns whether points of a primitive can be followed from frame to frame. */
  boolean isFollowed(int primitive) {
    return placed.get(primitive).isPresent();
  }

  /**
   * Returns the numbers that the primitives have in another pose; -1 for those that are not there,
   * or have other triangles there.
   */
  int[] numbersIn(PosedSurfaces other) {
    int[] numbers = new int[names.size()];
    Map<Name, List<Integer>> there = other.byName();
    byName()
        .forEach(
            (name, own) -> {
              List<Integer> found = there.getOrDefault(name, List.of());
              for (int i = 0; i < own.size(); i++) {
                boolean isSame =
                    found.size() == own.size() && isOf(own.get(i), other, found.get(i));
                numbers[own.get(i)] = isSame ? found.get(i) : NONE;
              }
            });
    return numbers;
  }

  private Map<Name, List<Integer>> byName() {
    Map<Name, List<Integer>> byName = new HashMap<>();
    for (int i = 0; i < names.size(); i++) {
      byName.computeIfAbsent(names.get(i), name -> new ArrayList<>()).add(i);
    }
    return byName;
  }

  private boolean isOf(int primitive, PosedSurfaces other, int number) {
    Optional<Corners> here = corners(primitive);
    Optional<Corners> there = other.corners(number);
    return here.isPresent() && there.isPresent() && here.get().isOf(there.get());
  }

  /** Returns the point of a triangle with the barycentric weights (1 − b1 − b2, b1, b2). */
  Vec3 point(int primitive, int triangle, double b1, double b2) {
    Placed at = placed.get(primitive).orElseThrow();
    Vec3 a = at.corner(triangle, 0);
    Vec3 e1 = at.corner(triangle, 1).minus(a);
    Vec3 e2 = at.corner(triangle, 2).minus(a);
    return a.plus(b1, e1).plus(b2, e2);
  }

  /** Returns a vector across a triangle, whose length is twice the area. */
  Vec3 across(int primitive, int triangle) {
    Placed at = placed.get(primitive).orElseThrow();
    Vec3 a = at.corner(triangle, 0);
    Vec3 e1 = at.corner(triangle, 1).minus(a);
    Vec3 e2 = at.corner(triangle, 2).minus(a);
    return e1.cross(e2);
  }

  /**
   * Returns the barycentric weights of the second and third corner for a point of a triangle, as
   * nearly as floats can tell.
   */
  Point2 weights(int primitive, int triangle, Vec3 point) {
    Placed at = placed.get(primitive).orElseThrow();
    Vec3 a = at.corner(triangle, 0);
    Vec3 e1 = at.corner(triangle, 1).minus(a);
    Vec3 e2 = at.corner(triangle, 2).minus(a);
    Vec3 v = point.minus(a);
    double d11 = e1.dot(e1);
    double d12 = e1.dot(e2);
    double d22 = e2.dot(e2);
    double area = d11 * d22 - d12 * d12;
    double b1 = (d22 * v.dot(e1) - d12 * v.dot(e2)) / area;
    double b2 = (d11 * v.dot(e2) - d12 * v.dot(e1)) / area;
    boolean isKnown = Math.abs(b1) + Math.abs(b2) <= 4;
    return isKnown ? new Point2(b1, b2) : new Point2(1 / 3., 1 / 3.);
  }

  /** Returns where the camera is. */
  Vec3 eye() {
    return camera.position();
  }

  /** Returns where the camera sees a point; see {@link Camera#project}. */
  Optional<Point2> project(Vec3 point) {
    return camera.project(point);
  }
}
