package io.github.lumbre.parser;

import java.util.List;

/** A scene that cannot be used, with everything that is wrong with it, up to a limit. */
public final class SceneFormatException extends Exception {
  private static final long serialVersionUID = 1;

  /** What kind of thing is wrong; the first problem decides. */
  public enum Kind {
    /** The scene file is missing, unreadable, not JSON, or says something it may not. */
    INVALID,
    /** A mesh or picture that the scene contains or names cannot be decoded. */
    ASSET,
    /** Something is larger than allowed. */
    LIMIT
  }

  private final Kind kind;
  private final String[] problems;

  /**
   * @param problems at least one; each a line such as {@code scene.json: $.objects[3].radius:
   *     expected a finite number > 0, found -1}
   */
  SceneFormatException(Kind kind, List<String> problems) {
    super(String.join(System.lineSeparator(), problems));
    this.kind = kind;
    this.problems = problems.toArray(String[]::new);
  }

  public Kind kind() {
    return kind;
  }

  /** Returns the problems, a line each. */
  public List<String> problems() {
    return List.of(problems);
  }
}
