package io.github.lumbre.lab;

import io.github.lumbre.base.text.Numbers;
import java.io.IOException;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * The machine that runs a render, and the other conditions that influence times.
 *
 * @param cpu processor model, or its architecture where the system does not report a model
 * @param cores number of logical cores available to this process
 * @param jvm name and version of the Java virtual machine
 * @param jvmOptions options of the JVM, without system properties, which may be private
 * @param maxHeapBytes maximum heap size in bytes
 * @param collectors names of the garbage collectors
 * @param os name, version and architecture of the system
 * @param loadBefore mean number of running or runnable threads on the system over the last minute;
 *     negative where the system does not report it
 */
public record Machine(
    String cpu,
    int cores,
    String jvm,
    List<String> jvmOptions,
    long maxHeapBytes,
    List<String> collectors,
    String os,
    double loadBefore) {
  public Machine {
    jvmOptions = List.copyOf(jvmOptions);
    collectors = List.copyOf(collectors);
  }

  /** Returns the current state of this machine. */
  public static Machine here() {
    String arch = property("os.arch");
    return new Machine(
        cpu(Path.of("/proc/cpuinfo"), arch),
        Runtime.getRuntime().availableProcessors(),
        property("java.vm.name") + " " + property("java.runtime.version"),
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
            .filter(option -> option.startsWith("-X"))
            .toList(),
        Runtime.getRuntime().maxMemory(),
        ManagementFactory.getGarbageCollectorMXBeans().stream()
            .map(GarbageCollectorMXBean::getName)
            .toList(),
        property("os.name") + " " + property("os.version") + " " + arch,
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
  }

  /** Returns the first processor model in Linux's {@code /proc/cpuinfo}, or else a default. */
  static String cpu(Path list, String otherwise) {
    try (Stream<String> lines = Files.lines(list)) {
      return lines
          .filter(line -> line.startsWith("model name") && line.contains(":"))
          .map(line -> line.substring(line.indexOf(':') + 1).strip())
          .filter(model -> !model.isEmpty())
          .findFirst()
          .orElse(otherwise);
    } catch (IOException e) {
      return otherwise;
    }
  }

  /** Returns the machine as one line, without options, memory and load. */
  public String line() {
    return cpu + ", " + Numbers.count(cores, "logical core") + "; " + jvm + "; " + os;
  }

  private static String property(String key) {
    return System.getProperty(key, "unknown");
  }
}
