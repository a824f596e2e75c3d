package io.github.lumbre.render;

/** A render that a fault of the program ended; the cause says which. */
public final class RenderException extends RuntimeException {
  private static final long serialVersionUID = 1;

  /** Wraps what a worker thread threw. */
  public RenderException(String message, Throwable cause) {
    super(message, cause);
  }
}
