package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Tests {@code lumbre trade}. */
class TradeCommandTest extends CommandFixture {
  private Outcome trade(String... flags) {
    return withScene(TinyScene.JSON, "trade T/tiny.json", flags);
  }

  @Test
  void pageTableAndObjectAreWritten() throws Exception {
    Path page = directory.resolve("out.html");
    Outcome outcome =
        trade("--quick", "--time", "1s", "--seeds", "3", "-o", page.toString()).done();
    assertThat(outcome.out().strip()).isEqualTo(page.toString());

    String html = Files.readString(page);
    assertThat(html)
        .contains(
            "Recommended settings for a target error", "identical", "<tr class=\"dominated\">")
        .doesNotContain("NaN", "Infinity", "DIFFERENT", "http://", "https://", "<script");

    JsonObject values =
        JsonParser.parseString(Files.readString(directory.resolve("out.json"))).getAsJsonObject();
    assertThat(values.get("format").getAsString()).isEqualTo("lumbre-trade-2");
    int rows = values.getAsJsonArray("rows").size();
    Map<String, Integer> counts = new LinkedHashMap<>();
    Set<Integer> ladder = new TreeSet<>();
    for (JsonElement element : values.getAsJsonArray("rows")) {
      JsonObject row = element.getAsJsonObject();
      counts.merge(text(row, "kind"), 1, Integer::sum);
      ladder.add(row.get("samples").getAsInt());
    }
    // One depth, one sampler, three MIS heuristics, four roulettes and three splits are unbiased;
    // six depths, ray tracing and three clamps are not.
    int rungs = ladder.size();
    assertThat(counts.get("noise") + counts.get("bias")).isEqualTo(22 * rungs);
    int denoised = ladder.contains(1) ? rungs - 1 : rungs;
    assertThat(counts.getOrDefault("denoised", 0)).isEqualTo(denoised);
    assertThat(Files.readAllLines(directory.resolve("out.csv"))).hasSize(3 * rows + 1);
  }

  @Test
  void knobsAreChosenAndWorkIsCounted() throws Exception {
    Path page = directory.resolve("out.html");
    Outcome outcome =
        trade("-s", "4", "--seeds", "3", "--knobs", "sampler,depth", "-o", page.toString()).done();
    JsonObject values =
        JsonParser.parseString(Files.readString(directory.resolve("out.json"))).getAsJsonObject();
    Map<String, String> kinds = new LinkedHashMap<>();
    for (JsonElement element : values.getAsJsonArray("rows")) {
      JsonObject row = element.getAsJsonObject();
      kinds.put(row.get("knob").getAsString() + row.get("value").getAsString(), text(row, "kind"));
      assertThat(row.get("rays_per_sample").getAsDouble()).isGreaterThanOrEqualTo(1);
      assertThat(row.get("nodes_per_sample").getAsDouble()).isGreaterThanOrEqualTo(1);
    }
    assertThat(kinds)
        .containsOnlyKeys(
            "depth1000",
            "samplerindependent",
            "depth1",
            "depth2",
            "depth3",
            "depth5",
            "depth8",
            "depth16")
        .containsEntry("samplerindependent", "noise")
        .containsEntry("depth1000", "noise")
        .containsEntry("depth16", "bias");
    assertThat(Files.readString(page)).contains("no change (control)");
    assertThat(values.getAsJsonObject("facts").get("command").getAsString())
        .startsWith("lumbre trade ")
        .contains(" -s 4 --seeds 3 --knobs sampler,depth ");
  }

  /** A denoiser's time counts, it needs more than one sample, and it is never called unbiased. */
  @Test
  void denoisedPicturesAreComparedWithNoisyOnes() throws Exception {
    Path page = directory.resolve("out.html");
    Outcome outcome =
        trade("-s", "16", "--size", "32x24", "--seeds", "3", "--knobs", "denoise", "-o", "" + page)
            .done();
    JsonObject values =
        JsonParser.parseString(Files.readString(directory.resolve("out.json"))).getAsJsonObject();
    Map<Integer, JsonObject> noisy = new LinkedHashMap<>();
    Map<Integer, JsonObject> denoised = new LinkedHashMap<>();
    for (JsonElement element : values.getAsJsonArray("rows")) {
      JsonObject row = element.getAsJsonObject();
      boolean isDenoised = text(row, "knob").equals("denoise");
      assertThat(text(row, "kind")).isEqualTo(isDenoised ? "denoised" : "noise");
      (isDenoised ? denoised : noisy).put(row.get("samples").getAsInt(), row);
    }
    assertThat(noisy).containsOnlyKeys(1, 4, 16);
    assertThat(denoised).containsOnlyKeys(4, 16);
    assertThat(mean(denoised.get(4), "relative_mse"))
        .isLessThan(mean(noisy.get(4), "relative_mse"));
    assertThat(mean(denoised.get(16), "cpu_seconds"))
        .isGreaterThan(mean(noisy.get(16), "cpu_seconds"));
    assertThat(Files.readString(page))
        .contains("Denoised pictures", "as many times the samples", "denoised (builtin)");
  }

  private static double mean(JsonObject row, String key) {
    return row.getAsJsonObject(key).get("value").getAsDouble();
  }

  private static String text(JsonObject object, String key) {
    return object.get(key).getAsString();
  }

  @Test
  void wrongFlagsAreNamed() throws IOException {
    trade("--knobs", "depth,color")
        .assertFailed(ExitCodes.USAGE, "--knobs: expected some of sampler,lights,", "found color");
    trade("--seeds", "2").assertFailed(ExitCodes.USAGE, "--seeds: expected 3 to 1000");
    trade("-o", "page.txt").assertFailed(ExitCodes.USAGE, "-o: expected a name that ends in .html");
    Files.writeString(directory.resolve("none"), "");
    trade("-o", directory + "/none/a.html").assertFailed(ExitCodes.OUTPUT, "/none cannot be");
  }
}
