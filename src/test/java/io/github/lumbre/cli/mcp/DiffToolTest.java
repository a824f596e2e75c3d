package io.github.lumbre.cli.mcp;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.Outcome;
import io.github.lumbre.testing.Pictures;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that the tool says and shows of two models what the command does. */
class DiffToolTest {
  private static final String SMALL =
      "'old':'old.obj','new':'new.obj','width':64,'height':48,'samples':2";

  @TempDir private Path temporary;
  private Path folder;
  private McpClient client;

  @BeforeEach
  void start() throws IOException {
    folder = Files.createDirectory(temporary.resolve("parts"));
    Files.writeString(folder.resolve("old.obj"), part("base", 0) + part("lid", 3) + part("pin", 7));
    Files.writeString(
        folder.resolve("new.obj"), part("base", 0) + part("lid", 4) + part("cap", -2));
    client = new McpClient((in, out) -> Mcp.serve(List.of(folder), in, out));
  }

  /** Returns a tetrahedron of a height that depends on its name, at a place. */
  private static String part(String name, int x) {
    return "o %s\nv %d 0 0\nv %d 0 0\nv %d %d 0\nv %d 0 1\n"
            .formatted(name, x, x + 1, x, name.charAt(0) - 'a' + 1, x)
        + "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n";
  }

  @AfterEach
  void end() throws IOException {
    client.close();
  }

  @Test
  void theChangesAreThoseOfTheCommand() throws Exception {
    JsonObject values = client.numbers("diff", SMALL);
    String printed = Outcome.of("diff", "--json", folder + "/old.obj", folder + "/new.obj").out();
    JsonObject expected = JsonParser.parseString(printed).getAsJsonObject();
    for (String key : List.of("format", "unit", "same", "notCompared", "changes")) {
      assertThat(values.get(key)).as(key).isEqualTo(expected.get(key));
    }
    assertThat(values.getAsJsonArray("changes"))
        .extracting(change -> change.getAsJsonObject().get("kind").getAsString())
        .containsExactly("added", "removed", "moved");
    assertThat(values.get("summary").getAsString())
        .isEqualTo("1 added, 1 removed, 1 moved, 1 the same");
    assertThat(values.getAsJsonObject("colors").keySet()).contains("added", "where it was");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {"`` | ``", ",'view':'front','z_up':true | --view front --up z"})
  void thePicturesAreThoseOfThePage(String arguments, String flags) throws Exception {
    JsonArray content = client.result("diff", samples(arguments)).getAsJsonArray("content");
    List<int[]> shown = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      shown.add(pixels(content.get(i).getAsJsonObject().get("data").getAsString()));
    }
    Path page = temporary.resolve("page.html");
    String line = "diff %s/old.obj %s/new.obj -o %s --size 64x48 " + flags;
    Outcome.of(line.formatted(folder, folder, page).strip().split(" "));
    Matcher pictures = Pattern.compile("base64,([^\"]+)").matcher(Files.readString(page));
    for (int[] each : shown) {
      assertThat(pictures.find()).isTrue();
      assertThat(each).isEqualTo(pixels(pictures.group(1)));
    }
  }

  private static String samples(String arguments) {
    return SMALL.replace(",'samples':2", "") + arguments;
  }

  private static int[] pixels(String base64) throws IOException {
    byte[] png = Base64.getDecoder().decode(base64);
    return Pictures.pixels(ImageIO.read(new ByteArrayInputStream(png)));
  }

  @Test
  void theTextSaysItInLines() throws Exception {
    JsonArray content = client.result("diff", SMALL).getAsJsonArray("content");
    assertThat(content.get(3).getAsJsonObject().get("text").getAsString().lines())
        .startsWith(
            "new.obj against old.obj: 1 added, 1 removed, 1 moved, 1 the same",
            "added cap",
            "removed pin",
            "moved lid: by (1, 0, 0)");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        ",'tolerance':0 | tolerance: expected a number",
        ",'tolerance':'1' | tolerance: expected a number",
        ",'camera':'a' | \"camera\": expected one of the arguments",
        ",'hide':['nothing'] | hide: expected",
      })
  void faultsAreExplained(String arguments, String message) throws Exception {
    assertThat(client.failure("diff", SMALL + arguments)).contains(message);
  }

  @Test
  void otherFilesAreRefused() throws Exception {
    Files.writeString(temporary.resolve("secret.stl"), "solid a\nendsolid a\n");
    Files.writeString(folder.resolve("s.json"), "{}");
    Files.writeString(folder.resolve("bad.stl"), "solid a\nfacet\n");
    for (String name : List.of("../secret.stl", "missing.stl", "s.json", "bad.stl")) {
      for (String order : List.of("'old':'%s','new':'new.obj'", "'old':'new.obj','new':'%s'")) {
        assertThat(client.failure("diff", order.formatted(name)))
            .contains(": ", "expected ")
            .doesNotContain("Exception");
      }
    }
  }

  /** A tolerance is in the unit of the file, and is kept as it is stated. */
  @Test
  void aToleranceHidesSmallMoves() throws Exception {
    JsonObject coarse = client.numbers("diff", SMALL + ",'tolerance':1.5");
    assertThat(coarse.get("tolerance").getAsDouble()).isEqualTo(1.5);
    assertThat(coarse.getAsJsonArray("changes"))
        .extracting(change -> change.getAsJsonObject().get("kind").getAsString())
        .doesNotContain("moved");
    JsonObject fine = client.numbers("diff", SMALL + ",'tolerance':1e-9");
    assertThat(fine.get("tolerance").getAsDouble()).isEqualTo(1e-9);
  }
}
