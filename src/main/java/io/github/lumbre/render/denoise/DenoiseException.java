package io.github.lumbre.render.denoise;

/** Denoising failed: an installed program is missing, hangs, fails, or answers nonsense. */
public final class DenoiseException extends Exception {
  private static final long serialVersionUID = 1L;

  /** Creates an exception whose message names the program and the problem. */
  public DenoiseException(String message) {
    super(message);
  }

  /** Creates an exception with a cause. */
  public DenoiseException(String message, Throwable cause) {
    super(message, cause);
  }
}
