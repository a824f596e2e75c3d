package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.checkpoint.internal.Checkpoints;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.testing.Effort;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Measures the overhead of checkpoints for a large picture. */
@Tag(Effort.EXHAUSTIVE)
class CheckpointOverheadTest {
  private static final Crop FRAME = new Crop(0, 0, 1920, 1080);
  private static final int SAVES = 11;

  /** The maximum overhead: 1 % of the 60 s between two checkpoints. */
  private static final double MOST_SECONDS = .01 * 60;

  private final List<Double> pauses = new ArrayList<>();
  private final List<Double> processor = new ArrayList<>();
  private final List<Double> whole = Collections.synchronizedList(new ArrayList<>());

  @TempDir private Path directory;

  /** Returns a film whose pixels have 100 samples. */
  private static Film film() {
    Random random = new Random(4);
    Film film = new Film(FRAME, false, 0);
    for (int pixel = 0; pixel < FRAME.width() * FRAME.height(); pixel++) {
      ByteBuffer bytes = ByteBuffer.allocate(Film.MAX_PIXEL_BYTES).put((byte) 100);
      for (int channel = 0; channel < 3; channel++) {
        bytes.put((byte) random.nextInt(100)).putLong(random.nextLong());
      }
      film.decode(pixel, bytes.putLong(random.nextLong()).flip());
    }
    return film;
  }

  private static double seconds(long start) {
    return (System.nanoTime() - start) * 1e-9;
  }

  private static double median(List<Double> values) {
    return values.stream().sorted().toList().get(values.size() / 2);
  }

  @Test
  void checkpointsTakeAtMostAHundredthOfAMinute() throws IOException, InterruptedException {
    Film film = film();
    try (CheckpointFile file = CheckpointFile.reserve(directory.resolve("a.film"))) {
      Checkpoints checkpoints = new Checkpoints(Duration.ZERO, true);
      for (int i = 1; i <= SAVES; i++) {
        long start = System.nanoTime();
        checkpoints.saveIfDue(film, content -> save(file, content));
        pauses.add(seconds(start));
        while (whole.size() < i) {
          Thread.sleep(10);
        }
      }
    }
    System.out.printf(
        "checkpoint of %dx%d: rendering waits %.3f s (the first time %.3f s), %.2f s of processor"
            + " time, on the disk after %.2f s (medians of %d)%n",
        FRAME.width(),
        FRAME.height(),
        median(pauses),
        pauses.get(0),
        median(processor),
        median(whole),
        SAVES);
    int processors = Runtime.getRuntime().availableProcessors();
    assertThat(median(pauses) + median(processor) / processors).isLessThan(MOST_SECONDS);
  }

  private void save(CheckpointFile file, Film film) {
    long start = System.nanoTime();
    try {
      file.save(
          FilmFile.of(
              FilmFixture.IDENTITY,
              film,
              RecordedLayers.NONE,
              FilmFixture.NOTES,
              RenderStatistics.ZERO));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    processor.add(ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() * 1e-9);
    whole.add(seconds(start));
  }
}
