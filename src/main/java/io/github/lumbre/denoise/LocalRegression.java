package io.github.lumbre.denoise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;

/**
 * Explains a picture around some pixels, the <i>anchors</i>, as a linear function of features and
 * of the position, by weighted least squares over similar pixels, and blends the explanations
 * (Bitterli, Rousselle, Moon, Iglesias-Guitián, Adler, Mitchell, Jarosz &amp; Novák 2016,
 * "Nonlinearly Weighted First-order Regression for Denoising Monte Carlo Renderings"). Unlike in
 * the paper, not every pixel is an anchor, but one of 16, and each pixel that these do not explain
 * well (Moon, Iglesias-Guitian, Yoon &amp; Mitchell 2015, "Adaptive Rendering with Linear
 * Predictions").
 *
 * @param similarity tells the weights; its features are those of the regression
 * @param radius half of the side of the square in which pixels are compared
 * @param isFirstOrder whether the position is a feature
 */
record LocalRegression(Similarity similarity, int radius, boolean isFirstOrder) {
  private static final int STRIDE = 4;

  /** Rows of pixels whose anchors one task explains. */
  private static final int ROWS = 32;

  /** Pixels with less weight than this become anchors too. */
  private static final float ENOUGH = 3;

  private static final double RIDGE = 1e-3;
  private static final double FEATURE_RIDGE = 1e-2;

  /**
   * Returns the blended explanations of some channels.
   *
   * @throws InterruptedException if the thread is interrupted
   */
  Raster of(Raster target, ExecutorService threads) throws InterruptedException {
    Raster none = new Raster(target.width(), target.height(), 1);
    Arrays.fill(none.values(), Float.POSITIVE_INFINITY);
    Raster sums = new Raster(target.width(), target.height(), target.channels() + 1);
    addAll(target, none, true, sums, threads);
    addAll(target, sums.part(target.channels(), 1), false, sums, threads);
    Raster result = new Raster(target.width(), target.height(), target.channels());
    for (int i = 0; i < target.pixels(); i++) {
      float weight = sums.values()[i * sums.channels() + target.channels()];
      for (int c = 0; c < target.channels(); c++) {
        result.values()[i * target.channels() + c] =
            sums.values()[i * sums.channels() + c] / weight;
      }
    }
    return result;
  }

  /** Adds the explanations of all anchors to sums, in the same order for any number of threads. */
  private void addAll(
      Raster target, Raster explained, boolean isGrid, Raster sums, ExecutorService threads)
      throws InterruptedException {
    int height = target.height();
    List<Callable<Stripe>> tasks = new ArrayList<>();
    for (int first = 0; first < height; first += ROWS) {
      int top = first;
      tasks.add(() -> stripe(target, explained, isGrid, top));
    }
    try {
      for (var done : threads.invokeAll(tasks)) {
        Stripe stripe = done.get();
        for (int i = 0; i < stripe.sums.length; i++) {
          sums.values()[stripe.first + i] += stripe.sums[i];
        }
      }
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    }
  }

  /**
   * The sums of the explanations of some rows of anchors.
   *
   * @param first index of the first sum in the raster of all
   */
  private record Stripe(int first, float[] sums) {}

  private Stripe stripe(Raster target, Raster explained, boolean isGrid, int top)
      throws InterruptedException {
    int width = target.width();
    int height = target.height();
    int bottom = Math.min(height, top + ROWS);
    int start = Math.max(0, top - radius);
    int end = Math.min(height, bottom + radius);
    int channels = target.channels() + 1;
    Stripe stripe =
        new Stripe(start * width * channels, new float[(end - start) * width * channels]);
    LeastSquares model = new LeastSquares(features(), target.channels());
    Neighborhoods near = new Neighborhoods(similarity, radius);
    for (int y = top; y < bottom; y += Neighborhoods.TILE_HEIGHT) {
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      for (int x = 0; x < width; x += Neighborhoods.TILE_WIDTH) {
        findAnchors(near, explained, isGrid, x, y);
        near.weigh();
        for (int k = 0; k < near.count(); k++) {
          fit(target, model, near, k);
          add(model, near, k, channels, stripe);
        }
      }
    }
    return stripe;
  }

  private static void findAnchors(
      Neighborhoods near, Raster explained, boolean isGrid, int left, int top) {
    near.start(top);
    int right = Math.min(explained.width(), left + Neighborhoods.TILE_WIDTH);
    int bottom = Math.min(explained.height(), top + Neighborhoods.TILE_HEIGHT);
    for (int y = top; y < bottom; y++) {
      for (int x = left; x < right; x++) {
        if (isGrid
            ? y % STRIDE == STRIDE / 2 && x % STRIDE == STRIDE / 2
            : explained.value(x, y, 0) < ENOUGH) {
          near.add(x);
        }
      }
      near.endRow();
    }
  }

  /** Returns the number of terms of the linear function. */
  private int features() {
    return 1 + similarity.features().channels() + (isFirstOrder ? 2 : 0);
  }

  private void fit(Raster target, LeastSquares model, Neighborhoods near, int anchor) {
    int width = target.width();
    int px = near.x(anchor);
    int py = near.y(anchor);
    model.clear();
    double sum = 0;
    int bottom = Math.min(target.height() - 1, py + radius);
    for (int qy = Math.max(0, py - radius); qy <= bottom; qy++) {
      for (int qx = Math.max(0, px - radius); qx <= Math.min(width - 1, px + radius); qx++) {
        float weight = near.weight(anchor, qx - px, qy - py);
        if (weight != 0) {
          sum += weight;
          setTerms(model.terms(), px, py, qx, qy);
          model.add(weight, target.values(), (qy * width + qx) * target.channels());
        }
      }
    }
    solve(model, py * width + px, sum);
  }

  /** Solves with a ridge: terms that are noisy or hardly vary have small coefficients. */
  private void solve(LeastSquares model, int p, double sum) {
    int count = similarity.features().channels();
    for (int c = 0; c < count; c++) {
      float variance = similarity.featureVariance().values()[p * count + c];
      model.addRidge(1 + c, sum * (RIDGE + variance) + FEATURE_RIDGE);
    }
    for (int i = 1 + count; i < features(); i++) {
      model.addRidge(i, sum * RIDGE + 1);
    }
    model.solve();
  }

  private void setTerms(double[] terms, int px, int py, int qx, int qy) {
    Raster features = similarity.features();
    int count = features.channels();
    int p = (py * features.width() + px) * count;
    int q = (qy * features.width() + qx) * count;
    terms[0] = 1;
    for (int c = 0; c < count; c++) {
      terms[1 + c] = features.values()[q + c] - features.values()[p + c];
    }
    if (isFirstOrder) {
      terms[1 + count] = (qx - px) / (double) radius;
      terms[2 + count] = (qy - py) / (double) radius;
    }
  }

  private void add(
      LeastSquares model, Neighborhoods near, int anchor, int channels, Stripe stripe) {
    Raster features = similarity.features();
    int width = features.width();
    int px = near.x(anchor);
    int py = near.y(anchor);
    int last = Math.min(features.height() - 1, py + radius);
    for (int qy = Math.max(0, py - radius); qy <= last; qy++) {
      for (int qx = Math.max(0, px - radius); qx <= Math.min(width - 1, px + radius); qx++) {
        float weight = near.weight(anchor, qx - px, qy - py);
        if (weight != 0) {
          setTerms(model.terms(), px, py, qx, qy);
          int at = (qy * width + qx) * channels - stripe.first;
          double[] values = model.values();
          for (int c = 0; c < channels - 1; c++) {
            stripe.sums[at + c] += (float) (weight * values[c]);
          }
          stripe.sums[at + channels - 1] += weight;
        }
      }
    }
  }
}
