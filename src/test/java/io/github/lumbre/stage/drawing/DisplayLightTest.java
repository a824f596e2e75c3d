package io.github.lumbre.stage.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import java.awt.image.BufferedImage;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DisplayLightTest {
  private static final int SIZE = 64;

  private static Image noise(boolean hasAlpha) {
    float[] rgb = new float[3 * SIZE * SIZE];
    float[] alpha = new float[hasAlpha ? SIZE * SIZE : 0];
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < rgb.length; i++) {
      rgb[i] = (float) (6 * random.nextDouble());
    }
    for (int i = 0; i < alpha.length; i++) {
      alpha[i] = i % 5 / 4f;
    }
    return new Image(SIZE, SIZE, rgb, alpha);
  }

  /** Rounding to floats may move a value to the next byte where it lies between two bytes. */
  @ParameterizedTest
  @EnumSource(ToneCurve.class)
  void hasThePixelsOfThePictureForDisplay(ToneCurve curve) {
    ImageWriter.Options options = new ImageWriter.Options(Exposure.of(-1.3), curve, 8, Map.of());
    for (Image picture : new Image[] {noise(false), noise(true)}) {
      DisplayLight light = DisplayLight.of(picture, options);
      BufferedImage expected = picture.toBufferedImage(options);
      BufferedImage shown = light.image().toBufferedImage(light.options());
      int different = 0;
      for (int i = 0; i < SIZE * SIZE; i++) {
        int x = i % SIZE;
        int y = i / SIZE;
        different += expected.getRGB(x, y) == shown.getRGB(x, y) ? 0 : 1;
      }
      assertThat(different).isLessThanOrEqualTo(2);
    }
  }

  /** On a surface eight times as bright as white, half a pixel of black is half of white. */
  @ParameterizedTest
  @EnumSource(ToneCurve.class)
  void linesKeepTheirWeightOnBrightSurfaces(ToneCurve curve) {
    Image bright = new Image(1, 1, new float[] {8, 8, 8}, new float[0]);
    ImageWriter.Options options = new ImageWriter.Options(Exposure.NONE, curve, 8, Map.of());
    DisplayLight light = DisplayLight.of(bright, options);
    Canvas canvas = new Canvas(light.image());
    canvas.draw(new Strokes().add(-9, 0, 9, 0), new Pen(Rgb.BLACK, 1));
    assertThat(canvas.image().pixel(0, 0).r()).isEqualTo(light.image().pixel(0, 0).r() / 2);
  }
}
