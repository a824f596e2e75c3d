package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.PixelJson;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests {@code lumbre pixel}. */
class PixelCommandTest extends CommandFixture {
  private Outcome pixel(String json, String... flags) {
    return withScene(json, "pixel T/tiny.json", flags);
  }

  @Test
  void pathIsToldVertexByVertexWithItsPlacesInTheFile() {
    Outcome outcome = pixel(TinyScene.JSON, "8,6", "--sample", "1").done();
    assertThat(outcome.err()).isEmpty();
    assertThat(outcome.out().lines())
        .contains("pixel 8,6, sample 1, seed 0", "vertex 0", "vertex 1")
        .anyMatch(line -> line.startsWith("  hits       $.objects[2]"))
        .anyMatch(line -> line.startsWith("  material   $.assets[1]"))
        .anyMatch(line -> line.startsWith("film         ("));
  }

  @Test
  void pixelAsAWholeHasMeanVarianceAndBrightestSamples() {
    Outcome outcome = pixel(TinyScene.JSON, "8,6", "-s", "20").done();
    assertThat(outcome.out().lines())
        .contains(
            "pixel 8,6, 20 samples, seed 0",
            "shows        $.objects[2], material $.assets[1]",
            "rejected     0 samples")
        .filteredOn(line -> line.startsWith("brightest "))
        .hasSize(8);
  }

  @Test
  void textHasSixDigitsAndJsonAll() {
    for (String[] flags : new String[][] {{"--sample", "1"}, {"-s", "20"}}) {
      Outcome text = corner(flags);
      assertThat(text.out())
          .containsPattern("\\d\\.\\d{4}")
          .doesNotContainPattern("[1-9]\\d*\\.?\\d{6}");
      String[] more = Stream.concat(Stream.of(flags), Stream.of("--json")).toArray(String[]::new);
      assertThat(corner(more).out()).containsPattern("0\\.\\d{15}");
    }
  }

  @Test
  void objectsAtAnEdgeAreCounted() {
    Outcome outcome = pixel(TinyScene.JSON, "5,3", "-s", "64", "--size", "8x6");
    List<Integer> counts =
        Pattern.compile(
                "(?m)^shows +(\\$.objects\\[\\d\\].*|no object) \\((\\d+) of the samples\\)$")
            .matcher(outcome.out())
            .results()
            .map(found -> Integer.valueOf(found.group(2)))
            .toList();
    assertThat(counts).hasSizeGreaterThan(1).doesNotContain(0);
    assertThat(counts.stream().mapToInt(n -> n).sum()).isEqualTo(64);
  }

  @Test
  void jsonHoldsTheSame() {
    String text = pixel(TinyScene.JSON, "8,6", "--sample", "1", "--json").out();
    JsonObject sample = JsonParser.parseString(text).getAsJsonObject();
    assertThat(sample.get("format").getAsString()).isEqualTo(PixelJson.FORMAT);
    JsonObject first = sample.getAsJsonArray("vertices").get(0).getAsJsonObject();
    assertThat(first.getAsJsonObject("hit").get("object_path").getAsString())
        .isEqualTo("$.objects[2]");
    assertThat(sample.get("film")).isEqualTo(sample.get("radiance"));
    String all = pixel(TinyScene.JSON, "8,6", "--json").out();
    JsonObject pixel = JsonParser.parseString(all).getAsJsonObject();
    assertThat(pixel.get("samples").getAsInt()).isEqualTo(2);
    JsonObject shown = pixel.getAsJsonArray("shows").get(0).getAsJsonObject();
    assertThat(shown.get("object_path").getAsString()).isEqualTo("$.objects[2]");
    assertThat(shown.get("samples").getAsInt()).isEqualTo(2);
  }

  @Test
  void wrongPlacesAreRefused() {
    pixel(TinyScene.JSON, "16,6").assertFailed(ExitCodes.USAGE, "x: expected 0 to 15, found 16");
    pixel(TinyScene.JSON, "0,12").assertFailed(ExitCodes.USAGE, "y: expected 0 to 11");
    pixel(TinyScene.JSON, "0;1").assertFailed(ExitCodes.USAGE, "expected x,y in pixels");
    pixel(TinyScene.JSON, "0,1", "--sample", "-1").assertFailed(ExitCodes.USAGE, "--sample");
  }

  @Test
  void splitPathsAreReplayed() {
    JsonObject plain = json(corner("--sample", "1", "--json"));
    JsonObject split = json(corner("--sample", "1", "--split", "5", "--json"));
    assertThat(split.get("radiance")).isNotEqualTo(plain.get("radiance"));
    JsonArray vertices = split.getAsJsonArray("vertices");
    assertThat(vertices.get(0).getAsJsonObject().get("end").getAsString()).isEqualTo("split");
    assertThat(vertices.size()).isGreaterThan(plain.getAsJsonArray("vertices").size());
    assertThat(vertices.get(0).getAsJsonObject().getAsJsonArray("scattered")).hasSize(5);
    assertThat(vertices.get(vertices.size() - 1).getAsJsonObject().get("branch").getAsInt())
        .isPositive();
    assertThat(sumOfAmounts(vertices)).isEqualTo(numbers(split.getAsJsonArray("radiance")));
    pixel(TinyScene.JSON, "8,9", "--split", "257")
        .assertFailed(ExitCodes.USAGE, "--split: expected 1 to 256, found 257");
  }

  private static List<Double> sumOfAmounts(JsonArray vertices) {
    double[] sum = new double[3];
    for (JsonElement vertex : vertices) {
      for (JsonElement found : vertex.getAsJsonObject().getAsJsonArray("contributions")) {
        List<Double> amount = numbers(found.getAsJsonObject().getAsJsonArray("amount"));
        for (int i = 0; i < sum.length; i++) {
          sum[i] += amount.get(i);
        }
      }
    }
    return Arrays.stream(sum).boxed().toList();
  }

  private static List<Double> numbers(JsonArray array) {
    return array.asList().stream().map(JsonElement::getAsDouble).toList();
  }

  private static Outcome corner(String... flags) {
    Stream<String> first =
        Stream.of("pixel", "scenes/cornell-box.json", "20,40", "--size", "64x48");
    return Outcome.of(Stream.concat(first, Stream.of(flags)).toArray(String[]::new));
  }

  private static JsonObject json(Outcome outcome) {
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    return outcome.json();
  }

  /** The warning of a render suggests a command, which reports the same sample. */
  @Test
  void rejectedSamplesAreReplayedByTheCommandOfTheWarning() {
    Path scene = TinyScene.write(directory, TinyScene.blinding());
    Path picture = directory.resolve("tiny.png");
    Outcome render =
        Outcome.of("render", "" + scene, "-o", "" + picture, "--quiet", "--seed", "3", "-s", "4")
            .done();
    List<String> warnings =
        render.err().lines().filter(line -> line.contains("lumbre pixel ")).toList();
    assertThat(warnings).isNotEmpty();
    String command = warnings.get(0).replaceFirst(".*lumbre ", "");
    Outcome replay = Outcome.of(command.split(" ")).done();
    assertThat(replay.out())
        .contains("Infinity", "rejected     negative, NaN or infinite", "film         (0, 0, 0)");
    Outcome strict = Outcome.of((command + " --strict").split(" "));
    assertThat(strict.exitCode()).isEqualTo(ExitCodes.INTERNAL);
    assertThat(Outcome.of((command + " --json").split(" ")).out()).contains("\"Infinity\"");
  }
}
