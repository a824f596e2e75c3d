package io.github.lumbre.model.format.off;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial.AlphaMode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of OFF texts. */
class OffReaderTest {
  private static final String SQUARE = "0 0 0;1 0 0;1 1 0;0 1 0;";
  private static final float GRAY = (float) PlainModel.ALBEDO;

  /** Returns a file; lines end where the text has semicolons. */
  private static ModelFixture off(String text) {
    return new ModelFixture("a.OFF", text.replace(';', '\n'));
  }

  private static float linear(double encoded) {
    return (float) Srgb.decode(encoded);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "OFF;4 1 0;" + SQUARE + "4 0 1 2 3;",
        "OFF 4 1 0;" + SQUARE + "4 0 1 2 3",
        "OFF4 1 0;" + SQUARE + "4 0 1 2 3",
        "OFF;4 1;" + SQUARE + "4 0 1 2 3;",
        "# made by a test;OFF # text;; #4 2 0;4 1 0;;0 0 0 # first;1 0 0;1 1 0;0 1 0;;4 0 1 2 3;;",
        "\ufeffOFF\r;4 1 0\r;0 0 0\r;1 0 0\r;1 1 0\r;0 1 0\r;4 0 1 2 3\r;"
      })
  void polygonsBecomeFans(String text) throws ModelFormatException {
    Model model = off(text).read();
    assertThat(model.warnings()).isEmpty();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(mesh.normals()).isEmpty();
    assertThat(mesh.colors()).isEmpty();
  }

  /** Numbers of a vertex or a face on several lines, several on one line, or all on one. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "OFF;4 1 0;" + SQUARE + "4 0;1;2;3;",
        "OFF;4 1 0;0 0;0;1;0 0;1 1;0;0 1 0;4;0 1 2 3",
        "OFF;4 1 0;0 0 0 1 0 0;1 1 0 0 1 0;4 0 1 2 3",
        "OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3",
        "OFF;4;1;0;0;0;0;1;0;0;1;1;0;0;1;0;4;0;1;2;3",
        "OFF;4 2 0;" + SQUARE + "3 0 1 2 3 0 2 3",
        "OFF # text;4 2 0 0 0 0 1 0 0;1 1 0 # corner;0 1 0 3 0 1 2 3 0 2 3;;"
      })
  void linesNeedNotBeThoseOfVerticesAndFaces(String text) throws ModelFormatException {
    Model model = off(text).read();
    assertThat(model.warnings()).isEmpty();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(mesh.colors()).isEmpty();
  }

  @Test
  void attributesNeedNotBeOnOneLine() throws ModelFormatException {
    Model model = off("OFF;4 2 0;" + SQUARE + "3 0;1 2 255 0 0;3 0 2 3 0 255 0;").read();
    assertThat(model.warnings()).isEmpty();
    assertThat(model.parts().get(0).geometry().colors()).startsWith(1, 0, 0, 1);
    for (String color : new String[] {"0 51 0", "0 51 0 255"}) {
      String text = "COFF 3 1 0 0 0 0 %s 1 0 0 %s 0 1 0 %s 3 0 1 2";
      ModelGeometry mesh = off(text.formatted(color, color, color)).geometry();
      assertThat(mesh.colors()).startsWith(0, linear(.2), 0, 1);
      assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 0, 1, 0);
    }
    String all =
        "STCNOFF 3 1 0 0 0 0 0 0 1 1 0 0 1 0 1 1 0 0 0 0 1 1 0 0 1 1 1"
            + " 0 1 0 0 0 1 1 0 0 1 .5 .5";
    ModelGeometry mesh = off(all + " 3 0 1 2").geometry();
    assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1);
    assertThat(mesh.uv0()).containsExactly(0, 1, 1, 1, .5, .5);
  }

  @Test
  void materialIsLightGray() throws ModelFormatException {
    ModelPart part = off("OFF;4 1 0;" + SQUARE + "4 0 1 2 3;").part();
    assertThat(part.material().input(BASE_COLOR).factor()).isEqualTo(Rgb.gray(PlainModel.ALBEDO));
    assertThat(part.material().doubleSided()).isTrue();
  }

  @Test
  void verticesHaveNormalsColorsAndCoordinatesInThisOrder() throws ModelFormatException {
    String text =
        "STCNOFF;3 1 0;0 0 0 0 0 1 255 0 0 51 .25 1;1 0 0 0 1 0 0 0 0 .5 0;0 1 0 1 0 0 0 5 0 0 0;"
            + "3 0 1 2;";
    Model model = off(text).read();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 1, 0, 1, 0, 0);
    assertThat(mesh.uv0()).containsExactly(.25, 1, .5, 0, 0, 0);
    assertThat(mesh.colors()).containsExactly(1, 0, 0, .2f, 0, 0, 0, 1, 0, linear(5 / 255.), 0, 1);
    assertThat(model.parts().get(0).material().alphaMode()).isEqualTo(AlphaMode.BLEND);
    assertThat(model.warnings()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"255 0 51, 1, .2", "1 0 .2, 1, .2", "1.0 0 0.2 1.0, 1, .2", "1 0 1, 1, 1"})
  void largestComponentDecidesWhatIsOne(String color, double red, double blue)
      throws ModelFormatException {
    String vertices = "0 0 0 %s;1 0 0 %<s;0 1 0 %<s;".formatted(color);
    float[] colors = off("COFF;3 1 0;" + vertices + "3 0 1 2;").geometry().colors();
    assertThat(colors).startsWith(linear(red), 0, linear(blue), 1).hasSize(12);
    String faces = "OFF;4 1 0;" + SQUARE + "4 0 1 2 3 " + color;
    assertThat(off(faces).geometry().colors()).startsWith(linear(red), 0, linear(blue), 1);
  }

  @Test
  void facesHaveColorsOfTheirOwn() throws ModelFormatException {
    ModelPart part = off("OFF;4 3 0;" + SQUARE + "3 0 1 2 255 0 0;3 0 2 3;3 0 3 1 0 255 0").part();
    ModelGeometry mesh = part.geometry();
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 8);
    assertThat(mesh.colors()).startsWith(1, 0, 0, 1).endsWith(0, 1, 0, 1);
    assertThat(mesh.colors()[4 * 3]).isEqualTo(GRAY);
    assertThat(mesh.positions()).startsWith(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0);
    assertThat(part.material().alphaMode()).isEqualTo(AlphaMode.OPAQUE);
  }

  @Test
  void cornersOfOneFaceShareItsVertices() throws ModelFormatException {
    ModelGeometry mesh = off("OFF;4 1 0;" + SQUARE + "4 0 1 2 3 255 0 0").geometry();
    assertThat(mesh.vertexCount()).isEqualTo(4);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
  }

  @Test
  void colorsOfVerticesWin() throws ModelFormatException {
    String text = "COFF;3 1 0;0 0 0 0 0 255;1 0 0 0 0 255;0 1 0 0 0 255;3 0 1 2 255 0 0;";
    assertThat(off(text).geometry().colors()).startsWith(0, 0, 1, 1);
  }

  @Test
  void whatIsNotUsedIsReported() throws ModelFormatException {
    String text = "OFF;3 3 0;0 0 0 9;1 0 0;0 1 0;3 0 1 2 7;3 0 1 2 1 2;2 0 1;more";
    assertThat(off(text).read().warnings())
        .containsExactly(
            "line 9: ignored what follows the last face",
            "line 3: ignored words at the end of a line: 1",
            "line 6: ignored indices of a table of colors: 1",
            "line 7: ignored colors of other than 3 or 4 numbers: 1",
            "line 8: ignored faces of fewer than 3 corners: 1");
  }

  @Test
  void verticesThatAreNotFiniteAreLeftOut() throws ModelFormatException {
    String text = "NOFF;4 2 0;0 0 0 0 0 1;1 0 0 0 nan 1;0 1 0 0 0 1;inf 1 0 0 0 1;3 0 1 2;3 1 2 3;";
    Model model = off(text).read();
    ModelGeometry mesh = model.parts().get(0).geometry();
    assertThat(mesh.indices()).containsExactly(0, 1, 2);
    assertThat(mesh.positions()).endsWith(0, 1, 0);
    assertThat(mesh.normals()).isEmpty();
    assertThat(model.warnings())
        .containsExactly(
            "line 8: left out faces with a vertex that is not a finite number: 1",
            "ignored the normals, because some are not finite");
  }

  @Test
  void unusedAlphaIsIgnored() throws ModelFormatException {
    Model model = off("COFF;3 1 0;0 0 0 9 9 9 0;1 0 0 9 9 9 0;0 1 0 9 9 9 0;3 0 1 2").read();
    assertThat(model.parts().get(0).geometry().colors()).endsWith(1);
    assertThat(model.parts().get(0).material().alphaMode()).isEqualTo(AlphaMode.OPAQUE);
    assertThat(model.warnings()).containsExactly("ignored alpha, which is 0 everywhere");
  }

  @Test
  void axesAndUnitAreThoseOfTheOptions() throws ModelFormatException {
    ModelOptions options =
        new ModelOptions(Optional.empty(), Optional.empty(), ModelOptions.Up.Z, .001);
    ModelPart part = off("OFF;4 1 0;" + SQUARE + "4 0 1 2 3;").with(options).part();
    assertThat(ModelFixture.mapped(part, 1000, 2000, 3000)).isEqualTo(new Vec3(1, 3, -2));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "OF;3 1 0|MALFORMED line 1: expected \"OFF\", found something else",
        "OFF|MALFORMED line 1: expected the numbers of vertices and faces, found the end of the"
            + " file",
        "OFF;3 x 0|MALFORMED line 2: expected an integer from 0 to 2147483647, found \"x\"",
        "OFF;-3 1 0|MALFORMED line 2: expected an integer from 0 to 2147483647, found \"-3\"",
        "OFF;2147483647 2147483647 0|MALFORMED line 2: expected 2147483647 vertices and"
            + " 2147483647 faces of at least 17179869176 bytes, found 1 bytes",
        "OFF99999999999 1 0|MALFORMED line 1: expected 2147483647 vertices and 1 faces of at least"
            + " 12884901884 bytes, found 1 bytes",
        "4OFF;3 1 0|UNSUPPORTED line 1: expected three coordinates, found \"4OFF\"; export it as"
            + " OFF text or GLB",
        "nOFF;5;3 1 0|UNSUPPORTED line 1: expected three coordinates, found \"nOFF\"; export it as"
            + " OFF text or GLB",
        "OFF BINARY;|UNSUPPORTED line 1: expected OFF as text, found \"BINARY\"; export it as OFF"
            + " text or GLB",
        "OFF;3 1 0;0 0 0;1 0;0 1 0;3 0 1 2;|MALFORMED line 4: expected 3 numbers, found 2",
        "NOFF;3 1 0;0 0 0;1 0 0;0 1 0;3 0 1 2;|MALFORMED line 3: expected 6 numbers, found 3",
        "OFF;3 1 0;0 0 x;1 0 0;0 1 0;3 0 1 2;|MALFORMED line 3: expected a finite number, found"
            + " \"x\"",
        "OFF;3 1 0;0.0001 0.0001 0.0001;1 0 0;|MALFORMED line 5: expected 3 vertices, found 2",
        "OFF;3 2 0;0.0001 0.0001 0;1 0 0;0 1 0;3 0 1 2;|MALFORMED line 7: expected 2 faces, found"
            + " 1",
        "OFF;3 1 0;0 0 0;1 0 0;0 1 0;3 0 1 3;|MALFORMED line 6: expected an integer from 0 to 2,"
            + " found \"3\"",
        "OFF;3 1 0;0 0 0;1 0 0;0 1 0;3 0 1 -1;|MALFORMED line 6: expected an integer from 0 to 2,"
            + " found \"-1\"",
        "OFF;3 1 0;0 0 0;1 0 0;0 1 0;4 0 1 2;|MALFORMED line 6: expected a vertex, found the end"
            + " of the line"
      })
  void errorsNameThePlace(String text, String message) {
    assertThat(off(text).refusal()).isEqualTo(message);
  }

  @Test
  void memoryIsLimited() {
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(Limits.NONE.withMemory(300));
    assertThat(off("OFF;4 1 0;" + SQUARE + "4 0 1 2 3;").with(options).refusal())
        .isEqualTo("TOO_LARGE expected at most 300 bytes of memory for the model, found 320");
  }

  @Test
  void interruptEndsTheReading() {
    ModelFixture model = off("OFF" + ";".repeat(1 << 15) + "4 1 0;" + SQUARE + "4 0 1 2 3");
    assertCancelled(model::read);
  }
}
