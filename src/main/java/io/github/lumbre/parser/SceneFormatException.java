package io.github.lumbre.parser;

import java.util.List;
import java.util.stream.Collectors;

/** A scene that cannot be used, with everything that is wrong with it, up to a limit. */
public final class SceneFormatException extends Exception {
  private static final long serialVersionUID = 1;

  /** What kind of thing is wrong; the first problem decides. */
  public enum Kind {
    /** The scene file is missing, unreadable, not JSON, or has an invalid value. */
    INVALID,
    /** A mesh or picture that the scene contains or names cannot be decoded. */
    ASSET,
    /** Something is larger than allowed. */
    LIMIT
  }

  private final Kind kind;
  private final Problem[] problems;

  /**
   * @param problems at least one
   */
  SceneFormatException(Kind kind, List<Problem> problems) {
    super(
        problems.stream()
            .map(Problem::toString)
            .collect(Collectors.joining(System.lineSeparator())));
    this.kind = kind;
    this.problems = problems.toArray(Problem[]::new);
  }

  public Kind kind() {
    return kind;
  }

  /** Returns the problems, in the order in which they were found. */
  public List<Problem> problems() {
    return List.of(problems);
  }
}
