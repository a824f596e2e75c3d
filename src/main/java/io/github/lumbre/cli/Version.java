package io.github.lumbre.cli;

import io.github.lumbre.geometry.Kernel;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** Which Lumbre this is, and what it runs on. */
final class Version implements IVersionProvider {
  /** Returns the version's number: {@code 1.2.0}. */
  static String number() {
    Properties properties = new Properties();
    try (InputStream in = Version.class.getResourceAsStream("version.properties")) {
      properties.load(in);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return properties.getProperty("version");
  }

  @Override
  public String[] getVersion() {
    return new String[] {
      "Lumbre " + number(),
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
