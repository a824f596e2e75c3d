package io.github.lumbre.audit;

import io.github.lumbre.parser.Origin;
import java.util.Objects;

/**
 * Something questionable in a scene.
 *
 * @param severity how much it matters
 * @param law a short name of what was looked at, for programs
 * @param path of the place in the file, and the name there, if there is one
 * @param found what was found
 * @param means what follows from it
 * @param advice what to do; empty if nothing
 */
public record Finding(
    Severity severity, String law, Origin path, String found, String means, String advice) {
  public Finding {
    Objects.requireNonNull(severity, "severity");
    Objects.requireNonNull(path, "path");
  }

  /** How much a finding matters. */
  public enum Severity {
    /** The picture is probably not what was meant, or wrong. */
    WARNING,
    /** Worth knowing; often as meant. */
    NOTE
  }

  static Finding warning(String law, Origin path, String found, String means, String advice) {
    return new Finding(Severity.WARNING, law, path, found, means, advice);
  }

  static Finding note(String law, Origin path, String found, String means, String advice) {
    return new Finding(Severity.NOTE, law, path, found, means, advice);
  }
}
