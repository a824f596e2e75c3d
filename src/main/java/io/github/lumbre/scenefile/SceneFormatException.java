package io.github.lumbre.scenefile;

import java.util.List;
import java.util.stream.Collectors;

/** Thrown if a scene cannot be used. Lists its errors, up to a limit of 20. */
public final class SceneFormatException extends Exception {
  private static final long serialVersionUID = 1;

  /** The kind of an error; the first error determines the kind of the exception. */
  public enum Kind {
    /** The scene file is missing, unreadable, not JSON, or has an invalid value. */
    INVALID,
    /** A mesh or image that the scene contains or names cannot be decoded. */
    ASSET,
    /** A size or number exceeds its limit. */
    LIMIT,
    /** An option does not suit the model, or contradicts another one. */
    OPTION
  }

  private final Kind kind;
  private final Problem[] problems;

  /**
   * Creates an exception.
   *
   * @param problems at least one
   */
  public SceneFormatException(Kind kind, List<Problem> problems) {
    super(
        problems.stream()
            .map(Problem::toString)
            .collect(Collectors.joining(System.lineSeparator())));
    this.kind = kind;
    this.problems = problems.toArray(Problem[]::new);
  }

  /** Returns why the scene cannot be used. */
  public Kind kind() {
    return kind;
  }

  /** Returns the errors in the order in which they were found; at least one. */
  public List<Problem> problems() {
    return List.of(problems);
  }
}
