package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.xml.sax.InputSource;

class TradeCommandTest {
  @TempDir private Path directory;

  private Outcome trade(String... flags) {
    String scene = TinyScene.write(directory, TinyScene.JSON).toString();
    String[] args = new String[flags.length + 2];
    args[0] = "trade";
    args[1] = scene;
    System.arraycopy(flags, 0, args, 2, flags.length);
    return Outcome.of(args);
  }

  @Test
  void pageTableAndObjectAreWritten() throws Exception {
    Path page = directory.resolve("out.html");
    Outcome outcome = trade("--quick", "--time", "1s", "--seeds", "3", "-o", page.toString());
    assertThat(outcome.exitCode()).isZero();
    assertThat(outcome.out().strip()).isEqualTo(page.toString());

    String html = Files.readString(page);
    assertThat(html)
        .contains("For this error pick these settings", "the same bits", "data:image/png;base64,")
        .doesNotContain("NaN", "Infinity", "DIFFERENT", "http://", "https://", "<script");
    assertThat(parsedDrawings(html)).isEqualTo(2);

    JsonObject values =
        JsonParser.parseString(Files.readString(directory.resolve("out.json"))).getAsJsonObject();
    assertThat(values.get("format").getAsString()).isEqualTo("lumbre-trade-1");
    int rows = values.getAsJsonArray("rows").size();
    // Seven depths and ray tracing, three seeds each, and the head.
    assertThat(rows % 8).isZero();
    assertThat(Files.readAllLines(directory.resolve("out.csv"))).hasSize(3 * rows + 1);
  }

  private static int parsedDrawings(String html) throws Exception {
    Matcher found = Pattern.compile("<svg.*?</svg>", Pattern.DOTALL).matcher(html);
    int count = 0;
    for (; found.find(); count++) {
      DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(new InputSource(new StringReader(found.group())));
    }
    return count;
  }

  @Test
  void wrongFlagsAreNamed() throws IOException {
    trade("--seeds", "2").assertFailed(ExitCodes.USAGE, "--seeds: expected 3 to 1000");
    trade("-o", "page.txt").assertFailed(ExitCodes.USAGE, "-o: expected a name that ends in .html");
    trade("-o", directory + "/none/a.html").assertFailed(ExitCodes.OUTPUT, "does not exist");
  }
}
