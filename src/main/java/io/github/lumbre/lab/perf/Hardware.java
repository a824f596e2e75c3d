package io.github.lumbre.lab.perf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * The machine that runs a render.
 *
 * @param cpu processor model, or its architecture where the system does not report a model
 * @param cores number of logical cores available to this process
 * @param jvm name and version of the Java virtual machine
 * @param os name, version and architecture of the system
 */
public record Hardware(String cpu, int cores, String jvm, String os) {
  /** Returns this machine. */
  public static Hardware here() {
    String arch = property("os.arch");
    return new Hardware(
        cpu(Path.of("/proc/cpuinfo"), arch),
        Runtime.getRuntime().availableProcessors(),
        property("java.vm.name") + " " + property("java.runtime.version"),
        property("os.name") + " " + property("os.version") + " " + arch);
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

  /** Returns the description as one line. */
  public String line() {
    String count = cores == 1 ? "1 logical core" : cores + " logical cores";
    return cpu + ", " + count + "; " + jvm + "; " + os;
  }

  private static String property(String key) {
    return System.getProperty(key, "unknown");
  }
}
