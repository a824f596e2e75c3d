package io.github.lumbre.checkpoint;

import java.io.IOException;

/** A file that is no film, or a damaged one; the message says which, without the file's name. */
public final class FilmFormatException extends IOException {
  private static final long serialVersionUID = 1;

  FilmFormatException(String message) {
    super(message);
  }
}
