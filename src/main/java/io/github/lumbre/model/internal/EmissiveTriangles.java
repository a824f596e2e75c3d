package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.light.Emission;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.ModelSurface.Emitter;
import io.github.lumbre.texture.internal.Constant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Divides an emissive mesh into emitters of near triangles with similar radiance. A light sampler
 * that selects emitters by their power and distance thus selects triangles so.
 */
final class EmissiveTriangles {
  /** An emitter has at most this many triangles, if there are fewer than {@link #MAX_EMITTERS}. */
  private static final int TRIANGLES = 32;

  private static final int MAX_EMITTERS = 2048;

  /** Triangles whose radiance differs by a larger factor are in different emitters. */
  private static final double LEVEL = 4;

  private static final int LEVELS = 8;

  /** The radiance is read at the centers of this many equal parts of each edge, squared. */
  private static final int GRID = 4;

  /**
   * The mean radiance of triangles that seem to be black, as a fraction of the mesh's radiance:
   * points between the sampled ones may be bright.
   */
  private static final double DARK = 1e-3;

  private final TriangleMesh mesh;
  private final Transform toWorld;
  private final Emission emission;
  private final double[] radiances;
  private final double[] areas;
  private final double[] centers;
  private final List<Emitter> emitters = new ArrayList<>();

  private EmissiveTriangles(TriangleMesh mesh, Transform toWorld, Emission emission) {
    this.mesh = mesh;
    this.toWorld = toWorld;
    this.emission = emission;
    int triangles = mesh.triangleCount();
    radiances = new double[triangles];
    areas = new double[triangles];
    centers = new double[3 * triangles];
    for (int i = 0; i < triangles; i++) {
      Vec3 a = toWorld.point(mesh.position(mesh.vertex(i, 0)));
      Vec3 b = toWorld.point(mesh.position(mesh.vertex(i, 1)));
      Vec3 c = toWorld.point(mesh.position(mesh.vertex(i, 2)));
      areas[i] = .5 * b.minus(a).cross(c.minus(a)).length();
      centers[3 * i] = (a.x() + b.x() + c.x()) / 3;
      centers[3 * i + 1] = (a.y() + b.y() + c.y()) / 3;
      centers[3 * i + 2] = (a.z() + b.z() + c.z()) / 3;
      radiances[i] = radiance(i);
    }
  }

  /**
   * Returns the emitters of a mesh; together they have each of its triangles once.
   *
   * @param shape of the whole mesh, in world space
   * @param toWorld from the mesh's local space
   */
  static List<Emitter> of(TriangleMesh mesh, Shape shape, Transform toWorld, Emission emission) {
    boolean isUniform = emission.radiance() instanceof Constant;
    if (emission.isBlack() || isUniform && mesh.triangleCount() <= TRIANGLES) {
      return List.of(new Emitter(shape, emission));
    }
    EmissiveTriangles triangles = new EmissiveTriangles(mesh, toWorld, emission);
    triangles.divide();
    return triangles.emitters.isEmpty()
        ? List.of(new Emitter(shape, emission))
        : List.copyOf(triangles.emitters);
  }

  private double radiance(int triangle) {
    double sum = 0;
    for (int i = 0; i < GRID; i++) {
      for (int j = 0; j < 2 * (GRID - i) - 1; j++) {
        // The upright parts have even j, the inverted ones odd j.
        double s = (i + (j % 2 == 0 ? 1 : 2) / 3.) / GRID;
        double t = (Math.floorDiv(j, 2) + (j % 2 == 0 ? 1 : 2) / 3.) / GRID;
        sum += emission.radiance().at(mesh.point(triangle, s, t)).max();
      }
    }
    return sum / (GRID * GRID);
  }

  private void divide() {
    double brightest = Arrays.stream(radiances).max().orElse(0);
    if (!(brightest > 0) || !Double.isFinite(brightest)) {
      return;
    }
    List<List<Integer>> levels = new ArrayList<>();
    for (int i = 0; i <= LEVELS; i++) {
      levels.add(new ArrayList<>());
    }
    for (int i = 0; i < radiances.length; i++) {
      levels.get(level(radiances[i] / brightest)).add(i);
    }
    int most = Math.max(TRIANGLES, radiances.length / MAX_EMITTERS);
    double mean = mean(levels.stream().flatMap(List::stream).toList());
    for (int i = 0; i < LEVELS; i++) {
      split(levels.get(i).toArray(Integer[]::new), most);
    }
    if (!levels.get(LEVELS).isEmpty()) {
      add(levels.get(LEVELS), DARK * mean);
    }
  }

  /** Returns the level of a triangle from the brightest, 0; {@link #LEVELS} for black. */
  private static int level(double relative) {
    if (relative == 0) {
      return LEVELS;
    }
    int level = 0;
    for (double limit = 1 / LEVEL; relative < limit && level < LEVELS - 1; limit /= LEVEL) {
      level++;
    }
    return level;
  }

  private double mean(List<Integer> triangles) {
    double power = 0;
    double area = 0;
    for (int i : triangles) {
      power += areas[i] * radiances[i];
      area += areas[i];
    }
    return area > 0 ? power / area : 0;
  }

  /** Halves the triangles along the longest axis of their centers until they are few. */
  private void split(Integer[] triangles, int most) {
    if (triangles.length == 0) {
      return;
    }
    if (triangles.length <= most) {
      List<Integer> group = Arrays.stream(triangles).sorted().toList();
      add(group, mean(group));
      return;
    }
    int axis = longestAxis(triangles);
    Arrays.sort(
        triangles,
        Comparator.<Integer>comparingDouble(i -> centers[3 * i + axis]).thenComparing(i -> i));
    int middle = Math.floorDiv(triangles.length, 2);
    split(Arrays.copyOfRange(triangles, 0, middle), most);
    split(Arrays.copyOfRange(triangles, middle, triangles.length), most);
  }

  private int longestAxis(Integer[] triangles) {
    int longest = 0;
    double size = -1;
    for (int axis = 0; axis < 3; axis++) {
      double min = Double.POSITIVE_INFINITY;
      double max = Double.NEGATIVE_INFINITY;
      for (int i : triangles) {
        min = Math.min(min, centers[3 * i + axis]);
        max = Math.max(max, centers[3 * i + axis]);
      }
      if (max - min > size) {
        size = max - min;
        longest = axis;
      }
    }
    return longest;
  }

  private void add(List<Integer> triangles, double meanRadiance) {
    TriangleMesh part = mesh.part(triangles.stream().mapToInt(i -> i).toArray());
    emitters.add(new Emitter(Mesh.baked(part, toWorld), emission.withMean(meanRadiance)));
  }
}
