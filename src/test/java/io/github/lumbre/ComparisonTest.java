package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.scenefile.SceneParser;
import java.io.StringWriter;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks the programs of comparisons and of the denoiser's training, which are not built. */
class ComparisonTest {
  private static final Path FOLDER = Path.of("src");

  @TempDir private Path classes;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "comparison/RenderServer.java",
        "comparison/KernelServer.java",
        "comparison/DenoiserMeter.java",
        "comparison/AnimationMeter.java comparison/MeteredFrame.java",
        "denoiser/TrainingRenderer.java"
      })
  void compilesAgainstTheLibraryAlone(String sources) throws Exception {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      List<String> options =
          List.of(
              "-Xlint:all", "-Werror", "-proc:none", "-d", classes.toString(), "-cp", library());
      boolean compiled =
          compiler
              .getTask(
                  messages,
                  files,
                  null,
                  options,
                  null,
                  files.getJavaFileObjects(
                      Stream.of(sources.split(" ")).map(FOLDER::resolve).toArray(Path[]::new)))
              .call();
      assertThat(compiled).as(messages.toString()).isTrue();
    }
  }

  private static String library() throws URISyntaxException {
    return Path.of(SceneParser.class.getProtectionDomain().getCodeSource().getLocation().toURI())
        .toString();
  }
}
