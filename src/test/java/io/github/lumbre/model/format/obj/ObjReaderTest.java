package io.github.lumbre.model.format.obj;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of OBJ files. */
class ObjReaderTest {
  private static final String CORNERS = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

  private static ObjMesh read(String text) throws ModelFormatException {
    return ObjReader.read(text.getBytes(StandardCharsets.UTF_8));
  }

  private static String refusal(String text) {
    return catchThrowableOfType(ModelFormatException.class, () -> read(text)).getMessage();
  }

  @Test
  void trianglesAreRead() throws ModelFormatException {
    ObjMesh mesh = read(CORNERS + "f 1 2 3\nf 1 3 4\n");
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
    assertThat(mesh.normals()).isEmpty();
    assertThat(mesh.uvs()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "f 1 2 3 4",
        "f -4 -3 -2 -1",
        "f 1/1 2/1 3/1 4/1",
        "f 1//1 2//1 3//1 4//1",
        "f 1/1/1 2/2/2 3/3/3 4/4/4",
        "f\t1  2 \\\n 3 4 # corners",
        "f 1 2 3 \\\r\n4\r",
        "g part\no thing\ns off\nusemtl red\nmtllib a.mtl\n#f 9 9 9\nl 1 2\nf 1 2 3 4",
        "f 1/ 2/ 3/ 4/",
        "f +1 +2 +3 +4"
      })
  void quadsBecomeFansHoweverTheyAreWritten(String face) throws ModelFormatException {
    ObjMesh mesh = read(CORNERS + face);
    assertThat(mesh.positions()).hasSize(12);
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 0, 2, 3);
  }

  @ParameterizedTest
  @ValueSource(strings = {"\n", "\r\n", "\r"})
  void linesEndInThreeWays(String end) throws ModelFormatException {
    String text = "# of a tool\n" + CORNERS + "f 1 2 \\\n3\n\no up # up\nf 1 3 4 # end\nf 1 2";
    text = text.replace("\n", end);
    assertThat(refusal(text)).isEqualTo("line 11: expected at least 3 corners per face, found 2");
    ObjMesh mesh = read(text.substring(0, text.lastIndexOf('f')));
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  }

  @Test
  void byteOrderMarksAreNotPartOfTheFirstWord() throws ModelFormatException {
    ObjMesh mesh = read("\ufeff" + CORNERS + "f 1 2 3 4");
    assertThat(mesh.positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
  }

  @Test
  void cornersThatDifferAreDifferentVertices() throws ModelFormatException {
    ObjMesh mesh =
        read(
            CORNERS
                + "vt 0 0\nvt 0.25 0.5 9\nvt 1\nvn 0 0 1\nvn 0 0 -1\n"
                + "f 1/1/1 2/2/1 3/3/1\nf 1/1/2 3/3/1 4/-1/-1\n");
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 3, 2, 4);
    assertThat(mesh.uvs()).containsExactly(0, 0, .25, .5, 1, 0, 0, 0, 1, 0);
    assertThat(mesh.normals()).containsExactly(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, -1);
  }

  @Test
  void trianglesWithoutNormalsAndUvsInAFileThatHasThemGetTheirOwn() throws ModelFormatException {
    ObjMesh mesh = read(CORNERS + "vt .5 .5\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1 2 3\n");
    assertThat(mesh.indices()).containsExactly(0, 1, 2, 3, 4, 5);
    assertThat(mesh.normals()).startsWith(1, 0, 0).endsWith(0, 0, 1, 0, 0, 1, 0, 0, 1);
    assertThat(mesh.uvs()).endsWith(0, 0, 1, 0, 0, 1);
  }

  @Test
  void facesMayComeBeforeTheirVertices() throws ModelFormatException {
    assertThat(read("f 1 2 3\n" + CORNERS).indices()).containsExactly(0, 1, 2);
  }

  @Test
  void numbersHaveDecimalPointsInEveryCountry() throws ModelFormatException {
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.GERMANY);
      ObjMesh mesh = read("v 1.5 -2.5e-1 .5 0.7\nv 1 0 0\nv 0 1 0\nf 1 2 3");
      assertThat(mesh.positions()).startsWith(1.5, -.25, .5);
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void manyCornersKeepTheirNumbers() throws ModelFormatException {
    StringBuilder text = new StringBuilder();
    int count = 3000;
    for (int i = 0; i < count; i++) {
      text.append("v ").append(i).append(" 0 0\n");
    }
    text.append('f');
    for (int i = count; i > 0; i--) {
      text.append(' ').append(i);
    }
    ObjMesh mesh = read(text.toString());
    assertThat(mesh.indices()).hasSize(3 * (count - 2)).endsWith(0, count - 2, count - 1);
    for (int i = 0; i < count; i++) {
      assertThat(mesh.positions()[3 * i]).isEqualTo(count - 1 - i);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "f 1 2 5|line 5: expected a vertex from 1 to 4, found 5",
        "f 1 2 -5|line 5: expected a vertex from -4 to -1, found -5",
        "f 1 2 0|line 5: expected indices that start at 1, found 0 in \"0\"",
        "f 1 2 3/0|line 5: expected indices that start at 1, found 0 in \"3/0\"",
        "f 1 2 x|line 5: expected indices such as 1/2/3, found \"x\"",
        "f 1 2 1/2/3/4|line 5: expected indices such as 1/2/3, found \"1/2/3/4\"",
        "f 1 2 /3|line 5: expected indices such as 1/2/3, found \"/3\"",
        "f 1 2 -|line 5: expected indices such as 1/2/3, found \"-\"",
        "f 1 2 1.0|line 5: expected indices such as 1/2/3, found \"1.0\"",
        "f 1 2 4294967297|line 5: expected indices such as 1/2/3, found \"4294967297\"",
        "f 1 2|line 5: expected at least 3 corners per face, found 2",
        "vt 0 0;f 1/1 2/1 3/2|line 6: expected a vt from 1 to 1, found 2",
        "vn 0 0 1;f 1//1 2//1 3//2|line 6: expected a vn from 1 to 1, found 2",
        "v 1 2|line 5: expected a number, found the end of the line",
        "v 1 2 NaN|line 5: expected a finite number, found \"NaN\"",
        "v 1 2 1e400|line 5: expected a finite number, found \"1e400\"",
        "v 1 2 0x1p3|line 5: expected a finite number, found \"0x1p3\"",
        "v 1 2 3f|line 5: expected a finite number, found \"3f\"",
        "v 1 2 1,5|line 5: expected a finite number, found \"1,5\"",
        "v 1 2 --1|line 5: expected a finite number, found \"--1\"",
        "g a;;|line 8: expected at least one face, found the end of the file"
      })
  void errorsNameTheLine(String text, String message) {
    assertThat(refusal(CORNERS + text.replace(';', '\n') + "\n".repeat(1))).isEqualTo(message);
  }

  @Test
  void meshLargerThanTheHeapIsRefusedByItsCensus() throws ModelFormatException {
    byte[] text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".repeat(30_000).getBytes(US_ASCII);
    assertThat(ObjCensus.of(text, Limits.NONE.withMemory(3 << 20)).positions()).isEqualTo(90_000);
    ModelFormatException thrown =
        catchThrowableOfType(
            ModelFormatException.class, () -> ObjCensus.of(text, Limits.NONE.withMemory(2 << 20)));
    assertThat(thrown)
        .hasMessage("expected at most 2097152 bytes of memory for the model, found 2520000");
    assertThat(thrown.kind()).isEqualTo(ModelFormatException.Kind.TOO_LARGE);
  }
}
