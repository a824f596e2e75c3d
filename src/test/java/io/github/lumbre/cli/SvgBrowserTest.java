package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.internal.Srgb;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Drawings as vectors in a browser beside the same lines as pixels. The browser mixes the numbers
 * of sRGB and Lumbre mixes light, so that a pixel counts as dark if lines cover more than half of
 * it. The pictures are in {@code target/browser}.
 */
@Tag("browser")
class SvgBrowserTest extends CommandFixture {
  private static final Path FOLDER = Path.of("target", "browser");
  private static final int WIDTH = 520;
  private static final int HEIGHT = 390;

  /** Cubes, one in another and two through each other, two rings and a dozen of small plates. */
  private static final String MODEL = model();

  private static Browser browser;

  private static String model() {
    StringBuilder text = new StringBuilder(ObjShapes.cube("a", 0, 2, 0, false));
    text.append(ObjShapes.cube("", .5, 1, 8, true));
    text.append(ObjShapes.cube("b", 1.3, 2, 16, false));
    text.append(ObjShapes.torus("ring", 5, 0, 1)).append(ObjShapes.torus("other", 5, 3, -2));
    for (int i = 0; i < 6; i++) {
      text.append("o plate%d\nv -4 %1$d 0\nv -2 %1$d 0\nv -3 %1$d 2\n".formatted(i));
      text.append("f -3 -2 -1\n");
    }
    return text.toString();
  }

  @BeforeAll
  static void start() throws Exception {
    Files.createDirectories(FOLDER);
    browser = Browser.start();
  }

  @AfterAll
  static void end() throws IOException {
    browser.close();
  }

  private BufferedImage shown(String name, int scale) throws Exception {
    Path page = directory.resolve("page.html");
    String style = "width:%dpx;height:%dpx;display:block".formatted(scale * WIDTH, scale * HEIGHT);
    Files.writeString(
        page,
        "<!DOCTYPE html><body style='margin:0'><img style='%s' src='%s'>".formatted(style, name));
    browser.open(page.toUri(), scale * WIDTH, scale * HEIGHT, false);
    Path picture = FOLDER.resolve(name.replace(".svg", scale + ".png"));
    browser.photograph(picture);
    return ImageIO.read(picture.toFile());
  }

  private static boolean isDark(BufferedImage image, int x, int y, boolean isLight) {
    boolean isInside = x >= 0 && y >= 0 && x < image.getWidth() && y < image.getHeight();
    double green = isInside ? (image.getRGB(x, y) >> 8 & 0xff) / 255. : 1;
    return (isLight ? Srgb.decode(green) : green) < .5;
  }

  /** Returns the part of the dark pixels of one picture that have none near them in the other. */
  private static double alone(BufferedImage of, boolean isLight, BufferedImage in) {
    int dark = 0;
    int alone = 0;
    for (int y = 0; y < of.getHeight(); y++) {
      for (int x = 0; x < of.getWidth(); x++) {
        if (isDark(of, x, y, isLight)) {
          dark++;
          boolean isNear = false;
          for (int i = 0; i < 9; i++) {
            isNear |= isDark(in, x + i % 3 - 1, y + i / 3 - 1, !isLight);
          }
          alone += isNear ? 0 : 1;
        }
      }
    }
    return (double) alone / dark;
  }

  private BufferedImage rendered(int scale, String flags) throws IOException {
    Files.writeString(directory.resolve("m.obj"), MODEL);
    runs(
        "render T/m.obj -o T/m.png --overwrite --look lines --line-width %s --size %dx%d %s"
            .formatted(1.5 * scale, scale * WIDTH, scale * HEIGHT, flags));
    Files.copy(
        directory.resolve("m.png"),
        FOLDER.resolve("lines" + scale + ".png"),
        StandardCopyOption.REPLACE_EXISTING);
    return picture("m.png");
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 4})
  void theLinesAreThoseOfPixels(int scale) throws Exception {
    for (String view : new String[] {"front", "iso", "30,20"}) {
      // Labels have a least size in pixels; gray lines of a hatch need more than one to be dark.
      String more = scale == 1 ? "--labels size,scale" : "--section z=1.4";
      String flags = more + " --hidden dashed --view " + view;
      BufferedImage pixels = rendered(scale, flags);
      runs("render T/m.obj -o T/m.svg --overwrite --size %dx%d ".formatted(WIDTH, HEIGHT) + flags);
      BufferedImage vectors = shown("m.svg", scale);
      assertThat(alone(vectors, false, pixels)).as(view).isLessThan(.005);
      assertThat(alone(pixels, true, vectors)).as(view).isLessThan(.005);
    }
  }

  @Test
  void missingDashesAreNoticed() throws Exception {
    BufferedImage pixels = rendered(1, "--view iso --hidden dashed");
    runs("render T/m.obj -o T/m.svg --view iso --size %dx%d".formatted(WIDTH, HEIGHT));
    assertThat(alone(pixels, true, shown("m.svg", 1))).isGreaterThan(.02);
  }
}
