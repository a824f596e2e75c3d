package io.github.lumbre.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the description of the machine. */
class MachineTest {
  @TempDir private Path directory;

  @Test
  void cpuIsTheFirstModelOfTheList() throws IOException {
    Path list = directory.resolve("cpuinfo");
    Files.writeString(
        list, "processor\t: 0\nmodel\t\t: 58\nmodel name\t: Core i7: fast\nmodel name\t: Other\n");
    assertThat(Machine.cpu(list, "amd64")).isEqualTo("Core i7: fast");
  }

  @Test
  void cpuIsTheArchitectureWhereNoModelIsTold() throws IOException {
    Path list = directory.resolve("cpuinfo");
    assertThat(Machine.cpu(list, "aarch64")).isEqualTo("aarch64");
    Files.writeString(list, "processor\t: 0\nCPU architecture: 8\n");
    assertThat(Machine.cpu(list, "aarch64")).isEqualTo("aarch64");
  }

  @Test
  void lineTellsProcessorCoresMachineAndSystem() {
    assertThat(machine("Fast", 4).line()).isEqualTo("Fast, 4 logical cores; VM 17; Linux 6 amd64");
    assertThat(machine("Slow", 1).line()).startsWith("Slow, 1 logical core;");
  }

  private static Machine machine(String cpu, int cores) {
    return new Machine(cpu, cores, "VM 17", List.of("-Xmx1g"), 1, List.of(), "Linux 6 amd64", 0);
  }
}
