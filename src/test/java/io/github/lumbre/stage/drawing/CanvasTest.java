package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CanvasTest {
  private static final int SIZE = 100;

  /** Bound of the error of the samples of a pixel for a half-plane. */
  private static final double SAMPLING = .05;

  static Image white(int width, int height) {
    float[] rgb = new float[3 * width * height];
    Arrays.fill(rgb, 1);
    return new Image(width, height, rgb, new float[0]);
  }

  /** Returns a white picture with black strokes. */
  private static Image drawn(Strokes strokes, double width) {
    Canvas canvas = new Canvas(white(SIZE, SIZE));
    canvas.draw(strokes, new Pen(Rgb.BLACK, width));
    return canvas.image();
  }

  private static double coverage(Image image, int x, int y) {
    return 1 - image.pixel(x, y).r();
  }

  private static double area(Image image) {
    double area = 0;
    for (int y = 0; y < image.height(); y++) {
      for (int x = 0; x < image.width(); x++) {
        area += coverage(image, x, y);
      }
    }
    return area;
  }

  private static double capsule(double length, double width) {
    return length * width + Math.PI * width * width / 4;
  }

  @ParameterizedTest
  @ValueSource(doubles = {.5, 1, 1.5, 2.7, 9})
  void coverageIsTheAreaAtAnyAngle(double width) {
    for (int degrees = 0; degrees < 180; degrees += 7) {
      double dx = 30 * Math.cos(Math.toRadians(degrees));
      double dy = 30 * Math.sin(Math.toRadians(degrees));
      Strokes line = new Strokes().add(50.3 - dx, 49.8 - dy, 50.3 + dx, 49.8 + dy);
      double expected = capsule(60, width);
      // 1 %: the samples of some hundred pixels, whose error is 0.011 in the root mean square.
      assertThat(area(drawn(line, width))).isCloseTo(expected, within(.01 * expected));
    }
  }

  @Test
  void coverageDoesNotChangeWithPartsOfAPixel() {
    double expected = capsule(Math.hypot(40, 13), 1.3);
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 50; i++) {
      double x = 20 + random.nextDouble();
      double y = 30 + random.nextDouble();
      Strokes line = new Strokes().add(x, y, x + 40, y + 13);
      assertThat(area(drawn(line, 1.3))).isCloseTo(expected, within(.01 * expected));
    }
  }

  @Test
  void lineOnPixelsFillsThem() {
    Image image = drawn(new Strokes().add(10.5, 10, 10.5, 20), 1);
    for (int y = 10; y < 20; y++) {
      assertThat(coverage(image, 10, y)).isEqualTo(1);
      assertThat(coverage(image, 9, y)).isZero();
      assertThat(coverage(image, 11, y)).isZero();
    }
  }

  @Test
  void lineBetweenPixelsCoversHalfOfBoth() {
    Image image = drawn(new Strokes().add(10, 31, 60, 31), 1);
    for (int x = 10; x < 60; x++) {
      assertThat(coverage(image, x, 30)).isEqualTo(.5);
      assertThat(coverage(image, x, 31)).isEqualTo(.5);
    }
  }

  /** The band of width w around the diagonal of a unit square has the area 2 s - s², s = w/√2. */
  @Test
  void lineThroughPixelCornersCoversItsBand() {
    Image image = drawn(new Strokes().add(10, 10, 40, 40), 1);
    double share = 1 / Math.sqrt(2);
    double band = 2 * share - share * share;
    for (int i = 11; i < 39; i++) {
      assertThat(coverage(image, i, i)).isCloseTo(band, within(SAMPLING));
      double corner = .5 * share * share;
      assertThat(coverage(image, i, i + 1)).isCloseTo(corner, within(SAMPLING));
      assertThat(coverage(image, i + 1, i)).isCloseTo(corner, within(SAMPLING));
    }
  }

  /**
   * In a row, each of the two edges crosses at most two pixels, which lie within 1.2 pixels of the
   * line: 4 * SAMPLING * 1.2 / 1.4. Over many rows, the errors cancel out.
   */
  @Test
  void centerOfTheLineStaysInPlace() {
    double errors = 0;
    int rows = 0;
    for (double x = 40; x < 41; x += .07) {
      Image image = drawn(new Strokes().add(x, -5, x + 9, 105), 1.4);
      for (int y = 0; y < SIZE; y++) {
        double error = center(image, y) - (x + 9 * (y + 5.5) / 110);
        assertThat(error).isBetween(-.17, .17);
        errors += error;
        rows++;
      }
    }
    assertThat(errors / rows).isCloseTo(0, within(.005));
  }

  private static double center(Image image, int row) {
    double sum = 0;
    double moment = 0;
    for (int column = 0; column < SIZE; column++) {
      sum += coverage(image, column, row);
      moment += coverage(image, column, row) * (column + .5);
    }
    return moment / sum;
  }

  @Test
  void segmentsOfOneLineCoverOnce() {
    Strokes whole = new Strokes().add(10, 20, 70, 55);
    Strokes parts = new Strokes();
    for (int i = 0; i < 600; i++) {
      parts.add(10 + .1 * i, 20 + 35 * i / 600., 10.1 + .1 * i, 20 + 35 * (i + 1) / 600.);
    }
    Image one = drawn(whole, 2.2);
    Image many = drawn(parts, 2.2);
    for (int i = 0; i < SIZE * SIZE; i++) {
      int x = i % SIZE;
      int y = i / SIZE;
      // A sample at the very edge may be inside by rounding.
      assertThat(coverage(many, x, y)).isCloseTo(coverage(one, x, y), within(1. / 64 + 1e-6));
    }
  }

  @Test
  void crossingIsNotDarker() {
    Canvas canvas = new Canvas(white(SIZE, SIZE));
    canvas.draw(new Strokes().add(50, 10, 50, 90).add(10, 50, 90, 50), new Pen(Rgb.BLACK, 4, .25));
    assertThat(canvas.image().pixel(50, 50).r()).isEqualTo(.75);
    assertThat(canvas.image().pixel(50, 20).r()).isEqualTo(.75);
  }

  @Test
  void largePictureIsDrawnInBandsWithoutSeams() {
    Canvas canvas = new Canvas(white(3, 500));
    canvas.draw(new Strokes().add(1.5, -10, 1.5, 600), new Pen(Rgb.BLACK, 1));
    for (int y = 0; y < 500; y++) {
      assertThat(coverage(canvas.image(), 1, y)).isEqualTo(1);
    }
  }

  @Test
  void dotIsADisk() {
    double expected = Math.PI * 9;
    assertThat(area(drawn(new Strokes().add(50.2, 50.7, 50.2, 50.7), 6)))
        .isCloseTo(expected, within(.01 * expected));
  }

  @Test
  void farEndsAreClipped() {
    Image near = drawn(new Strokes().add(-50, 20, 150, 20), 3);
    assertThat(drawn(new Strokes().add(-1e9, 20, 1e9, 20), 3).rgb()).isEqualTo(near.rgb());
  }

  @Test
  void whatIsNotANumberOrOutsideIsNotDrawn() {
    double inf = Double.POSITIVE_INFINITY;
    Strokes strokes =
        new Strokes()
            .add(Double.NaN, 20, 30, 20)
            .add(20, Double.NaN, 30, 20)
            .add(20, 20, 30, Double.NaN)
            .add(-inf, 20, inf, 20)
            .add(inf, inf, inf, inf)
            .add(20, -inf, 20, 40)
            .add(-1e300, -1e300, -1e300, 1e300)
            .add(-30, 10, -5, 90)
            .add(10, 103, 90, 103);
    assertThat(area(drawn(strokes, 2))).isZero();
  }

  @Test
  void anySegmentIsDrawn() {
    SplittableRandom random = new SplittableRandom(7);
    double[] values = {0, -0., 1, 50, 99.5, 100, -1, 1e-300, 1e9, -1e15, 1e300, -1.7e308};
    Strokes strokes = new Strokes();
    for (int i = 0; i < 2000; i++) {
      double[] c = random.ints(4, 0, values.length).mapToDouble(k -> values[k]).toArray();
      strokes.add(c[0], c[1], c[2], c[3]);
    }
    Image image = drawn(strokes, 1);
    for (float value : image.rgb()) {
      assertThat(value).isBetween(0f, 1f);
    }
  }

  @Test
  void drawsOverTransparentPixels() {
    Canvas canvas = new Canvas(new Image(3, 1, new float[9], new float[] {0, .5f, 1}));
    canvas.draw(new Strokes().add(-5, .5, 8, .5), new Pen(new Rgb(.8, .4, .2), 3, .5));
    Image image = canvas.image();
    assertThat(image.alpha(0, 0)).isEqualTo(.5f);
    assertThat(image.pixel(0, 0).r()).isCloseTo(.8, within(1e-6));
    assertThat(image.alpha(1, 0)).isEqualTo(.75f);
    assertThat(image.pixel(1, 0).r()).isCloseTo(.8 * .5 / .75, within(1e-6));
    assertThat(image.alpha(2, 0)).isEqualTo(1f);
    assertThat(image.pixel(2, 0).g()).isCloseTo(.2, within(1e-6));
  }

  @Test
  void opaquePenReplacesInfiniteLight() {
    Canvas canvas =
        new Canvas(new Image(1, 1, new float[] {Float.POSITIVE_INFINITY, 1, 1}, new float[0]));
    canvas.draw(new Strokes().add(-5, .5, 8, .5), new Pen(Rgb.BLACK, 3));
    assertThat(canvas.image().pixel(0, 0)).isEqualTo(Rgb.BLACK);
  }

  @Test
  void theGivenPictureDoesNotChange() {
    Image given = white(5, 5);
    Canvas canvas = new Canvas(given);
    Image before = canvas.image();
    canvas.draw(new Strokes().add(0, 0, 5, 5), new Pen(Rgb.BLACK, 2));
    assertThat(area(given)).isZero();
    assertThat(area(before)).isZero();
    assertThat(area(canvas.image())).isPositive();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, 1001, Double.NaN, Double.POSITIVE_INFINITY})
  void penHasAWidth(double width) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Pen(Rgb.BLACK, width))
        .withMessage("width: expected more than 0 and at most 1000.0, found " + width);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-.1, 1.1, Double.NaN})
  void penHasAnOpacity(double opacity) {
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Pen(Rgb.BLACK, 1, opacity))
        .withMessage("opacity: expected 0 to 1, found " + opacity);
  }

  @Test
  void polylineHasWholePoints() {
    assertThat(new Strokes().polyline(0, 0, 1, 1, 2, 0).count()).isEqualTo(2);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Strokes().polyline(0, 0, 1))
        .withMessage("points: expected an even number of at least 4 values, found 3");
  }
}
