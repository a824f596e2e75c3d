package io.github.lumbre.texture.internal;

import io.github.lumbre.math.internal.Range;
import io.github.lumbre.math.sampling.internal.Hash;
import java.util.ArrayList;
import java.util.List;

/**
 * Turbulence: a sum of value noise in several octaves. Each octave has half the scale and half the
 * weight of the one before. Sources: Perlin 1985, "An Image Synthesizer"; the value lattice is that
 * of Vandevenne's "Texture Generation using Random Noise". Immutable.
 *
 * <p>It is defined on the texels of a width × height texture, and tiles. Each octave has its own
 * lattice with a whole number of cells, stretched slightly where the scale does not divide the
 * size. The last cell's neighbor is the first cell. The value of a cell is a hash, so no table is
 * stored.
 */
final class Noise {
  /** A lattice of random values that covers the texture exactly. */
  private record Octave(long key, int columns, int rows, double weight) {
    double cell(int column, int row) {
      return Hash.unit(Hash.of(key, (long) row * columns + column));
    }
  }

  private final int width;
  private final int height;
  private final double constant;
  private final Octave[] octaves;

  /**
   * Creates a noise function.
   *
   * @param seed the seed of all random numbers
   * @param width in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param height in texels, 1 to {@value TexelTexture#MAX_SIDE}
   * @param coarsest the largest scale S ≥ 1, in texels; the others are S/2, S/4, … ≥ 1
   * @throws IllegalArgumentException if a number is out of range
   */
  public Noise(long seed, int width, int height, double coarsest) {
    Texels.requireSize(width, height);
    Range.FROM_ONE.require("coarsest", coarsest);
    this.width = width;
    this.height = height;
    List<Octave> varying = new ArrayList<>();
    double sum = 0;
    double weight = .5;
    long number = 0;
    // Coarse octaves with a single cell are constant; there can be about a thousand of them.
    for (double scale = coarsest; scale >= 1; scale /= 2) {
      Octave octave =
          new Octave(Hash.of(seed, ++number), cells(width, scale), cells(height, scale), weight);
      if (octave.columns == 1 && octave.rows == 1) {
        sum += weight * octave.cell(0, 0);
      } else {
        varying.add(octave);
      }
      weight /= 2;
    }
    constant = sum;
    octaves = varying.toArray(Octave[]::new);
  }

  private static int cells(int size, double scale) {
    return Math.max(1, (int) Math.round(size / scale));
  }

  /**
   * Returns Σ s · (smooth noise of scale s) / 2S over all scales s, in [0,1). Its mean over all
   * seeds is ½ (1 − 2^-n) for n octaves.
   *
   * @param column counted from the left, 0 to width - 1
   * @param row counted from the top, 0 to height - 1
   */
  public double turbulence(int column, int row) {
    double sum = constant;
    for (Octave octave : octaves) {
      sum += octave.weight * smooth(octave, column, row);
    }
    return sum;
  }

  /** Interpolates bilinearly between the values of a cell and its next neighbors. */
  private double smooth(Octave octave, int column, int row) {
    int x = column * octave.columns;
    int y = row * octave.rows;
    int x0 = x / width;
    int y0 = y / height;
    double s = (double) (x - x0 * width) / width;
    double t = (double) (y - y0 * height) / height;
    // Save three hashes if the texel is a corner of the lattice, as all are at scale 1.
    if (s == 0 && t == 0) {
      return octave.cell(x0, y0);
    }
    int x1 = x0 + 1 < octave.columns ? x0 + 1 : 0;
    int y1 = y0 + 1 < octave.rows ? y0 + 1 : 0;
    return Bilinear.mix(
        Bilinear.mix(octave.cell(x0, y0), octave.cell(x1, y0), s),
        Bilinear.mix(octave.cell(x0, y1), octave.cell(x1, y1), s),
        t);
  }
}
