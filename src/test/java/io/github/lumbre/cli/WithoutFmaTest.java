package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.internal.LinearReader;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Renders on a processor without fused multiply-add. */
class WithoutFmaTest {
  /** With {@link Math#fma} alone, the first model takes minutes. */
  @Test
  void picturesOfModelsAndScenesHaveTheSameBitsAndTakeNoMinutes(@TempDir Path here)
      throws Exception {
    Path there = here.resolve("there");
    Files.createDirectory(there);
    Process process =
        new ProcessBuilder(
                Program.java("java"),
                "-XX:-UseFMA",
                "--add-modules",
                "jdk.incubator.vector",
                "-cp",
                System.getProperty("java.class.path"),
                WithoutFma.class.getName(),
                there.toString())
            .redirectOutput(there.resolve("out.txt").toFile())
            .redirectError(there.resolve("err.txt").toFile())
            .start();
    Outcome outcome = Program.await(there, process).done();
    assertThat(outcome.out().lines())
        .containsExactly("false", "Java uses no fused multiply-add (FMA) on this processor");
    for (Path input : WithoutFma.INPUTS) {
      Path expected = WithoutFma.picture(here, input);
      WithoutFma.render(input, expected);
      assertThat(LinearReader.read(WithoutFma.picture(there, input)).rgb())
          .as(input.toString())
          .isEqualTo(LinearReader.read(expected).rgb());
    }
  }
}
