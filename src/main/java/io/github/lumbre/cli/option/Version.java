package io.github.lumbre.cli.option;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.lab.Release;
import picocli.CommandLine.IVersionProvider;

/** Prints the versions of Lumbre, the JVM and the operating system. */
public final class Version implements IVersionProvider {
  @Override
  public String[] getVersion() {
    return new String[] {
      "Lumbre " + Release.number(),
      "JVM: " + property("java.vm.name") + " " + property("java.runtime.version"),
      "Kernel: " + kernel(),
      "OS: " + property("os.name") + " " + property("os.version") + " " + property("os.arch")
    };
  }

  /** Returns the default traversal kernel and the reason for it. */
  private static String kernel() {
    if (Boolean.getBoolean("lumbre.kernel.deferred")) {
      // The launcher of the runtime image prints the version without loading the vector module.
      return "vector, if this processor supports vectors of 8 floats; otherwise scalar";
    }
    return Kernel.vectorObstacle()
        .map(obstacle -> "scalar, because " + obstacle)
        .orElse("vector, because Java and this processor support vectors of 8 floats");
  }

  private static String property(String key) {
    return System.getProperty(key, "unknown");
  }
}
