package io.github.lumbre.stage.thumbnail;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.format.threemf.ThreeMfSample;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.testing.FileMutator;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Thumbnails under load: eight clients send good models and mutated ones in turn, and one of the
 * clients stalls in the middle of its upload. The long test measures: {@code -Pendurance} on a
 * quiet machine of two processors, of {@code -Dlumbre.thumbnail.calls} calls.
 */
@Timeout(value = 30, unit = TimeUnit.MINUTES)
class ThumbnailLoadTest {
  private static final int CLIENTS = 8;
  private static final int QUARTERS = 4;
  private static final Limits LIMITS =
      Limits.UPLOADS
          .withBytes(4 << 20)
          .withTriangles(100_000)
          .withTexels(1 << 22)
          .withMemory(64 << 20)
          .withTime(Duration.ofSeconds(60));

  /** Heap that may be in use at the end beyond the first quarter. */
  private static final long MAX_GROWTH = 24L << 20;

  private record Model(String name, byte[] content) {}

  /** The first bytes of an upload, whose rest comes late. */
  private static final class Stalled extends InputStream {
    private final CountDownLatch rest;

    Stalled(CountDownLatch rest) {
      this.rest = rest;
    }

    @Override
    public int read() throws IOException {
      try {
        rest.await();
        return -1;
      } catch (InterruptedException e) {
        throw new IOException(e);
      }
    }
  }

  private final Map<String, String> hashes = new ConcurrentHashMap<>();
  private final ConcurrentLinkedQueue<Double> seconds = new ConcurrentLinkedQueue<>();
  private final AtomicInteger refused = new AtomicInteger();

  private static List<Model> models() throws IOException {
    List<Model> models = new ArrayList<>();
    for (String name : List.of("lantern.glb", "wine-glass.obj", "lamp-shade.obj")) {
      models.add(new Model(name, Files.readAllBytes(Path.of("scenes/models", name))));
    }
    models.add(new Model("hill.stl", ThumbnailModels.stl(2000)));
    models.add(new Model("square.3mf", ThreeMfSample.square()));
    return models;
  }

  @Test
  void everyCallIsAnsweredAndMemoryStaysFlat() throws Exception {
    run(24, 32);
  }

  @Test
  @Tag("endurance")
  void almostAllOfTwoThousandCallsTakeLessThanASecond() throws Exception {
    run(Integer.getInteger("lumbre.thumbnail.calls", 2000), 128);
    double[] sorted = seconds.stream().mapToDouble(s -> s).sorted().toArray();
    for (double share : new double[] {.5, .9, .99, 1}) {
      System.out.printf(
          "%.0f %%: %.3f s%n", 100 * share, sorted[(int) Math.ceil(share * sorted.length) - 1]);
    }
    System.out.println("refused: " + refused + ", " + new TreeMap<>(hashes));
    assertThat(sorted[sorted.length * 99 / 100]).isLessThan(1);
  }

  private void run(int calls, int side) throws Exception {
    List<Model> models = models();
    CountDownLatch rest = new CountDownLatch(1);
    ExecutorService clients = Executors.newFixedThreadPool(CLIENTS);
    List<Long> heap = new ArrayList<>();
    try (Thumbnails thumbnails = new Thumbnails(LIMITS)) {
      Future<byte[]> stalled =
          clients.submit(() -> thumbnails.png("a.stl", halfOf(models.get(3), rest), side));
      // The measurement is of a warm server.
      for (int i = 0; i < calls / 20 + models.size(); i++) {
        answer(thumbnails, models.get(i % models.size()), side, false);
      }
      seconds.clear();
      for (int quarter = 0; quarter < QUARTERS; quarter++) {
        List<Future<?>> sent = new ArrayList<>();
        for (int i = 0; i < calls / QUARTERS; i++) {
          Model model = models.get(i / 2 % models.size());
          boolean isHostile = i % 2 == 1;
          Random random = new Random(31L * quarter + i);
          Model upload = isHostile ? mutated(model, random) : model;
          sent.add(clients.submit(() -> answer(thumbnails, upload, side, isHostile)));
        }
        for (Future<?> answer : sent) {
          answer.get();
        }
        heap.add(usedHeap());
      }
      assertThat(stalled).isNotDone();
      rest.countDown();
      byte[] picture = stalled.get();
      assertThat(Sha256.of(picture)).isEqualTo(hashes.get("hill.stl"));
    } finally {
      clients.shutdownNow();
    }
    assertThat(seconds).hasSize(calls);
    assertThat(refused.get()).isBetween(calls / 10, calls / 2);
    assertThat(heap.get(QUARTERS - 1) - heap.get(0)).as("%s", heap).isLessThan(MAX_GROWTH);
  }

  private static InputStream halfOf(Model model, CountDownLatch rest) {
    int half = model.content.length / 2;
    return new SequenceInputStream(
        new SequenceInputStream(
            new ByteArrayInputStream(model.content, 0, half), new Stalled(rest)),
        new ByteArrayInputStream(model.content, half, model.content.length - half));
  }

  private static Model mutated(Model model, Random random) {
    return new Model(model.name, new FileMutator(random).changed(model.content, 256));
  }

  private Void answer(Thumbnails thumbnails, Model model, int side, boolean isHostile)
      throws Exception {
    long start = System.nanoTime();
    try {
      byte[] picture = thumbnails.png(model.name, new ByteArrayInputStream(model.content), side);
      String hash = Sha256.of(picture);
      if (!isHostile) {
        assertThat(hash).isEqualTo(hashes.computeIfAbsent(model.name, name -> hash));
      }
    } catch (SceneFormatException e) {
      assertThat(isHostile).as(e.getMessage()).isTrue();
      refused.incrementAndGet();
    }
    seconds.add((System.nanoTime() - start) * 1e-9);
    return null;
  }

  private static long usedHeap() throws InterruptedException {
    long least = Long.MAX_VALUE;
    for (int i = 0; i < 3; i++) {
      System.gc();
      Thread.sleep(50);
      Runtime runtime = Runtime.getRuntime();
      least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
    }
    return least;
  }
}
