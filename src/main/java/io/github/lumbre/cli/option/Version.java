package io.github.lumbre.cli.option;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.lab.Release;
import picocli.CommandLine.IVersionProvider;

/** Which Lumbre this is, and what it runs on. */
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

  /** Returns how rays would find what they hit, and why. */
  private static String kernel() {
    return Kernel.vectorObstacle()
        .map(obstacle -> "scalar, since " + obstacle)
        .orElse("vector, since Java and this processor have vectors of 8 floats");
  }

  private static String property(String key) {
    return System.getProperty(key, "unknown");
  }
}
