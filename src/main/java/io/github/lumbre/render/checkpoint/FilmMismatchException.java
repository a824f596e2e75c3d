package io.github.lumbre.render.checkpoint;

/**
 * Thrown when films, or a film and a scene, do not belong to the same picture; the message states
 * what differs.
 */
public final class FilmMismatchException extends Exception {
  private static final long serialVersionUID = 1;

  FilmMismatchException(String message) {
    super(message);
  }
}
