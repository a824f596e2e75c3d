package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.PictureError;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Parts and tiles of pictures are denoised like the whole, whatever their size. */
class DenoisedPartsTest {
  /** Beyond this distance from its border, a part is like the part of the whole. */
  private static final int FAR = 64;

  private static float albedo(int x, int y) {
    return (x / 12 + y / 12) % 2 == 0 ? .3f : .7f;
  }

  /** Dark on the left, bright on the right, with checkered albedo and a shadow. */
  private static double truth(int x, int y) {
    return albedo(x, y) * (x < 144 ? .2 : 1.2) * (x + y < 250 ? 1 : .4);
  }

  /** Returns a picture whose noise has a fourth of the light's size. */
  private static NoisyPicture noisy(int width, int height) {
    Random random = new Random(15);
    float[] albedo = new float[3 * width * height];
    float[] mean = new float[albedo.length];
    float[] noise = new float[albedo.length];
    for (int i = 0; i < albedo.length; i++) {
      int x = i / 3 % width;
      int y = i / 3 / width;
      double light = truth(x, y);
      albedo[i] = albedo(x, y);
      mean[i] = (float) (light * Math.max(0, 1 + .25 * random.nextGaussian()));
      noise[i] = (float) (.25 * light * random.nextGaussian());
    }
    NoisyPicture.Halves guide = new NoisyPicture.Halves(albedo, new float[0]);
    return picture(width, height, new NoisyPicture.Halves(mean, noise), guide);
  }

  private static NoisyPicture picture(
      int width, int height, NoisyPicture.Halves light, NoisyPicture.Halves albedo) {
    return new NoisyPicture(
        width, height, light, Optional.of(albedo), Optional.empty(), new float[0], 0);
  }

  /** A rectangle of a picture. */
  private record Part(int left, int top, int width, int height) {
    NoisyPicture of(NoisyPicture whole) {
      NoisyPicture.Halves light = whole.light();
      float[] albedo = of(whole.albedo().orElseThrow().mean(), whole.width());
      return picture(
          width,
          height,
          new NoisyPicture.Halves(
              of(light.mean(), whole.width()), of(light.noise(), whole.width())),
          new NoisyPicture.Halves(albedo, new float[0]));
    }

    Image of(Image whole) {
      return new Image(width, height, of(whole.rgb(), whole.width()), new float[0]);
    }

    private float[] of(float[] values, int across) {
      float[] part = new float[3 * width * height];
      for (int y = 0; y < height; y++) {
        System.arraycopy(values, 3 * ((top + y) * across + left), part, 3 * y * width, 3 * width);
      }
      return part;
    }
  }

  /** A part is exposed by its own light, and sees nothing beyond its border. */
  @Test
  void aPartIsLikeThePartOfTheWhole() throws InterruptedException {
    NoisyPicture whole = noisy(288, 216);
    NoisyPicture part = new Part(72, 16, 200, 184).of(whole);
    Image ofWhole = BuiltInDenoiser.denoise(whole, 2).image();
    Image ofPart = BuiltInDenoiser.denoise(part, 2).image();
    Image inner = new Part(FAR, FAR, 200 - 2 * FAR, 184 - 2 * FAR).of(ofPart);
    Image expected = new Part(72 + FAR, 16 + FAR, inner.width(), inner.height()).of(ofWhole);
    assertThat(inner.rgb()).isNotEqualTo(expected.rgb());
    assertThat(PictureError.of(inner, expected).flip()).isLessThan(.02);
  }

  @Test
  void smallTilesGiveTheBitsOfTheWhole() throws InterruptedException {
    NoisyPicture picture = noisy(61, 47);
    Denoised whole = BuiltInDenoiser.denoise(picture, 1);
    for (int tile : new int[] {1, 61 * 32, 40 * 47}) {
      Denoised tiled = BuiltInDenoiser.denoise(picture, 3, tile);
      assertThat(tiled.image().rgb()).as("tiles of %d", tile).isEqualTo(whole.image().rgb());
      assertThat(tiled.relativeError()).isEqualTo(whole.relativeError());
    }
  }

  /** Pictures far longer than a tile, and thinner than what the network sees. */
  @Test
  void longPicturesAreFine() throws InterruptedException {
    for (NoisyPicture picture : new NoisyPicture[] {noisy(16_384, 1), noisy(2, 16_384)}) {
      float[] clean = BuiltInDenoiser.denoise(picture, 2).image().rgb();
      assertThat(squaredError(clean, picture.width()))
          .as(picture.width() + "x" + picture.height())
          .isLessThan(squaredError(picture.light().mean(), picture.width()) / 2);
    }
  }

  private static double squaredError(float[] values, int width) {
    double sum = 0;
    for (int i = 0; i < values.length; i++) {
      double error = values[i] - truth(i / 3 % width, i / 3 / width);
      sum += error * error;
    }
    return sum / values.length;
  }
}
