package io.github.lumbre.model;

import java.util.Objects;

/** Thrown if a model file is damaged, unsupported or too large. Its message states the place. */
public final class ModelFormatException extends Exception {
  private static final long serialVersionUID = 1;

  /** Kinds of failures. */
  public enum Kind {
    /** The file breaks the rules of its format. */
    MALFORMED,
    /** The file requires a feature that is not supported. */
    UNSUPPORTED,
    /** The file exceeds a limit. */
    TOO_LARGE,
    /** A file that the model names, or data in one of its URIs, cannot be read. */
    ASSET;

    /**
     * Returns an exception of this kind.
     *
     * @param location in the file, such as {@code nodes[3].mesh} or {@code line 12}; empty if the
     *     whole file is meant
     * @param message what was expected, and what was found
     */
    public ModelFormatException at(String location, String message) {
      return new ModelFormatException(this, location, message);
    }
  }

  private final Kind kind;
  private final String location;
  private final String detail;

  /** See {@link Kind#at}. */
  public ModelFormatException(Kind kind, String location, String message) {
    super(location.isEmpty() ? message : location + ": " + message);
    this.kind = Objects.requireNonNull(kind, "kind");
    this.location = location;
    detail = message;
  }

  /** Returns the place in the file; empty if the whole file is meant. */
  public String location() {
    return location;
  }

  /** Returns the message without the place. */
  public String detail() {
    return detail;
  }

  /** Returns the kind of failure. */
  public Kind kind() {
    return kind;
  }
}
