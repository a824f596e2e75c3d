package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests hidden and highlighted parts. */
public class PartSelectionTest {
  private static final String LIBRARY = "newmtl red\nKd 1 0 0\nnewmtl gray\nKd .5 .5 .5\n";

  /** Returns an OBJ file with a triangle for each object; its material has its name. */
  private static ModelFixture obj(String... objects) {
    StringBuilder text = new StringBuilder("mtllib a.mtl\nv 0 0 0 .1 .2 .3\nv 1 0 0\nv 0 1 0\n");
    for (String object : objects) {
      String material = object.contains("red") ? "red" : "gray";
      text.append("o " + object + "\nusemtl " + material + "\nf 1 2 3\n");
    }
    return new ModelFixture("a.obj", text.toString()).with("a.mtl", LIBRARY);
  }

  /** Returns a binary STL file of tetrahedra that do not touch. */
  public static byte[] tetrahedra(int count) {
    ByteBuffer file = ByteBuffer.allocate(84 + 200 * count).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(80, 4 * count).position(84);
    float[][] corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int[][] faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (int i = 0; i < 4 * count; i++) {
      file.putFloat(0).putFloat(0).putFloat(0);
      // The faces of all tetrahedra take turns.
      for (int corner : faces[i / count]) {
        file.putFloat(corners[corner][0] + 2 * (i % count));
        file.putFloat(corners[corner][1]).putFloat(corners[corner][2]);
      }
      file.putShort((short) 0);
    }
    return file.array();
  }

  private static ModelFixture stl(int tetrahedra) {
    return new ModelFixture("a.stl", tetrahedra(tetrahedra));
  }

  private static List<String> labels(ModelFixture file, ModelOptions options)
      throws ModelFormatException {
    return file.with(options).read().parts().stream().map(part -> part.node().label()).toList();
  }

  private static ModelOptions hiding(String... parts) {
    return ModelOptions.DEFAULT.with(ModelOption.HIDE, List.of(parts));
  }

  private static ModelOptions highlighting(String... parts) {
    return ModelOptions.DEFAULT.with(ModelOption.HIGHLIGHT, List.of(parts));
  }

  private static Rgb color(ModelPart part) {
    return part.material().input(MaterialParameter.BASE_COLOR).factor();
  }

  @ParameterizedTest
  @CsvSource({"lid, b;lids", "l*, b", "*d, b;lids", "lid;b, lids", "lids;lids, b;lid"})
  void namedPartsAreHidden(String names, String left) throws ModelFormatException {
    assertThat(labels(obj("b", "lid", "lids"), hiding(names.split(";"))))
        .containsExactly(left.split(";"));
  }

  @Test
  void namesThatAreNoneAndAnEmptyRestAreErrors() {
    assertThat(obj("b", "lid").with(hiding("b", "lix")).refusal())
        .isEqualTo("MALFORMED hide: expected \"b\" or \"lid\", found \"lix\"; did you mean lid?");
    assertThat(obj("b", "lid").with(highlighting("lid*d")).refusal())
        .startsWith("MALFORMED highlight: expected \"b\" or \"lid\", found \"lid*d\"");
    assertThat(obj("b", "lid").with(hiding("*")).refusal())
        .isEqualTo("MALFORMED hide: expected at least one part to show, found none");
  }

  @ParameterizedTest
  @CsvSource({
    "a, a, true",
    "a, ab, false",
    "a*, ab, true",
    "*b, ab, true",
    "a*b, ab, true",
    "a*b, aab b, true",
    "a*b, abc, false",
    "a*a, a, false",
    "ab*ba, aba, false",
    "*x*y*, axbyc, true",
    "*y*x*, axbyc, false",
    "*, '', true",
    "**, x, true",
    "a*b*b, abb, true",
    "a*b*b, ab, false",
    "*.png, a*.png, true",
  })
  void starsStandForAnyText(String wanted, String text, boolean isMeant) {
    assertThat(PartSelection.isMeant(wanted, text)).isEqualTo(isMeant);
  }

  @Test
  void partsOfOneNameAreHiddenTogetherAndByTheirLabelsAlone() throws ModelFormatException {
    // OBJ joins objects of one name, and the two names differ after their first 60 characters.
    String name = "x".repeat(60);
    ModelFixture file = obj(name + "a", name + "b", "c");
    assertThat(labels(file, hiding("c"))).containsExactly(name + "…", name + "… 2");
    assertThat(labels(file, hiding(name + "… 2"))).containsExactly(name + "…", "c");
    assertThat(labels(file, hiding(name + "b"))).containsExactly(name + "…", "c");
    assertThat(labels(file, hiding("xx*"))).containsExactly("c");
  }

  @Test
  void modelsWithoutASelectionStayAsTheyAre() throws ModelFormatException {
    assertThat(labels(stl(3), ModelOptions.DEFAULT)).containsExactly("");
    Model model = stl(3).with(ModelOptions.DEFAULT).read();
    assertThat(PartSelection.shown(model, ModelOptions.DEFAULT)).isSameAs(model);
  }

  @Test
  void undividedFilesHaveConnectedPieces() throws ModelFormatException {
    Model model = stl(3).with(hiding("piece 2")).read();
    assertThat(model.parts())
        .extracting(part -> part.node().label())
        .containsExactly("piece 1", "piece 3");
    for (ModelPart part : model.parts()) {
      assertThat(part.geometry().triangleCount()).isEqualTo(4);
      assertThat(part.geometry().vertexCount()).isEqualTo(4);
    }
    assertThat(model.parts().get(1).geometry().positions())
        .containsExactlyInAnyOrder(4, 0, 0, 5, 0, 0, 4, 1, 0, 4, 0, 1);
  }

  /** The first two triangles have their last corners at one place, written in two ways. */
  @Test
  void trianglesAreConnectedByAnyCornerAtTheSamePosition() throws ModelFormatException {
    String vertices =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 0\nv 6 5 0\nv -0 1 0\nv 9 0 0\nv 9 1 0\nv 9 0 1\n";
    String faces = "f 1 2 3\nf 7 8 9\nf 4 5 6\n";
    ModelFixture file = new ModelFixture("a.obj", vertices + faces);
    assertThat(labels(file, hiding("piece 1"))).containsExactly("piece 2");
    Model model = file.with(hiding("piece 2")).read();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.parts().get(0).geometry().triangleCount()).isEqualTo(2);
  }

  @Test
  void piecesMayHaveSeveralMaterials() throws ModelFormatException {
    String vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 0 0\nv 9 1 0\nv 9 0 1\n";
    String faces = "usemtl a\nf 1 2 3\nf 5 6 7\nusemtl b\nf 2 4 3\n";
    ModelFixture file = new ModelFixture("a.obj", vertices + faces);
    assertThat(labels(file, hiding("piece 2"))).containsExactly("piece 1", "piece 1");
    assertThat(labels(file, hiding("piece 1"))).containsExactly("piece 2");
  }

  /** Each tetrahedron of 100,000 is a piece; further ones than the most parts are one. */
  @Test
  void manyPiecesAreJoined() throws ModelFormatException {
    List<String> left = labels(stl(100_000), hiding("piece 5", "piece 9999"));
    assertThat(left).hasSize(9_998).contains("piece 1", "piece 9998", "other pieces");
    Model model = stl(100_000).with(hiding("piece *")).read();
    assertThat(model.parts()).hasSize(1);
    assertThat(model.parts().get(0).geometry().triangleCount()).isEqualTo(4 * (100_000 - 9_999));
    assertThat(stl(100_000).with(hiding("piece 10000")).refusal())
        .contains("expected \"piece 1\", \"piece 2\", ")
        .contains("or another name, found \"piece 10000\"; did you mean piece 1000?")
        .hasSizeLessThan(500);
  }

  @Test
  void highlightedPartsKeepTheirLookAndOthersArePale() throws ModelFormatException {
    List<ModelPart> parts = obj("red", "wheel").with(highlighting("red")).read().parts();
    assertThat(color(parts.get(0))).isEqualTo(new Rgb(1, 0, 0));
    assertThat(parts.get(0).material().name()).isEqualTo("red");
    assertThat(parts.get(0).geometry().colors()).isNotEmpty();
    assertThat(color(parts.get(1))).isEqualTo(Rgb.gray(.85));
    assertThat(parts.get(1).geometry().colors()).isEmpty();
  }

  @Test
  void highlightedPartsThatAreGrayBecomeOrange() throws ModelFormatException {
    List<ModelPart> parts = stl(3).with(highlighting("piece 2")).read().parts();
    assertThat(color(parts.get(1)).r()).isGreaterThan(4 * color(parts.get(1)).g());
    assertThat(color(parts.get(0))).isEqualTo(Rgb.gray(.85));
    assertThat(parts.get(2).material()).isSameAs(parts.get(0).material());
  }

  @Test
  void hiddenPartsCannotBeShownByHighlightingThem() throws ModelFormatException {
    ModelOptions both = hiding("piece 1").with(ModelOption.HIGHLIGHT, List.of("piece 1"));
    List<ModelPart> parts = stl(2).with(both).read().parts();
    assertThat(parts).hasSize(1);
    assertThat(color(parts.get(0))).isEqualTo(Rgb.gray(.85));
  }

  @Test
  void partsOfModelsInArchivesAreHiddenOnce() throws ModelFormatException, IOException {
    ByteArrayOutputStream archive = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(archive)) {
      zip.putNextEntry(new ZipEntry("a.stl"));
      zip.write(tetrahedra(3));
    }
    ModelFixture file = new ModelFixture("a.zip", archive.toByteArray());
    assertThat(labels(file, hiding("piece 1"))).containsExactly("piece 2", "piece 3");
  }

  @Test
  void hostileNamesAreEscapedInErrors() {
    ModelFixture file = obj("a\u001b[31m", "b".repeat(100_000));
    assertThat(file.with(hiding("c\u001b")).refusal())
        .contains("\"a\\u001b[31m\"", "found \"c\\u001b\"")
        .doesNotContain("\u001b")
        .hasSizeLessThan(300);
  }
}
