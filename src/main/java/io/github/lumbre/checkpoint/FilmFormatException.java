package io.github.lumbre.checkpoint;

import java.io.IOException;

/** A file that is not a checkpoint file, or a damaged one. The message does not have its name. */
public final class FilmFormatException extends IOException {
  private static final long serialVersionUID = 1;

  FilmFormatException(String message) {
    super(message);
  }
}
