package io.github.lumbre.model.draco;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.FileMutator;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Every damaged stream is decoded or refused, soon, and with no more memory than it counts. */
class DracoMutationTest {
  private static final int QUICK = 3000;
  private static final int MANY = 100_000;
  private static final int HEADER = 60;
  private static final long MAX_BYTES = 30_000_000;
  private static final long MAX_SECONDS = 2;

  /** Bytes of classes that are loaded, and of messages. */
  private static final long UNCOUNTED = 8_000_000;

  private static final List<byte[]> FILES = DracoSamples.files().toList();

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
    byte[] original = FILES.get(random.nextInt(FILES.size()));
    byte[] file = new FileMutator(random).changed(original, HEADER);
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long[] counted = {0};
    DracoLimits limits = new DracoLimits(100_000, 100_000, bytes -> count(bytes, counted));
    long bytes = threads.getCurrentThreadAllocatedBytes();
    long start = threads.getCurrentThreadCpuTime();
    try {
      DracoMesh mesh = DracoMesh.decode(file, "x", limits);
      check(mesh);
      return true;
    } catch (ModelFormatException e) {
      assertThat(e.getMessage()).hasSizeLessThan(200).doesNotContain("null");
      return false;
    } finally {
      long time = threads.getCurrentThreadCpuTime() - start;
      assertThat(time).isLessThan(TimeUnit.SECONDS.toNanos(MAX_SECONDS));
      assertThat(threads.getCurrentThreadAllocatedBytes() - bytes)
          .isLessThan(counted[0] + UNCOUNTED);
    }
  }

  private static void count(long bytes, long[] counted) throws ModelFormatException {
    if (counted[0] + bytes > MAX_BYTES) {
      throw new ModelFormatException(Kind.TOO_LARGE, "x", "expected less memory, found more");
    }
    counted[0] += bytes;
  }

  private static void check(DracoMesh mesh) {
    boolean isSound = mesh.corners().length % 3 == 0;
    for (int corner : mesh.corners()) {
      isSound &= corner >= 0 && corner < mesh.pointCount();
    }
    for (DracoAttribute attribute : mesh.attributes()) {
      long size = (long) mesh.pointCount() * attribute.components() * attribute.type().size();
      isSound &= attribute.values().remaining() == size;
    }
    if (!isSound) {
      throw new IllegalStateException("unsound mesh of " + mesh.pointCount() + " points");
    }
  }
}
