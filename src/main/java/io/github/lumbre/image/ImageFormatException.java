package io.github.lumbre.image;

import java.io.IOException;
import java.util.Objects;

/** Bytes that are not a usable picture, and the reason. */
public final class ImageFormatException extends IOException {
  private static final long serialVersionUID = 1;

  /** The kind of problem. */
  public enum Kind {
    /** Truncated, contradictory, or no PNG or JPEG at all. */
    MALFORMED,
    /** More pixels than the limit or than memory holds, or more work than pixels justify. */
    TOO_LARGE
  }

  private final Kind kind;

  ImageFormatException(Kind kind, String message) {
    super(message);
    this.kind = Objects.requireNonNull(kind, "kind");
  }

  ImageFormatException(Kind kind, String message, Throwable cause) {
    super(message, cause);
    this.kind = Objects.requireNonNull(kind, "kind");
  }

  static ImageFormatException malformed(String message) {
    return new ImageFormatException(Kind.MALFORMED, message);
  }

  public Kind kind() {
    return kind;
  }
}
