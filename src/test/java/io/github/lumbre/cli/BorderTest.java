package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.run.Engine;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Few methods lie between the start of the program and the reader of a model. */
class BorderTest {
  private static final String CLI = "io.github.lumbre.cli.";
  private static final String READER = "io.github.lumbre.model.internal.ModelReader.read";

  /** {@link Main#main} and {@link Lumbre#main}, which end the JVM and are not called here. */
  private static final int BEFORE = 2;

  @TempDir private Path folder;

  /** Samples the stack of a command; lambdas count, but not their hidden frames. */
  private List<List<String>> stacksWhileReading(String... args) {
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    Thread command = new Thread(() -> Lumbre.run(args, nowhere, nowhere, Engine.LOCAL));
    List<List<String>> stacks = new ArrayList<>();
    command.start();
    while (command.isAlive()) {
      List<String> stack =
          Stream.of(command.getStackTrace())
              .filter(frame -> !frame.getClassName().contains("$$Lambda"))
              .filter(frame -> !frame.getClassName().equals(BorderTest.class.getName()))
              .map(frame -> frame.getClassName() + "." + frame.getMethodName())
              .toList();
      if (stack.stream().anyMatch(name -> name.startsWith(READER))) {
        stacks.add(stack);
      }
    }
    return stacks;
  }

  private Path slowModel() throws IOException {
    StringBuilder obj = new StringBuilder();
    IntStream.range(0, 20_000).forEach(i -> obj.append("v %d %d 1%n".formatted(i % 9, i % 7)));
    IntStream.range(1, 19_998).forEach(i -> obj.append("f %d %d %d%n".formatted(i, i + 1, i + 2)));
    return Files.writeString(folder.resolve("a.obj"), obj);
  }

  @Test
  void modelsAreReadAtMostTwelveMethodsBelowTheStart() throws IOException {
    List<List<String>> stacks =
        stacksWhileReading("render", slowModel().toString(), "--size", "8", "--dry-run");
    assertThat(stacks)
        .isNotEmpty()
        .allSatisfy(
            stack ->
                assertThat(stack.stream().filter(name -> name.startsWith(CLI)).toList())
                    .hasSizeBetween(5, 12 - BEFORE));
  }
}
