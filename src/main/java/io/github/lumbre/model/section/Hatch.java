package io.github.lumbre.model.section;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;

/**
 * Parallel lines on a cut surface, as in technical drawings (ISO 128-50): parts beside each other
 * differ in the direction or the distance of their lines.
 *
 * @param paper color between the lines
 * @param ink color of the lines
 * @param across unit vector across the lines, divided by their distance: its first component
 * @param upwards second component
 */
public record Hatch(Rgb paper, Rgb ink, double across, double upwards) implements Texture<Rgb> {
  /** The width of lines, relative to their distance. */
  public static final double WIDTH = .16;

  /** Sines and cosines of 45°, 135°, 30° and 120°, each a direction across the lines. */
  private static final double[][] DIRECTIONS = {
    {Math.sqrt(.5), -Math.sqrt(.5)},
    {Math.sqrt(.5), Math.sqrt(.5)},
    {.5, -Math.sqrt(.75)},
    {.5, Math.sqrt(.75)}
  };

  private static final double[] DISTANCES = {1, .7, 1.4};

  /**
   * Returns the hatch of a part.
   *
   * @param number of the part, from 0; the next 12 numbers have other hatches
   * @param color of the part
   * @param distance of the lines of the first part
   */
  static Hatch of(int number, Rgb color, double distance) {
    double[] direction = DIRECTIONS[number % DIRECTIONS.length];
    double factor = DISTANCES[number / 2 % DISTANCES.length] * distance;
    Rgb paper = color.times(.5).plus(Rgb.gray(.4));
    return new Hatch(paper, paper.times(.15), direction[0] / factor, direction[1] / factor);
  }

  @Override
  public Rgb at(double u, double v) {
    double line = u * across + v * upwards;
    return line - Math.floor(line) < WIDTH ? ink : paper;
  }
}
