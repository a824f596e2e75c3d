package io.github.lumbre.model.format.off;

import io.github.lumbre.model.internal.TextScanner;

/** How the numbers of an OFF text are laid out, in the order in which they are tried. */
enum OffLayout {
  /** A vertex or a face a line, as nearly all programs write them. */
  LINES(0),

  /** A vertex or a face begins a line, and may go on in the next ones. */
  WRAPPED(0),

  /** Numbers between any blanks and line ends; colors of vertices have 4, and faces no colors. */
  TOKENS(4),

  /** As {@link #TOKENS}; colors of vertices have 3 numbers. */
  TOKENS_WITHOUT_ALPHA(3);

  private final int colorSize;

  OffLayout(int colorSize) {
    this.colorSize = colorSize;
  }

  /** Returns whether the number of values on a line has no meaning. */
  boolean isTokens() {
    return colorSize > 0;
  }

  /** Returns the number of values of a vertex's color, if {@link #isTokens()}. */
  int colorSize() {
    return colorSize;
  }

  /** Moves to the next number of a vertex or a face, which has to follow. */
  boolean next(TextScanner scanner) {
    return this == LINES ? scanner.nextWord() : scanner.nextWordOfText();
  }

  /** Moves behind a vertex or a face. */
  void end(TextScanner scanner) {
    if (!isTokens()) {
      scanner.endLine();
    }
  }
}
