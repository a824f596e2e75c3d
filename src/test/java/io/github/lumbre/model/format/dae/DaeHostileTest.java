package io.github.lumbre.model.format.dae;

import static io.github.lumbre.model.format.dae.DaeSample.SQUARE;
import static io.github.lumbre.model.format.dae.DaeSample.VERTEX;
import static io.github.lumbre.model.format.dae.DaeSample.VERTICES;
import static io.github.lumbre.model.format.dae.DaeSample.fixture;
import static io.github.lumbre.model.format.dae.DaeSample.mesh;
import static io.github.lumbre.model.format.dae.DaeSample.source;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelFixture;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** COLLADA files that want too much are read in part, or refused, soon. */
@Timeout(20)
class DaeHostileTest {
  private static final String INSTANCE = "<instance_geometry url=\"#g\"/>";

  private static final String LIBRARY = DaeSample.square().replace(" material=\"m\"", "");

  @Test
  void entitiesAreRefused() {
    String text = DaeSample.file(LIBRARY, INSTANCE);
    String bomb =
        text.replace(
            "<COLLADA",
            "<!DOCTYPE COLLADA [<!ENTITY a \"x\"><!ENTITY b \"&a;&a;\">]><COLLADA");
    assertThat(fixture(bomb).refusal())
        .isEqualTo("MALFORMED line 2: expected XML without a document type, found \"<!\"");
    String outside =
        text.replace("<COLLADA", "<!DOCTYPE x SYSTEM \"file:///etc/passwd\"><COLLADA");
    assertThat(fixture(outside).refusal()).contains("expected XML without a document type");
  }

  @Test
  void depthIsLimited() throws ModelFormatException {
    String deep = "<node>".repeat(900) + INSTANCE + "</node>".repeat(900);
    assertThat(fixture(DaeSample.ofNodes("", LIBRARY, deep)).read().parts()).hasSize(1);
    String deeper = "<node>".repeat(100_000);
    assertThat(fixture(DaeSample.ofNodes("", LIBRARY, deeper)).refusal())
        .isEqualTo(
            "TOO_LARGE line 8: expected at most 1000 elements within each other, found more");
  }

  @Test
  void chainsOfInstancesAreLimited() {
    StringBuilder library = new StringBuilder("<library_nodes>");
    for (int i = 0; i < 20_000; i++) {
      library.append("<node id='c%d'><instance_node url='#c%d'/></node>".formatted(i, i + 1));
    }
    String nodes = LIBRARY + library + "</library_nodes>";
    assertThat(fixture(DaeSample.file(nodes, "<instance_node url=\"#c0\"/>")).refusal())
        .isEqualTo(
            "TOO_LARGE line 7: expected at most 1000 nodes within each other, found 1001");
  }

  /** Each node shows the next one twice: 2^40 squares. */
  @Test
  void billionsOfInstancesAreCountedBeforeTheyAreMade() throws ModelFormatException {
    StringBuilder library = new StringBuilder("<library_nodes>");
    for (int i = 0; i < 40; i++) {
      library.append("<node id='c%1$d'><instance_node url='#c%2$d'/>".formatted(i, i + 1));
      library.append("<instance_node url='#c%d'/></node>".formatted(i + 1));
    }
    String last = "<node id='c40'>%s</node></library_nodes>";
    String shown = DaeSample.file(LIBRARY + library + last.formatted(INSTANCE), c0() + INSTANCE);
    assertThat(fixture(shown).refusal()).contains("expected at most 10000 parts, found ");
    // Without a surface, they are not even walked.
    Model empty =
        fixture(DaeSample.file(LIBRARY + library + last.formatted(""), c0() + INSTANCE)).read();
    assertThat(empty.parts()).hasSize(1);
  }

  private static String c0() {
    return "<instance_node url=\"#c0\"/>";
  }

  @Test
  void nodesWithinThemselvesAreLeftOut() throws ModelFormatException {
    String nodes =
        "<node id='a'>%s<node id='b'><instance_node url='#a'/></node></node>".formatted(INSTANCE);
    Model read = fixture(DaeSample.ofNodes("", LIBRARY, nodes)).read();
    assertThat(read.parts()).hasSize(1);
    assertThat(read.warnings())
        .containsExactly(
            "line 8: expected nodes that do not contain themselves, found one; it is left out"
                + " there");
  }

  @Test
  void controllersWithoutEndAreLeftOut() throws ModelFormatException {
    String library =
        LIBRARY
            + "<library_controllers><controller id='c'><skin source='#c'/></controller>"
            + "</library_controllers>";
    Model read =
        fixture(DaeSample.file(library, INSTANCE + "<instance_controller url='#c'/>")).read();
    assertThat(read.parts()).hasSize(1);
    assertThat(read.warnings())
        .containsExactly("line 8: left out a controller without a skin or a morph");
  }

  @ParameterizedTest
  @CsvSource({"count=\"12\"", "stride=\"3\"", "count=\"4\""})
  void countsAreNotTrusted(String stated) throws ModelFormatException {
    String name = stated.substring(0, stated.indexOf('='));
    for (String number : new String[] {"2147483647", "999999999", "-1", "0", "x", ""}) {
      String changed = SQUARE.replace(stated, name + "=\"" + number + "\"");
      assertThat(changed).isNotEqualTo(SQUARE);
      String text = changed + VERTICES + "<triangles>" + VERTEX + "<p>0 1 2</p></triangles>";
      ModelFixture file = mesh(text).with(ModelOptions.DEFAULT.limitedTo(Limits.UPLOADS));
      assertThat(file.geometry().positions()).containsExactly(0, 0, 0, 1, 0, 0, 1, 1, 0);
    }
  }

  @Test
  void memoryIsCountedBeforeItIsNeeded() {
    Limits limits = Limits.UPLOADS.withMemory(10_000_000);
    ModelOptions options = ModelOptions.DEFAULT.limitedTo(limits);
    String[] texts = {
      DaeSample.file(LIBRARY, INSTANCE + "<node/>".repeat(200_000)),
      DaeSample.file(
          DaeSample.geometry(source("p", "X", "1 ".repeat(2_000_000))), INSTANCE),
      DaeSample.file(
          DaeSample.geometry("<triangles><p>" + "1 ".repeat(4_000_000) + "</p></triangles>"),
          INSTANCE),
      DaeSample.file(
          DaeSample.geometry("<polygons>" + "<p/>".repeat(4_000_000) + "</polygons>"), INSTANCE)
    };
    for (String text : texts) {
      assertThat(fixture(text).with(options).refusal())
          .startsWith("TOO_LARGE ")
          .contains("bytes of memory for the model");
    }
  }

  @Test
  void trianglesAreLimited() {
    String text =
        SQUARE
            + VERTICES
            + "<triangles>"
            + VERTEX
            + "<p>"
            + "0 1 2 ".repeat(40_000)
            + "</p></triangles>";
    Limits limits = Limits.UPLOADS.withTriangles(20_000);
    assertThat(mesh(text).with(ModelOptions.DEFAULT.limitedTo(limits)).refusal())
        .startsWith("TOO_LARGE ")
        .contains("expected at most 20000 triangles");
  }

  /** A comb of very many teeth, which ear clipping would take too long for. */
  @Test
  void polygonsOfTooManyCornersAreFans() throws ModelFormatException {
    int teeth = 60_000;
    StringBuilder points = new StringBuilder();
    StringBuilder indices = new StringBuilder();
    for (int i = 0; i < teeth; i++) {
      points.append("%d 0 0 %d %d 0 ".formatted(2 * i, 2 * i + 1, 5 + i % 7));
    }
    points.append("0 -9 0");
    for (int i = 0; i <= 2 * teeth; i++) {
      indices.append(2 * teeth - i).append(' ');
    }
    String text =
        source("p", "X Y Z", points.toString())
            + VERTICES
            + "<polygons>"
            + VERTEX
            + "<p>"
            + indices
            + "</p></polygons>";
    long start = System.nanoTime();
    Model read = mesh(text).read();
    assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofSeconds(15));
    assertThat(String.join(";", read.warnings())).contains("divided polygons of too many corners");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<a/>|expected a COLLADA file, found XML",
        "<COLLADA>|line 1: expected </COLLADA>, found the end of the file",
        "<COLLADA></b>|line 1: expected </COLLADA>, found </b>",
        "<COLLADA/>|expected at least one triangle with an area, found none",
        "''|expected a COLLADA file, found an empty file",
        "{}|expected a COLLADA file, found JSON",
        "v 1 2 3|line 1: expected a <COLLADA> element, found something else"
      })
  void damagedFilesAreRefused(String text, String message) {
    assertThat(fixture(text).refusal()).contains(message);
  }
}
