package io.github.lumbre.image.format.ktx;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.image.ImageFormatException;

/**
 * Decodes a slice: the colors of a picture, or its alpha (BasisLZ/ETC1S Bitstream Specification,
 * ETC1S slice decoding). Mutable.
 */
final class Etc1sSlice {
  private static final int LEFT = 0;
  private static final int ABOVE = 1;
  private static final int ABOVE_LEFT = 2;

  /** The symbol after those of four predictions of 2 bits: the last symbol is repeated. */
  private static final int REPEAT = 256;

  private static final int MIN_RUN = 3;
  private static final int LONG_RUN = 63;
  private static final int ALPHA = 3;

  private final BasisBits in;
  private final Etc1sCodeBooks books;
  private final Etc1sTables tables;
  private final TexelBlocks target;
  private final boolean isAlpha;
  private final int[] texels = new int[TexelBlocks.SIDE * TexelBlocks.SIDE];

  /** Indices of colors in two rows of blocks. */
  private final int[][] endpoints;

  /** Predictions for the odd row, by pairs of columns. */
  private final int[] below;

  private int lastEndpoint;
  private int predictions;
  private int lastPredictions;
  private long predictionRun;

  private final RecentSelectors recent;
  private long selectorRun;

  /**
   * @param isAlpha whether the green channel becomes the alpha of the target; otherwise its colors
   *     are written
   */
  Etc1sSlice(
      KtxInput in, Etc1sCodeBooks books, Etc1sTables tables, TexelBlocks target, boolean isAlpha) {
    this.in = new BasisBits(in);
    this.books = books;
    this.tables = tables;
    this.target = target;
    this.isAlpha = isAlpha;
    endpoints = new int[2][target.columns()];
    below = new int[(target.columns() + 1) / 2];
    recent = new RecentSelectors(tables.recent());
  }

  /** Decodes all blocks. */
  void decode() throws ImageFormatException {
    for (int row = 0; row < target.rows(); row++) {
      Interrupts.check();
      for (int column = 0; column < target.columns(); column++) {
        lastEndpoint = endpoint(column, row);
        endpoints[row & 1][column] = lastEndpoint;
        put(column, row, books.selectors()[selector()]);
      }
    }
  }

  private void put(int column, int row, int selectors) {
    for (int i = 0; i < texels.length; i++) {
      int color = books.colors()[Etc1sCodeBooks.COLORS * lastEndpoint + (selectors >>> 2 * i & 3)];
      texels[i] = isAlpha ? color << 2 * Byte.SIZE : color;
    }
    target.put(column, row, texels, isAlpha ? ALPHA : 0, isAlpha ? ALPHA + 1 : ALPHA);
  }

  private int endpoint(int column, int row) throws ImageFormatException {
    if ((column & 1) == 0) {
      predictions = (row & 1) == 0 ? nextPredictions() : below[column / 2];
      below[column / 2] = predictions >> 4;
    }
    int prediction = predictions & 3;
    predictions >>= 2;
    boolean isOutside = column == 0 && prediction != ABOVE || row == 0 && prediction != LEFT;
    int count = books.colors().length / Etc1sCodeBooks.COLORS;
    if (prediction > ABOVE_LEFT) {
      int index = lastEndpoint + tables.endpoints().decode(in);
      index -= index >= count ? count : 0;
      return require("colors", index, count);
    }
    if (isOutside) {
      throw in.damaged("repeats a block outside the picture");
    }
    int[] above = endpoints[row & 1 ^ 1];
    return switch (prediction) {
      case LEFT -> lastEndpoint;
      case ABOVE -> above[column];
      default -> above[column - 1];
    };
  }

  /** Returns the predictions of four blocks, 2 bits each: two of a row, and two below. */
  private int nextPredictions() throws ImageFormatException {
    if (predictionRun > 0) {
      predictionRun--;
      return lastPredictions;
    }
    int symbol = tables.predictions().decode(in);
    if (symbol == REPEAT) {
      predictionRun = in.readChunks(4) + MIN_RUN - 1;
    } else {
      lastPredictions = symbol;
    }
    return lastPredictions;
  }

  private int selector() throws ImageFormatException {
    int count = books.selectors().length;
    int symbol = count;
    if (selectorRun > 0) {
      selectorRun--;
    } else {
      symbol = tables.selectors().decode(in);
      if (symbol == count + recent.size()) {
        int run = tables.runs().decode(in);
        selectorRun = (run == LONG_RUN ? in.readChunks(7) : run) + MIN_RUN - 1;
        symbol = count;
      }
    }
    if (symbol >= count) {
      int index = require("recent selectors", symbol - count, recent.size());
      return require("selectors", recent.use(index), count);
    }
    recent.add(symbol);
    return symbol;
  }

  private int require(String things, int index, int count) throws ImageFormatException {
    if (index >= count) {
      throw in.damaged("expected one of %d %s, found number %d".formatted(count, things, index));
    }
    return index;
  }

  /**
   * Indices of selectors that were used lately, roughly the latest first (BasisLZ/ETC1S Bitstream
   * Specification, approximate move to front). Mutable.
   */
  private static final class RecentSelectors {
    private final int[] values;
    private int next;

    RecentSelectors(int size) {
      values = new int[size];
      next = size / 2;
    }

    int size() {
      return values.length;
    }

    void add(int selector) {
      values[next] = selector;
      next = next + 1 == values.length ? values.length / 2 : next + 1;
    }

    /** Returns a selector, and moves it forward. */
    int use(int index) {
      int selector = values[index];
      values[index] = values[index / 2];
      values[index / 2] = selector;
      return selector;
    }
  }
}
