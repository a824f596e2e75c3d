package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.RoundingMode;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the lookup, filtering and decoding of image textures. */
class ImageTextureTest {
  private static final double EPS = Math.ulp(1.0);

  private static Pixels random(int width, int height, int channels) {
    byte[] values = new byte[width * height * channels];
    new SplittableRandom(width).nextBytes(values);
    return Pixels.of(width, height, channels, values);
  }

  /** Returns a texture whose red is exactly the column and green the row from the bottom. */
  private static ImageTexture indices(int width, int height) {
    short[] values = new short[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      values[3 * i] = (short) (i % width);
      values[3 * i + 1] = (short) (height - 1 - i / width);
    }
    return new ImageTexture(Pixels.of(width, height, 3, values), Role.DATA, Filter.NEAREST);
  }

  private static long column(ImageTexture indices, double u) {
    return Math.round(65535 * indices.at(new TexturePoint(u, 0)).r());
  }

  private static long row(ImageTexture indices, double v) {
    return Math.round(65535 * indices.at(new TexturePoint(0, v)).g());
  }

  /** Returns the index by exact arithmetic: floor(u · size) mod size. */
  private static long exactIndex(double u, int size) {
    BigDecimal floor =
        new BigDecimal(u).multiply(BigDecimal.valueOf(size)).setScale(0, RoundingMode.FLOOR);
    return floor.toBigInteger().mod(BigInteger.valueOf(size)).longValueExact();
  }

  private static TexturePoint somewhere(SplittableRandom random) {
    return new TexturePoint(random.nextDouble(-3, 3), random.nextDouble(-3, 3));
  }

  @ParameterizedTest
  @EnumSource
  void aSingleTexelIsEverywhere(Filter filter) {
    ImageTexture texture =
        new ImageTexture(Pixels.of(1, 1, 3, new byte[] {10, 20, 30}), Role.COLOR, filter);
    Rgb texel = new Rgb(Srgb.fromByte(10), Srgb.fromByte(20), Srgb.fromByte(30));
    double[] extremes = {
      0, -0.0, 1, -1, .5, -1e-20, 1e-300, 1e9 + .25, -1e300, Double.MAX_VALUE, 1 - 0x1p-53
    };
    for (double u : extremes) {
      for (double v : extremes) {
        assertThat(texture.at(new TexturePoint(u, v))).isEqualTo(texel);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"3, 5", "1000, 999", "1, 7", "64, 64"})
  void nearestFindsTheTexelThatThePointLiesIn(int width, int height) {
    ImageTexture texture = indices(width, height);
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 5000; i++) {
      TexturePoint p = somewhere(random);
      assertThat(column(texture, p.u())).isEqualTo(exactIndex(p.u(), width));
      assertThat(row(texture, p.v())).isEqualTo(exactIndex(p.v(), height));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 5, 7, 1000, 999, 16384})
  void extremesStayInsideTheirRange(int size) {
    ImageTexture texture = indices(size, 1);
    ImageTexture tall = indices(1, size);
    double[] extremes = {
      -0.0,
      0,
      1,
      -1,
      2,
      -7,
      1e9,
      -1e-20,
      -Double.MIN_VALUE,
      -0x1p-54,
      1 - 0x1p-53,
      Math.nextUp(-1.0),
      Math.nextDown(-1.0),
      Double.MIN_VALUE,
      1e300,
      -1e300
    };
    for (double u : extremes) {
      assertThat(column(texture, u)).as("u = %s", u).isEqualTo(exactIndex(u, size));
      assertThat(row(tall, u)).as("v = %s", u).isEqualTo(exactIndex(u, size));
    }
  }

  @Test
  void farTilesAreReadAtTheirFraction() {
    ImageTexture texture = indices(1000, 1);
    assertThat(column(texture, 1e9 + .25)).isEqualTo(250);
    assertThat(column(texture, -1e9 - .25)).isEqualTo(750);
  }

  /** In a billion tiles, positions are exact to an ulp, which is 1e-7 of a tile. */
  @Test
  void aBillionTilesAreReadAtTheirFraction() {
    Texture<Rgb> tiled = new UvMapping(0, 0, 1e9, 1e9).over(indices(1000, 1));
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 10_000; i++) {
      double u = random.nextDouble();
      double exactly =
          new BigDecimal(u)
              .multiply(BigDecimal.valueOf(1_000_000_000L))
              .remainder(BigDecimal.ONE)
              .doubleValue();
      double found = 65535 * tiled.at(new TexturePoint(u, .5)).r();
      double off = Math.abs(found + .5 - 1000 * exactly);
      assertThat(Math.min(off, 1000 - off)).isLessThan(.5 + 1000 * Math.ulp(1e9));
    }
  }

  @ParameterizedTest
  @EnumSource
  void whatIsNotFiniteIsReadAtTheOriginAndCounted(Filter filter) {
    ImageTexture texture = new ImageTexture(random(3, 5, 3), Role.COLOR, filter);
    Rgb origin = texture.at(new TexturePoint(0, 0));
    InvalidCoordinates.take();
    double[] odd = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (double value : odd) {
      assertThat(texture.at(new TexturePoint(value, .7))).isEqualTo(origin);
      assertThat(texture.at(new TexturePoint(.7, value))).isEqualTo(origin);
    }
    assertThat(InvalidCoordinates.take()).isEqualTo(2L * odd.length);
    assertThat(InvalidCoordinates.take()).isZero();
  }

  @Test
  void theBottomRowIsAtZero() {
    Pixels pixels = Pixels.of(1, 2, 1, new byte[] {0, (byte) 255});
    ImageTexture texture = new ImageTexture(pixels, Role.DATA, Filter.NEAREST);
    assertThat(texture.at(new TexturePoint(0, 0))).isEqualTo(Rgb.WHITE);
    assertThat(texture.at(new TexturePoint(0, .9))).isEqualTo(Rgb.BLACK);
  }

  @Test
  void rolesDecodeAllValues() {
    byte[] values = new byte[256];
    for (int i = 0; i < 256; i++) {
      values[i] = (byte) i;
    }
    Pixels pixels = Pixels.of(256, 1, 1, values);
    ImageTexture color = new ImageTexture(pixels, Role.COLOR, Filter.NEAREST);
    ImageTexture data = new ImageTexture(pixels, Role.DATA, Filter.NEAREST);
    ImageTexture normal = new ImageTexture(pixels, Role.NORMAL, Filter.NEAREST);
    for (int i = 0; i < 256; i++) {
      TexturePoint p = new TexturePoint((i + .5) / 256, 0);
      assertThat(color.at(p)).isEqualTo(Rgb.gray(Srgb.decode(i / 255.0)));
      assertThat(data.at(p)).isEqualTo(Rgb.gray(i / 255.0));
      assertThat(normal.at(p)).isEqualTo(Rgb.gray(Math.max(-1, (i - 128) / 127.0)));
    }
  }

  @Test
  void sixteenBitsDecodeLikeEight() {
    short[] values = {0, (short) 32768, (short) 65535};
    Pixels pixels = Pixels.of(1, 1, 3, values);
    TexturePoint p = new TexturePoint(.5, .5);
    assertThat(new ImageTexture(pixels, Role.COLOR, Filter.NEAREST).at(p))
        .isEqualTo(new Rgb(0, Srgb.decode(32768 / 65535.0), 1));
    assertThat(new ImageTexture(pixels, Role.DATA, Filter.NEAREST).at(p))
        .isEqualTo(new Rgb(0, 32768 / 65535.0, 1));
    assertThat(new ImageTexture(pixels, Role.NORMAL, Filter.NEAREST).at(p))
        .isEqualTo(new Rgb(-1, 0, 1));
  }

  @ParameterizedTest
  @CsvSource({"3, 5", "1000, 999", "1, 1", "2, 1"})
  void bilinearIsTheWeightedMeanOfFourCenters(int width, int height) {
    Pixels pixels = random(width, height, 3);
    ImageTexture texture = new ImageTexture(pixels, Role.COLOR, Filter.BILINEAR);
    SplittableRandom random = new SplittableRandom(6);
    for (int i = 0; i < 2000; i++) {
      TexturePoint p = somewhere(random);
      double x = (p.u() - Math.floor(p.u())) * width - .5;
      double y = (p.v() - Math.floor(p.v())) * height - .5;
      double expected = 0;
      for (int dy = 0; dy < 2; dy++) {
        for (int dx = 0; dx < 2; dx++) {
          int column = Math.floorMod((int) Math.floor(x) + dx, width);
          int row = height - 1 - Math.floorMod((int) Math.floor(y) + dy, height);
          double s = x - Math.floor(x);
          double t = y - Math.floor(y);
          expected +=
              (dx == 0 ? 1 - s : s)
                  * (dy == 0 ? 1 - t : t)
                  * Srgb.fromByte(pixels.raw(column, row, 1));
        }
      }
      assertThat(texture.at(p).g()).isCloseTo(expected, within(4 * EPS));
    }
  }

  @Test
  void bilinearKeepsARampLinear() {
    int size = 256;
    byte[] values = new byte[size * size * 3];
    for (int i = 0; i < size * size; i++) {
      values[3 * i] = (byte) (i % size);
      values[3 * i + 1] = (byte) (size - 1 - i / size);
    }
    ImageTexture texture =
        new ImageTexture(Pixels.of(size, size, 3, values), Role.DATA, Filter.BILINEAR);
    SplittableRandom random = new SplittableRandom(8);
    for (int i = 0; i < 10_000; i++) {
      double u = random.nextDouble(.5 / size, 1 - .5 / size);
      double v = random.nextDouble(.5 / size, 1 - .5 / size);
      Rgb value = texture.at(new TexturePoint(u, v));
      assertThat(value.r()).isCloseTo((u * size - .5) / 255, within(4 * EPS));
      assertThat(value.g()).isCloseTo((v * size - .5) / 255, within(4 * EPS));
    }
  }

  @Test
  void bilinearMeetsTheTexelsAtTheirCenters() {
    Pixels pixels = random(8, 4, 3);
    ImageTexture nearest = new ImageTexture(pixels, Role.COLOR, Filter.NEAREST);
    ImageTexture bilinear = new ImageTexture(pixels, Role.COLOR, Filter.BILINEAR);
    for (int y = 0; y < 4; y++) {
      for (int x = 0; x < 8; x++) {
        TexturePoint center = new TexturePoint((x + .5) / 8, (y + .5) / 4);
        assertThat(bilinear.at(center)).isEqualTo(nearest.at(center));
      }
    }
  }

  @Test
  void bilinearIsContinuousAcrossTheBorders() {
    ImageTexture texture = new ImageTexture(random(3, 5, 3), Role.COLOR, Filter.BILINEAR);
    for (double other : new double[] {0, .1, .5, .99}) {
      assertClose(texture, new TexturePoint(-1e-20, other), new TexturePoint(0, other));
      assertClose(texture, new TexturePoint(1 - 0x1p-53, other), new TexturePoint(1, other));
      assertClose(texture, new TexturePoint(other, -1e-20), new TexturePoint(other, 0));
      assertClose(texture, new TexturePoint(other, 1 - 0x1p-53), new TexturePoint(other, 1));
    }
  }

  private static void assertClose(ImageTexture texture, TexturePoint a, TexturePoint b) {
    assertThat(texture.at(a).r()).isCloseTo(texture.at(b).r(), within(1e-14));
    assertThat(texture.at(a).b()).isCloseTo(texture.at(b).b(), within(1e-14));
  }

  @ParameterizedTest
  @EnumSource
  void interpolatedValuesStayInsideTheirRange(Filter filter) {
    ImageTexture texture = new ImageTexture(random(4, 4, 1), Role.NORMAL, filter);
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 5000; i++) {
      assertThat(texture.at(somewhere(random)).r()).isBetween(-1.0, 1.0);
    }
  }

  @Test
  void theSizeIsThePictures() {
    ImageTexture texture = indices(3, 5);
    assertThat(texture.width()).isEqualTo(3);
    assertThat(texture.height()).isEqualTo(5);
  }
}
