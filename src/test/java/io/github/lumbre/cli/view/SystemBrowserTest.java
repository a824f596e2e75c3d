package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The browser is the system's; a terminal without a screen has none. */
class SystemBrowserTest {
  @Test
  void eachSystemHasItsProgram(@TempDir Path folder) throws Exception {
    Path program = Files.createFile(folder.resolve("xdg-open"));
    Map<String, String> screen = Map.of("PATH", "" + folder, "DISPLAY", ":0");
    assertThat(SystemBrowser.command("Windows 11", Map.of())).startsWith("rundll32");
    assertThat(SystemBrowser.command("Mac OS X", Map.of())).containsExactly("open");
    assertThat(SystemBrowser.command("Linux", screen)).isEmpty();
    assertThat(program.toFile().setExecutable(true)).isTrue();
    assertThat(SystemBrowser.command("Linux", screen)).containsExactly("xdg-open");
    assertThat(SystemBrowser.command("Linux", Map.of("PATH", "" + folder))).isEmpty();
    assertThat(SystemBrowser.command("Linux", Map.of("DISPLAY", ":0"))).isEmpty();
  }
}
