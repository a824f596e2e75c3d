package io.github.lumbre.stage.drawing;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import java.text.Normalizer;
import java.util.Arrays;

/**
 * A line of text below a picture: black on white, or with a white edge on a transparent ground. A
 * text that is too wide lacks its middle, which dots replace. Stateless.
 */
public final class Caption {
  /** A picture is this many capitals wide, if they can be read then. */
  private static final double CAPITALS_PER_WIDTH = 28;

  private static final double LEAST_CAPITAL = 7;
  private static final double MOST_CAPITAL = 24;
  private static final double CAPITALS_PER_PEN = 9;

  /** The height of the line in capitals. */
  private static final double LINE = 2.2;

  /** Fewer characters do not name anything. */
  private static final int LEAST_CHARACTERS = 4;

  /** Longer texts are cut before they are measured. */
  private static final int MOST_CHARACTERS = 200;

  private static final String DOTS = "...";

  private Caption() {}

  private static double capital(int width) {
    return Math.max(LEAST_CAPITAL, Math.min(width / CAPITALS_PER_WIDTH, MOST_CAPITAL));
  }

  private static double pen(int width) {
    return Math.max(1, capital(width) / CAPITALS_PER_PEN);
  }

  /** Returns the height in pixels of the line below a picture of a width in pixels. */
  public static int height(int width) {
    return (int) Math.ceil(LINE * capital(width));
  }

  /** Returns whether at least a part of a text can be read below a picture of a width. */
  public static boolean hasRoom(String text, int width) {
    String composed = composed(text);
    String shown = shortened(composed, width);
    return shown.equals(composed) || shown.length() >= LEAST_CHARACTERS + DOTS.length();
  }

  /**
   * Returns a picture of a text, in linear light.
   *
   * @param width in pixels, at least 1
   * @param isTransparent whether its ground is transparent
   */
  public static Image of(String text, int width, boolean isTransparent) {
    int height = height(width);
    float[] ground = new float[3 * width * height];
    Arrays.fill(ground, isTransparent ? 0 : 1);
    Canvas canvas =
        new Canvas(
            new Image(width, height, ground, new float[isTransparent ? width * height : 0]));
    String shown = shortened(composed(text), width);
    double size = capital(width);
    double left = .5 * (width - StrokeFont.width(shown, size));
    double above = StrokeFont.ASCENT / StrokeFont.CAPITAL;
    double below = StrokeFont.DESCENT / StrokeFont.CAPITAL;
    Strokes strokes = new Strokes();
    StrokeFont.add(strokes, shown, left, .5 * (height + (above - below) * size), size);
    if (isTransparent) {
      canvas.draw(strokes, new Pen(Rgb.WHITE, 3 * pen(width)));
    }
    canvas.draw(strokes, new Pen(Rgb.BLACK, pen(width)));
    return canvas.image();
  }

  /** Returns a text whose letters have their accents, as the font has them. */
  private static String composed(String text) {
    return Normalizer.normalize(text, Normalizer.Form.NFC);
  }

  /** Returns a text, or its beginning and its end if it is too wide; empty if nothing fits. */
  private static String shortened(String text, int width) {
    int[] characters = text.codePoints().toArray();
    double room = width - 4 * pen(width);
    if (characters.length <= MOST_CHARACTERS && fits(text, width, room)) {
      return text;
    }
    for (int kept = Math.min(characters.length - 1, MOST_CHARACTERS); kept > 0; kept--) {
      int end = kept / 2;
      String part =
          new String(characters, 0, kept - end)
              + DOTS
              + new String(characters, characters.length - end, end);
      if (fits(part, width, room)) {
        return part;
      }
    }
    return "";
  }

  private static boolean fits(String text, int width, double room) {
    return StrokeFont.width(text, capital(width)) <= room;
  }
}
