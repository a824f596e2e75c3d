package io.github.lumbre.lab.perf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.lab.report.BenchmarkFixture;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the two output formats of a measurement. */
class PerfTableTest {
  private static final PerfResult RESULT =
      PerfFixture.result("tiny", BenchmarkFixture.HASH, 9, 2, 2.5);

  @Test
  void resultsFollowFromMedians() {
    assertThat(RESULT.renders().seconds()).isEqualTo(2.5);
    assertThat(RESULT.renders().cpuSeconds()).isEqualTo(5);
    assertThat(RESULT.renders().bytesPerRay()).isEqualTo(64);
    assertThat(RESULT.errorSeconds()).isCloseTo(.1, within(1e-12));
    assertThat(RESULT.secondsToTarget()).isCloseTo(10, within(1e-12));
  }

  @Test
  void rowsHaveACellForEachColumn() {
    PerfTables table = PerfFixture.TABLES;
    List<String> head = table.head();
    String line = table.line(RESULT);
    assertThat(line)
        .isEqualTo(
            "| tiny | 8x4 | 10 | 2 | 2.500 s | 5.000 s | 128 | 400 | 200 | 64 | 2.00 s"
                + " | 0.0400 | 0.100 | 10.0 s | `0123456789abcdef` |");
    assertThat(head.subList(head.size() - 2, head.size()))
        .allMatch(other -> cells(other) == cells(line));
    assertThat(String.join("\n", head))
        .contains("Fast|er, 4 logical cores", "Load average before: 0.25", "Threads: 1, 2.");
  }

  private static long cells(String line) {
    return line.chars().filter(c -> c == '|').count();
  }

  @Test
  void fileForProgramsHoldsEveryRepetition() {
    String text = PerfFixture.TABLES.json(List.of(RESULT));
    JsonObject root = JsonParser.parseString(text).getAsJsonObject();
    assertThat(root.get("format").getAsString()).isEqualTo("lumbre-bench-1");
    assertThat(root.getAsJsonObject("machine").keySet())
        .contains("cpu", "cores", "jvm", "jvm_options", "collectors", "os", "load_before");
    JsonObject result = root.getAsJsonArray("results").get(0).getAsJsonObject();
    assertThat(result.getAsJsonArray("repetitions")).hasSize(3);
    assertThat(result.getAsJsonArray("repetitions").get(1))
        .hasToString("{\"seconds\":2.0,\"cpu_seconds\":4.0,\"allocated_bytes\":64000}");
    assertThat(result.get("rays").getAsLong()).isEqualTo(600);
    assertThat(result.get("shadow_rays").getAsLong()).isEqualTo(400);
    assertThat(result.get("scene_sha256").getAsString()).isEqualTo("feed");
    assertThat(result.get("image_sha256").getAsString()).isEqualTo(BenchmarkFixture.HASH);
    assertThat(result.getAsJsonArray("relative_mse")).hasToString("[0.03,0.05]");
  }
}
