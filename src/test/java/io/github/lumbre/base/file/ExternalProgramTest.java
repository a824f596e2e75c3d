package io.github.lumbre.base.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests how installed programs are run, with small scripts. */
@DisabledOnOs(OS.WINDOWS)
class ExternalProgramTest {
  private static final ExternalProgram.Input ENDLESS =
      out -> {
        while (true) {
          out.write(new byte[1 << 16]);
        }
      };

  @TempDir private Path folder;

  private ExternalProgram program(String script) throws IOException {
    Path file = Files.writeString(folder.resolve("tool"), "#!/bin/sh\n" + script);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    return ExternalProgram.find("tool", Optional.of(folder), "TOOL", Map.of(), "make it");
  }

  private static void write(OutputStream out) throws IOException {
    out.write("some input".getBytes(StandardCharsets.US_ASCII));
  }

  @Test
  void inputAndArgumentsReachTheProgram() throws Exception {
    String said =
        program("cat; echo \" $1\"\n").run(List.of("a b;$HOME"), ExternalProgramTest::write);
    assertThat(said).isEqualTo("some input a b;$HOME\n");
  }

  @Test
  void theInputEnds() throws Exception {
    assertThat(program("wc -c\n").run(List.of(), ExternalProgram.Input.NONE).strip())
        .isEqualTo("0");
  }

  @Test
  void aProgramThatDoesNotReadIsEnded() throws Exception {
    ExternalProgram program = program("sleep 60\n").within(Duration.ofMillis(300));
    assertThatThrownBy(() -> program.run(List.of(), ENDLESS))
        .isInstanceOf(IOException.class)
        .hasMessage(folder.resolve("tool") + ": took longer than 0.3 s and was ended");
  }

  @Test
  void aProgramThatFailsIsQuotedInOneLine() throws Exception {
    ExternalProgram program = program("echo first; printf 'last\\033[2J'; exit 3\n");
    assertThatThrownBy(() -> program.run(List.of(), ENDLESS))
        .isInstanceOf(IOException.class)
        .hasMessage(folder.resolve("tool") + ": failed with code 3: first; last [2J");
    ExternalProgram talking = program("head -c 100000 /dev/zero | tr '\\0' x; exit 1\n");
    assertThatThrownBy(() -> talking.run(List.of(), ExternalProgram.Input.NONE))
        .satisfies(e -> assertThat(e.getMessage().length()).isLessThan(500));
  }

  @Test
  void aProgramThatDoesNotReadToTheEndHasFailed() throws Exception {
    ExternalProgram program = program("head -c 10; echo done; exit 0\n");
    assertThatThrownBy(() -> program.run(List.of(), ENDLESS)).isInstanceOf(IOException.class);
  }

  @Test
  void anInputThatFailsIsReported() throws Exception {
    ExternalProgram program = program("cat\n");
    assertThatThrownBy(
            () ->
                program.run(
                    List.of(),
                    out -> {
                      throw new IOException("frame-003.png: PNG is truncated");
                    }))
        .isInstanceOf(IOException.class)
        .hasMessage("frame-003.png: PNG is truncated");
  }

  /** The program and one that it has started write their ids; both would sleep for an hour. */
  @Test
  void anInterruptEndsTheProgramAndItsChildren() throws Exception {
    ExternalProgram program = program("sleep 3600 & echo $$ $! > \"$1\"; wait\n");
    Path ids = folder.resolve("ids");
    Thread thread = Thread.currentThread();
    Thread interrupter =
        new Thread(
            () -> {
              while (!hasLine(ids)) {
                Thread.onSpinWait();
              }
              thread.interrupt();
            });
    interrupter.start();
    assertThatThrownBy(() -> program.run(List.of(ids.toString()), ENDLESS))
        .isInstanceOf(InterruptedException.class);
    interrupter.join();
    for (String id : Files.readString(ids).strip().split(" ")) {
      Optional<ProcessHandle> process = ProcessHandle.of(Long.parseLong(id));
      if (process.isPresent()) {
        process.get().onExit().get(30, TimeUnit.SECONDS);
      }
    }
  }

  private static boolean hasLine(Path file) {
    try {
      return Files.exists(file) && Files.readString(file).endsWith("\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aMissingProgramIsExplained() {
    assertThatThrownBy(
            () ->
                ExternalProgram.find(
                    "tool", Optional.empty(), "TOOL", Map.of("PATH", "/nowhere"), "make it"))
        .isInstanceOf(IOException.class)
        .hasMessage("tool: not found on the PATH; make it; or state its path in TOOL");
    assertThatThrownBy(
            () ->
                ExternalProgram.find(
                    "tool", Optional.empty(), "TOOL", Map.of("TOOL", "/no/tool"), "make it"))
        .hasMessage("/no/tool: not a program; make it; or state its path in TOOL");
  }
}
