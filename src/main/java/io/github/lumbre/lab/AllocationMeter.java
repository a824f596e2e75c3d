package io.github.lumbre.lab;

import com.sun.management.ThreadMXBean;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.lang.management.ManagementFactory;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Counts the bytes that a render's threads allocate, and forwards progress to another listener. The
 * threads live for one render, so a thread's total at the end of its last bucket is its share.
 * Garbage collection has no effect. Shared by the threads.
 */
final class AllocationMeter implements Progress {
  private static final ThreadMXBean THREADS =
      ManagementFactory.getPlatformMXBean(ThreadMXBean.class);

  private final Progress listener;
  private final Map<Thread, Long> bytes = new ConcurrentHashMap<>();

  AllocationMeter(Progress listener) {
    this.listener = listener;
  }

  /** Returns the sum over all threads, up to their finished buckets. */
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
  public void finished(Crop bucket) {
    bytes.put(Thread.currentThread(), THREADS.getCurrentThreadAllocatedBytes());
    listener.finished(bucket);
  }

  @Override
  public boolean isCancelled() {
    return listener.isCancelled();
  }
}
