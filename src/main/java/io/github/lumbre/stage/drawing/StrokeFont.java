package io.github.lumbre.stage.drawing;

/**
 * Text as strokes of constant width: printable ASCII, umlauts, ß, and the signs °, ±, ×, ², ³, µ,
 * ø, Ø, ⌀ and −. Other characters are boxes. The same text has the same strokes on every machine.
 */
public final class StrokeFont {
  /** Height of capitals and digits in units of the table. */
  public static final double CAPITAL = 14;

  /** Distance of the lowest point of any character below the baseline, in units of the table. */
  public static final double DESCENT = 4;

  /** Distance of the highest point of any character above the baseline, in units of the table. */
  public static final double ASCENT = 17;

  /** Distance between characters, in units of the table. */
  static final double GAP = 4;

  private StrokeFont() {}

  /**
   * Returns the width of a line of text without the width of the pen.
   *
   * @param size height of capitals in pixels
   */
  public static double width(String text, double size) {
    double units = text.codePoints().mapToDouble(c -> GlyphTable.of(c).width() + GAP).sum();
    return Math.max(0, units - GAP) * size / CAPITAL;
  }

  /**
   * Adds the strokes of a line of text.
   *
   * @param x of its left end, in pixels
   * @param y of its baseline, in pixels
   * @param size height of capitals in pixels; the pen should have an eighth of it
   */
  public static void add(Strokes strokes, String text, double x, double y, double size) {
    double scale = size / CAPITAL;
    double left = 0;
    for (int character : text.codePoints().toArray()) {
      Glyph glyph = GlyphTable.of(character);
      for (double[] points : glyph.strokes()) {
        double[] placed = new double[points.length];
        for (int i = 0; i < points.length; i += 2) {
          placed[i] = x + (left + points[i]) * scale;
          placed[i + 1] = y - points[i + 1] * scale;
        }
        strokes.polyline(placed);
      }
      left += glyph.width() + GAP;
    }
  }
}
