package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Collectors;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A model and the files that it names are read once by each command, also over an old picture. */
class ModelReadOnceTest {
  @TempDir private Path directory;

  /** Runs a command, and returns the bytes that it reads of each file in the directory, by name. */
  private Map<String, Long> bytesReadBy(String line) throws IOException {
    Path events = directory.resolve("events.jfr");
    try (Recording recording = new Recording()) {
      recording.enable("jdk.FileRead").withoutThreshold();
      recording.start();
      Outcome outcome = Outcome.in(directory, line);
      recording.stop();
      recording.dump(events);
      assertThat(outcome.exitCode()).as(line + ": " + outcome.err()).isZero();
    }
    return RecordingFile.readAllEvents(events).stream()
        .filter(event -> String.valueOf(event.getString("path")).startsWith(directory + "/"))
        .collect(
            Collectors.groupingBy(
                event -> Path.of(event.getString("path")).getFileName().toString(),
                Collectors.summingLong(ModelReadOnceTest::bytes)));
  }

  private static long bytes(RecordedEvent event) {
    return Math.max(0, event.getLong("bytesRead"));
  }

  @Test
  void eachFileIsReadOnce() throws IOException {
    Path model = ModelSample.write(directory);
    long size = Files.size(model);
    long picture = Files.size(directory.resolve("paint.png"));
    String render = "render T/sample.glb -o T/a.png --size 8x6 -s 1 --quiet";
    for (String line :
        new String[] {
          render,
          render,
          "check T/sample.glb",
          "import T/sample.glb",
          "import T/sample.glb",
          "views T/sample.glb -o T/views --size 8x6 -s 1",
          "views T/sample.glb -o T/views --size 8x6 -s 1",
          "render T/sample.glb -o T/b.png --size 8x6 -s 1 --quiet --checkpoint T/b.film",
          "resume T/b.film -s 2 --quiet"
        }) {
      assertThat(bytesReadBy(line))
          .as(line)
          .containsEntry("sample.glb", size)
          .containsEntry("paint.png", picture);
    }
  }
}
