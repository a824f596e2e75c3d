package io.github.lumbre.model.section;

import static io.github.lumbre.model.section.SectionsTest.area;
import static io.github.lumbre.model.section.SectionsTest.box;
import static io.github.lumbre.model.section.SectionsTest.caps;
import static io.github.lumbre.model.section.SectionsTest.cut;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Cuts of parts whose shells are inside out, doubled, or closed by triangles without area. */
class NestingTest {
  private static final String OPEN =
      "part: the part is not closed, or its triangles face different sides; its cut has no"
          + " surface";

  /** Returns one part with the triangles of others. */
  private static ModelPart joined(ModelPart... shells) {
    double[] positions = {};
    int[] indices = {};
    for (ModelPart shell : shells) {
      int vertices = positions.length / 3;
      int corners = indices.length;
      double[] more = shell.geometry().positions();
      int[] moreCorners = shell.geometry().indices();
      positions = Arrays.copyOf(positions, positions.length + more.length);
      System.arraycopy(more, 0, positions, 3 * vertices, more.length);
      indices = Arrays.copyOf(indices, corners + moreCorners.length);
      for (int i = 0; i < moreCorners.length; i++) {
        indices[corners + i] = moreCorners[i] + vertices;
      }
    }
    return SectionsTest.part("part", positions, indices);
  }

  private static ModelPart insideOut(ModelPart part) {
    int[] turned = part.geometry().indices().clone();
    for (int i = 0; i < turned.length; i += 3) {
      int second = turned[i + 1];
      turned[i + 1] = turned[i + 2];
      turned[i + 2] = second;
    }
    return SectionsTest.part(part.name(), part.geometry().positions(), turned);
  }

  /** Returns a box, inside out if the sign is -1. */
  private static ModelPart block(
      int sign, double x0, double x1, double y0, double y1, double z0, double z1) {
    double[] p = box("", 0, 1).geometry().positions().clone();
    for (int i = 0; i < p.length; i += 3) {
      p[i] = p[i] == 0 ? x0 : x1;
      p[i + 1] = p[i + 1] == 0 ? y0 : y1;
      p[i + 2] = p[i + 2] == 0 ? z0 : z1;
    }
    ModelPart block = SectionsTest.part("", p, box("", 0, 1).geometry().indices());
    return sign < 0 ? insideOut(block) : block;
  }

  private static ModelPart cube(int sign, double from, double to) {
    return block(sign, from, to, from, to, from, to);
  }

  private static ModelPart undivided(ModelPart part) {
    return part.with(ModelNode.undivided(""), part.geometry(), part.material());
  }

  /** A body with a cavity, and a solid in the cavity: as it should be, and inside out. */
  @ParameterizedTest
  @CsvSource({
    "1, -1, 1, 0", "-1, 1, -1, 0", // all inside out
    "-1, -1, 1, 1", "-1, -1, -1, 1", "-1, 1, 1, 1" // only some of it
  })
  void shellsNestByContainment(int outer, int cavity, int inner, int warnings)
      throws ModelFormatException {
    ModelPart part = joined(cube(outer, 0, 10), cube(cavity, 1, 9), cube(inner, 3, 7));
    for (ModelPart each : List.of(part, undivided(part))) {
      Model model = cut(List.of(each), "z=50%");
      assertThat(area(caps(model))).isCloseTo(100 - 64 + 16, within(1e-12));
      assertThat(model.warnings()).hasSize(warnings);
    }
  }

  /** Two solids of which one is in the other are no cavity if they face their outsides. */
  @Test
  void aSolidInASolidStaysFilled() throws ModelFormatException {
    Model model = cut(List.of(joined(cube(1, 0, 10), cube(1, 1, 9))), "z=5");
    assertThat(area(caps(model))).isCloseTo(100, within(1e-12));
    assertThat(model.warnings()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"1, -1", "-1, 1", "-1, -1", "1, 1"})
  void overlappingSolidsAreFilledWhicheverIsInsideOut(int one, int other)
      throws ModelFormatException {
    ModelPart part =
        joined(block(one, 0, 2, 0, 2, 0, 2), block(other, 1, 3, 0, 2, 0, 2));
    for (ModelPart each : List.of(part, undivided(part))) {
      Model model = cut(List.of(each), "z=1");
      assertThat(area(caps(model))).isCloseTo(6, within(1e-12));
      assertThat(caps(model)).hasSize(1);
      assertThat(model.warnings()).isEmpty();
    }
  }

  /** Bars that cross have a common area, and no corner of one is in the other. */
  @Test
  void piecesThatCrossAreOne() throws ModelFormatException {
    ModelPart part = joined(block(1, 0, 9, 4, 5, 0, 2), block(-1, 4, 5, 0, 9, 0, 2));
    Model model = cut(List.of(undivided(part)), "z=1");
    assertThat(caps(model)).hasSize(1);
    assertThat(area(caps(model))).isCloseTo(17, within(1e-6));
    ModelPart beside = joined(block(1, 0, 4, 0, 4, 0, 4), block(1, 4, 8, 0, 4, 1, 3));
    assertThat(caps(cut(List.of(undivided(beside)), "z=2"))).hasSize(2);
  }

  /** A rod that is inside out is no cavity where a plane cuts it within a block. */
  @Test
  void aRodThatLeavesABlockIsNoCavity() throws ModelFormatException {
    ModelPart part =
        joined(block(1, 0, 4, 0, 4, 0, 4), block(-1, 1, 2, 1, 2, 2, 6));
    assertThat(area(caps(cut(List.of(part), "z=3")))).isCloseTo(16, within(1e-12));
  }

  /** A cavity in two blocks that overlap is in neither of them alone. */
  @ParameterizedTest
  @ValueSource(ints = {1, -1})
  void aCavityInSeveralShellsStaysOpen(int sign) throws ModelFormatException {
    ModelPart part =
        joined(
            block(sign, 0, 5, 0, 4, 0, 4),
            block(sign, 4.9, 10, 0, 4, 0, 4),
            block(-sign, 4, 6, 1, 3, 1, 3));
    // The strip in which the blocks overlap is twice in the part, and once in the cavity. Where
    // outlines cross, their points are on a grid.
    assertThat(area(caps(cut(List.of(part), "z=2")))).isCloseTo(40 - 4 + .2, within(1e-6));
  }

  /** As mirrored instances have them. */
  @Test
  void aMirroredPartWithACavityIsHollow() throws ModelFormatException {
    ModelPart part = joined(cube(1, 0, 10), cube(-1, 1, 9));
    ModelPart mirrored =
        new ModelPart(
            part.node(),
            "",
            part.geometry(),
            part.material(),
            Transform.scale(new Vec3(1, -1, 1)));
    Model model = cut(List.of(mirrored), "z=5");
    assertThat(area(caps(model))).isCloseTo(36, within(1e-12));
    assertThat(model.warnings()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void trianglesInBothDirectionsHaveNoInside(boolean isSame) throws ModelFormatException {
    ModelPart cube = cube(1, 0, 2);
    ModelPart other = insideOut(cube);
    if (!isSame) {
      // The other diagonals of the faces: corners of a cube in another order.
      int[] corners = other.geometry().indices().clone();
      for (int i = 0; i < corners.length; i++) {
        corners[i] ^= 1;
      }
      other = insideOut(SectionsTest.part("", cube.geometry().positions(), corners));
    }
    Model model = cut(List.of(joined(cube, other)), "z=1");
    assertThat(caps(model)).isEmpty();
    assertThat(model.warnings()).containsExactly(OPEN);
    Model both = cut(List.of(joined(cube, other, cube(1, 5, 7))), "z=1");
    assertThat(both.warnings()).containsExactly(OPEN);
  }

  private static Model read(String name, String text) throws ModelFormatException, IOException {
    return ModelReader.read(
        name,
        text.getBytes(StandardCharsets.US_ASCII),
        ModelFolder.NONE,
        ModelOptions.DEFAULT.with(ModelOption.SECTION, List.of("z=50%")));
  }

  /** The corners of a skewed box, and points that divide two of its edges. */
  private static final int[][] POINTS = {
    {0, 0, 0}, {6, 2, 0}, {0, 8, 2}, {6, 10, 2}, {2, 0, 8}, {8, 2, 8}, {2, 8, 10}, {8, 10, 10},
    {1, 0, 4}, {3, 1, 0}
  };

  private static String facet(int a, int b, int c) {
    StringBuilder text = new StringBuilder("facet normal 0 0 0\nouter loop\n");
    for (int i : new int[] {a, b, c}) {
      int[] p = POINTS[i];
      text.append("vertex " + p[0] + " " + p[1] + " " + p[2] + "\n");
    }
    return text.append("endloop\nendfacet\n").toString();
  }

  /**
   * Returns the triangles of the skewed box: on the face of one side, points lie within two edges.
   */
  private static List<int[]> divided(boolean isFlatToo) {
    List<int[]> triangles = new ArrayList<>();
    int[] box = box("", 0, 1).geometry().indices();
    for (int i = 0; i < box.length; i += 3) {
      int[] t = {box[i], box[i + 1], box[i + 2]};
      if (t[0] == 0 && t[1] == 4 && t[2] == 6) {
        // The edge from 0 to 4 is divided here, and not in the face beside it.
        triangles.add(new int[] {0, 8, 6});
        triangles.add(new int[] {8, 4, 6});
      } else if (t[0] == 0 && t[1] == 1 && t[2] == 5) {
        triangles.add(new int[] {0, 9, 5});
        triangles.add(new int[] {9, 1, 5});
      } else {
        triangles.add(t);
      }
    }
    if (isFlatToo) {
      triangles.add(new int[] {0, 4, 8});
      triangles.add(new int[] {0, 1, 9});
    }
    return triangles;
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void trianglesWithoutAreaCloseAPart(boolean isFlatToo) throws Exception {
    StringBuilder stl = new StringBuilder("solid part\n");
    StringBuilder off = new StringBuilder("OFF\n10 " + divided(isFlatToo).size() + " 0\n");
    StringBuilder obj = new StringBuilder();
    for (int[] p : POINTS) {
      off.append(p[0] + " " + p[1] + " " + p[2] + "\n");
      obj.append("v " + p[0] + " " + p[1] + " " + p[2] + "\n");
    }
    for (int[] t : divided(isFlatToo)) {
      stl.append(facet(t[0], t[1], t[2]));
      off.append("3 " + t[0] + " " + t[1] + " " + t[2] + "\n");
      obj.append("f " + (t[0] + 1) + " " + (t[1] + 1) + " " + (t[2] + 1) + "\n");
    }
    double whole = area(caps(cut(List.of(SectionsTest.part("", skewed(), boxCorners())), "z=50%")));
    for (Model model :
        List.of(
            read("a.stl", stl.append("endsolid\n").toString()),
            read("a.off", off.toString()),
            read("a.obj", obj.toString()))) {
      assertThat(area(caps(model))).isCloseTo(whole, within(1e-12)).isGreaterThan(10);
      assertThat(model.warnings()).noneMatch(warning -> warning.contains("closed"));
    }
  }

  private static int[] boxCorners() {
    return box("", 0, 1).geometry().indices();
  }

  private static double[] skewed() {
    double[] p = new double[24];
    for (int i = 0; i < p.length; i++) {
      p[i] = POINTS[i / 3][i % 3];
    }
    return p;
  }

  /** Points within the edges of a hole do not close it. */
  @Test
  void holesWithDividedEdgesStayOpen() throws ModelFormatException {
    List<int[]> triangles = divided(false);
    triangles.remove(0);
    double[] p = new double[30];
    for (int i = 0; i < p.length; i++) {
      p[i] = POINTS[i / 3][i % 3];
    }
    int[] indices = triangles.stream().flatMapToInt(Arrays::stream).toArray();
    Model model = cut(List.of(SectionsTest.part("part", p, indices)), "z=50%");
    assertThat(caps(model)).isEmpty();
    assertThat(model.warnings()).containsExactly(OPEN);
  }
}
