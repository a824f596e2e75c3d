package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Tests the JVM options file that both launchers use. */
class JvmOptionsTest {
  private static final Path FOLDER = Path.of("src", "main", "jvm");
  private static final Pattern HINT =
      Pattern.compile("(?m)^-XX:CompileCommand=\\w+,([\\w.]+)::(\\w+)(,[\\w.]+)?$");

  @Test
  void everyHintedMethodExists() throws IOException {
    String options =
        Files.readString(FOLDER.resolve("options"))
            + Files.readString(FOLDER.resolve("short-options"));
    List<MatchResult> hints = HINT.matcher(options).results().toList();
    assertThat(hints).hasSize(options.split("CompileCommand=\\w+,", -1).length - 1).isNotEmpty();
    for (MatchResult hint : hints) {
      assertThat(hint.group(1))
          .satisfies(
              name ->
                  assertThat(Class.forName(name).getDeclaredMethods())
                      .extracting(Method::getName)
                      .contains(hint.group(2)));
    }
  }

  @Test
  void bothLaunchersReadTheFileAndStateNoOptionOfTheirOwn() throws IOException {
    for (String launcher : List.of("lumbre", "lumbre.cmd")) {
      String text = Files.readString(Path.of(launcher));
      // Those of the archive of classes name a file that the launcher makes.
      String others =
          text.replaceAll(
              "-XX:(\\+AutoCreateSharedArchive|(DumpLoadedClassList|Shared\\w+|AOTCache\\w*)=)"
                  + "|-Xshare(:dump|\\*)",
              "");
      assertThat(others)
          .containsPattern("src.main.jvm.options")
          .doesNotContain("-XX:", "-Xshare", "-Djava.awt");
    }
  }
}
