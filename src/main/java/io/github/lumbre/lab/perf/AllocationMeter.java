package io.github.lumbre.lab.perf;

import com.sun.management.ThreadMXBean;
import io.github.lumbre.render.Bucket;
import io.github.lumbre.render.Progress;
import java.lang.management.ManagementFactory;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Counts the bytes that a render's threads allocate, and passes on what it hears to another. The
 * threads live for one render, so what each has allocated when its last bucket is done is its
 * share; garbage collection does not matter. Shared by the threads.
 */
final class AllocationMeter implements Progress {
  private static final ThreadMXBean THREADS =
      ManagementFactory.getPlatformMXBean(ThreadMXBean.class);

  private final Progress listener;
  private final Map<Thread, Long> bytes = new ConcurrentHashMap<>();

  AllocationMeter(Progress listener) {
    this.listener = listener;
  }

  /** Returns the sum over all threads, as of the buckets that are done. */
  long bytes() {
    return bytes.values().stream().mapToLong(Long::longValue).sum();
  }

  @Override
  public void started(long totalSamples) {
    listener.started(totalSamples);
  }

  @Override
  public void advanced(long samples) {
    listener.advanced(samples);
  }

  @Override
  public void finished(Bucket bucket) {
    bytes.put(Thread.currentThread(), THREADS.getCurrentThreadAllocatedBytes());
    listener.finished(bucket);
  }

  @Override
  public boolean isCancelled() {
    return listener.isCancelled();
  }
}
