package io.github.lumbre.image.internal;

import io.github.lumbre.image.Rgb;
import java.util.List;
import java.util.Optional;

/**
 * A drawing of lines and areas. Coordinates are in pixels from the top left corner; y points down.
 *
 * @param background color behind everything; empty for none
 * @param groups in the order in which they are drawn
 */
public record VectorPicture(Page page, Optional<Rgb> background, List<Group> groups) {
  /**
   * The size of a drawing, and where pixels are on it.
   *
   * @param width in units
   * @param height in units
   * @param left of the first pixel, in units
   * @param top of the first pixel, in units
   * @param pixel the side of a pixel in units
   * @param unit {@code mm}, or an empty text for pixels
   */
  public record Page(
      double width, double height, double left, double top, double pixel, String unit) {
    /** Returns the page of a picture in pixels. */
    public static Page ofPixels(int width, int height) {
      return new Page(width, height, 0, 0, 1, "");
    }
  }

  /**
   * What belongs together.
   *
   * @param id a name of ASCII letters, digits and hyphens
   * @param title any text; empty for none
   */
  public record Group(String id, String title, List<Layer> layers) {}

  /**
   * Paths that are drawn alike.
   *
   * @param kind a name of ASCII letters
   * @param color linear, as a screen can show it
   * @param width of lines in pixels; 0 to fill what is inside an odd number of the paths
   * @param dash length of dashes in pixels, which have round ends besides; 0 for whole lines
   * @param gap between dashes in pixels
   * @param paths x and y of each of their points, at least two; the first point of a closed path is
   *     also its last one
   */
  public record Layer(
      String kind, Rgb color, double width, double dash, double gap, List<double[]> paths) {}

  public VectorPicture {
    groups = List.copyOf(groups);
  }
}
