package io.github.lumbre.lab.perf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the description of the machine. */
class HardwareTest {
  @TempDir private Path directory;

  @Test
  void cpuIsTheFirstModelOfTheList() throws IOException {
    Path list = directory.resolve("cpuinfo");
    Files.writeString(
        list, "processor\t: 0\nmodel\t\t: 58\nmodel name\t: Core i7: fast\nmodel name\t: Other\n");
    assertThat(Hardware.cpu(list, "amd64")).isEqualTo("Core i7: fast");
  }

  @Test
  void cpuIsTheArchitectureWhereNoModelIsTold() throws IOException {
    Path list = directory.resolve("cpuinfo");
    assertThat(Hardware.cpu(list, "aarch64")).isEqualTo("aarch64");
    Files.writeString(list, "processor\t: 0\nCPU architecture: 8\n");
    assertThat(Hardware.cpu(list, "aarch64")).isEqualTo("aarch64");
  }

  @Test
  void lineTellsProcessorCoresMachineAndSystem() {
    assertThat(new Hardware("Fast", 4, "VM 17", "Linux 6 amd64").line())
        .isEqualTo("Fast, 4 logical cores; VM 17; Linux 6 amd64");
    assertThat(new Hardware("Slow", 1, "VM", "OS").line()).startsWith("Slow, 1 logical core;");
  }
}
