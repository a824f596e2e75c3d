package io.github.lumbre.stage.drawing;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Which part of a model each pixel of a picture shows. Immutable. */
public final class PartMap {
  private final List<String> names;
  private final int width;
  private final int[] parts;

  /**
   * @param names of the parts
   * @param width of the picture
   * @param parts the number of the part in each pixel, in rows from the top; negative for none.
   *     Later changes of the array are not allowed
   */
  public PartMap(List<String> names, int width, int[] parts) {
    this.names = List.copyOf(names);
    this.width = width;
    this.parts = parts;
  }

  /**
   * A visible part.
   *
   * @param x of the pixel that is farthest from what is not the part, in the picture
   * @param y of this pixel
   */
  record Visible(String name, int pixels, int x, int y) {}

  /** Returns the name of the part in a pixel; empty if there is none, or no pixel. */
  Optional<String> nameAt(int x, int y) {
    boolean isPixel = x >= 0 && x < width && y >= 0 && y < parts.length / width;
    return isPixel && parts[y * width + x] >= 0
        ? Optional.of(names.get(parts[y * width + x]))
        : Optional.empty();
  }

  /**
   * Returns the visible parts, the largest first; empty for those without a pixel in the columns.
   *
   * @param first the first column to look for the farthest pixel
   * @param end the column after the last one
   */
  List<Optional<Visible>> visible(int first, int end) {
    int[] pixels = new int[names.size()];
    int[] best = new int[names.size()];
    Arrays.fill(best, -1);
    int[] distances = distances();
    for (int i = 0; i < parts.length; i++) {
      int part = parts[i];
      if (part >= 0) {
        pixels[part]++;
        boolean isInside = i % width >= first && i % width < end;
        if (isInside && (best[part] < 0 || distances[i] > distances[best[part]])) {
          best[part] = i;
        }
      }
    }
    return IntStream.range(0, pixels.length)
        .filter(part -> pixels[part] > 0)
        .boxed()
        .sorted(Comparator.comparingInt(part -> -pixels[part]))
        .map(
            part ->
                best[part] < 0
                    ? Optional.<Visible>empty()
                    : Optional.of(
                        new Visible(
                            names.get(part), pixels[part], best[part] % width, best[part] / width)))
        .toList();
  }

  /**
   * Returns the distance of each pixel from the nearest one of another part, or from the outside:
   * the larger of the distances in columns and rows.
   */
  private int[] distances() {
    int[] distances = new int[parts.length];
    for (int i = 0; i < parts.length; i++) {
      distances[i] = Math.min(next(distances, i, -1), across(distances, i, -1));
    }
    for (int i = parts.length - 1; i >= 0; i--) {
      int after = Math.min(next(distances, i, 1), across(distances, i, 1));
      distances[i] = Math.min(distances[i], after);
    }
    return distances;
  }

  /** Returns one more than the distance of the pixel beside. */
  private int next(int[] distances, int i, int step) {
    int column = i % width + step;
    boolean isOfPart = column >= 0 && column < width && parts[i + step] == parts[i];
    return isOfPart ? distances[i + step] + 1 : 1;
  }

  /** Returns one more than the least distance of the three pixels in the row above or below. */
  private int across(int[] distances, int i, int step) {
    int row = i + step * width;
    if (row < 0 || row >= parts.length || parts[row] != parts[i]) {
      return 1;
    }
    int column = i % width;
    int least = distances[row];
    for (int side = -1; side <= 1; side += 2) {
      boolean isOfPart =
          column + side >= 0 && column + side < width && parts[row + side] == parts[i];
      least = isOfPart ? Math.min(least, distances[row + side]) : 0;
    }
    return least + 1;
  }
}
