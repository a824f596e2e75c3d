package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.render.denoise.Network.Layer;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the convolutions of the network. */
class ConvolutionTest {
  private static final int WIDTH = 48;
  private static final int ROWS = 5;

  /** Returns maps with values as a network has them: many rows of pixels are 0, some negative. */
  private static Maps maps(Random random, int count) {
    Maps maps = new Maps(WIDTH, -1, ROWS + 2, count);
    for (int i = 0; i < count; i++) {
      for (int y = 0; y < ROWS; y++) {
        int start = random.nextInt(WIDTH);
        int end = start + random.nextInt(WIDTH - start);
        for (int x = start; x < end; x++) {
          float value = random.nextInt(4) == 0 ? -0f : random.nextFloat() - .25f;
          maps.plane(i)[maps.at(y) + x] = Loops.rounded(value);
        }
      }
    }
    return maps;
  }

  /** Returns the computed rows of a layer over a part of the pixels: all that are marked. */
  private static Maps applied(boolean isScalar, Layer layer, Maps[] inputs, int level) {
    Maps out = new Maps(WIDTH, 0, ROWS, layer.outputs());
    FilteredPart part = new FilteredPart(units(level), 0, 0, WIDTH, level);
    Convolution convolution = new Convolution(isScalar);
    convolution.apply(layer, inputs, 0, 2, part, out);
    convolution.apply(layer, inputs, 2, ROWS, part, out);
    return out;
  }

  /** Returns squares, every third of which is not filtered. */
  private static FilteredUnits units(int level) {
    int across = (WIDTH << level) / TileFilter.UNIT;
    boolean[] filtered = new boolean[across * FilteredUnits.count(ROWS << level)];
    for (int i = 0; i < filtered.length; i++) {
      filtered[i] = i % 3 != 1;
    }
    return new FilteredUnits(across, filtered);
  }

  /** The fast compiler's code makes the same pictures, of parts that are any number of pixels. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4})
  void scalarCodeHasTheSameBits(int level) {
    Random random = new Random(level);
    int last = Network.LEVELS - 1;
    Layer layer = level < last ? Network.get().up(level)[0] : Network.get().down(level)[0];
    int first = layer.inputs() / 3;
    Maps[] inputs = {maps(random, first), maps(random, layer.inputs() - first)};
    Maps vectors = applied(false, layer, inputs, level);
    Maps scalars = applied(true, layer, inputs, level);
    int positive = 0;
    for (int o = 0; o < layer.outputs(); o++) {
      assertThat(scalars.plane(o)).isEqualTo(vectors.plane(o));
      for (float value : vectors.plane(o)) {
        positive += value > 0 ? 1 : 0;
      }
    }
    assertThat(positive).isGreaterThan(100);
  }

  /** By the definition, in doubles. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void outputsAreWeightedSums(boolean isScalar) {
    Layer layer = Network.get().down(1)[1];
    Maps in = maps(new Random(7), layer.inputs());
    Maps out = applied(isScalar, layer, new Maps[] {in}, 1);
    int x = 18;
    for (int y = 0; y < 3; y++) {
      for (int o = 0; o < layer.outputs(); o++) {
        double sum = layer.biases()[o];
        for (int i = 0; i < layer.inputs(); i++) {
          for (int t = 0; t < 9; t++) {
            float value = in.plane(i)[in.at(y + t / 3 - 1) + x + t % 3 - 1];
            sum += (double) layer.weights()[o * layer.stride() + 9 * i + t] * value;
          }
        }
        assertThat(out.plane(o)[out.at(y) + x])
            .isCloseTo((float) Math.max(0, sum), within(2e-4f));
      }
    }
  }

  @Test
  void otherPixelsStayAsTheyAre() {
    Layer layer = Network.get().down(0)[1];
    Maps in = maps(new Random(8), layer.inputs());
    for (boolean isScalar : new boolean[] {false, true}) {
      Maps out = applied(isScalar, layer, new Maps[] {in}, 0);
      for (int o = 0; o < out.count(); o++) {
        assertThat(out.plane(o)[out.at(1) + 16]).isZero();
        assertThat(out.plane(o)[out.at(1) + 31]).isZero();
      }
    }
  }
}
