package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.ImageLayer.Precision;
import io.github.lumbre.image.LayeredImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests what a denoiser learns from an OpenEXR file. */
class NoisyPictureTest {
  private static final int WIDTH = 40;
  private static final int HEIGHT = 30;

  private static ImageLayer layer(String name, String channels, float value) {
    List<String> names = List.of(channels.split(" "));
    float[] values = new float[names.size() * WIDTH * HEIGHT];
    Arrays.fill(values, value);
    return new ImageLayer(name, names, Precision.FLOAT, WIDTH, HEIGHT, values);
  }

  private static NoisyPicture read(ImageLayer... layers) {
    return NoisyPicture.of(new LayeredImage(WIDTH, HEIGHT, List.of(layers), Map.of()));
  }

  /**
   * Neither half may be brighter than the other. 1200 signs have a sum of 0 with a standard
   * deviation of 35; in each half of the columns, 24.
   */
  @Test
  void signsOfTheNoiseHaveNoPattern() {
    NoisyPicture noisy = read(layer("", "R G B", 1), layer("variance", "R G B", .25f));
    assertThat(noisy.light().isNoiseKnown()).isTrue();
    float[] noise = noisy.light().noise();
    int sum = 0;
    int sumOfEven = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
      assertThat(Math.abs(noise[3 * i])).isEqualTo(.5f);
      assertThat(noise[3 * i + 1]).isEqualTo(noise[3 * i]);
      assertThat(noise[3 * i + 2]).isEqualTo(noise[3 * i]);
      int sign = noise[3 * i] > 0 ? 1 : -1;
      sum += sign;
      sumOfEven += i % 2 == 0 ? sign : 0;
    }
    assertThat(sum).isBetween(-150, 150);
    assertThat(sumOfEven).isBetween(-110, 110);
  }

  @Test
  void noiseIsUnknownWhereItsVarianceIsNegativeOrMissing() {
    assertThat(read(layer("", "R G B", 1)).light().isNoiseKnown()).isFalse();
    NoisyPicture single = read(layer("", "R G B", 1), layer("variance", "R G B", -1));
    assertThat(single.light().isNoiseKnown()).isFalse();
  }

  @Test
  void otherGuidesStandInForThoseOfDenoisers() {
    ImageLayer picture = layer("", "R G B", 1);
    assertThat(read(picture).albedo()).isEmpty();
    assertThat(read(picture, layer("albedo", "R G B", .3f)).albedo().get().mean())
        .containsOnly(.3f);
    List<ImageLayer> both =
        new ArrayList<>(
            List.of(layer("normal", "X Y Z", .1f), layer("denoisingNormal", "X Y Z", .2f)));
    both.add(picture);
    assertThat(read(both.toArray(ImageLayer[]::new)).normal().get().mean()).containsOnly(.2f);
    assertThat(read(picture, layer("normal", "R G B", .1f)).normal()).isEmpty();
  }

  @Test
  void valuesThatAreNotFiniteAreReplaced() {
    ImageLayer picture = layer("", "R G B A", 1);
    picture.values()[4 * 17] = Float.NaN;
    picture.values()[4 * 99 + 1] = Float.NEGATIVE_INFINITY;
    picture.values()[3] = 7;
    picture.values()[7] = Float.NaN;
    ImageLayer albedo = layer("albedo", "R G B", .5f);
    albedo.values()[5] = Float.POSITIVE_INFINITY;
    NoisyPicture noisy = read(picture, albedo);
    assertThat(noisy.replaced()).isEqualTo(2);
    assertThat(noisy.light().mean()).containsOnly(1);
    assertThat(noisy.alpha()).startsWith(1, 0, 1);
    assertThat(noisy.albedo().get().mean()[5]).isZero();
  }

  @Test
  void filesWithoutAPictureAreRefused() {
    assertThatThrownBy(() -> read(layer("albedo", "R G B", 1)))
        .hasMessageContaining("expected channels R, G and B");
    assertThatThrownBy(() -> read(layer("", "R G B", Float.NaN)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
