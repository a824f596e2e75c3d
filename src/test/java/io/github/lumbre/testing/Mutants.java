package io.github.lumbre.testing;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.concurrent.TimeUnit;

/** Damaged files: each must be read, or refused with a reason, soon and with little memory. */
public final class Mutants {
  private static final int MANY = 100_000;

  private Mutants() {}

  /** Makes and reads one damaged file. */
  public interface Reader {
    /** Returns whether the file was read; false if it was refused with a reason. */
    boolean isRead(long seed) throws Exception;
  }

  /** Reads the mutants of a normal or an exhaustive run; some must be read and some refused. */
  public static void few(int quick, Reader reader) {
    few(quick, .05, .95, reader);
  }

  /** Reads mutants with new seeds, or those from the one of {@code -Dlumbre.fuzz.seed} on. */
  public static void many(Reader reader) {
    many(.05, .95, reader);
  }

  /** As {@link #few(int, Reader)}, with the least and the most part that is read. */
  public static void few(int quick, double least, double most, Reader reader) {
    int count = Effort.count(quick, MANY);
    int read = read(Effort.seed(1), count, reader);
    assertThat(read).isBetween(part(least, count), part(most, count));
  }

  /** As {@link #many(Reader)}, with the least and the most part that is read. */
  public static void many(double least, double most, Reader reader) {
    long seed = Long.getLong("lumbre.fuzz.seed", System.nanoTime());
    assertThat(read(seed, MANY, reader)).isBetween(part(least, MANY), part(most, MANY));
  }

  private static int part(double part, int count) {
    return (int) Math.round(part * count);
  }

  /** Returns how many mutants are read; an error has the seed of its mutant. */
  public static int read(long seed, int count, Reader reader) {
    int read = 0;
    for (int i = 0; i < count; i++) {
      try {
        read += reader.isRead(seed + i) ? 1 : 0;
      } catch (Exception | Error e) {
        throw new AssertionError("seed " + (seed + i), e);
      }
    }
    return read;
  }

  /** Checks a text for people: a short one without the insides of a program. */
  public static void assertPrintable(String text, int longest) {
    assertThat(text).hasSizeLessThan(longest).doesNotContain("Exception", "java.", "null");
    assertThat(text.codePoints().anyMatch(Character::isISOControl)).as(text).isFalse();
  }

  /** What this thread needs from now on. */
  public static final class Needs {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final long MAX_SECONDS = 2;

    /** Bytes of classes that are loaded, of messages, and of Java's decoders. */
    private static final long UNCOUNTED = 8_000_000;

    private final long bytes = THREADS.getCurrentThreadAllocatedBytes();
    private final long start = THREADS.getCurrentThreadCpuTime();

    /** Checks that it was little time, and hardly more memory than was counted. */
    public void assertLittle(long counted) {
      assertThat(THREADS.getCurrentThreadCpuTime() - start)
          .isLessThan(TimeUnit.SECONDS.toNanos(MAX_SECONDS));
      assertThat(THREADS.getCurrentThreadAllocatedBytes() - bytes).isLessThan(counted + UNCOUNTED);
    }
  }
}
