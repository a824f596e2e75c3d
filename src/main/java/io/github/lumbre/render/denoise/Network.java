package io.github.lumbre.render.denoise;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.ShortBuffer;

/**
 * The weights of the network: a U-Net of five levels, each half the size of the one before. Each
 * level has two convolutions on the way down, two on the way up, and a head that predicts how its
 * pixels are filtered. {@code src/denoiser/network.py} is the same network, and its training made
 * the weights.
 */
final class Network {
  static final int FEATURES = 16;
  static final int LEVELS = 5;

  /** Side of the predicted kernels, and their number of weights. */
  static final int SIDE = 5;

  static final int TAPS = SIDE * SIDE;

  /** After a kernel's weights, a head predicts these. */
  static final int SHARE = TAPS;

  static final int WEIGHT = TAPS + 1;

  /** At full size alone. */
  static final int MIX = TAPS + 2;

  static final String RESOURCE = "weights.f16";

  /** {@code builtin} and the start of the SHA-256 hash of the weights. */
  static final String NAME = "builtin 1b77145c";

  private static final int[] DOWN = {16, 32, 48, 64, 64};
  private static final int[] UP = {24, 32, 48, 64};

  /**
   * A layer: each output is a weighted sum of taps of all inputs.
   *
   * @param stride the distance of an output's weights from those of the output before: their
   *     number, rounded up to a multiple of three
   * @param weights by output, input and tap; then zeros up to the next output. They have at most 11
   *     significant bits, as {@link Loops#rounded} expects.
   * @param biases a number that each output is added to
   */
  record Layer(int inputs, int outputs, int stride, float[] weights, float[] biases) {}

  private static final class Holder {
    static final Network NETWORK = read();
  }

  private final Layer[][] down = new Layer[LEVELS][];
  private final Layer[][] up = new Layer[LEVELS - 1][];
  private final Layer[] heads = new Layer[LEVELS];

  private Network(byte[] weights) {
    ShortBuffer in = ByteBuffer.wrap(weights).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer();
    for (int level = 0; level < LEVELS; level++) {
      int inputs = level == 0 ? FEATURES : DOWN[level - 1];
      down[level] = new Layer[] {layer(in, inputs, DOWN[level], 9), null};
      down[level][1] = layer(in, DOWN[level], DOWN[level], 9);
    }
    for (int level = 0; level < LEVELS - 1; level++) {
      int inputs = DOWN[level] + (level + 1 < UP.length ? UP[level + 1] : DOWN[LEVELS - 1]);
      up[level] = new Layer[] {layer(in, inputs, UP[level], 9), null};
      up[level][1] = layer(in, UP[level], UP[level], 9);
    }
    for (int level = 0; level < LEVELS; level++) {
      int inputs = level < UP.length ? UP[level] : DOWN[level];
      heads[level] = layer(in, inputs, level == 0 ? MIX + 1 : WEIGHT + 1, 1);
    }
  }

  /** Returns the network, which is read at the first call. */
  static Network get() {
    return Holder.NETWORK;
  }

  private static Network read() {
    try (InputStream in = Network.class.getResourceAsStream(RESOURCE)) {
      return new Network(in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException("the denoiser's weights cannot be read", e);
    }
  }

  private static Layer layer(ShortBuffer in, int inputs, int outputs, int taps) {
    int count = inputs * taps;
    int stride = (count + 2) / 3 * 3;
    float[] weights = new float[stride * outputs];
    for (int o = 0; o < outputs; o++) {
      readHalves(in, weights, o * stride, count);
    }
    float[] biases = new float[outputs];
    readHalves(in, biases, 0, outputs);
    return new Layer(inputs, outputs, stride, weights, biases);
  }

  private static void readHalves(ShortBuffer in, float[] values, int first, int count) {
    short[] halves = new short[count];
    in.get(halves);
    for (int i = 0; i < count; i++) {
      values[first + i] = half(halves[i]);
    }
  }

  /** Returns the value of the bits of a finite IEEE 754 binary16 number. */
  static float half(short bits) {
    int magnitude = bits & 0x7fff;
    float value =
        magnitude < 1024
            ? magnitude * 0x1p-24f
            : Float.intBitsToFloat((magnitude << 13) + (127 - 15 << 23));
    return bits < 0 ? -value : value;
  }

  /** Returns the two convolutions of a level on the way down. */
  Layer[] down(int level) {
    return down[level];
  }

  /** Returns the two convolutions of a level on the way up. */
  Layer[] up(int level) {
    return up[level];
  }

  Layer head(int level) {
    return heads[level];
  }
}
