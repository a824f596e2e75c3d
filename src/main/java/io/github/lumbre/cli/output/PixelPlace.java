package io.github.lumbre.cli.output;

/**
 * A pixel of the full frame.
 *
 * @param x column, from the left
 * @param y row, from the top
 */
public record PixelPlace(int x, int y) {
  @Override
  public String toString() {
    return x + "," + y;
  }
}
