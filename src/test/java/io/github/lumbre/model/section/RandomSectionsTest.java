package io.github.lumbre.model.section;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.testing.Effort;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * The caps of random meshes cover the points of the plane whose winding number is not 0, by the
 * triangles that a ray beside the plane crosses.
 */
class RandomSectionsTest {
  private static final double[] NONE = {};
  private static final int QUICK = 300;
  private static final int MANY = 100_000;
  private static final int PROBES = 12;

  /** A distance that is small beside the meshes, and large beside rounding errors. */
  private static final double NEAR = 1e-6;

  private static ModelPart part(int number, double[] positions, Transform place, int... indices) {
    return new ModelPart(
        ModelNode.of("part " + number, "", Optional.empty()),
        "part " + number,
        new ModelGeometry(positions, NONE, NONE, NONE, NONE, new float[0], indices),
        PlainModel.defaultMaterial(),
        place);
  }

  private static double[] positions(Random random, int count, int grid) {
    double[] p = new double[3 * count];
    Arrays.setAll(
        p, i -> grid == 0 ? random.nextDouble() : random.nextInt(grid + 1) / (double) grid);
    return p;
  }

  /**
   * Returns tetrahedra around one vertex; each has its own orientation, and some have no volume.
   */
  private static int[] closed(Random random, int vertices) {
    int[] corners = new int[12 * (1 + random.nextInt(6))];
    for (int i = 0; i < corners.length; i += 12) {
      int a = random.nextInt(vertices);
      int b = random.nextInt(vertices);
      int c = random.nextInt(vertices);
      int[] faces = {0, a, b, 0, b, c, 0, c, a, a, c, b};
      System.arraycopy(faces, 0, corners, i, 12);
    }
    return corners;
  }

  private static Transform place(Random random) {
    double size = random.nextInt(4) == 0 ? -1 : 1;
    return random.nextBoolean()
        ? Transform.IDENTITY
        : Transform.scale(new Vec3(size, 1, 1))
            .times(Transform.rotationDegrees(new Vec3(0, 90 * random.nextInt(4), 0)));
  }

  private static String plane(Random random) {
    return switch (random.nextInt(4)) {
      case 0 -> "x=50%";
      case 1 -> "-y=" + random.nextInt(3) / 2.;
      case 2 -> "z=" + (random.nextDouble() - .5);
      default ->
          "50%%,50%%,50%%/%s,%s,%s"
              .formatted(random.nextDouble(), random.nextDouble() - .5, random.nextGaussian());
    };
  }

  /** Returns the winding number of a part at a point, by a ray along a direction. */
  private static int winding(ModelPart part, Vec3 origin, Vec3 direction) {
    int winding = 0;
    int[] corners = part.geometry().indices();
    for (int i = 0; i < corners.length; i += 3) {
      Vec3 a = part.position(corners[i]).minus(origin);
      Vec3 b = part.position(corners[i + 1]).minus(origin);
      Vec3 c = part.position(corners[i + 2]).minus(origin);
      double u = direction.dot(c.cross(b));
      double v = direction.dot(a.cross(c));
      double w = direction.dot(b.cross(a));
      boolean isCrossed = u > 0 && v > 0 && w > 0 || u < 0 && v < 0 && w < 0;
      double sum = u + v + w;
      if (isCrossed && a.dot(b.cross(c)) / sum < 0) {
        winding += sum < 0 ? 1 : -1;
      }
    }
    return winding;
  }

  private static boolean covers(ModelPart cap, double u, double v) {
    int[] c = cap.geometry().indices();
    double[] uv = cap.geometry().uv0();
    for (int i = 0; i < c.length; i += 3) {
      boolean isInside = true;
      for (int k = 0; k < 3; k++) {
        int a = 2 * c[i + k];
        int b = 2 * c[i + (k + 1) % 3];
        isInside &= (uv[b] - uv[a]) * (v - uv[a + 1]) - (uv[b + 1] - uv[a + 1]) * (u - uv[a]) >= 0;
      }
      if (isInside) {
        return true;
      }
    }
    return false;
  }

  private static Bounds3 bounds(List<ModelPart> parts) {
    Bounds3 bounds = Bounds3.EMPTY;
    for (ModelPart part : parts) {
      for (int v : part.geometry().indices()) {
        bounds = bounds.union(part.position(v));
      }
    }
    return bounds;
  }

  private static void requireCapsByWinding(Random random) throws ModelFormatException {
    List<ModelPart> parts = new ArrayList<>();
    for (int i = 0; i < 1 + random.nextInt(2); i++) {
      int grid = new int[] {0, 1, 2, 4}[random.nextInt(4)];
      int vertices = 4 + random.nextInt(8);
      parts.add(
          part(i, positions(random, vertices, grid), place(random), closed(random, vertices)));
    }
    String text = plane(random);
    Optional<Model> model = cut(parts, text);
    if (model.isEmpty()) {
      return;
    }
    CutPlane plane = Section.of(text).in(bounds(parts), Transform.IDENTITY);
    for (ModelPart part : parts) {
      List<ModelPart> caps =
          SectionsTest.caps(model.get()).stream().filter(c -> c.node() == part.node()).toList();
      // Triangles that all have another one behind them have no inside.
      assertThat(model.get().warnings())
          .noneMatch(w -> w.startsWith(part.name() + ": the part is not") && !caps.isEmpty());
      // A part that touches the plane from behind stays as it is.
      boolean isCut =
          Arrays.stream(part.geometry().indices()).anyMatch(v -> plane.side(part.position(v)) > 0);
      for (int i = 0; i < PROBES; i++) {
        Vec3 p = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
        Vec3 on = plane.at(plane.u(p), plane.v(p));
        requireSame(part, isCut, caps, plane, on);
      }
    }
  }

  private static void requireSame(
      ModelPart part, boolean isCut, List<ModelPart> caps, CutPlane plane, Vec3 on) {
    Vec3 direction = plane.right().times(.8).plus(.6, plane.up());
    int winding = winding(part, on.plus(-NEAR * NEAR, plane.normal()), direction);
    for (int k = 0; k < 8; k++) {
      Vec3 beside =
          on.plus(4 * NEAR * ((k & 1) - .5), plane.right())
              .plus(4 * NEAR * ((k >> 1 & 1) - .5), plane.up())
              .plus(-NEAR * (k >> 2), plane.normal());
      if (winding(part, beside, direction) != winding) {
        return;
      }
    }
    boolean isCovered = caps.stream().anyMatch(cap -> covers(cap, plane.u(on), plane.v(on)));
    assertThat(isCovered).isEqualTo(isCut && winding != 0);
  }

  /** Returns the cut model; empty if nothing is left. */
  private static Optional<Model> cut(List<ModelPart> parts, String... planes) {
    try {
      Model model =
          Sections.cut(
              PlainModel.of(parts, List.of()),
              ModelOptions.DEFAULT.with(ModelOption.SECTION, List.of(planes)));
      // Builds the meshes, which checks their numbers.
      new ModelScene(model, Transform.IDENTITY, Kernel.AUTO, Limits.NONE, false).surfaces();
      return Optional.of(model);
    } catch (ModelFormatException e) {
      assertThat(e.getMessage()).startsWith("section: expected a plane that leaves something");
      return Optional.empty();
    }
  }

  /** Any triangles, planes and scales are cut without an exception. */
  private static void requireCut(Random random) {
    List<ModelPart> parts = new ArrayList<>();
    double scale = new double[] {1, 1e-150, 1e100, 1e149}[random.nextInt(4)];
    ModelNode node = ModelNode.undivided("");
    for (int i = 0; i < 1 + random.nextInt(4); i++) {
      int vertices = 3 + random.nextInt(20);
      double[] p = positions(random, vertices, random.nextInt(4));
      Arrays.setAll(p, k -> p[k] * scale);
      int[] indices = new int[3 * (1 + random.nextInt(30))];
      Arrays.setAll(indices, k -> random.nextInt(vertices));
      ModelPart part =
          part(i, p, place(random), random.nextBoolean() ? closed(random, vertices) : indices);
      boolean isCloud = random.nextInt(5) == 0;
      ModelGeometry shape = isCloud ? part.geometry().points() : part.geometry();
      parts.add(part.with(random.nextBoolean() ? node : part.node(), shape, part.material()));
    }
    String[] planes = new String[1 + random.nextInt(3)];
    Arrays.setAll(planes, i -> plane(random));
    cut(parts, planes);
  }

  @Test
  void capsHaveTheNonzeroWindingRule() throws ModelFormatException {
    for (int seed = 0; seed < QUICK; seed++) {
      requireCapsByWinding(new Random(seed));
      requireCut(new Random(seed));
    }
  }

  @Test
  @Tag("fuzz")
  void manyCapsHaveTheNonzeroWindingRule() throws ModelFormatException {
    Random seeds = new Random(Effort.seed(2));
    for (int i = 0; i < MANY; i++) {
      requireCapsByWinding(new Random(seeds.nextLong()));
      requireCut(new Random(seeds.nextLong()));
    }
  }
}
