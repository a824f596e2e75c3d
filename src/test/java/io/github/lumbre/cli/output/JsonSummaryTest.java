package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.Outcome;
import io.github.lumbre.cli.TinyScene;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the JSON output of renders and failures. */
class JsonSummaryTest {
  @TempDir private Path directory;

  private Outcome run(String command, String scene, String... flags) {
    String file = TinyScene.write(directory, scene).toString();
    return Outcome.of(
        Stream.concat(Stream.of(command, file), Stream.of(flags)).toArray(String[]::new));
  }

  private Outcome render(String scene, String... flags) {
    String picture = directory.resolve("tiny.png").toString();
    Stream<String> all = Stream.concat(Stream.of("-o", picture, "--json"), Stream.of(flags));
    return run("render", scene, all.toArray(String[]::new));
  }

  private static JsonObject object(Outcome outcome) {
    assertThat(outcome.out().lines()).hasSize(1);
    JsonObject object = outcome.json();
    assertThat(object.get("format").getAsString()).isEqualTo(JsonSummary.FORMAT);
    assertThat(object.get("exit_code").getAsInt()).isEqualTo(outcome.exitCode());
    return object;
  }

  @Test
  void renderTellsWhatItDid() {
    JsonObject object = object(render(TinyScene.JSON));
    assertThat(object.get("command").getAsString()).isEqualTo("render");
    assertThat(object.get("complete").getAsBoolean()).isTrue();
    assertThat(object.get("samples").getAsLong()).isEqualTo(16 * 12 * 2);
    assertThat(object.get("output").getAsString()).endsWith("tiny.png");
    assertThat(object.get("scene_sha256").getAsString()).hasSize(64);
    assertThat(object.get("warnings").getAsJsonArray()).isEmpty();
    assertThat(object.has("problems")).isFalse();
  }

  @Test
  void partialRenderSaysWhatStoppedIt() {
    JsonObject object = object(render(TinyScene.JSON, "-s", "1000000000", "--timeout", "0.7s"));
    assertThat(object.get("complete").getAsBoolean()).isFalse();
    assertThat(object.get("stopped_by").getAsString()).isEqualTo("timeout");
    assertThat(object.get("ended_by").getAsString()).isEqualTo("timeout");
  }

  @Test
  void dryRunTellsItsEstimate() {
    JsonObject object = object(render(TinyScene.JSON, "--dry-run", "--threads", "2"));
    assertThat(object.get("pixels").getAsLong()).isEqualTo(192);
    assertThat(object.get("threads").getAsInt()).isEqualTo(2);
    assertThat(object.get("fits").getAsBoolean()).isTrue();
  }

  @Test
  void checkTellsWhatTheSceneHolds() {
    JsonObject object = object(run("check", TinyScene.JSON, "--json"));
    assertThat(object.get("camera").getAsString()).isEqualTo("Pinhole");
    assertThat(object.get("shapes").getAsInt()).isEqualTo(3);
  }

  @Test
  void failuresTellAllProblemsAndTheExitCode() {
    String wrong =
        TinyScene.with("\"radius\": 1", "\"radius\": -1")
            .replace("\"intensity\": 3", "\"intensity\": -3");
    for (Outcome outcome : List.of(run("check", wrong, "--json"), render(wrong))) {
      assertThat(outcome.exitCode()).isEqualTo(ExitCodes.SCENE);
      assertThat(object(outcome).get("problems").getAsJsonArray()).hasSize(2);
      assertThat(outcome.err().lines()).hasSize(2);
    }
    Outcome strict =
        run("check", TinyScene.with("\"radius\": 1", "\"radiu\": 1"), "--json", "--strict");
    assertThat(object(strict).get("problems").toString()).contains("--strict");
    Outcome large = render(TinyScene.JSON, "--max-pixels", "9");
    assertThat(object(large).get("exit_code").getAsInt()).isEqualTo(ExitCodes.LIMIT);
  }

  @Test
  void wrongCommandLineIsToldInWordsAlone() {
    Outcome outcome = render(TinyScene.JSON, "--crop", "10,0,7,1");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(outcome.out()).isEmpty();
  }

  @Test
  void charactersThatControlTerminalsAreEscapedAndComeBack() {
    // Right-to-left override, control sequence introducer, and a tag character of two units.
    String evil = "a\u202e\u009b31m\udb40\udc01";
    StringWriter out = new StringWriter();
    JsonSummary summary = new JsonSummary("check", Path.of("scene.json"));
    summary.put("name", evil);
    summary.print(new Messages(new PrintWriter(out)));
    assertThat(out.toString())
        .doesNotContain("\u202e", "\u009b", "\udb40")
        .contains("\\udb40\\udc01");
    JsonObject object = JsonParser.parseString(out.toString()).getAsJsonObject();
    assertThat(object.get("name").getAsString()).isEqualTo(evil);
  }

  @Test
  void progressIsAnObjectALineOnStandardError() {
    Outcome outcome = render(TinyScene.JSON, "--progress", "json", "--quiet");
    List<JsonObject> lines =
        outcome.err().lines().map(JsonParser::parseString).map(e -> e.getAsJsonObject()).toList();
    assertThat(lines).hasSizeGreaterThanOrEqualTo(1);
    JsonObject last = lines.get(lines.size() - 1);
    assertThat(last.get("done").getAsLong()).isEqualTo(16 * 12 * 2);
    assertThat(last.get("total").getAsLong()).isEqualTo(16 * 12 * 2);
    assertThat(last.get("seconds_left").getAsDouble()).isZero();
  }

  @Test
  void progressTellsTheNoiseOfTheRender() {
    Outcome outcome = render(TinyScene.JSON, "--progress", "json", "--quiet", "--samples", "64");
    List<String> lines = outcome.err().lines().toList();
    JsonObject last = JsonParser.parseString(lines.get(lines.size() - 1)).getAsJsonObject();
    JsonObject noise = object(outcome).get("noise").getAsJsonObject();
    assertThat(last.get("relative_error").getAsDouble())
        .isCloseTo(noise.get("relative_rmse").getAsDouble(), within(1e-12));
  }

  @Test
  void progressTellsRateTimeLeftAndTheErrorIfThereIsOne() {
    Map<String, Number> place = Map.of("frame", 3);
    assertThat(
            JsonProgress.line(
                place, 250, 1000, 50, OptionalDouble.empty(), OptionalDouble.of(.125)))
        .isEqualTo(
            "{\"frame\":3,\"done\":250,\"total\":1000,\"seconds\":50.0,\"rate\":5.0,"
                + "\"seconds_left\":150.0,\"relative_error\":0.125}");
    assertThat(
            JsonProgress.line(Map.of(), 0, 1000, 0, OptionalDouble.empty(), OptionalDouble.empty()))
        .isEqualTo("{\"done\":0,\"total\":1000,\"seconds\":0.0,\"rate\":0.0}");
  }
}
