package io.github.lumbre.cli.option;

import io.github.lumbre.base.Release;
import io.github.lumbre.geometry.Kernel;
import java.io.PrintWriter;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.IVersionProvider;

/** Prints the versions of Lumbre, the JVM and the operating system. */
public final class Version implements IVersionProvider {
  /** Arguments that need no command. */
  private static final Set<String> FLAGS = Set.of("-V", "--version");

  /** Returns whether arguments ask for the version of the program, and nothing else. */
  public static boolean isAskedForBy(String... args) {
    return args.length == 1 && FLAGS.contains(args[0]);
  }

  public static void print(PrintWriter out) {
    for (String line : new Version().getVersion()) {
      out.println(line);
    }
  }

  /** Joins instead of adding strings, for which Java would make methods first. */
  @Override
  public String[] getVersion() {
    return new String[] {
      line("Lumbre", Release.number()),
      line("JVM:", property("java.vm.name"), property("java.runtime.version")),
      line("Kernel:", kernel()),
      line("OS:", property("os.name"), property("os.version"), property("os.arch"))
    };
  }

  private static String line(String... words) {
    return String.join(" ", words);
  }

  /** Returns the default traversal kernel and the reason for it. */
  private static String kernel() {
    if (Boolean.getBoolean("lumbre.kernel.deferred")) {
      // The launcher of the runtime image prints the version without loading the vector module.
      return "vector, if this processor supports vectors of 8 floats; otherwise scalar";
    }
    // The launcher of the repository does so too, but Java can tell what the module would find.
    boolean isLater = "yes".equals(System.getProperty("lumbre.vectors.later"));
    Optional<String> obstacle = isLater ? Kernel.processorObstacle() : Kernel.vectorObstacle();
    return obstacle.isPresent()
        ? "scalar, because ".concat(obstacle.get())
        : "vector, because Java and this processor support vectors of 8 floats";
  }

  private static String property(String key) {
    return System.getProperty(key, "unknown");
  }
}
