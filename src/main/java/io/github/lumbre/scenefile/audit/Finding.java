package io.github.lumbre.scenefile.audit;

import io.github.lumbre.scenefile.internal.Origin;
import java.util.Objects;

/**
 * A questionable property of a scene.
 *
 * @param severity its importance
 * @param law short name of the check, for programs
 * @param path place in the file, such as {@code $.objects[3]}
 * @param name the name of what is there; empty if it has none
 * @param found what was found, as one sentence without a final period
 * @param means its effect on the render
 * @param advice how to fix it; empty if there is nothing to do
 */
public record Finding(
    Severity severity,
    String law,
    String path,
    String name,
    String found,
    String means,
    String advice) {
  public Finding {
    Objects.requireNonNull(severity, "severity");
    Objects.requireNonNull(path, "path");
    Objects.requireNonNull(name, "name");
  }

  /** The importance of a finding. */
  public enum Severity {
    /** The image is probably wrong or not as intended. */
    WARNING,
    /** Useful to know; often intended. */
    NOTE
  }

  static Finding warning(String law, Origin at, String found, String means, String advice) {
    return new Finding(Severity.WARNING, law, at.path(), at.name(), found, means, advice);
  }

  static Finding note(String law, Origin at, String found, String means, String advice) {
    return new Finding(Severity.NOTE, law, at.path(), at.name(), found, means, advice);
  }
}
