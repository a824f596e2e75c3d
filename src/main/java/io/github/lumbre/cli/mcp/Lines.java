package io.github.lumbre.cli.mcp;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;

/**
 * Reads a stream line by line, and keeps no more of a line than a limit. Confined to one thread.
 */
final class Lines {
  private final InputStream in;
  private final int most;

  /**
   * A line without its end.
   *
   * @param bytes at most the limit
   * @param isWhole whether the line is not longer than the limit
   */
  record Line(byte[] bytes, boolean isWhole) {
    boolean isBlank() {
      for (byte b : bytes) {
        if (b != ' ' && b != '\t' && b != '\r') {
          return false;
        }
      }
      return true;
    }
  }

  /**
   * @param most bytes of a line
   */
  Lines(InputStream in, int most) {
    this.in = new BufferedInputStream(in);
    this.most = most;
  }

  /** Returns the next line; empty at the end of the stream. */
  Optional<Line> next() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    boolean isWhole = true;
    int b = in.read();
    if (b < 0) {
      return Optional.empty();
    }
    for (; b >= 0 && b != '\n'; b = in.read()) {
      if (line.size() < most) {
        line.write(b);
      } else {
        isWhole = false;
      }
    }
    return Optional.of(new Line(line.toByteArray(), isWhole));
  }
}
