package io.github.lumbre.image;

import java.io.IOException;
import java.util.Objects;

/** Thrown when bytes are not a usable picture; the message states the reason. */
public final class ImageFormatException extends IOException {
  private static final long serialVersionUID = 1;

  /** The kind of problem. */
  public enum Kind {
    /** The file is truncated or inconsistent, or not in a supported format. */
    MALFORMED,
    /**
     * The picture exceeds a limit, does not fit into memory, or would take far too long to decode.
     */
    TOO_LARGE
  }

  private final Kind kind;

  /** Creates an exception without a cause. */
  public ImageFormatException(Kind kind, String message) {
    super(message);
    this.kind = Objects.requireNonNull(kind, "kind");
  }

  /** Creates an exception with the failure of a decoder as its cause. */
  public ImageFormatException(Kind kind, String message, Throwable cause) {
    super(message, cause);
    this.kind = Objects.requireNonNull(kind, "kind");
  }

  /** Returns the failure of a file that is damaged, or is no picture. */
  public static ImageFormatException malformed(String message) {
    return new ImageFormatException(Kind.MALFORMED, message);
  }

  /** Returns why the picture cannot be read. */
  public Kind kind() {
    return kind;
  }
}
