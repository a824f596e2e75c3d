package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.gltf.GltfFile;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is broken in a file is left out with a warning, and the rest of the model stays. */
class BrokenElementsTest {
  private static final Path CASES = Path.of("src/test/resources/cases");
  private static final String NUMBERS = "property float x;property float y;property float z;";
  private static final String VERTICES = "0 0 0;1 0 0;0 1 0;";

  private static ModelFixture obj(String text) {
    return new ModelFixture("a.obj", text.replace(';', '\n'));
  }

  private static ModelFixture ply(String properties, String vertices, String faces) {
    int count = vertices.split(";").length;
    String header =
        "ply;format ascii 1.0;element vertex %d;%selement face %d;"
            .formatted(count, properties, faces.split(";").length);
    String list = "property list uchar int vertex_indices;end_header;";
    return new ModelFixture("a.ply", (header + list + vertices + faces).replace(';', '\n'));
  }

  /** Checks that the only triangle is (0,0,0), (1,0,0), (0,1,0), and returns the warnings. */
  private static Model triangle(ModelFixture file) throws ModelFormatException {
    Model model = file.read();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.triangleCount()).isEqualTo(1);
    double[] corners =
        Arrays.stream(mesh.indices())
            .flatMap(i -> IntStream.range(3 * i, 3 * i + 3))
            .mapToDouble(i -> mesh.positions()[i])
            .toArray();
    assertThat(corners).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    for (double[] array : new double[][] {mesh.positions(), mesh.normals(), mesh.uv0()}) {
      assertThat(Arrays.stream(array).allMatch(Double::isFinite)).isTrue();
    }
    return model;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "v 0 0;v 1 0;v 0 1;f 1 2 3|line 1: took z for 0 in vertices of two numbers: 3",
        "v 0 0 0 nan 0 0;v 1 0 0 1 0 0;v 0 1 0;f 1 2 3|line 1: ignored colors of vertices that are"
            + " not finite: 1",
        "v 0 0 0 -nan(ind) 0 inf;v 1 0 0;v 0 1 0;f 1 2 3|line 1: ignored colors of vertices that"
            + " are not finite: 1",
        "v 0 0 0;v 1 0 0;v 0 1 0;v nan nan nan;f 1 2 3;f 1 2 4;f 4 3 1|line 6: left out faces with"
            + " a vertex that is not a finite number: 2",
        "v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 3;f 1;f;f 1 2|line 5: ignored faces of fewer than 3"
            + " corners: 3",
        "v 0 0 0;v 1 0 0;v 0 1 0;vt nan 1;vt inf;f 1/1 2/1 3/2|line 4: took texture coordinates"
            + " that are not finite for 0: 2"
      })
  void objLeavesThemOut(String text, String warning) throws ModelFormatException {
    assertThat(triangle(obj(text)).warnings()).containsExactly(warning);
  }

  @Test
  void unusedVerticesOfObjMayBeBroken() throws ModelFormatException {
    String text = "v 0 0 0;v 1 0 0;v 0 1 0;v 1.#QNAN -1.#IND Infinity;f 1 2 3";
    assertThat(triangle(obj(text)).warnings()).isEmpty();
  }

  @Test
  void normalsThatAreNotFiniteAreAsNone() throws ModelFormatException {
    String text = "v 0 0 0;v 1 0 0;v 0 1 0;vn nan 0 0;vn 0 0 1;f 1//1 2//2 3//2";
    triangle(obj(text));
    assertThat(obj(text).geometry().normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-16LE", "UTF-16BE"})
  void textsMayBeInUtf16(String charset) throws ModelFormatException, IOException {
    String text = "\ufeffmtllib \u00e9.mtl\nusemtl \u00e9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Charset utf16 = Charset.forName(charset);
    ModelFixture file =
        new ModelFixture("a.obj", text.getBytes(utf16))
            .with("\u00e9.mtl", "\ufeffnewmtl \u00e9\nKd 1 0 0\n".getBytes(utf16));
    Model model = triangle(file);
    assertThat(model.warnings())
        .containsExactly(
            "expected UTF-8, found UTF-16, which is read, too",
            "line 1: expected UTF-8, found UTF-16, which is read, too");
    assertThat(model.parts().get(0).material().input(MaterialParameter.BASE_COLOR).factor().r())
        .isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({
    "-colorspace sRGB a.png, -colorspace",
    "-s 1 1 1 -colorspace linear -clamp on a.png, -colorspace",
    "-foo a.png, -foo",
    "-foo -bar 3 a.png, -foo"
  })
  void unknownOptionsOfMapsAreIgnored(String map, String option) throws ModelFormatException {
    ModelFixture file =
        obj("mtllib a.mtl;usemtl m;v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 3")
            .with("a.mtl", "newmtl m\nmap_Kd " + map)
            .with("a.png", Pixels.of(1, 1, 3, new byte[3]).toPng());
    Model model = triangle(file);
    assertThat(model.parts().get(0).material().input(MaterialParameter.BASE_COLOR).texture())
        .isPresent();
    assertThat(model.warnings().get(0)).isEqualTo("a.mtl line 2: ignored the option " + option);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 0 0 7 x;1 0 0;0 1 0;|3 0 1 2 8;|line 10: element vertex: ignored words at the end of a"
            + " line: 2",
        "0 0 0;1 0 0;0 1 0;|0;3 0 1 2;2 0 1;1 2;|line 13: element face: ignored faces of fewer than"
            + " 3 corners: 3",
        "0 0 0;1 0 0;0 1 0;nan 0 -inf;|3 0 1 2;4 0 1 2 3;|left out triangles with a vertex that is"
            + " not a finite number: 1"
      })
  void plyLeavesThemOut(String vertices, String faces, String warning) throws ModelFormatException {
    ModelFixture file = ply(NUMBERS, vertices, faces);
    if (faces.contains("4 0 1 2 3")) {
      // The other half of the quadrilateral stays.
      assertThat(file.geometry().triangleCount()).isEqualTo(2);
    } else {
      triangle(file);
    }
    assertThat(file.read().warnings()).containsExactly(warning);
  }

  @Test
  void unusedVerticesOfPlyMayBeBroken() throws ModelFormatException {
    Model model = triangle(ply(NUMBERS, VERTICES + "nan nan nan;", "3 0 1 2;"));
    assertThat(model.warnings())
        .containsExactly("element vertex: ignored vertices that are not finite: 1");
  }

  @Test
  void brokenNormalsOfPlyAreIgnoredIfTheyAreUsed() throws ModelFormatException {
    String normals = NUMBERS + "property float nx;property float ny;property float nz;";
    String sound = "0 0 0 0 0 1;1 0 0 0 0 1;0 1 0 0 0 1;0 0 0 nan 0 0;";
    assertThat(triangle(ply(normals, sound, "3 0 1 2;")).warnings()).isEmpty();
    ModelFixture broken = ply(normals, sound.replaceFirst("0 0 1", "0 0 nan"), "3 0 1 2;");
    assertThat(triangle(broken).warnings())
        .containsExactly("element vertex: ignored the normals, because some are not finite");
    assertThat(broken.geometry().normals()).isEmpty();
  }

  @Test
  void brokenColorsOfPlyAreWhite() throws ModelFormatException {
    String colors = NUMBERS + "property float red;property float green;property float blue;";
    ModelFixture file = ply(colors, "0 0 0 nan 0 0;1 0 0 0 0 0;0 1 0 0 0 0;", "3 0 1 2;");
    assertThat(triangle(file).warnings())
        .containsExactly(
            "line 13: element vertex: ignored texture coordinates and colors that are not finite:"
                + " 1");
    assertThat(file.geometry().colors()).startsWith(1, 0, 0, 1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"nanv.ply", "empty_list.ply"})
  void casesShowTheirQuadrilateral(String name) throws ModelFormatException, IOException {
    byte[] content = Files.readAllBytes(CASES.resolve(name));
    assertThat(new ModelFixture(name, content).geometry().triangleCount()).isEqualTo(2);
  }

  /** Returns a GLB file whose JSON chunk has some bytes more than a multiple of four. */
  private static byte[] unpadded(int more) {
    byte[] padded = GltfFile.ofTriangle().glb();
    int length = 20 + (padded[12] & 0xff | (padded[13] & 0xff) << 8);
    byte[] json =
        new String(padded, 20, length - 20, StandardCharsets.US_ASCII)
            .strip()
            .getBytes(StandardCharsets.US_ASCII);
    int size = (json.length + 3 & ~3) + more;
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(padded, 0, 12);
    out.writeBytes(new byte[] {(byte) size, (byte) (size >> 8), 0, 0, 'J', 'S', 'O', 'N'});
    out.writeBytes(json);
    out.writeBytes(" ".repeat(size - json.length).getBytes(StandardCharsets.US_ASCII));
    out.write(padded, length, padded.length - length);
    byte[] file = out.toByteArray();
    file[8] = (byte) file.length;
    file[9] = (byte) (file.length >> 8);
    return file;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void chunksMayLackTheirPadding(int more) throws ModelFormatException, IOException {
    Model model = ModelReader.read("a.glb", unpadded(more), GltfFile.EMPTY, ModelOptions.DEFAULT);
    assertThat(model.parts().get(0).geometry().positions())
        .containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    assertThat(model.warnings())
        .isEqualTo(
            more == 0
                ? List.of()
                : List.of("byte 12: expected a chunk that is padded to 4 bytes, found none"));
  }
}
