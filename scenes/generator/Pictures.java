package generator;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;

/** The textures. Pixels are 0xRRGGBB, row 0 at the top. */
final class Pictures {
  static final int SIGN_HEIGHT = 18;

  private static final int INK = 0x20242C;
  private static final int PAPER = 0xF2EEE2;
  private static final int RED = 0xB03020;

  private static final int[][] BAYER = {
    {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}
  };

  /** Letters five pixels wide and seven high, row by row. */
  private static final Map<Character, String> FONT =
      Map.ofEntries(
          Map.entry('A', "01110 10001 10001 11111 10001 10001 10001"),
          Map.entry('B', "11110 10001 10001 11110 10001 10001 11110"),
          Map.entry('E', "11111 10000 10000 11110 10000 10000 11111"),
          Map.entry('H', "10001 10001 10001 11111 10001 10001 10001"),
          Map.entry('L', "10000 10000 10000 10000 10000 10000 11111"),
          Map.entry('M', "10001 11011 10101 10101 10001 10001 10001"),
          Map.entry('N', "10001 10001 11001 10101 10011 10001 10001"),
          Map.entry('O', "01110 10001 10001 10001 10001 10001 01110"),
          Map.entry('R', "11110 10001 10001 11110 10100 10010 10001"),
          Map.entry('S', "01111 10000 10000 01110 00001 00001 11110"),
          Map.entry('T', "11111 00100 00100 00100 00100 00100 00100"),
          Map.entry('U', "10001 10001 10001 10001 10001 10001 01110"),
          Map.entry('W', "10001 10001 10001 10101 10101 11011 10001"));

  static void writeAll(Path folder) throws IOException {
    write(folder.resolve("checker.png"), checker(0xE8E4DA, 0x4A4640));
    write(folder.resolve("gold.png"), checker(0xE0A848, 0xF0E8D8));
    write(folder.resolve("arrow.png"), upArrow(24));
    write(folder.resolve("heart.png"), heart(128));
    write(folder.resolve("sky.png"), sky(512, 256));
    write(folder.resolve("banner.png"), banner("LUMBRE"));
    for (Compass side : Compass.values()) {
      String file = side.name().toLowerCase(Locale.ROOT) + ".png";
      write(folder.resolve(file), sign(side.name()));
    }
  }

  private static void write(Path file, int[][] pixels) throws IOException {
    Raster raster = new Raster(pixels[0].length, pixels.length);
    for (int y = 0; y < pixels.length; y++) {
      for (int x = 0; x < pixels[y].length; x++) {
        raster.set(x, y, pixels[y][x]);
      }
    }
    Png.writePlain(file, raster);
  }

  private static int[][] checker(int a, int b) {
    return new int[][] {{a, b}, {b, a}};
  }

  static int signWidth(String word) {
    return 6 * word.length() + 3;
  }

  /** A word above an arrow to the right. */
  private static int[][] sign(String word) {
    int width = signWidth(word);
    int[][] pixels = filled(width, SIGN_HEIGHT, PAPER);
    letters(pixels, word, 2, 2);
    for (int x = 2; x < width - 2; x++) {
      int reach = x < width - 5 ? 0 : width - 3 - x;
      for (int y = 13 - reach; y <= 13 + reach; y++) {
        pixels[y][x] = RED;
      }
    }
    return pixels;
  }

  /** A word around half a ball, upright when the ball's image is turned over. */
  private static int[][] banner(String word) {
    int width = 6 * word.length();
    int[][] pixels = filled(width, width / 2, 0xE8B830);
    for (int y = width / 4 - 5; y < width / 4 + 6; y++) {
      Arrays.fill(pixels[y], PAPER);
    }
    letters(pixels, word, 0, width / 4 - 3);
    return pixels;
  }

  private static void letters(int[][] pixels, String word, int left, int top) {
    for (int i = 0; i < word.length(); i++) {
      String[] rows = FONT.get(word.charAt(i)).split(" ");
      for (int y = 0; y < 7; y++) {
        for (int x = 0; x < 5; x++) {
          if (rows[y].charAt(x) == '1') {
            pixels[top + y][left + 6 * i + x] = INK;
          }
        }
      }
    }
  }

  private static int[][] upArrow(int size) {
    int[][] pixels = filled(size, size, PAPER);
    int middle = size / 2;
    for (int y = 2; y < size - 2; y++) {
      int half = y < middle ? y - 1 : 3;
      for (int x = middle - half; x < middle + half; x++) {
        pixels[y][x] = RED;
      }
    }
    return pixels;
  }

  /** The curve x² + (1.25y − √|x|)² = 1, white on black. */
  private static int[][] heart(int size) {
    int[][] pixels = filled(size, size, 0);
    for (int row = 0; row < size; row++) {
      for (int column = 0; column < size; column++) {
        double x = ((column + .5) / size * 2 - 1) * 1.05;
        double y = (1 - (row + .5) / size * 2) * 1.05 + .21;
        double bent = 1.25 * y - Math.sqrt(Math.abs(x));
        if (x * x + bent * bent <= 1) {
          pixels[row][column] = 0xFFFFFF;
        }
      }
    }
    return pixels;
  }

  /**
   * All directions by longitude and latitude: a clear sky with the sun 50° high in the middle
   * column, and the ground below.
   */
  private static int[][] sky(int width, int height) {
    int[][] pixels = filled(width, height, 0);
    double sunHeight = StrictMath.toRadians(50);
    for (int row = 0; row < height; row++) {
      double latitude = Math.PI * (.5 - (row + .5) / height);
      for (int column = 0; column < width; column++) {
        double longitude = 2 * Math.PI * ((column + .5) / width - .5);
        double cosine =
            StrictMath.cos(latitude) * StrictMath.cos(sunHeight) * StrictMath.cos(longitude)
                + StrictMath.sin(latitude) * StrictMath.sin(sunHeight);
        double fromSun = StrictMath.toDegrees(StrictMath.acos(Math.min(1, cosine)));
        pixels[row][column] =
            dithered(skyColour(StrictMath.sin(latitude), fromSun), row, column);
      }
    }
    return pixels;
  }

  private static double[] skyColour(double sine, double degreesFromSun) {
    if (sine < 0) {
      return Scene.rgb(.02, .018, .016);
    }
    double up = StrictMath.sqrt(sine);
    double glow = .06 * StrictMath.exp(-degreesFromSun / 12);
    double sun = Math.max(0, Math.min(1, 9 - degreesFromSun));
    return new double[] {
      .04 - .032 * up + glow + sun,
      .045 - .029 * up + .9 * glow + .93 * sun,
      .05 - .01 * up + .75 * glow + .8 * sun
    };
  }

  /** Pixels by the sRGB curve, dithered so that slow gradients show no steps. */
  private static int dithered(double[] linear, int row, int column) {
    double threshold = (BAYER[row % 4][column % 4] + .5) / 16;
    int pixel = 0;
    for (double c : linear) {
      pixel = pixel << 8 | (int) StrictMath.floor(srgb(c) * 255 + threshold);
    }
    return pixel;
  }

  /** The sRGB curve, IEC 61966-2-1. */
  private static double srgb(double linear) {
    double c = Math.min(1, linear);
    return c <= .0031308 ? 12.92 * c : 1.055 * StrictMath.pow(c, 1 / 2.4) - .055;
  }

  private static int[][] filled(int width, int height, int colour) {
    int[][] pixels = new int[height][width];
    for (int[] row : pixels) {
      Arrays.fill(row, colour);
    }
    return pixels;
  }
}
