package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.run.FilmKeeper;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Measures memory during a long render: 100 passes in a normal build, 30 min with {@code
 * -Pendurance}, or the minutes in {@code -Dlumbre.endurance.minutes}.
 */
class EnduranceTest {
  private static final Path SCENE = Path.of("scenes", "glass-and-mirror.json");
  private static final Duration INTERVAL = Duration.ofMinutes(1);
  private static final int LOOKS = 4;
  private static final int PASSES_PER_LOOK = 25;
  private static final long MEBIBYTE = 1 << 20;

  /** The maximum growth of the used heap, in bytes. */
  private static final long MOST_HEAP_GROWTH = MEBIBYTE;

  /** The maximum growth of the JVM's own memory, in bytes, mainly for compiled code. */
  private static final long MOST_RESIDENT_GROWTH = 16 * MEBIBYTE;

  @TempDir private Path directory;

  /** The memory in use at one moment. */
  private record Memory(double seconds, long heap, long resident) {}

  @Test
  void manyPassesAndCheckpointsTakeNoMoreMemoryThanSome() throws Exception {
    SceneFile scene = new SceneParser().overriding(EnduranceTest::small).parse(SCENE);
    FilmRenderer renderer = new FilmRenderer(scene.settings(), scene.scene());
    Film film = renderer.newFilm();
    List<Memory> found = new ArrayList<>();
    long start = System.nanoTime();
    try (FilmKeeper keeper = keeper()) {
      keeper.begin(
          Map.of(), RecordedLayers.NONE, Map::of, RenderStatistics.ZERO, scene.settings());
      for (int pass = 1; pass <= LOOKS * PASSES_PER_LOOK; pass++) {
        Progress pausing = Progress.NONE.cancelledAlsoIf(keeper::isDue);
        PassResult result = renderer.addSamples(film, pass, pausing);
        keeper.passed(film, result);
        if (pass % PASSES_PER_LOOK == 0) {
          found.add(new Memory(seconds(start), MemoryInUse.heap(), MemoryInUse.resident()));
        }
      }
      keeper.saveLast(film);
      assertThat(keeper.failure()).isEmpty();
    }
    assertNoGrowth(found);
  }

  private static RenderSettings small(RenderSettings settings) {
    return settings.toBuilder().size(160, 90).threads(2).build();
  }

  private FilmKeeper keeper() throws IOException {
    return new FilmKeeper(
        Optional.of(CheckpointFile.reserve(film())),
        Duration.ZERO,
        Fallback.TEMPORARY,
        new Messages(new PrintWriter(Writer.nullWriter())));
  }

  private static void assertNoGrowth(List<Memory> found) throws InterruptedException {
    long first = found.get(0).heap;
    assertThat(found).allMatch(memory -> memory.heap <= first + MOST_HEAP_GROWTH);
    awaitNoThreads();
  }

  /** The first measurement is after 60 s, the last one before the picture is developed. */
  @Test
  @Tag("endurance")
  void memoryDoesNotGrow() throws Exception {
    Duration whole = Duration.ofMinutes(Long.getLong("lumbre.endurance.minutes", 30));
    FutureTask<Integer> render = new FutureTask<>(() -> render(whole));
    Thread renderer = new Thread(render, "endurance");
    long start = System.nanoTime();
    renderer.start();
    List<Memory> found = new ArrayList<>();
    renderer.join(INTERVAL.toMillis());
    while (seconds(start) < whole.minus(INTERVAL.dividedBy(2)).toSeconds()) {
      found.add(new Memory(seconds(start), MemoryInUse.heap(), MemoryInUse.resident()));
      renderer.join(INTERVAL.toMillis());
    }
    renderer.join();
    assertThat(render.get()).isZero();
    System.out.println(table(found));
    assertThat(found).hasSizeGreaterThan(1);
    assertNoGrowth(found);
    long first = found.get(0).resident;
    assertThat(found).allMatch(memory -> memory.resident <= first + MOST_RESIDENT_GROWTH);
  }

  private static double seconds(long start) {
    return (System.nanoTime() - start) * 1e-9;
  }

  private Path film() {
    return directory.resolve("a.film");
  }

  private int render(Duration time) throws IOException {
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    String[] args = {
      "render",
      SCENE.toString(),
      "--size",
      "320x180",
      "--threads",
      "1",
      "--time",
      time.toSeconds() + "s",
      "--progress",
      "json",
      "--checkpoint",
      film().toString(),
      "--checkpoint-interval",
      "5s",
      "-o",
      directory.resolve("a.exr").toString()
    };
    return Lumbre.run(args, nowhere, nowhere);
  }

  private static String table(List<Memory> found) {
    StringBuilder table = new StringBuilder("seconds  heap KiB  resident KiB\n");
    for (Memory memory : found) {
      table.append(
          String.format(
              "%7.0f  %8d  %12d%n", memory.seconds, memory.heap >> 10, memory.resident >> 10));
    }
    return table.toString();
  }

  /** A change of the kernel ends within a second after the last pass. */
  private static void awaitNoThreads() throws InterruptedException {
    for (int tenths = 0; tenths < 100 && !liveThreads().isEmpty(); tenths++) {
      Thread.sleep(100);
    }
    assertThat(liveThreads()).isEmpty();
  }

  private static List<String> liveThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("lumbre-"))
        .toList();
  }
}
