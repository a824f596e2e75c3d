package io.github.lumbre.stage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Triangles that a program has in memory, beside PLY texts of the same numbers. */
class TrianglesTest {
  private static final int SIDE = 5;

  private static SceneParser parser() {
    return new SceneParser()
        .overriding(settings -> settings.toBuilder().size(40, 30).samples(2).build());
  }

  private static byte[] picture(StagedModel model) throws Exception {
    SceneFile file = model.scene();
    return new PictureRenderer(file.settings())
        .render(file.scene())
        .toPng(file.settings().development());
  }

  private static byte[] picture(String ply, Stage stage) throws Exception {
    return picture(
        StagedModel.read("a.ply", ply.getBytes("US-ASCII"), ModelFolder.NONE, stage, parser()));
  }

  /** A hilly sheet, whose vertices have normals and colors. */
  private static final class Sheet {
    final double[] positions = new double[3 * SIDE * SIDE];
    final double[] normals = new double[3 * SIDE * SIDE];
    final float[] colors = new float[4 * SIDE * SIDE];
    final int[] indices = new int[6 * (SIDE - 1) * (SIDE - 1)];

    Sheet(double height, long seed) {
      Random random = new Random(seed);
      for (int i = 0; i < SIDE * SIDE; i++) {
        put(positions, i, i % SIDE, height + random.nextDouble(), i / SIDE);
        put(normals, i, random.nextDouble() - .5, 1, random.nextDouble() - .5);
        for (int channel = 0; channel < 4; channel++) {
          colors[4 * i + channel] = channel == 3 ? 1 : random.nextFloat();
        }
      }
      int at = 0;
      for (int i = 0; i < SIDE * (SIDE - 1); i++) {
        if (i % SIDE < SIDE - 1) {
          for (int corner : new int[] {i, i + SIDE, i + 1, i + 1, i + SIDE, i + SIDE + 1}) {
            indices[at++] = corner;
          }
        }
      }
    }

    private static void put(double[] values, int i, double x, double y, double z) {
      values[3 * i] = x;
      values[3 * i + 1] = y;
      values[3 * i + 2] = z;
    }

    TriangleMesh mesh() {
      return TriangleMesh.of(positions, indices).withNormals(normals).withColors(colors);
    }
  }

  /** Returns the PLY text of some sheets; those after the first one are further down in it. */
  private static String ply(Sheet... sheets) {
    StringBuilder text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex ");
    text.append(sheets.length * SIDE * SIDE).append('\n');
    for (String name : List.of("x", "y", "z", "nx", "ny", "nz")) {
      text.append("property double ").append(name).append('\n');
    }
    for (String name : List.of("red", "green", "blue", "alpha")) {
      text.append("property float ").append(name).append('\n');
    }
    int triangles = sheets.length * sheets[0].indices.length / 3;
    text.append("element face ").append(triangles).append('\n');
    text.append("property list uchar int vertex_indices\nend_header\n");
    for (Sheet sheet : sheets) {
      for (int i = 0; i < SIDE * SIDE; i++) {
        for (int k = 0; k < 3; k++) {
          text.append(sheet.positions[3 * i + k]).append(' ');
        }
        for (int k = 0; k < 3; k++) {
          text.append(sheet.normals[3 * i + k]).append(' ');
        }
        for (int k = 0; k < 4; k++) {
          text.append(sheet.colors[4 * i + k]).append(k < 3 ? " " : "\n");
        }
      }
    }
    for (int s = 0; s < sheets.length; s++) {
      for (int i = 0; i < sheets[s].indices.length; i += 3) {
        text.append('3');
        for (int k = 0; k < 3; k++) {
          text.append(' ').append(s * SIDE * SIDE + sheets[s].indices[i + k]);
        }
        text.append('\n');
      }
    }
    return text.toString();
  }

  @Test
  void pictureHasTheBitsOfThePly() throws Exception {
    Sheet sheet = new Sheet(0, 1);
    for (Stage stage : List.of(Stage.DEFAULT, Stage.DEFAULT.seenFrom(Stage.View.of("iso")))) {
      byte[] picture = picture(StagedModel.of(sheet.mesh(), stage, parser()));
      assertThat(picture).isEqualTo(picture(ply(sheet), stage));
    }
  }

  @Test
  void flatTrianglesWithoutColorsAreThoseOfThePly() throws Exception {
    Sheet sheet = new Sheet(0, 2);
    String text =
        ply(sheet)
            .replaceAll("property double n.\n", "")
            .replaceAll("property float [a-z]+\n", "")
            .replaceAll("(?m)^(\\S+ \\S+ \\S+) \\S+ \\S+ \\S+ \\S+ \\S+ \\S+ \\S+$", "$1");
    TriangleMesh mesh = TriangleMesh.of(sheet.positions, sheet.indices);
    byte[] picture = picture(StagedModel.of(mesh, Stage.DEFAULT, parser()));
    assertThat(picture).isEqualTo(picture(text, Stage.DEFAULT));
  }

  @Test
  void partsHaveTheBitsOfTheirPly() throws Exception {
    Sheet lower = new Sheet(0, 3);
    Sheet upper = new Sheet(2, 4);
    Map<String, TriangleMesh> parts = new LinkedHashMap<>();
    parts.put("upper sheet", upper.mesh());
    parts.put("lower sheet", lower.mesh());
    byte[] picture = picture(StagedModel.of(parts, Stage.DEFAULT, parser()));
    assertThat(picture).isEqualTo(picture(ply(lower, upper), Stage.DEFAULT));
  }

  @Test
  void partsAreHiddenByName() throws Exception {
    Sheet lower = new Sheet(0, 5);
    Map<String, TriangleMesh> parts =
        Map.of("lower", lower.mesh(), "größere", new Sheet(2, 6).mesh());
    Stage hiding =
        Stage.DEFAULT.reading(
            Stage.DEFAULT.options().with(ModelOption.HIDE, List.of("größere")));
    byte[] picture = picture(StagedModel.of(parts, hiding, parser()));
    assertThat(picture)
        .isEqualTo(picture(StagedModel.of(lower.mesh(), Stage.DEFAULT, parser())));
  }

  @Test
  void arraysAreCopied() throws Exception {
    Sheet sheet = new Sheet(0, 7);
    TriangleMesh mesh = sheet.mesh();
    byte[] before = picture(StagedModel.of(mesh, Stage.DEFAULT, parser()));
    Arrays.fill(sheet.positions, 0);
    Arrays.fill(sheet.normals, 0);
    Arrays.fill(sheet.colors, 0);
    Arrays.fill(sheet.indices, 0);
    assertThat(picture(StagedModel.of(mesh, Stage.DEFAULT, parser()))).isEqualTo(before);
  }

  @Test
  void wrongArraysAreRefusedWithTheirPlace() {
    double[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    int[] indices = {0, 1, 2};
    TriangleMesh mesh = TriangleMesh.of(corners, indices);
    assertThatThrownBy(() -> TriangleMesh.of(corners, new int[] {0, 1, 3}))
        .hasMessage("indices[2]: expected 0 to 2, found 3");
    assertThatThrownBy(() -> TriangleMesh.of(new double[] {0, 0, Double.NaN}, indices))
        .hasMessage("positions[2]: expected a finite number, found NaN");
    assertThatThrownBy(() -> mesh.withNormals(new double[3]))
        .hasMessage("normals: expected a length of 0 or 9, found 3");
    float[] colors = new float[12];
    colors[5] = Float.NaN;
    assertThatThrownBy(() -> mesh.withColors(colors))
        .hasMessage("colors[5]: expected a finite number of at least 0, found NaN");
  }

  @Test
  void limitsAreThoseOfFiles() {
    TriangleMesh sheet = new Sheet(0, 8).mesh();
    SceneParser limited = parser().limitedTo(Limits.NONE.withTriangles(31));
    assertThatThrownBy(() -> StagedModel.of(sheet, Stage.DEFAULT, limited))
        .isInstanceOfSatisfying(
            SceneFormatException.class,
            e -> assertThat(e.kind()).isEqualTo(SceneFormatException.Kind.LIMIT))
        .hasMessageContaining("triangles.ply: element face: expected at most 31 triangles");
    double[] far = {0, 0, 0, 1e200, 0, 0, 0, 1, 0};
    TriangleMesh huge = TriangleMesh.of(far, new int[] {0, 1, 2});
    assertThatThrownBy(() -> StagedModel.of(huge, Stage.DEFAULT, parser()))
        .hasMessageContaining("element vertex 1: expected a number of at most 1e150 for x");
  }

  @Test
  void whatIsLeftOutIsReported() throws Exception {
    double[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    TriangleMesh mesh =
        TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 1, 1})
            .withColors(new float[] {2, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1});
    assertThat(StagedModel.of(mesh, Stage.DEFAULT, parser()).scene().warnings())
        .anyMatch(w -> w.toString().contains("dropped triangles of zero area: 1"))
        .anyMatch(w -> w.toString().contains("clamped components of colors"));
  }

  @Test
  void aNameThatAFileCannotKeepIsRefused() {
    TriangleMesh sheet = new Sheet(0, 9).mesh();
    for (String name : List.of("", " a", "a  b", "a\nend_header", "a\u0000b", "a\ud800")) {
      assertThatThrownBy(() -> StagedModel.of(Map.of(name, sheet), Stage.DEFAULT, parser()))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageStartingWith("parts: expected names of words with single spaces");
    }
  }

  /** A PLY file of vertices alone shows points. */
  @Test
  void verticesWithoutTrianglesAreRefused() {
    TriangleMesh none = TriangleMesh.of(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[0]);
    String message = "triangles.ply: expected at least one triangle with an area, found none";
    assertThatThrownBy(() -> StagedModel.of(none, Stage.DEFAULT, parser())).hasMessage(message);
    assertThatThrownBy(() -> StagedModel.of(Map.of("a", none), Stage.DEFAULT, parser()))
        .hasMessage(message);
  }
}
