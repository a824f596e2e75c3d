package io.github.lumbre.texture.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The maxima have the bits of nine lookups in each cell. */
class GridMaximaTest {
  private static final Rgb TINT = new Rgb(.3, 1.7, .9);

  private static Pixels bytes(int width, int height, int channels) {
    byte[] values = new byte[width * height * channels];
    new Random(1).nextBytes(values);
    return Pixels.of(width, height, channels, values);
  }

  private static Pixels shorts(int width, int height) {
    short[] values = new short[width * height * 3];
    Random random = new Random(2);
    for (int i = 0; i < values.length; i++) {
      values[i] = (short) random.nextInt();
    }
    return Pixels.of(width, height, 3, values);
  }

  private static LinearTexture linear(int width, int height) {
    float[] values = new float[width * height * 3];
    Random random = new Random(3);
    for (int i = 0; i < values.length; i++) {
      values[i] = (float) Math.exp(20 * random.nextDouble() - 10);
    }
    return new LinearTexture(new Image(width, height, values, new float[0]));
  }

  private static ImageTexture color(Pixels pixels) {
    return new ImageTexture(pixels, Role.COLOR, Filter.BILINEAR);
  }

  static Stream<Arguments> textures() {
    return Stream.of(
        Arguments.of(color(bytes(37, 19, 3)), 37, 19),
        Arguments.of(color(bytes(64, 32, 4)), 64, 32),
        Arguments.of(color(bytes(1100, 3, 1)), 1100, 3),
        Arguments.of(color(bytes(1, 1, 3)), 1, 1),
        Arguments.of(color(bytes(2, 1, 3)), 2, 1),
        Arguments.of(color(bytes(1, 5, 3)), 1, 5),
        Arguments.of(color(bytes(3, 2, 3)), 3, 2),
        Arguments.of(color(bytes(37, 19, 3)), 5, 7),
        Arguments.of(color(bytes(5, 7, 3)), 37, 19),
        Arguments.of(color(shorts(33, 21)), 33, 21),
        Arguments.of(TintedTexture.of(TINT, color(bytes(37, 19, 3))), 37, 19),
        Arguments.of(linear(41, 23), 41, 23),
        Arguments.of(TintedTexture.of(TINT, linear(41, 23)), 41, 23));
  }

  @ParameterizedTest
  @MethodSource("textures")
  void theyHaveTheBitsOfLookups(Texture<Rgb> texture, int columns, int rows) {
    GridMaxima maxima = GridMaxima.of(texture, columns, rows).orElseThrow();
    double[] found = new double[columns];
    for (int row = 0; row < rows; row++) {
      maxima.read(row, found);
      for (int column = 0; column < columns; column++) {
        double most = 0;
        for (int i = 0; i < 9; i++) {
          double u = GridMaxima.coordinate(column, i % 3, columns);
          double v = GridMaxima.coordinate(row, i / 3, rows);
          most = Math.max(most, texture.at(u, v).max());
        }
        assertThat(found[column]).isEqualTo(most);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 255, 256, 257, 700})
  void theTableHasAllRows(int rows) {
    for (Texture<Rgb> texture : List.of(color(bytes(5, rows, 3)), linear(5, rows))) {
      double[][] table = GridMaxima.table(texture, 5, rows).orElseThrow();
      assertThat(table).hasDimensions(rows, 5);
      GridMaxima maxima = GridMaxima.of(texture, 5, rows).orElseThrow();
      double[] expected = new double[5];
      for (int row = 0; row < rows; row++) {
        maxima.read(row, expected);
        assertThat(table[row]).isEqualTo(expected);
      }
    }
  }

  @Test
  void otherTexturesHaveNone() {
    assertThat(GridMaxima.table(Texture.constant(Rgb.WHITE), 2, 2)).isEmpty();
    ImageTexture nearest = new ImageTexture(bytes(3, 2, 3), Role.COLOR, Filter.NEAREST);
    assertThat(GridMaxima.table(nearest, 3, 2)).isEmpty();
  }
}
