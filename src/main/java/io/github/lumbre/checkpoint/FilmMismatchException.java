package io.github.lumbre.checkpoint;

/** Films, or a film and a scene, that do not belong together; the message names what differs. */
public final class FilmMismatchException extends Exception {
  private static final long serialVersionUID = 1;

  FilmMismatchException(String message) {
    super(message);
  }
}
