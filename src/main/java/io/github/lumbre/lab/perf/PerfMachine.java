package io.github.lumbre.lab.perf;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;

/**
 * The conditions, other than the program, that influence times.
 *
 * @param options options of the JVM, without system properties, which may be private
 * @param maxHeapBytes maximum heap size in bytes
 * @param collectors names of the garbage collectors
 * @param load mean number of running or runnable threads on the system over the last minute;
 *     negative where the system does not report it
 */
public record PerfMachine(
    Hardware hardware,
    List<String> options,
    long maxHeapBytes,
    List<String> collectors,
    double load) {
  public PerfMachine {
    options = List.copyOf(options);
    collectors = List.copyOf(collectors);
  }

  /** Returns the current state of this machine. */
  public static PerfMachine here() {
    return new PerfMachine(
        Hardware.here(),
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(option -> option.startsWith("-X"))
            .toList(),
        Runtime.getRuntime().maxMemory(),
        ManagementFactory.getGarbageCollectorMXBeans().stream()
            .map(GarbageCollectorMXBean::getName)
            .toList(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
  }
}
