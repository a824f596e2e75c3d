package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code lumbre audit}. */
class AuditCommandTest {
  @TempDir private Path directory;

  @Test
  void warningsFailOnlyUnderStrictness() {
    String odd = TinyScene.with("\"radius\": 1", "\"radius\": 1, \"colour\": 2");
    String scene = TinyScene.write(directory, odd).toString();
    Outcome relaxed = Outcome.of("audit", scene).done();
    assertThat(relaxed.err()).isEmpty();
    assertThat(relaxed.out())
        .contains("warning  $.objects[2].colour: unknown key", "effect: ", "fix: ")
        .contains("warnings 1, notes ");
    assertThat(Outcome.of("audit", scene, "--strict").exitCode()).isEqualTo(ExitCodes.WARNINGS);
  }

  @Test
  void jsonHoldsTheFindings() {
    String odd = TinyScene.with("\"radius\": 1", "\"radius\": 1, \"colour\": 2");
    String scene = TinyScene.write(directory, odd).toString();
    JsonObject audit = Outcome.of("audit", scene, "--json").json();
    assertThat(audit.get("format").getAsString()).isEqualTo(AuditCommand.FORMAT);
    assertThat(audit.get("warnings").getAsInt()).isEqualTo(1);
    JsonObject first = audit.getAsJsonArray("findings").get(0).getAsJsonObject();
    assertThat(first.get("path").getAsString()).isEqualTo("$.objects[2].colour");
    assertThat(first.get("severity").getAsString()).isEqualTo("warning");
  }

  @Test
  void soundSceneOfTheProjectHasNoWarnings() {
    Outcome outcome = Outcome.of("audit", "--strict", "scenes/cornell-box.json").done();
    assertThat(outcome.out()).endsWith("scenes/cornell-box.json: warnings 0, notes 0\n");
  }
}
