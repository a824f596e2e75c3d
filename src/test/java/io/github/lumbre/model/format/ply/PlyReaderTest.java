package io.github.lumbre.model.format.ply;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelPart;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of PLY files. */
class PlyReaderTest {
  private static final String XYZ = "property float x;property float y;property float z;";
  private static final String FACE = "element face 1;property list uchar int vertex_indices;";
  private static final String TRIANGLE = "0 0 0;1 0 0;0 1 0;3 0 1 2;";

  private static String header(String format, String body) {
    return "ply;format %s 1.0;comment a test;%send_header;".formatted(format, body);
  }

  private static ModelFixture ascii(String header, String body) {
    return new ModelFixture("a.ply", (header("ascii", header) + body).replace(';', '\n'));
  }

  /** Returns a binary file: the numbers of an item are written with the types of its properties. */
  private static ModelFixture binary(ByteOrder order, String header, Object... numbers) {
    String name = order == ByteOrder.LITTLE_ENDIAN ? "binary_little_endian" : "binary_big_endian";
    ByteBuffer body = ByteBuffer.allocate(1000).order(order);
    for (Object number : numbers) {
      if (number instanceof Byte b) {
        body.put(b);
      } else if (number instanceof Short s) {
        body.putShort(s);
      } else if (number instanceof Integer i) {
        body.putInt(i);
      } else if (number instanceof Float f) {
        body.putFloat(f);
      } else {
        body.putDouble((Double) number);
      }
    }
    ByteArrayOutputStream file = new ByteArrayOutputStream();
    file.writeBytes(header(name, header).replace(';', '\n').getBytes(StandardCharsets.US_ASCII));
    file.write(body.array(), 0, body.position());
    return new ModelFixture("a.ply", file.toByteArray());
  }

  @Test
  void componentsOfColorsOutOfRangeAreClamped() throws ModelFormatException {
    String floats = "property float red;property float green;property float blue;";
    String vertices = "0 0 0 .5 -1 2;1 0 0 1 1 1.0001;0 1 0 0 inf 0;";
    Model model = ascii("element vertex 3;" + XYZ + floats + FACE, vertices + "3 0 1 2").read();
    assertThat(model.parts().get(0).geometry().colors())
        .containsExactly(.5f, 0, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1);
    assertThat(model.warnings())
        .containsExactly(
            "line 14: element vertex: clamped components of colors to the range 0 to 1: 2",
            "line 16: element vertex: ignored texture coordinates and colors that are not finite: 1");
  }

  @Test
  void componentsOfFaceColorsOutOfRangeAreClamped() throws ModelFormatException {
    String floats = "property float red;property float green;property float blue;";
    Model model = ascii("element vertex 3;" + XYZ + FACE + floats, TRIANGLE.replace("3 0 1 2;", "3 0 1 2 .5 -1 2")).read();
    assertThat(model.parts().get(0).geometry().colors()).startsWith(.5f, 0, 1, 1);
    assertThat(model.warnings())
        .containsExactly("line 17: element face: clamped components of colors to the range 0 to 1: 2");
  }

  @Test
  void polygonsBecomeFans() throws ModelFormatException {
    ModelGeometry mesh =
        ascii("element vertex 4;" + XYZ + FACE, "0 0 0;1 0 0;;1 1 .5;0 1 0;4 0 1 2 3").geometry();
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, .5, 0, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(mesh.normals()).isEmpty();
    assertThat(mesh.uv0()).isEmpty();
    assertThat(mesh.colors()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"LITTLE_ENDIAN", "BIG_ENDIAN"})
  void binaryFilesHaveAnyOrderOfElementsAndProperties(String name) throws ModelFormatException {
    ByteOrder order = name.equals("BIG_ENDIAN") ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    String header =
        "element face 1;property short flag;property list uint ushort vertex_index;"
            + "property list uchar float texcoord;"
            + "element other 2;property int64x;".replace("int64x", "double weight")
            + "element vertex 3;property double z;property uchar quality;property short y;"
            + "property int x;";
    Object[] numbers = {
      (short) -1,
      3,
      (short) 2,
      (short) 1,
      (short) 0,
      (byte) 1,
      .5f, // The face.
      1.0,
      2.0,
      -1.5,
      (byte) 200,
      (short) -300,
      70_000,
      0.0,
      (byte) 0,
      (short) 1,
      -2,
      1.0,
      (byte) 0,
      (short) 0,
      0
    };
    Model model = binary(order, header, numbers).read();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.positions()).containsExactly(0, 0, 1, -2, 1, 0, 70_000, -300, -1.5);
    assertThat(mesh.indices()).containsExactly(0, 1, 2);
    assertThat(model.warnings())
        .containsExactly(
            "element vertex: ignored the properties quality",
            "element face: ignored the properties flag",
            "element face: faces without coordinates for all corners: 1");
  }

  @ParameterizedTest
  @ValueSource(strings = {"s t", "u v", "texture_u texture_v"})
  void normalsAndTextureCoordinatesAreRead(String uv) throws ModelFormatException {
    String[] names = uv.split(" ");
    ModelGeometry mesh =
        ascii(
                "element vertex 3;property float %s;property float %s;"
                        .formatted(names[0], names[1])
                    + XYZ
                    + "property float nx;property float ny;property float nz;"
                    + FACE,
                ".5 1 0 0 0 0 0 1;0 .25 1 0 0 0 1 0;0 0 0 1 0 1 0 0;3 0 1 2")
            .geometry();
    assertThat(mesh.uv0()).containsExactly(.5, 1, 0, .25, 0, 0);
    assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 1, 0, 1, 0, 0);
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
  }

  @Test
  void integerColorsAreEncodedAndFloatsLinear() throws ModelFormatException {
    String rgb = "property T red;property T green;property T blue;";
    ModelFixture bytes =
        ascii(
            "element vertex 3;" + XYZ + rgb.replace("T", "uchar") + "property uchar alpha;" + FACE,
            "0 0 0 0 128 255 255;1 0 0 0 0 0 51;0 1 0 0 0 0 255;3 0 1 2");
    float[] colors = bytes.geometry().colors();
    assertThat(Arrays.copyOf(colors, 4)).containsExactly(0, (float) Srgb.decode(128 / 255.0), 1, 1);
    assertThat(colors[7]).isEqualTo(.2f);
    assertThat(bytes.part().material().alphaMode()).isEqualTo(AlphaMode.BLEND);
    ModelFixture floats =
        ascii(
            "element vertex 3;" + XYZ + rgb.replace("T", "float") + FACE,
            "0 0 0 -1 .5 2;1 0 0 0 0 0;0 1 0 0 0 0;3 0 1 2");
    assertThat(Arrays.copyOf(floats.geometry().colors(), 4)).containsExactly(0, .5f, 1, 1);
    assertThat(floats.part().material().alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(floats.part().material().input(BASE_COLOR).factor().r()).isEqualTo(1);
  }

  @Test
  void alphaOfZeroEverywhereIsIgnored() throws ModelFormatException {
    String header =
        "element vertex 3;"
            + XYZ
            + "property uchar red;property uchar green;property uchar blue;property uchar alpha;"
            + FACE;
    Model model = ascii(header, "0 0 0 9 9 9 0;1 0 0 9 9 9 0;0 1 0 9 9 9 0;3 0 1 2").read();
    assertThat(model.parts().get(0).geometry().colors()[3]).isEqualTo(1);
    assertThat(model.warnings())
        .containsExactly("element vertex: ignored alpha, which is 0 everywhere");
  }

  @Test
  void stripsAlternateAndRestart() throws ModelFormatException {
    ModelGeometry mesh =
        ascii(
                "element vertex 5;"
                    + XYZ
                    + "element tristrips 1;"
                    + "property list int int vertex_indices;",
                "0 0 0;1 0 0;0 1 0;1 1 0;0 2 0;9 0 1 2 3 4 -1 2 3 4")
            .geometry();
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 2, 1, 3, 2, 3, 4, 2, 3, 4);
  }

  @Test
  void axesAndUnitAreThoseOfTheOptions() throws ModelFormatException {
    ModelOptions options =
        new ModelOptions(Optional.empty(), Optional.empty(), ModelOptions.Up.Z, 2);
    ModelPart part = ascii("element vertex 3;" + XYZ + FACE, TRIANGLE).with(options).part();
    assertThat(ModelFixture.mapped(part, 1, 2, 3)).isEqualTo(new Vec3(2, 6, -4));
  }

  @Test
  void linesEndInThreeWays() throws ModelFormatException {
    String text = header("ascii", "element vertex 3;" + XYZ + FACE) + TRIANGLE;
    for (String end : new String[] {"\n", "\r\n", "\r"}) {
      ModelGeometry mesh = new ModelFixture("a.ply", text.replace(";", end)).geometry();
      assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    }
  }

  /** Tests binary data whose first byte is a line feed, after headers of all line endings. */
  @Test
  void binaryDataBeginsAfterTheLineEnd() throws ModelFormatException {
    String header =
        header(
            "binary_little_endian",
            "element vertex 3;property char x;property char y;property char z;" + FACE);
    byte[] body = {10, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0};
    for (String end : new String[] {"\n", "\r\n", "\r"}) {
      ByteArrayOutputStream file = new ByteArrayOutputStream();
      file.writeBytes(header.replace(";", end).getBytes(StandardCharsets.US_ASCII));
      file.writeBytes(body);
      ModelGeometry mesh = new ModelFixture("a.ply", file.toByteArray()).geometry();
      assertThat(mesh.positions()).containsExactly(10, 0, 0, 1, 0, 0, 0, 1, 0);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 0 0;1 0 0;0 1;3 0 1 2|line 13: element vertex: expected a number for z, found the end"
            + " of the line",
        "0 0 0;1 0 0;0 1 x;3 0 1 2|line 13: expected a finite number, found \"x\"",
        "0 0 0;1 0 0;0 1 1e200;3 0 1 2|line 13: expected a number of at most 1e150, found"
            + " \"1e200\"",
        "0 0 0;1 0 0;0 1 0;3 0 1 3|line 14: element face: expected a vertex from 0 to 2, found 3",
        "0 0 0;1 0 0;0 1 0;3 0 1 -1|line 14: element face: expected a vertex from 0 to 2, found"
            + " -1",
        "0 0 0;1 0 0;0 1 0;4 0 1  2  |line 14: element face: expected a number for vertex_indices,"
            + " found the end of the line",
        "0 0 0;1 0 0;0 1 0;-3 0 1 2|line 14: expected an integer from 0 to 3, found" + " \"-3\"",
        "0 0 0;1 0 0;0 1 0;3 0 1 2.0|line 14: expected an integer from -2147483648"
            + " to 2147483647, found \"2.0\"",
        "0 0 0;1 0 0;0 1 0 ;;|line 15: element face: expected 1 items, found 0",
        "0 0 0;1 0 0;2 0 0;3 0 1 2|expected at least one triangle with an area, found none (dropped"
            + " triangles of zero area: 1)",
      })
  void errorsInTextsNameTheLine(String body, String message) {
    ModelFixture file = ascii("element vertex 3;" + XYZ + FACE, body);
    assertThat(file.refusal()).isEqualTo("MALFORMED " + message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "plx|MALFORMED line 1: expected \"ply\", found something else",
        "ply;element|MALFORMED line 2: expected \"format\", found \"element\"",
        "ply;format ascii 2.0|UNSUPPORTED line 2: expected version 1.0, found \"2.0\"",
        "ply;format asci 1.0|MALFORMED line 2: expected ascii, binary_little_endian or"
            + " binary_big_endian, found \"asci\"",
        "ply;format ascii 1.0;element a 1;elem|MALFORMED line 4: expected \"element\", \"property\""
            + " or \"end_header\", found \"elem\"",
        "ply;format ascii 1.0;property int x|MALFORMED line 3: expected \"element\", \"property\""
            + " or \"end_header\", found \"property\"",
        "ply;format ascii 1.0;element vertex|MALFORMED line 3: expected a number of items, found"
            + " the end of the line",
        "ply;format ascii 1.0;element vertex -1|MALFORMED line 3: expected an integer from 0 to"
            + " 9223372036854775807, found \"-1\"",
        "ply;format ascii 1.0;element vertex 4000000000|TOO_LARGE line 3: expected at most"
            + " 715827879 items, found 4000000000",
        "ply;format ascii 1.0;element a 1;property long x|MALFORMED line 4: expected a type such"
            + " as float or uchar, found \"long\"",
        "ply;format ascii 1.0;element a 1;property list float int x|MALFORMED line 4: expected an"
            + " integer type for the length of a list, found a float",
        "ply;format ascii 1.0;element a 1;element a 1|MALFORMED line 4: expected elements of"
            + " different names, found \"a\" again",
        "ply;format ascii 1.0;comment|MALFORMED line 3: expected \"end_header\", found the end of"
            + " the file",
        "ply;format ascii 1.0;end_header|MALFORMED expected an element vertex, found none"
      })
  void errorsInHeadersNameTheLine(String text, String message) {
    assertThat(new ModelFixture("a.ply", text.replace(';', '\n')).refusal()).isEqualTo(message);
  }

  @Test
  void countsBeyondTheFileAreRefusedBeforeAllocation() {
    assertThat(ascii("element vertex 700000000;" + XYZ + FACE, TRIANGLE).refusal())
        .isEqualTo(
            "MALFORMED element vertex: expected 700000000 items of at least 6 bytes, found 27"
                + " bytes");
    assertThat(binary(ByteOrder.BIG_ENDIAN, "element vertex 1;" + XYZ + FACE, 0f, 0f, 0f).refusal())
        .isEqualTo("MALFORMED element face: expected 1 items of at least 1 bytes, found 0 bytes");
  }

  @Test
  void errorsInBinaryFilesNameTheItem() {
    String header = "element vertex 3;" + XYZ + FACE;
    Object[] vertices = {0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f};
    assertThat(with(header, vertices, (byte) 9, 0, 1, 2).refusal())
        .isEqualTo(
            "MALFORMED element face 0: expected a list of 0 to 3 items for vertex_indices, found"
                + " one of 9");
    assertThat(with(header, vertices, (byte) 3, 0, 1, 7).refusal())
        .isEqualTo("MALFORMED element face 0: expected a vertex from 0 to 2, found 7");
  }

  private static ModelFixture with(String header, Object[] vertices, Object... face) {
    Object[] all = Arrays.copyOf(vertices, vertices.length + face.length);
    System.arraycopy(face, 0, all, vertices.length, face.length);
    return binary(ByteOrder.LITTLE_ENDIAN, header, all);
  }

  @Test
  void unknownLinesBeforeTheFirstElementAreIgnored() throws ModelFormatException {
    Model model = ascii("Created by;element vertex 3;" + XYZ + FACE, TRIANGLE).read();
    assertThat(model.warnings())
        .containsExactly("line 4: ignored a line that begins with an unknown word");
  }

  @Test
  void facesNeedIndices() {
    String face = "element face 1;property float quality;";
    assertThat(ascii("element vertex 3;" + XYZ + face, TRIANGLE).refusal())
        .isEqualTo(
            "UNSUPPORTED expected an element face or tristrips with a list vertex_indices,"
                + " found none");
    assertThat(ascii("element vertex 3;property float x;" + FACE, TRIANGLE).refusal())
        .isEqualTo("MALFORMED element vertex: expected the properties x, y and z");
  }

  @Test
  void trianglesOfZeroAreaAreDropped() throws ModelFormatException {
    Model model =
        ascii(
                "element vertex 4;" + XYZ + FACE.replace("1;", "2;"),
                "0 0 0;1 0 0;2 0 0;0 1 0;3 0 1 2;3 0 1 3")
            .read();
    assertThat(model.parts().get(0).geometry().indices()).containsExactly(0, 1, 3);
    assertThat(model.warnings()).containsExactly("dropped triangles of zero area: 1");
  }
}
