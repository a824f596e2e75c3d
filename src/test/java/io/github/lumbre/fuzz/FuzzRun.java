package io.github.lumbre.fuzz;

import io.github.lumbre.fuzz.HostileScenes.Ending;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongFunction;

/**
 * Runs very many hostile scenes or pictures on several threads. Each has a limit of 30 s of
 * processor time, and of 10 min of wall-clock time because the machine may be busy.
 *
 * <p>System properties and their defaults: {@code lumbre.fuzz.scenes} (1,000,000), {@code
 * lumbre.fuzz.pictures} (1,000,000), {@code lumbre.fuzz.threads} (one per processor) and {@code
 * lumbre.fuzz.seed} (a new one). Mutable; each instance is one run.
 */
final class FuzzRun {
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration PATIENCE_BY_THE_CLOCK = Duration.ofMinutes(10);
  private static final Duration SLOW = Duration.ofSeconds(3);
  private static final int MOST_FAILURES = 20;
  private static final long REPORT_EVERY = 10_000;

  private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

  /** A current trial, with its start in processor time and in wall-clock time. */
  private record Started(long seed, long processorNanos, long nanos) {}

  private final String what;
  private final LongFunction<Ending> trial;
  private final long count;
  private final int threads;
  private final long firstSeed;
  private final AtomicLong next = new AtomicLong();
  private final Map<Thread, Started> running = new ConcurrentHashMap<>();
  private final Map<String, LongAdder> endings = new ConcurrentSkipListMap<>();
  private final Queue<String> failures = new ConcurrentLinkedQueue<>();

  private FuzzRun(
      String what, LongFunction<Ending> trial, long count, int threads, long firstSeed) {
    this.what = what;
    this.trial = trial;
    this.count = count;
    this.threads = threads;
    this.firstSeed = firstSeed;
  }

  /**
   * @param what the subject of the trials, for messages and the name of a property
   * @param trial runs the trial of a seed, and throws an {@link AssertionError} if it fails
   */
  static FuzzRun fromProperties(String what, LongFunction<Ending> trial) {
    int processors = Runtime.getRuntime().availableProcessors();
    Long seed = Long.getLong("lumbre.fuzz.seed");
    return new FuzzRun(
        what,
        trial,
        Long.getLong("lumbre.fuzz." + what, 1_000_000),
        Integer.getInteger("lumbre.fuzz.threads", processors),
        seed == null ? new SecureRandom().nextLong() >>> 1 : seed);
  }

  /** Runs until all trials are done, or too many have failed. */
  void start() throws InterruptedException {
    System.out.println(
        count + " hostile " + what + "; to repeat them: -Dlumbre.fuzz.seed=" + firstSeed);
    List<Thread> workers = new ArrayList<>();
    for (int i = 0; i < threads; i++) {
      Thread worker = new Thread(this::work, "fuzz-" + i);
      worker.setDaemon(true);
      worker.start();
      workers.add(worker);
    }
    for (Thread worker : workers) {
      while (worker.isAlive() && !isHung(worker)) {
        worker.join(1000);
      }
    }
    System.out.println("ended: " + endings);
  }

  /** Returns one message for each failure. */
  List<String> failures() {
    return List.copyOf(failures);
  }

  private boolean isHung(Thread worker) {
    Started started = running.get(worker);
    if (started == null) {
      return false;
    }
    long processorNanos = CLOCK.getThreadCpuTime(worker.getId()) - started.processorNanos;
    if (processorNanos < PATIENCE.toNanos()
        && System.nanoTime() - started.nanos < PATIENCE_BY_THE_CLOCK.toNanos()) {
      return false;
    }
    failures.add("seed " + started.seed + " takes more than " + PATIENCE);
    next.set(count);
    return true;
  }

  private void work() {
    for (long i = next.getAndIncrement();
        i < count && failures.size() < MOST_FAILURES;
        i = next.getAndIncrement()) {
      long seed = firstSeed + i;
      long start = CLOCK.getCurrentThreadCpuTime();
      running.put(Thread.currentThread(), new Started(seed, start, System.nanoTime()));
      tryOne(seed);
      if (CLOCK.getCurrentThreadCpuTime() - start > SLOW.toNanos()) {
        count("slow: " + seed);
      }
      if (i > 0 && i % REPORT_EVERY == 0) {
        System.out.println(i + " " + what + ": " + endings);
      }
    }
    running.remove(Thread.currentThread());
  }

  private void tryOne(long seed) {
    try {
      Ending ending = trial.apply(seed);
      count("exit code " + ending.exitCode());
      if (ending.rejected() > 0) {
        count("with rejected samples");
      }
    } catch (AssertionError e) {
      failures.add(e.getMessage() + " " + e.getCause());
      e.printStackTrace();
    }
  }

  private void count(String what) {
    endings.computeIfAbsent(what, key -> new LongAdder()).increment();
  }
}
