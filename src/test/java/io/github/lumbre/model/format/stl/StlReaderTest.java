package io.github.lumbre.model.format.stl;

import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelPart;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of STL files. */
class StlReaderTest {
  private static final float[] SQUARE = {
    0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0, //
    0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0
  };

  /** Returns a binary file: per triangle, a normal and three vertices. */
  private static byte[] binary(String header, float... facets) {
    int count = facets.length / 12;
    ByteBuffer out = ByteBuffer.allocate(84 + 50 * count).order(ByteOrder.LITTLE_ENDIAN);
    out.put(header.getBytes(StandardCharsets.US_ASCII)).putInt(80, count).position(84);
    for (int i = 0; i < facets.length; i++) {
      out.putFloat(facets[i]);
      if (i % 12 == 11) {
        out.putShort((short) 7);
      }
    }
    return out.array();
  }

  private static String facet(String normal, String... vertices) {
    return " facet normal "
        + normal
        + "\n  outer loop\n   vertex "
        + String.join("\n   vertex ", vertices)
        + "\n  endloop\n endfacet\n";
  }

  private static ModelFixture stl(byte[] file) {
    return new ModelFixture("a.stl", file);
  }

  private static ModelFixture stl(String text) {
    return new ModelFixture("a.STL", text);
  }

  @ParameterizedTest
  @CsvSource({"made by a test", "solid but binary"})
  void binaryFilesAreToldBySize(String header) throws ModelFormatException {
    ModelGeometry mesh = stl(binary(header, SQUARE)).geometry();
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(mesh.normals()).isEmpty();
  }

  @Test
  void textsOfSeveralSolidsHaveSeveralParts() throws ModelFormatException {
    String text =
        "solid left wing\n"
            + facet("0 0 1", "0 0 0", "1 0 0", "0 1e0 0")
            + "endsolid left wing\nSOLID\r\n"
            + facet("0 0 0", "0 0 5", "1 0 5", "0 1 5").toUpperCase()
            + "ENDSOLID\nsolid empty\nendsolid empty\n";
    Model model = stl(text).read();
    assertThat(model.parts()).extracting(ModelPart::name).containsExactly("left wing", "");
    assertThat(model.parts()).extracting(ModelPart::location).containsExactly("line 1", "line 10");
    assertThat(model.parts().get(1).geometry().positions()).startsWith(0, 0, 5);
    assertThat(model.warnings()).isEmpty();
  }

  @Test
  void trianglesOfZeroAreaAreDropped() throws ModelFormatException {
    String text =
        "solid\n"
            + facet("nan nan nan", "0 0 0", "1 1 1", "2 2 2")
            + facet("-nan(ind) 0 0", "0 0 0", "0 0 0", "2 2 2")
            + facet("0 0 1", "0 0 0", "1e-200 0 0", "0 1e-200 -0")
            + "endsolid";
    Model model = stl(text).read();
    assertThat(model.parts().get(0).geometry().triangleCount()).isEqualTo(1);
    assertThat(model.warnings()).containsExactly("line 1: dropped triangles of zero area: 2");
  }

  @Test
  void ordersOfVerticesDecideWhichSideIsOutside() throws ModelFormatException {
    float[] turned = SQUARE.clone();
    turned[2] = -1;
    turned[14] = 0;
    Model model = stl(binary("", turned)).read();
    assertThat(model.parts().get(0).geometry().indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(model.warnings())
        .containsExactly("ignored normals that point to the back of their triangles: 1");
  }

  @Test
  void axesAndUnitAreThoseOfTheOptions() throws ModelFormatException {
    ModelOptions options =
        new ModelOptions(Optional.empty(), Optional.empty(), ModelOptions.Up.Z, .001);
    ModelPart part = stl(binary("", SQUARE)).with(options).part();
    assertThat(ModelFixture.mapped(part, 1000, 2000, 3000)).isEqualTo(new Vec3(1, 3, -2));
  }

  @Test
  void materialIsDiffuse() throws ModelFormatException {
    ModelMaterial material = stl(binary("", SQUARE)).part().material();
    assertThat(material.input(METALLIC).number()).isZero();
    assertThat(material.input(ROUGHNESS).number()).isEqualTo(1);
    assertThat(material.doubleSided()).isTrue();
  }

  @Test
  void bytesAfterTheLastTriangleAreIgnored() throws ModelFormatException {
    byte[] file = binary("", SQUARE);
    Model model = stl(Arrays.copyOf(file, file.length + 3)).read();
    assertThat(model.warnings()).containsExactly("ignored 3 bytes after the last triangle");
  }

  @Test
  void binaryFilesEndWithTheirLastTriangle() {
    byte[] file = binary("", SQUARE);
    assertThat(stl(Arrays.copyOf(file, file.length - 1)).refusal())
        .isEqualTo("MALFORMED expected 184 bytes for 2 triangles, found 183");
    assertThat(stl(new byte[83]).refusal())
        .isEqualTo("MALFORMED expected \"solid\" or a header of 84 bytes, found 83 bytes");
    assertThat(stl(new byte[84]).refusal())
        .isEqualTo("MALFORMED expected at least one triangle with an area, found none");
    byte[] huge = new byte[84];
    Arrays.fill(huge, (byte) -1);
    assertThat(stl(huge).refusal())
        .isEqualTo("MALFORMED expected 214748364834 bytes for 4294967295 triangles, found 84");
  }

  @ParameterizedTest
  @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY})
  void facetsThatAreNotFiniteAreLeftOut(float number) throws ModelFormatException {
    float[] broken = SQUARE.clone();
    broken[20] = number;
    Model model = stl(binary("", broken)).read();
    assertThat(model.parts().get(0).geometry().triangleCount()).isEqualTo(1);
    assertThat(model.warnings())
        .containsExactly("left out faces with a vertex that is not a finite number: 1");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "solid a;facett|line 2: expected \"facet\", found \"facett\"",
        "solid a;facet normal 0 0|line 2: expected a number, found the end of the file",
        "solid a;facet normal 0 0 x|line 2: expected a finite number, found \"x\"",
        "solid a;facet normal 0 0 1 outer loop vertex 1 2;1e999|"
            + "line 3: expected a finite number, found \"1e999\"",
        "solid a;facet normal 0 0 1 outer loop endloop|line 2: expected \"vertex\", found"
            + " \"endloop\"",
        "solid a;endsolid;facet|line 3: expected \"solid\", found \"facet\""
      })
  void errorsNameTheLine(String text, String message) {
    assertThat(stl(text.replace(';', '\n')).refusal()).isEqualTo("MALFORMED " + message);
  }

  @Test
  void missingEndIsReported() throws ModelFormatException {
    Model model = stl("solid a\n" + facet("0 0 1", "0 0 0", "1 0 0", "0 1 0")).read();
    assertThat(model.warnings())
        .containsExactly("line 9: expected \"endsolid\", found the end of the file");
  }
}
