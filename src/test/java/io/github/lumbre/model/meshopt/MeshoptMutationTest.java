package io.github.lumbre.model.meshopt;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.meshopt.MeshoptSamples.Sample;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.FileMutator;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged stream is decoded or refused, soon, and with no memory besides its elements. */
class MeshoptMutationTest {
  private static final int QUICK = 1000;
  private static final int MANY = 100_000;
  private static final int HEADER = 40;
  private static final long MAX_SECONDS = 2;

  /** Bytes of classes that are loaded, of a block, and of messages. */
  private static final long UNCOUNTED = 8_000_000;

  private static final List<Sample> SAMPLES =
      MeshoptSamples.all().stream().filter(sample -> sample.count() > 0).toList();

  @Test
  void mutantsAreDecodedOrRefused() {
    run(Effort.seed(1), Effort.count(QUICK, MANY));
  }

  @Test
  @Tag("fuzz")
  void manyMutantsAreDecodedOrRefused() {
    run(Long.getLong("lumbre.fuzz.seed", System.nanoTime()), MANY);
  }

  private static void run(long seed, int count) {
    int decoded = 0;
    for (int i = 0; i < count; i++) {
      try {
        decoded += isDecoded(seed + i) ? 1 : 0;
      } catch (RuntimeException | Error e) {
        throw new AssertionError("seed " + (seed + i), e);
      }
    }
    assertThat(decoded).isBetween(count / 20, count * 19 / 20);
  }

  /** Decodes a damaged stream with any filter, sometimes as more elements. */
  private static boolean isDecoded(long seed) {
    Random random = new Random(seed);
    Sample sample = SAMPLES.get(random.nextInt(SAMPLES.size()));
    byte[] file = new FileMutator(random).changed(sample.stream(), HEADER);
    MeshoptFilter filter = MeshoptFilter.values()[random.nextInt(MeshoptFilter.values().length)];
    int count = sample.count() + (random.nextInt(4) == 0 ? 3 * random.nextInt(100_000) : 0);
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long bytes = threads.getCurrentThreadAllocatedBytes();
    long start = threads.getCurrentThreadCpuTime();
    try {
      ByteBuffer decoded = sample.mode().decode(ByteBuffer.wrap(file), count, sample.stride(), "x");
      assertThat(decoded.remaining()).isEqualTo(count * sample.stride());
      if (sample.mode() == MeshoptMode.ATTRIBUTES && filter.fits(sample.stride())) {
        filter.restore(decoded, sample.stride());
      }
      return true;
    } catch (ModelFormatException e) {
      assertThat(e.getMessage()).hasSizeLessThan(200).doesNotContain("null");
      return false;
    } finally {
      long time = threads.getCurrentThreadCpuTime() - start;
      assertThat(time).isLessThan(TimeUnit.SECONDS.toNanos(MAX_SECONDS));
      assertThat(threads.getCurrentThreadAllocatedBytes() - bytes)
          .isLessThan((long) count * sample.stride() + UNCOUNTED);
    }
  }
}
