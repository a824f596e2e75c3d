package io.github.lumbre.model.section;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Models are cut by planes, and the cuts of closed parts are filled. */
class SectionsTest {
  private static final double[] NONE = {};

  /** The largest relative error of areas, by the number of triangles of round shapes. */
  private static final double ROUND = .005;

  static ModelPart part(String name, double[] positions, int... indices) {
    ModelGeometry mesh =
        new ModelGeometry(positions, NONE, NONE, NONE, NONE, new float[0], indices);
    return new ModelPart(
        ModelNode.of(name, "", Optional.empty()),
        name,
        mesh,
        PlainModel.defaultMaterial(),
        Transform.IDENTITY);
  }

  /** Returns one part with the triangles of two, the second one turned inside out. */
  static ModelPart hollow(String name, ModelPart outside, ModelPart inside) {
    double[] outer = outside.geometry().positions();
    double[] inner = inside.geometry().positions();
    double[] positions = Arrays.copyOf(outer, outer.length + inner.length);
    System.arraycopy(inner, 0, positions, outer.length, inner.length);
    int[] corners = outside.geometry().indices();
    int[] holes = inside.geometry().indices();
    int[] indices = Arrays.copyOf(corners, corners.length + holes.length);
    for (int i = 0; i < holes.length; i++) {
      int turned = i % 3 == 0 ? i : i % 3 == 1 ? i + 1 : i - 1;
      indices[corners.length + i] = holes[turned] + outer.length / 3;
    }
    return part(name, positions, indices);
  }

  static ModelPart box(String name, double from, double to) {
    double[] p = new double[24];
    for (int i = 0; i < 8; i++) {
      p[3 * i] = (i & 1) == 0 ? from : to;
      p[3 * i + 1] = (i & 2) == 0 ? from : to;
      p[3 * i + 2] = (i & 4) == 0 ? from : to;
    }
    return part(
        name, p, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 1, 3, 7, 1,
        7, 5, 0, 4, 6, 0, 6, 2);
  }

  /** Returns a torus around the y axis; a sphere if its ring has no radius. */
  static ModelPart torus(String name, double ring, double tube, int around, int across) {
    boolean isSphere = ring == 0;
    int rows = isSphere ? across + 1 : across;
    double[] p = new double[3 * around * rows];
    for (int i = 0; i < around; i++) {
      for (int j = 0; j < rows; j++) {
        double a = 2 * Math.PI * i / around;
        double b = isSphere ? Math.PI * (j / (double) across - .5) : 2 * Math.PI * j / across;
        boolean isPole = isSphere && (j == 0 || j == across);
        double radius = isPole ? 0 : ring + tube * Math.cos(b);
        int at = 3 * (i * rows + j);
        p[at] = radius == 0 ? 0 : radius * Math.cos(a);
        p[at + 1] = tube * Math.sin(b);
        p[at + 2] = radius == 0 ? 0 : radius * Math.sin(a);
      }
    }
    List<Integer> indices = new ArrayList<>();
    for (int i = 0; i < around; i++) {
      for (int j = 0; j < across; j++) {
        int next = (i + 1) % around;
        int low = i * rows + j;
        int high = i * rows + (j + 1) % rows;
        int nextLow = next * rows + j;
        int nextHigh = next * rows + (j + 1) % rows;
        indices.addAll(List.of(low, high, nextHigh, low, nextHigh, nextLow));
      }
    }
    return part(name, p, indices.stream().mapToInt(i -> i).toArray());
  }

  static Model cut(List<ModelPart> parts, String... sections) throws ModelFormatException {
    return Sections.cut(
        PlainModel.of(parts, List.of()),
        ModelOptions.DEFAULT.with(ModelOption.SECTION, List.of(sections)));
  }

  static List<ModelPart> caps(Model model) {
    return model.parts().stream().filter(p -> p.material().hatch().isPresent()).toList();
  }

  static double area(List<ModelPart> parts) {
    double sum = 0;
    for (ModelPart part : parts) {
      int[] corners = part.geometry().indices();
      for (int i = 0; i < corners.length; i += 3) {
        Vec3 a = part.position(corners[i]);
        Vec3 e = part.position(corners[i + 1]).minus(a);
        sum += e.cross(part.position(corners[i + 2]).minus(a)).length() / 2;
      }
    }
    return sum;
  }

  /** Returns the enclosed volume; of closed meshes it does not depend on the origin. */
  private static double volume(List<ModelPart> parts, Vec3 origin) {
    double sum = 0;
    for (ModelPart part : parts) {
      int[] corners = part.geometry().indices();
      for (int i = 0; i < corners.length; i += 3) {
        Vec3 a = part.position(corners[i]).minus(origin);
        Vec3 b = part.position(corners[i + 1]).minus(origin);
        Vec3 c = part.position(corners[i + 2]).minus(origin);
        sum += a.dot(b.cross(c)) / 6;
      }
    }
    return sum;
  }

  @Test
  void cubeIsHalved() throws ModelFormatException {
    Model model = cut(List.of(box("box", 0, 2)), "x=25%");
    assertThat(model.warnings()).isEmpty();
    assertThat(model.parts()).hasSize(2);
    assertThat(area(caps(model))).isEqualTo(4);
    assertThat(area(model.parts())).isCloseTo(2 * 4 + 4 * 1, within(1e-14));
    assertThat(volume(model.parts(), Vec3.ZERO)).isCloseTo(2, within(1e-14));
    assertThat(volume(model.parts(), new Vec3(3, -5, 7))).isCloseTo(2, within(1e-13));
  }

  @Test
  void hollowCubeHasWalls() throws ModelFormatException {
    Model model = cut(List.of(hollow("box", box("", 0, 10), box("", 1, 9))), "z=50%");
    assertThat(area(caps(model))).isCloseTo(100 - 64, within(1e-12));
    assertThat(volume(model.parts(), new Vec3(1, 2, 3)))
        .isCloseTo((1000 - 512) / 2., within(1e-10));
  }

  @Test
  void quarterIsRemoved() throws ModelFormatException {
    Model model = cut(List.of(hollow("box", box("", 0, 10), box("", 1, 9))), "x=5", "z=5");
    assertThat(area(caps(model))).isCloseTo(100 - 64, within(1e-12));
    assertThat(volume(model.parts(), new Vec3(1, 2, 3))).isCloseTo(488 * .75, within(1e-10));
  }

  @Test
  void sphereShellIsARing() throws ModelFormatException {
    ModelPart shell = hollow("shell", torus("", 0, 2, 128, 64), torus("", 0, 1.5, 128, 64));
    for (String plane : List.of("x=0", "y=0", "0,0,0/1,2,3")) {
      double ring = Math.PI * (2 * 2 - 1.5 * 1.5);
      assertThat(area(caps(cut(List.of(shell), plane)))).isCloseTo(ring, within(ROUND * ring));
    }
    double disc = Math.PI * (4 - 1.8 * 1.8);
    double found = area(caps(cut(List.of(shell), "y=1.8")));
    assertThat(found).isCloseTo(disc, within(ROUND * disc));
  }

  @Test
  void torusHasTwoDiscsOrOneRing() throws ModelFormatException {
    ModelPart torus = torus("torus", 3, 1, 128, 128);
    double discs = 2 * Math.PI;
    assertThat(area(caps(cut(List.of(torus), "x=0")))).isCloseTo(discs, within(ROUND * discs));
    double ring = Math.PI * (16 - 4);
    assertThat(area(caps(cut(List.of(torus), "y=0")))).isCloseTo(ring, within(ROUND * ring));
  }

  /** Programs that turn a profile about an axis often leave a hole at it, by rounding. */
  @Test
  void pinholesOfRoundingErrorsAreClosed() throws ModelFormatException {
    ModelPart ball = torus("ball", 0, 1, 64, 32);
    double[] p = ball.geometry().positions().clone();
    for (int i = 0; i < p.length; i += 3) {
      if (Math.abs(p[i + 1]) == 1) {
        p[i] = 5.5e-17 * Math.cos(i);
        p[i + 2] = 5.5e-17 * Math.sin(i);
      }
    }
    Model model = cut(List.of(part("ball", p, ball.geometry().indices())), "x=0.000001");
    assertThat(model.warnings()).isEmpty();
    assertThat(area(caps(model))).isCloseTo(Math.PI, within(ROUND * Math.PI));
    Model through = cut(List.of(part("ball", p, ball.geometry().indices())), "x=0");
    assertThat(area(caps(through))).isCloseTo(Math.PI, within(ROUND * Math.PI));
  }

  @Test
  void openPartsHaveNoCapAndAWarning() throws ModelFormatException {
    ModelPart box = box("lid", 0, 2);
    int[] corners = box.geometry().indices();
    ModelPart open = part("lid", box.geometry().positions(), Arrays.copyOf(corners, 33));
    Model model = cut(List.of(open, box("box", 4, 5)), "y=1");
    assertThat(caps(model)).isEmpty();
    assertThat(model.warnings())
        .containsExactly(
            "lid: the part is not closed, or its triangles face different sides; its cut has no"
                + " surface");
    // The hole is in the face x = 0, which this plane does not cut.
    Model beside = cut(List.of(open), "x=1");
    assertThat(caps(beside)).isEmpty();
    assertThat(beside.warnings()).isEqualTo(model.warnings());
  }

  @Test
  void cutMeshesAreVisibleFromBothSides() throws ModelFormatException {
    ModelPart box = box("box", 0, 2);
    ModelMaterial oneSided = ModelMaterial.builder("", "").build();
    ModelPart part = box.with(box.node(), box.geometry(), oneSided);
    assertThat(cut(List.of(part), "y=1").parts().get(0).material().doubleSided()).isTrue();
    assertThat(cut(List.of(part), "y=3").parts().get(0).material().doubleSided()).isFalse();
  }

  @Test
  void stripOfMoebiusIsOpen() throws ModelFormatException {
    int count = 40;
    double[] p = new double[6 * count];
    List<Integer> indices = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double a = 2 * Math.PI * i / count;
      for (int side = 0; side < 2; side++) {
        double s = (side - .5) * Math.cos(a / 2);
        p[6 * i + 3 * side] = (3 + s) * Math.cos(a);
        p[6 * i + 3 * side + 1] = (side - .5) * Math.sin(a / 2);
        p[6 * i + 3 * side + 2] = (3 + s) * Math.sin(a);
      }
      int next = (i + 1) % count;
      int turn = next == 0 ? 1 : 0;
      indices.addAll(List.of(2 * i, 2 * i + 1, 2 * next + 1 - turn));
      indices.addAll(List.of(2 * i, 2 * next + 1 - turn, 2 * next + turn));
    }
    Model model =
        cut(List.of(part("strip", p, indices.stream().mapToInt(i -> i).toArray())), "x=0");
    assertThat(caps(model)).isEmpty();
    assertThat(model.warnings()).hasSize(1);
  }

  @Test
  void overlappingPartsAreEachFilled() throws ModelFormatException {
    Model model = cut(List.of(box("a", 0, 4), box("b", 1, 5)), "z=2");
    assertThat(caps(model)).hasSize(2);
    assertThat(area(caps(model))).isEqualTo(32);
    assertThat(caps(model).get(0).material().hatch())
        .isNotEqualTo(caps(model).get(1).material().hatch());
    assertThat(caps(model)).extracting(ModelPart::name).containsExactly("a", "b");
  }

  @Test
  void partsThatTouchThePlaneStayOrGo() throws ModelFormatException {
    ModelPart below = box("below", 0, 1);
    ModelPart above = box("above", 1, 2);
    Model model = cut(List.of(below, above), "x=1");
    assertThat(model.parts()).containsExactly(below);
    // One part of two cubes that do not touch each other; the second one is inside out.
    double[] apart = above.geometry().positions().clone();
    for (int i = 1; i < apart.length; i += 3) {
      apart[i] += 7;
    }
    ModelPart far = part("", apart, above.geometry().indices());
    Model both = cut(List.of(hollow("both", below, far)), "x=1");
    assertThat(caps(both)).isEmpty();
    assertThat(area(both.parts())).isEqualTo(6);
  }

  @Test
  void planesThroughVerticesAndEdgesCut() throws ModelFormatException {
    ModelPart sphere = torus("ball", 0, 1, 64, 32);
    Model model = cut(List.of(sphere), "y=0");
    assertThat(area(caps(model))).isCloseTo(Math.PI, within(ROUND * Math.PI));
    assertThat(volume(model.parts(), new Vec3(0, 9, 0)))
        .isCloseTo(2 * Math.PI / 3, within(.01 * Math.PI));
    // Across the diagonals of a cube, through four of its vertices.
    assertThat(area(caps(cut(List.of(box("box", 0, 1)), "0,0,0/1,-1,0"))))
        .isCloseTo(Math.sqrt(2), within(1e-14));
  }

  @Test
  void planeOutsideOfTheModelIsReported() throws ModelFormatException {
    ModelPart box = box("box", 0, 2.5);
    Model model = cut(List.of(box), "x=3");
    assertThat(model.parts()).containsExactly(box);
    assertThat(model.warnings())
        .containsExactly(
            "section x=3 cuts nothing of the model, which is from x=0 to 2.5, y=0 to 2.5, z=0 to"
                + " 2.5 in the unit of the file");
    assertThatThrownBy(() -> cut(List.of(box), "x=0"))
        .isInstanceOf(ModelFormatException.class)
        .hasMessage(
            "section: expected a plane that leaves something of the model, which is from x=0 to"
                + " 2.5, y=0 to 2.5, z=0 to 2.5 in the unit of the file, found x=0");
  }

  @Test
  void piecesOfAnUndividedFileAreHatchedApart() throws ModelFormatException {
    ModelPart hollow = hollow("", box("", 0, 10), box("", 1, 9));
    ModelPart both = hollow("", hollow, hollow("", box("", 2, 8), box("", 3, 7)));
    // The inner box was turned with its cavity; its winding is turned back.
    int[] corners = both.geometry().indices().clone();
    int half = corners.length / 2;
    for (int i = half; i < corners.length; i += 3) {
      int second = corners[i + 1];
      corners[i + 1] = corners[i + 2];
      corners[i + 2] = second;
    }
    ModelPart turned = part("box", both.geometry().positions(), corners);
    ModelPart one = turned.with(ModelNode.undivided(""), turned.geometry(), turned.material());
    List<ModelPart> caps = caps(cut(List.of(one), "x=4", "-z=6"));
    assertThat(caps).hasSize(4);
    assertThat(caps.stream().map(cap -> cap.material().hatch()).distinct()).hasSize(2);
    List<ModelPart> across = caps(cut(List.of(one), "x=4"));
    assertThat(across).extracting(cap -> area(List.of(cap))).containsExactlyInAnyOrder(36., 20.);
    assertThat(caps(cut(List.of(turned), "x=4"))).hasSize(1);
  }

  @Test
  void uncutInstancesStayShared() throws ModelFormatException {
    ModelPart box = box("box", 0, 1);
    List<ModelPart> parts = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      Transform place = Transform.translation(new Vec3(1.5 * i - 2, 0, 0));
      parts.add(
          new ModelPart(
              ModelNode.of("n" + i, "", Optional.empty()),
              "",
              box.geometry(),
              box.material(),
              place));
    }
    Model model = cut(parts, "x=0");
    assertThat(model.parts().get(0)).isSameAs(parts.get(0));
    assertThat(model.parts()).hasSize(3);
    assertThat(model.parts().get(1).geometry()).isNotSameAs(box.geometry());
    assertThat(area(caps(model))).isEqualTo(1);
  }

  @Test
  void attributesAreInterpolated() throws ModelFormatException {
    ModelGeometry mesh =
        new ModelGeometry(
            new double[] {0, 0, 0, 4, 0, 0, 0, 4, 0},
            new double[] {0, 0, 1, 0, 0, 1, 1, 0, 0},
            new double[] {1, 0, 0, -1, 1, 0, 0, -1, 0, 1, 0, -1},
            new double[] {0, 0, 8, 0, 0, 8},
            new double[] {1, 1, 1, 1, 5, 5},
            new float[] {0, 0, 0, 1, 1, .5f, 0, 1, 0, 0, 1, 0},
            new int[] {0, 1, 2});
    ModelPart part =
        box("", 0, 1).with(ModelNode.undivided(""), mesh, PlainModel.defaultMaterial());
    ModelGeometry left = cut(List.of(part), "x=1").parts().get(0).geometry();
    assertThat(left.positions()).containsExactly(0, 0, 0, 0, 4, 0, 1, 3, 0, 1, 0, 0);
    assertThat(left.normals()).containsExactly(0, 0, 1, 1, 0, 0, .75, 0, .25, 0, 0, 1);
    assertThat(left.tangents())
        .containsExactly(1, 0, 0, -1, 0, 1, 0, -1, .25, .75, 0, -1, 1, 0, 0, -1);
    assertThat(left.uv0()).containsExactly(0, 0, 0, 8, 2, 6, 2, 0);
    assertThat(left.uv1()).containsExactly(1, 1, 5, 5, 4, 4, 1, 1);
    assertThat(left.colors())
        .containsExactly(0, 0, 0, 1, 0, 0, 1, 0, .25f, .125f, .75f, .25f, .25f, .125f, 0, 1);
  }

  @Test
  void memoryIsLimited() {
    ModelPart box = box("box", 0, 1);
    ModelOptions options =
        ModelOptions.DEFAULT
            .with(ModelOption.SECTION, List.of("x=.5"))
            .limitedTo(Limits.NONE.withMemory(100));
    assertThatThrownBy(() -> Sections.cut(PlainModel.of(List.of(box), List.of()), options))
        .isInstanceOf(ModelFormatException.class)
        .hasMessage("box: expected at most 100 bytes of memory for the model, found 4000");
  }
}
