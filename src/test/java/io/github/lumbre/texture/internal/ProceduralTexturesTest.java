package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import java.util.HashSet;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the values and the tiling of procedural textures. */
class ProceduralTexturesTest {
  private static final double SMALL = 1e-12;

  /** One of each kind, with the format's defaults. */
  enum Kind {
    WOOD {
      @Override
      TexelTexture texture(long seed, int width, int height) {
        return new WoodTexture(seed, width, height, 10);
      }
    },
    MARBLE {
      @Override
      TexelTexture texture(long seed, int width, int height) {
        return new MarbleTexture(seed, width, height);
      }
    },
    CLOUD {
      @Override
      TexelTexture texture(long seed, int width, int height) {
        return new CloudTexture(seed, width, height, 128);
      }
    },
    VORONOI {
      @Override
      TexelTexture texture(long seed, int width, int height) {
        return new VoronoiTexture(seed, width, height, 10, false);
      }
    },
    GRAY_VORONOI {
      @Override
      TexelTexture texture(long seed, int width, int height) {
        return new VoronoiTexture(seed, width, height, 200, true);
      }
    };

    abstract TexelTexture texture(long seed, int width, int height);
  }

  private static boolean isInUnitRange(Rgb c) {
    return c.r() >= 0 && c.r() <= 1 && c.g() >= 0 && c.g() <= 1 && c.b() >= 0 && c.b() <= 1;
  }

  /** Checks the corners and random texels. */
  private static void assertInUnitRange(TexelTexture texture) {
    SplittableRandom random = new SplittableRandom(1);
    int right = texture.width() - 1;
    int bottom = texture.height() - 1;
    assertThat(texture.texel(0, 0)).matches(ProceduralTexturesTest::isInUnitRange);
    assertThat(texture.texel(right, bottom)).matches(ProceduralTexturesTest::isInUnitRange);
    for (int i = 0; i < 100; i++) {
      assertThat(texture.texel(random.nextInt(right + 1), random.nextInt(bottom + 1)))
          .matches(ProceduralTexturesTest::isInUnitRange);
    }
  }

  private static double distance(Rgb a, Rgb b) {
    return Math.max(
        Math.abs(a.r() - b.r()), Math.max(Math.abs(a.g() - b.g()), Math.abs(a.b() - b.b())));
  }

  @ParameterizedTest
  @EnumSource
  void valuesOfAllSizesLieInTheUnitRange(Kind kind) {
    int[] sizes = {1, 2, 3, 31, 32, 33, 500, 1000, 4096};
    for (int width : sizes) {
      for (int height : sizes) {
        assertInUnitRange(kind.texture(width, width, height));
      }
    }
    assertInUnitRange(kind.texture(1, 16384, 16384));
    assertInUnitRange(kind.texture(1, 16384, 1));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1, .3, 1e6, 1e18, 1e300, Double.MAX_VALUE})
  void anyNumberOfRingsGivesWood(double rings) {
    assertInUnitRange(new WoodTexture(2, 77, 33, rings));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 128, 1e6, 1e300, Double.MAX_VALUE})
  void anyDensityFromOneGivesClouds(double density) {
    assertInUnitRange(new CloudTexture(2, 77, 33, density));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 1000, 1_000_000})
  void anyNumberOfSamplesGivesCells(int samples) {
    assertInUnitRange(new VoronoiTexture(2, 77, 33, samples, false));
    assertInUnitRange(new VoronoiTexture(2, 1, 4096, samples, true));
  }

  @ParameterizedTest
  @EnumSource
  void bordersMeetLikeTheInside(Kind kind) {
    int[][] sizes = {{300, 200}, {128, 257}, {500, 500}};
    for (int[] size : sizes) {
      TexelTexture texture = kind.texture(size[0], size[0], size[1]);
      double inside = 0;
      double border = 0;
      for (int y = 0; y < size[1]; y++) {
        for (int x = 0; x < size[0]; x++) {
          Rgb here = texture.texel(x, y);
          double right = distance(here, texture.texel((x + 1) % size[0], y));
          double below = distance(here, texture.texel(x, (y + 1) % size[1]));
          border = Math.max(border, x == size[0] - 1 ? right : 0);
          border = Math.max(border, y == size[1] - 1 ? below : 0);
          inside = Math.max(inside, x < size[0] - 1 ? right : 0);
          inside = Math.max(inside, y < size[1] - 1 ? below : 0);
        }
      }
      assertThat(border).isPositive().isLessThanOrEqualTo(inside);
    }
  }

  @ParameterizedTest
  @EnumSource
  void anotherSeedGivesAnotherTexture(Kind kind) {
    for (long seed : new long[] {0, 1, -1, Long.MAX_VALUE}) {
      TexelTexture one = kind.texture(seed, 200, 100);
      TexelTexture same = kind.texture(seed, 200, 100);
      TexelTexture other = kind.texture(seed + 1, 200, 100);
      int different = 0;
      for (int i = 0; i < 20_000; i++) {
        Rgb value = one.texel(i % 200, i / 200);
        assertThat(same.texel(i % 200, i / 200)).isEqualTo(value);
        different += value.equals(other.texel(i % 200, i / 200)) ? 0 : 1;
      }
      assertThat(different).isGreaterThan(10_000);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "WOOD, 0.20295927472101855, 0.55699734149978",
    "MARBLE, 0.9900392614940966, 0.9973833150342428",
    "CLOUD, 0.8650740724350635, 0.8468785944328776",
    "VORONOI, 0.3280767391525029, 0.9007606806068834",
    "GRAY_VORONOI, 0.6447043917399394, 0.01678829452815611"
  })
  void valuesAreTheSameOnEveryMachine(Kind kind, double inside, double lastCorner) {
    TexelTexture texture = kind.texture(7, 500, 300);
    assertThat(texture.texel(123, 45).g()).isEqualTo(inside);
    assertThat(texture.texel(499, 299).g()).isEqualTo(lastCorner);
  }

  @ParameterizedTest
  @EnumSource
  void pointsHaveTheValueOfTheTexelThatAPictureWouldShow(Kind kind) {
    int width = 30;
    int height = 20;
    TexelTexture texture = kind.texture(4, width, height);
    short[] indices = new short[3 * width * height];
    for (int i = 0; i < width * height; i++) {
      indices[3 * i] = (short) (i % width);
      indices[3 * i + 1] = (short) (i / width);
    }
    ImageTexture picture =
        new ImageTexture(Pixels.of(width, height, 3, indices), Role.DATA, Filter.NEAREST);
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 2000; i++) {
      TexturePoint p = new TexturePoint(random.nextDouble(-3, 3), random.nextDouble(-3, 3));
      Rgb place = picture.at(p).times(65535);
      Rgb texel = texture.texel((int) Math.rint(place.r()), (int) Math.rint(place.g()));
      assertThat(texture.at(p)).isEqualTo(texel);
    }
    assertThat(texture.at(new TexturePoint(Double.NaN, .5)))
        .isEqualTo(texture.texel(0, height - 1));
  }

  @ParameterizedTest
  @EnumSource
  void interpolationIsContinuousAndMeetsTheTexels(Kind kind) {
    TexelTexture texture = kind.texture(4, 30, 20);
    BilinearTexture smooth = new BilinearTexture(texture);
    for (int i = 0; i < 600; i++) {
      TexturePoint center = new TexturePoint((i % 30 + .5) / 30, (i / 30 + .5) / 20);
      assertThat(distance(smooth.at(center), texture.at(center))).isLessThan(SMALL);
      Rgb between = smooth.at(new TexturePoint((i % 30 + 1.0) / 30, center.v()));
      Rgb next = texture.at(new TexturePoint((i % 30 + 1.5) / 30, center.v()));
      assertThat(distance(between, texture.at(center).plus(next).times(.5))).isLessThan(SMALL);
    }
  }

  @Test
  void woodIsTheFormulaOfItsNoise() {
    Noise noise = new Noise(8, 400, 200, 32);
    TexelTexture wood = new WoodTexture(8, 400, 200, 6);
    for (int i = 0; i < 400; i++) {
      int row = i * 7 % 200;
      double d = Math.hypot((i - 200) / 400.0, (row - 100) / 200.0);
      double s = Math.abs(Math.sin(2 * Math.PI * 6 * (d + .035 * noise.turbulence(i, row)))) / 2;
      assertThat(distance(wood.texel(i, row), new Rgb(80 / 255.0 + s, 30 / 255.0 + s, 30 / 255.0)))
          .isLessThan(SMALL);
    }
  }

  @Test
  void marbleIsTheFormulaOfItsNoise() {
    Noise noise = new Noise(8, 400, 200, 128);
    TexelTexture marble = new MarbleTexture(8, 400, 200);
    for (int i = 0; i < 400; i++) {
      int row = i * 7 % 200;
      double halfTurns = 5 * i / 400.0 + 10 * row / 200.0 + 4 * noise.turbulence(i, row);
      assertThat(distance(marble.texel(i, row), Rgb.gray(Math.abs(Math.sin(Math.PI * halfTurns)))))
          .isLessThan(SMALL);
    }
  }

  @Test
  void cloudsAreTheFormulaOfTheirNoise() {
    Noise noise = new Noise(8, 400, 200, 50);
    TexelTexture cloud = new CloudTexture(8, 400, 200, 50);
    for (int i = 0; i < 400; i++) {
      double t = noise.turbulence(i, i / 2);
      assertThat(distance(cloud.texel(i, i / 2), new Rgb(t, .753 + .247 * t, 1))).isLessThan(SMALL);
    }
  }

  @ParameterizedTest
  @CsvSource({"30, 500, 500", "7, 300, 100", "100, 1000, 50", "13, 20, 700"})
  void everySampleHasACell(int samples, int width, int height) {
    TexelTexture texture = new VoronoiTexture(6, width, height, samples, false);
    Set<Rgb> colors = new HashSet<>();
    for (int i = 0; i < width * height; i++) {
      colors.add(texture.texel(i % width, i / width));
    }
    assertThat(colors).hasSize(samples);
  }

  /**
   * With one sample per texel of a line, most samples are nearest to the center of their own texel.
   */
  @Test
  void cellsLieAroundTheirSamples() {
    int own = 0;
    int count = 400;
    for (int seed = 0; seed < count; seed++) {
      Rgb first = new VoronoiTexture(seed, 1, 1, 1, false).texel(0, 0);
      own += new VoronoiTexture(seed, 20, 1, 20, false).texel(0, 0).equals(first) ? 1 : 0;
      own += new VoronoiTexture(seed, 1, 20, 20, false).texel(0, 0).equals(first) ? 1 : 0;
    }
    assertThat(own).isGreaterThan(count);
  }

  @Test
  void blackAndWhiteCellsAreGray() {
    TexelTexture texture = new VoronoiTexture(6, 100, 100, 30, true);
    for (int i = 0; i < 10_000; i++) {
      Rgb c = texture.texel(i % 100, i / 100);
      assertThat(c).isEqualTo(Rgb.gray(c.r()));
    }
  }

  @Test
  void manyThreadsSeeTheSameTexture() {
    TexelTexture shared = new MarbleTexture(1, 300, 300);
    TexelTexture own = new MarbleTexture(1, 300, 300);
    double[] seen =
        IntStream.range(0, 90_000)
            .parallel()
            .mapToDouble(i -> shared.texel(i * 7 % 300, i / 300).r())
            .toArray();
    for (int i = 0; i < seen.length; i++) {
      assertThat(seen[i]).isEqualTo(own.texel(i * 7 % 300, i / 300).r());
    }
  }

  @Test
  void sizesAndNumbersOutsideTheirRangesAreRefused() {
    assertThatThrownBy(() -> new MarbleTexture(0, 0, 5))
        .hasMessage("width and height: expected 1 to 16384, found 0x5");
    assertThatThrownBy(() -> new VoronoiTexture(0, 5, 16385, 10, true))
        .hasMessage("width and height: expected 1 to 16384, found 5x16385");
    assertThatThrownBy(() -> new VoronoiTexture(0, -1, 5, 10, true))
        .hasMessage("width and height: expected 1 to 16384, found -1x5");
    assertThatThrownBy(() -> new VoronoiTexture(0, 5, 5, 0, true))
        .hasMessage("samples: expected 1 to 1000000, found 0");
    assertThatThrownBy(() -> new WoodTexture(0, 5, 5, -1))
        .hasMessage("rings: expected a finite number >= 0, found -1.0");
  }
}
