package io.github.lumbre.cli.view;

import java.io.File;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Opens addresses in the browser that the user has chosen in the system. */
public final class SystemBrowser {
  private SystemBrowser() {}

  /**
   * Opens an address. Returns whether a browser was started; false in a terminal without a screen.
   */
  public static boolean open(URI address) {
    List<String> command = command(System.getProperty("os.name"), System.getenv());
    if (command.isEmpty()) {
      return false;
    }
    try {
      ProcessBuilder builder = new ProcessBuilder(new ArrayList<>(command));
      builder.command().add(address.toString());
      builder
          .redirectInput(nothing())
          .redirectOutput(Redirect.DISCARD)
          .redirectError(Redirect.DISCARD)
          .start();
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private static File nothing() {
    boolean isWindows = File.separatorChar == '\\';
    return new File(isWindows ? "NUL" : "/dev/null");
  }

  /** Returns the program that opens an address; empty if there is none. */
  static List<String> command(String system, Map<String, String> environment) {
    String name = system.toLowerCase(Locale.ROOT);
    if (name.startsWith("windows")) {
      return List.of("rundll32", "url.dll,FileProtocolHandler");
    }
    if (name.startsWith("mac")) {
      return List.of("open");
    }
    boolean hasScreen =
        !environment.getOrDefault("DISPLAY", "").isEmpty()
            || !environment.getOrDefault("WAYLAND_DISPLAY", "").isEmpty();
    boolean isInstalled =
        Arrays.stream(environment.getOrDefault("PATH", "").split(File.pathSeparator))
            .filter(folder -> !folder.isEmpty())
            .anyMatch(folder -> Files.isExecutable(Path.of(folder, "xdg-open")));
    return hasScreen && isInstalled ? List.of("xdg-open") : List.of();
  }
}
