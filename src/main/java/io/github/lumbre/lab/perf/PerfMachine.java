package io.github.lumbre.lab.perf;

import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;

/**
 * What bears on times besides the program.
 *
 * @param options of the virtual machine; system properties are left out, which may be private
 * @param maxHeapBytes that it may use
 * @param collectors of garbage
 * @param load how many threads of all programs were running or waiting to run, on average over the
 *     last minute; negative where the system does not tell
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

  /** Returns this machine as it is now. */
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
