package io.github.lumbre.render;

/** Thrown when a program error ended a render; the cause is the exception of a worker thread. */
public final class RenderException extends RuntimeException {
  private static final long serialVersionUID = 1;

  /** Wraps the exception of a worker thread. */
  public RenderException(String message, Throwable cause) {
    super(message, cause);
  }
}
