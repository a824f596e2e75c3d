package io.github.lumbre.model.format.dae;

import static io.github.lumbre.model.format.dae.DaeSample.SQUARE;
import static io.github.lumbre.model.format.dae.DaeSample.VERTEX;
import static io.github.lumbre.model.format.dae.DaeSample.VERTICES;
import static io.github.lumbre.model.format.dae.DaeSample.mesh;
import static io.github.lumbre.model.format.dae.DaeSample.source;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the meshes of COLLADA files. */
class DaeMeshTest {
  private static ModelGeometry square(String primitive) throws ModelFormatException {
    return mesh(SQUARE + VERTICES + primitive).geometry();
  }

  private static Vec3 corner(ModelGeometry mesh, int index) {
    int vertex = mesh.indices()[index];
    double[] p = mesh.positions();
    return new Vec3(p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]);
  }

  /** Returns the corners of all triangles as digits of their x and y, a word for each triangle. */
  private static String digits(ModelGeometry mesh) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < mesh.indices().length; i++) {
      Vec3 p = corner(mesh, i);
      text.append(i > 0 && i % 3 == 0 ? " " : "").append((int) p.x()).append((int) p.y());
      text.append(i % 3 < 2 ? "," : "");
    }
    return text.toString();
  }

  /** Returns the signed areas of all triangles as seen from +z. */
  private static List<Double> areas(ModelGeometry mesh) {
    List<Double> areas = new ArrayList<>();
    for (int i = 0; i < mesh.indices().length; i += 3) {
      Vec3 a = corner(mesh, i);
      Vec3 cross = corner(mesh, i + 1).minus(a).cross(corner(mesh, i + 2).minus(a));
      areas.add(cross.z() / 2);
    }
    return areas;
  }

  private static double sum(List<Double> areas) {
    return areas.stream().mapToDouble(a -> a).sum();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "triangles|<p>0 1 2 0 2 3</p>|00,10,11 00,11,01",
        "polylist|<vcount>4</vcount><p>0 1 2 3</p>|00,10,11 00,11,01",
        "polylist|<vcount>3 3</vcount><p>0 1 2 0 2 3</p>|00,10,11 00,11,01",
        "polygons|<p>0 1 2</p><p>0 2 3</p>|00,10,11 00,11,01",
        "tristrips|<p>0 1 3 2</p>|00,10,01 01,10,11",
        "tristrips|<p>0 1 3</p><p>1 2 3</p>|00,10,01 10,11,01",
        "trifans|<p>0 1 2 3</p>|00,10,11 00,11,01"
      })
  void facesOfAllKindsBecomeTriangles(String kind, String indices, String expected)
      throws ModelFormatException {
    String text = "<" + kind + ">" + VERTEX + indices + "</" + kind + ">";
    assertThat(digits(square(text))).isEqualTo(expected);
    // Comments and sections may be anywhere in a text.
    String torn = text.replace("<p>0", "<p><!-- 7 --> <![CDATA[0]]> ");
    assertThat(digits(square(torn))).isEqualTo(expected);
  }

  @Test
  void inputsHaveOffsetsAndSets() throws ModelFormatException {
    String normals = source("n", "X Y Z", "0 0 1 0 0 -1 0 1 0");
    String uvs = source("t", "S T", ".1 .2 .3 .4 .5 .6");
    String text =
        SQUARE
            + normals
            + uvs
            + VERTICES
            + "<triangles><input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
            + "<input semantic=\"TEXCOORD\" source=\"#t\" offset=\"3\" set=\"4\"/>"
            + VERTEX.replace("offset=\"0\"", "offset=\"2\"")
            + "<p>9 0 0 2  9 1 1 1  9 2 2 0</p></triangles>";
    String look =
        DaeSample.material(
            "lambert", "<diffuse><texture texture=\"i\" texcoord=\"T\"/></diffuse>");
    String libraries = DaeSample.geometry(text.replace("<triangles", "<triangles material=\"m\""));
    ModelGeometry read =
        DaeSample.fixture(DaeSample.file(libraries + look, DaeSample.instance())).geometry();
    assertThat(digits(read)).isEqualTo("00,10,11");
    assertThat(read.normals()).containsExactly(0, 0, 1, 0, 0, -1, 0, 1, 0);
    assertThat(read.uv0()).isEmpty(); // The picture is unknown.
  }

  @Test
  void verticesMayHaveNormals() throws ModelFormatException {
    String text =
        SQUARE
            + source("n", "X Y Z", "0 0 1 0 0 2 0 0 3 0 0 4")
            + "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>"
            + "<input semantic=\"NORMAL\" source=\"#n\"/></vertices>"
            + "<triangles>"
            + VERTEX
            + "<p>0 1 3</p></triangles>";
    assertThat(mesh(text).geometry().normals()).containsExactly(0, 0, 1, 0, 0, 2, 0, 0, 4);
  }

  @Test
  void accessorsHaveStridesOffsetsAndUnnamedComponents() throws ModelFormatException {
    String source =
        "<source id=\"p\"><float_array id=\"a\" count=\"14\">7 7 0 0 9 0  1 0 9 0  1 1 9 0"
            + "</float_array><technique_common><accessor source=\"#a\" offset=\"2\" stride=\"4\""
            + " count=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
            + "<param type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor>"
            + "</technique_common></source>";
    String text = source + VERTICES + "<triangles>" + VERTEX + "<p>0 1 2</p></triangles>";
    assertThat(mesh(text).geometry().positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0);
  }

  private static Model triangle(String source, String indices) throws ModelFormatException {
    return mesh(source + VERTICES + "<triangles>" + VERTEX + "<p>" + indices + "</p></triangles>")
        .read();
  }

  /** Nothing that is corrected is silent; indices of what is not there cost their faces. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "stride=\"3\" | stride=\"2\"  | line 5: stride: expected 3 to 12, found \"2\"; 3 is used",
        "stride=\"3\" | stride=\"0\"  | line 5: stride: expected 3 to 12, found \"0\"; 3 is used",
        "stride=\"3\" | stride=\"13\" | line 5: stride: expected 3 to 12, found \"13\"; 3 is used",
        "stride=\"3\" | stride=\"-3\" | line 5: stride: expected 3 to 12, found \"-3\"; 3 is used",
        "stride=\"3\" | offset=\"99\" | line 5: offset: expected 0 to 12, found \"99\"; 0 is used",
        "count=\"4\"  | count=\"5\"   | line 5: expected 5 vectors, found 4",
        "count=\"12\" | count=\"15\"  | line 4: expected 15 numbers, found 12"
      })
  void wrongLengthsOfSourcesAreNamed(String stated, String found, String warning)
      throws ModelFormatException {
    String changed = SQUARE.replace(stated, found);
    assertThat(changed).isNotEqualTo(SQUARE);
    Model read = triangle(changed, "0 1 2");
    assertThat(read.parts().get(0).geometry().positions())
        .containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0);
    assertThat(read.warnings()).containsExactly(warning);
  }

  /** A file whose numbers were cut off has one warning, not one for each count. */
  @Test
  void arraysThatAreCutOffAreNamedOnce() throws ModelFormatException {
    String cut = SQUARE.replace(" 0 1 0</float_array>", "</float_array>");
    Model read = triangle(cut, "0 1 2");
    assertThat(read.warnings()).containsExactly("line 4: expected 12 numbers, found 9");
  }

  @Test
  void wrongStridesOfManySourcesAreCounted() throws ModelFormatException {
    StringBuilder inputs = new StringBuilder();
    StringBuilder sources = new StringBuilder();
    for (int i = 0; i < 25; i++) {
      sources.append(
          source("n" + i, "X Y Z", "0 0 1").replace("stride=\"3\"", "stride=\"1\""));
      inputs.append("<triangles>").append(VERTEX);
      inputs.append("<input semantic=\"NORMAL\" source=\"#n%d\" offset=\"1\"/>".formatted(i));
      inputs.append("<p>0 0 1 0 2 0</p></triangles>");
    }
    List<String> warnings = mesh(SQUARE + sources + VERTICES + inputs).read().warnings();
    assertThat(warnings).hasSize(21).endsWith("and 5 more: wrong strides and offsets");
  }

  /** The numbers follow each other if nothing says otherwise. */
  @ParameterizedTest
  @ValueSource(strings = {"", "stride=\"3\"", "stride=\"2\""})
  void accessorsMayLackParameters(String stride) throws ModelFormatException {
    double[] flat = {0, 0, 0, 0, 1, 0, 1, 1, 0};
    double[] whole = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    String source = SQUARE.replaceAll("<param [^>]*>", "").replace("stride=\"3\"", stride);
    Model read = triangle(source, "0 1 3");
    assertThat(read.parts().get(0).geometry().positions())
        .containsExactly(stride.contains("2") ? flat : whole);
  }

  /** An L, whose fan from the first corner would leave it. */
  @Test
  void concavePolygonsAreDividedInside() throws ModelFormatException {
    String corners = source("p", "X Y Z", "1 1 0  1 2 0  0 2 0  0 0 0  2 0 0  2 1 0");
    for (String order : List.of("0 1 2 3 4 5", "2 3 4 5 0 1", "3 4 5 0 1 2")) {
      String text =
          corners
              + VERTICES
              + "<polylist><vcount>6</vcount>"
              + VERTEX
              + "<p>"
              + order
              + "</p></polylist>";
      List<Double> areas = areas(mesh(text).geometry());
      assertThat(areas).hasSize(4).allMatch(area -> area > 0);
      assertThat(sum(areas)).isEqualTo(3);
    }
  }

  @ParameterizedTest
  @CsvSource({"4 5 6 7,8 9 10 11", "7 6 5 4,11 10 9 8"})
  void holesStayOpen(String first, String second) throws ModelFormatException {
    String corners =
        source(
            "p",
            "X Y Z",
            "0 0 0 8 0 0 8 4 0 0 4 0  1 1 0 3 1 0 3 3 0 1 3 0  5 1 0 7 1 0 7 3 0 5 3 0");
    String text =
        corners
            + VERTICES
            + "<polygons count=\"2\">"
            + VERTEX
            + "<ph><p>0 1 2 3</p><h>"
            + first
            + "</h><h>"
            + second
            + "</h></ph><p>4 5 6</p></polygons>";
    List<Double> areas = areas(mesh(text).geometry());
    assertThat(areas).allMatch(area -> area > 0);
    assertThat(sum(areas)).isEqualTo(32 - 8 + 2);
    assertThat(areas).hasSize(4 + 8 + 2 * 2 - 2 + 1);
  }

  @Test
  void holesOutsideAreLeftOut() throws ModelFormatException {
    String text =
        source("p", "X Y Z", "0 0 0 1 0 0 1 1 0 0 1 0 5 5 0 6 5 0 6 6 0")
            + VERTICES
            + "<polygons>"
            + VERTEX
            + "<ph><p>0 1 2 3</p><h>4 5 6</h></ph></polygons>";
    Model read = mesh(text).read();
    assertThat(sum(areas(read.parts().get(0).geometry()))).isEqualTo(1);
    assertThat(read.warnings())
        .containsExactly("line 7: left out holes that are not inside their polygons: 1");
  }

  @Test
  void colorsOfVerticesAreEncoded() throws ModelFormatException {
    String colored =
        SQUARE
            + source("c", "R G B", "1 .5 0  1 .5 0  1 .5 0  1 .5 0")
            + "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>"
            + "<input semantic=\"COLOR\" source=\"#c\"/></vertices><triangles>"
            + VERTEX
            + "<p>0 1 2</p></triangles>";
    float half = .21404114f; // sRGB 0.5 by IEC 61966-2-1
    assertThat(mesh(colored).geometry().colors())
        .containsExactly(1, half, 0, 1, 1, half, 0, 1, 1, half, 0, 1);
    String bytes = colored.replace("1 .5 0", "255 127.5 0");
    Model read = mesh(bytes).read();
    assertThat(read.parts().get(0).geometry().colors()).startsWith(1, half, 0, 1);
    assertThat(read.warnings()).hasSize(1);
    assertThat(read.warnings().get(0)).contains("took the colors of vertices for 0 to 255");
  }

  @Test
  void colorsOfFacesHaveAnOffsetAndAlpha() throws ModelFormatException {
    String colored =
        SQUARE
            + source("c", "R G B A", "1 0 0 .25  0 1 0 1")
            + VERTICES
            + "<triangles>"
            + VERTEX
            + "<input semantic=\"COLOR\" source=\"#c\" offset=\"1\"/>"
            + "<p>0 1 1 1 2 1 0 0 2 0 3 0</p></triangles>";
    ModelGeometry read = mesh(colored).geometry();
    assertThat(read.vertexCount()).isEqualTo(6);
    assertThat(read.colors()).startsWith(0, 1, 0, 1).endsWith(1, 0, 0, .25f);
  }

  @Test
  void alphaOfVerticesNeedsASurfaceThatIsTransparent() throws ModelFormatException {
    String faces =
        "<triangles material=\"m\">"
            + VERTEX
            + "<input semantic=\"COLOR\" source=\"#c\" offset=\"1\"/>"
            + "<p>0 0 1 0 2 0</p></triangles>";
    String half = SQUARE + source("c", "R G B A", "1 0 0 .5") + VERTICES + faces;
    String plain = half.replace(" material=\"m\"", "");
    assertThat(mesh(plain).part().material().alphaMode()).isEqualTo(AlphaMode.BLEND);
    String libraries = DaeSample.geometry(half) + DaeSample.material("lambert", "");
    Model painted = DaeSample.fixture(DaeSample.file(libraries, DaeSample.instance())).read();
    assertThat(painted.parts().get(0).material().alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(painted.warnings())
        .containsExactly("line 10: ignored alpha of vertices, whose material is opaque");
    Model invisible = mesh(plain.replace("1 0 0 .5", "1 0 0 0")).read();
    assertThat(invisible.parts().get(0).material().alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(invisible.warnings())
        .containsExactly("line 10: ignored alpha, which is 0 everywhere");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<p>0 1 2 0 2 3 1</p>|ignored faces of fewer than 3 corners: 1",
        "<p>0 1 2 0 2 3 0 1 9</p>|left out faces with indices beyond their vertices: 1",
        "<p>0 1 2 0 2 3 0 1 x</p>|left out faces with indices beyond their vertices: 1",
        "<p>0 1 2 0 2 3 0 1 -1</p>|left out faces with indices beyond their vertices: 1",
        "<p>0 1 2 0 2 3 0 1 99999999999</p>|left out faces with indices beyond their vertices: 1",
        "<p>0 1 2 0 2 3 0 1 4</p>|left out faces with a vertex that is not a finite number: 1",
        "<p>0 1 2 0 2 3 0 1 1</p>|dropped triangles of zero area: 1"
      })
  void wrongFacesAreLeftOut(String indices, String warning) throws ModelFormatException {
    String positions = SQUARE.replace("0 1 0</float", "0 1 0 nan 1e999 ,</float");
    String text = positions + VERTICES + "<triangles>" + VERTEX + indices + "</triangles>";
    Model read = mesh(text).read();
    assertThat(digits(read.parts().get(0).geometry())).isEqualTo("00,10,11 00,11,01");
    assertThat(read.warnings()).hasSize(2).element(1).asString().endsWith(": " + warning);
    assertThat(read.warnings().get(0))
        .contains("expected finite numbers, found other words: 3");
  }

  @Test
  void missingElementsAreNamed() throws ModelFormatException {
    String text =
        SQUARE
            + VERTICES
            + "<polylist count=\"5\">"
            + VERTEX
            + "<vcount>4 3 2 8</vcount><p>0 1 2 3 0 1 2 0 1</p></polylist>";
    Model read = mesh(text).read();
    assertThat(read.parts().get(0).geometry().triangleCount()).isEqualTo(3);
    assertThat(String.join(";", read.warnings()))
        .contains("expected 5 in <polylist>, found 3")
        .contains("ignored faces of fewer than 3 corners: 1")
        .contains("left out polygons whose number of corners is wrong: 1");
  }

  @Test
  void brokenNormalsAreComputed() throws ModelFormatException {
    String text =
        SQUARE
            + source("n", "X Y Z", "1 0 0 nan 0 0")
            + VERTICES
            + "<triangles>"
            + VERTEX
            + "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
            + "<p>0 0 1 0 2 0  0 0 2 1 3 7</p></triangles>";
    Model read = mesh(text).read();
    assertThat(read.parts().get(0).geometry().normals())
        .containsExactly(1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1);
    assertThat(String.join(";", read.warnings()))
        .contains("computed normals of faces whose own are missing or not finite: 1");
  }

  @Test
  void linesAreLeftOut() throws ModelFormatException {
    String lines = "<lines count=\"1\">" + VERTEX + "<p>0 1</p></lines>";
    Model read =
        mesh(SQUARE + VERTICES + lines + "<triangles>" + VERTEX + "<p>0 1 2</p></triangles>")
            .read();
    assertThat(read.warnings()).containsExactly("line 7: left out lines: 1");
    assertThat(mesh(SQUARE + VERTICES + lines).refusal())
        .contains("expected at least one triangle with an area, found none")
        .contains("left out lines");
  }

  @Test
  void primitivesOfOneMaterialAreOnePart() throws ModelFormatException {
    String first = "<triangles material=\"m\">" + VERTEX + "<p>0 1 2</p></triangles>";
    String other = first.replace("\"m\"", "\"o\"");
    Model read = mesh(SQUARE + VERTICES + first + other + first.replace("1 2", "2 3")).read();
    assertThat(read.parts()).hasSize(2);
    assertThat(digits(read.parts().get(0).geometry())).isEqualTo("00,10,11 00,11,01");
    assertThat(read.parts().get(1).node()).isSameAs(read.parts().get(0).node());
  }

  /** Programs that join files leave the ids of their meshes as they were. */
  @Test
  void idsOfMeshesMayBeUsedAnew() throws ModelFormatException {
    String first = SQUARE + VERTICES + DaeSample.TRIANGLES;
    String libraries =
        DaeSample.geometry("g", first) + DaeSample.geometry("h", first.replace("1 1 0", "5 5 0"));
    String nodes = "<instance_geometry url=\"#g\"/><instance_geometry url=\"#h\"/>";
    Model read = DaeSample.fixture(DaeSample.file(libraries, nodes)).read();
    assertThat(digits(read.parts().get(0).geometry())).isEqualTo("00,10,11 00,11,01");
    assertThat(digits(read.parts().get(1).geometry())).isEqualTo("00,10,55 00,55,01");
  }

  @Test
  void decimalCommasArePoints() throws ModelFormatException {
    String text =
        source("p", "X Y Z", "0,0 0 0 1,5 0 0 1,5 2,5e0 0")
            + VERTICES
            + "<triangles>"
            + VERTEX
            + "<p>0 1 2</p></triangles>";
    Model read = mesh(text).read();
    assertThat(read.parts().get(0).geometry().positions())
        .containsExactly(0, 0, 0, 1.5, 0, 0, 1.5, 2.5, 0);
    assertThat(read.warnings())
        .containsExactly("line 4: commas in numbers are taken for decimal points");
  }
}
