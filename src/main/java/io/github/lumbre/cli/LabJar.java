package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import java.io.IOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The jar of the lab, which lies beside the program's own. The commands that measure run with it on
 * their class path, all others without it.
 */
final class LabJar {
  /** Names of the commands, and the earlier name of one. */
  private static final Set<String> COMMANDS =
      Set.of("benchmark", "bench", "coverage", "perf", "selftest", "trade");

  private static final String MISSING =
      "lumbre: %s: needs %s, which is missing; put it there: each release and package has it beside"
          + " the program, and './mvnw package' builds it in target%n";

  private static final String A_CLASS = "io/github/lumbre/lab/Trial.class";

  private LabJar() {}

  /**
   * Runs a command with the lab, if it needs the lab and runs without it.
   *
   * @return whether it did
   */
  static boolean runs(String[] args) {
    Optional<String> command = Stream.of(args).filter(arg -> !arg.startsWith("-")).findFirst();
    if (command.filter(COMMANDS::contains).isEmpty()
        || LabJar.class.getClassLoader().getResource(A_CLASS) != null) {
      return false;
    }
    try {
      Path program =
          Path.of(LabJar.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      Path lab = beside(program);
      if (!Files.isRegularFile(lab)) {
        System.err.printf(MISSING, command.get(), lab);
        System.exit(ExitCode.INTERNAL.number());
      }
      URL[] places = {program.toUri().toURL(), lab.toUri().toURL()};
      URLClassLoader loader = new URLClassLoader(places, ClassLoader.getPlatformClassLoader());
      Thread.currentThread().setContextClassLoader(loader);
      Class<?> main = loader.loadClass(Lumbre.class.getName());
      main.getMethod("main", String[].class).invoke(null, (Object) args);
    } catch (URISyntaxException | IOException | ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
    return true;
  }

  /** Returns the place of the lab's jar: {@code a-lab.jar} for {@code a-cli.jar}. */
  static Path beside(Path program) {
    String name = program.getFileName().toString();
    boolean isDeployed = name.endsWith("-cli.jar");
    return program.resolveSibling(
        isDeployed ? name.replaceFirst("-cli[.]jar$", "-lab.jar") : "lumbre-lab.jar");
  }
}
