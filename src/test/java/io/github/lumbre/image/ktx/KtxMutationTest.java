package io.github.lumbre.image.ktx;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedPicture;
import io.github.lumbre.image.ktx.KtxSamples.Sample;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.FileMutator;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged file is decoded or refused, soon, and with no more memory than it counts. */
class KtxMutationTest {
  private static final int QUICK = 2000;
  private static final int MANY = 100_000;
  private static final int HEADER = 300;
  private static final long MAX_SECONDS = 2;

  /** Bytes of code books, of classes that are loaded, and of messages. */
  private static final long UNCOUNTED = 8_000_000;

  private static final List<Sample> SAMPLES = KtxSamples.all();

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

  private static boolean isDecoded(long seed) {
    Random random = new Random(seed);
    byte[] original = SAMPLES.get(random.nextInt(SAMPLES.size())).file();
    byte[] file = new FileMutator(random).changed(original, HEADER);
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long estimate = 0;
    long bytes = threads.getCurrentThreadAllocatedBytes();
    long start = threads.getCurrentThreadCpuTime();
    try {
      if (!KtxFile.startsIn(file)) {
        return false;
      }
      EncodedPicture header = KtxFile.open(file);
      long pixels = (long) header.width() * header.height();
      if (pixels > Limits.UPLOADS.texels()) {
        return false;
      }
      estimate = pixels * header.bytesPerPixel();
      Pixels decoded = header.decoder().decode();
      assertThat(decoded.width()).isEqualTo(header.width());
      return true;
    } catch (ImageFormatException e) {
      assertThat(e.getMessage()).hasSizeLessThan(200).doesNotContain("null");
      assertThat(e.getMessage().codePoints().noneMatch(Character::isISOControl)).isTrue();
      return false;
    } finally {
      long time = threads.getCurrentThreadCpuTime() - start;
      assertThat(time).isLessThan(TimeUnit.SECONDS.toNanos(MAX_SECONDS));
      assertThat(threads.getCurrentThreadAllocatedBytes() - bytes).isLessThan(estimate + UNCOUNTED);
    }
  }
}
