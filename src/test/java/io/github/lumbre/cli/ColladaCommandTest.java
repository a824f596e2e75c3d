package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.model.format.dae.DaeSample;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests commands with COLLADA files. */
class ColladaCommandTest {
  @TempDir private Path folder;

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(folder.resolve("a.dae"), DaeSample.squareWithCamera());
  }

  /** The camera of the file looks away from the square. */
  @Test
  void camerasAreUsedByNameAlone() {
    String render = "render T/a.dae -o T/a.pfm --overwrite --size 8x8 -s 1 --no-denoise --json";
    assertThat(visibleParts(render)).isEqualTo(1);
    assertThat(visibleParts(render + " --camera away")).isZero();
    Outcome.in(folder, "check T/a.dae --camera x")
        .assertFailed(ExitCodes.ASSET, "cameras: expected \"away\", found \"x\"");
  }

  private int visibleParts(String line) {
    JsonArray views = Outcome.in(folder, line).done().json().getAsJsonArray("views");
    return views.get(0).getAsJsonObject().get("visible_part_count").getAsInt();
  }

  /** The file states z as the upper axis, and a unit of half a meter. */
  @Test
  void axesAndUnitsOfTheFileCanBeCorrected() {
    assertThat(bounds("")).isEqualTo("[[0.0,0.0,-0.5],[0.5,0.0,0.0]]");
    assertThat(bounds(" --up y --unit 3")).isEqualTo("[[0.0,0.0,0.0],[3.0,3.0,0.0]]");
  }

  private String bounds(String flags) {
    Outcome check = Outcome.in(folder, "check T/a.dae --json" + flags).done();
    return check.json().get("bounds").toString().replace("-0.0", "0.0");
  }
}
