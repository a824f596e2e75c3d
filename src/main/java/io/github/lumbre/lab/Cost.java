package io.github.lumbre.lab;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;

/**
 * The time and memory that a render uses.
 *
 * @param seconds wall-clock time
 * @param cpuSeconds CPU time of the whole process, summed over processors, including JIT
 *     compilation and garbage collection
 * @param allocatedBytes bytes allocated by the rendering threads
 */
public record Cost(double seconds, double cpuSeconds, long allocatedBytes) {
  private static final OperatingSystemMXBean PROCESS =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);

  /** Returns the clocks' current times, for {@link #since}. */
  public static Cost now() {
    return new Cost(System.nanoTime() * 1e-9, PROCESS.getProcessCpuTime() * 1e-9, 0);
  }

  /** Returns the time since an earlier {@link #now}. */
  public static Cost since(Cost start) {
    Cost end = now();
    return new Cost(end.seconds - start.seconds, end.cpuSeconds - start.cpuSeconds, 0);
  }

  /** Returns the sum of both. */
  public Cost plus(Cost o) {
    return new Cost(
        seconds + o.seconds, cpuSeconds + o.cpuSeconds, allocatedBytes + o.allocatedBytes);
  }
}
