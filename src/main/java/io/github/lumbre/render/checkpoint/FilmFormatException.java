package io.github.lumbre.render.checkpoint;

import java.io.IOException;

/**
 * Thrown when a file is not a checkpoint file, or is damaged. The message does not contain the
 * file's name.
 */
public final class FilmFormatException extends IOException {
  private static final long serialVersionUID = 1;

  FilmFormatException(String message) {
    super(message);
  }
}
