package io.github.lumbre.render.denoise;

import io.github.lumbre.geometry.internal.CompiledKernel;
import io.github.lumbre.image.Image;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import java.util.HashSet;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Denoises with a small neural network, in plain Java: the same bits on every machine, for any
 * number of threads.
 *
 * <p>The network sees light, its noise, albedo and normals, and predicts kernels at five sizes of
 * the picture. The result is made of weighted means of the noisy pixels, so that little can be
 * invented (Bako et al. 2017, kernel prediction; Vogels et al. 2018, several sizes). What it was
 * trained on, and how, is in {@code src/denoiser}.
 */
public final class BuiltInDenoiser {
  /** Pixels around a tile that its result depends on. */
  static final int MARGIN = 12 * TileFilter.UNIT;

  /** Memory for each pixel of a tile, rounded up. */
  private static final int BYTES_PER_PIXEL = 240;

  /** Memory for each pixel of the picture, its guides and the result. */
  private static final int BYTES_PER_PICTURE_PIXEL = 135;

  /**
   * Pixels for each thread of the first picture, at least. Until the loops are compiled, more
   * threads would spend the time of processors, which the compilers need, on interpreting them.
   */
  private static final int FIRST_PIXELS_PER_THREAD = 1 << 16;

  private static final int SMALLEST_TILE = 640 * 640;
  private static final int LARGEST_TILE = 2200 * 1200;

  /** The result stays within this many standard deviations of the noisy picture. */
  static final double FARTHEST = 4;

  /**
   * How much larger the squared error is than the squared noise that is left, for each cube root of
   * the relative noise before: kernels also mix different light, and the more noise there is, the
   * wider they are. Fitted to twenty scenes with 4, 16 and 64 samples:
   * docs/measurements/2026-11-denoising.md.
   */
  static final double UNSEEN = 4.5;

  private final NoisyPicture noisy;
  private final Features features;
  private final Workers workers;
  private final FilteredUnits filtered;
  private final float[] result;

  /** The noise that is left of the result; no values if the noise is not known. */
  private final float[] left;

  /** Sums of relative squared errors, by row and {@link TileFilter#UNIT} columns. */
  private final double[] errors;

  private final int errorsInRow;

  private BuiltInDenoiser(NoisyPicture noisy, Workers workers) throws InterruptedException {
    this.noisy = noisy;
    this.workers = workers;
    features = new Features(noisy);
    filtered = FilteredUnits.of(features, workers);
    result = new float[noisy.light().mean().length];
    left = new float[noisy.light().noise().length];
    errorsInRow = FilteredUnits.count(features.right());
    errors = new double[Math.multiplyExact(features.bottom(), errorsInRow)];
  }

  /**
   * Renders a scene and denoises the picture, with the layers that help. Its bits are those of
   * {@link #denoise} of a film with {@link Layer#FOR_DENOISING}.
   *
   * @param settings whose layers are added to; their threads also denoise; for 0, one for each
   *     processor
   * @throws InterruptedException if the progress is cancelled, or the thread is interrupted
   */
  public static Image render(RenderSettings settings, Scene scene, Progress progress)
      throws InterruptedException {
    Set<Layer> layers = new HashSet<>(settings.get(Setting.LAYERS));
    layers.addAll(Layer.FOR_DENOISING);
    RenderSettings layered = settings.toBuilder().set(Setting.LAYERS, layers).build();
    FilmRenderer renderer = new FilmRenderer(layered, scene);
    Film film = renderer.newFilm();
    if (!new PassLoop(renderer, film).run(progress).complete()) {
      throw new InterruptedException("cancelled");
    }
    int all = Runtime.getRuntime().availableProcessors();
    int threads = settings.threads() > 0 ? settings.threads() : all;
    return denoise(NoisyPicture.of(film), threads).image();
  }

  /**
   * Denoises a picture. Light above 10^15 counts as 10^15, guides outside [-1,1] as -1 or 1. Memory
   * beyond the result is bounded: large pictures are filtered in tiles, with the same result.
   *
   * @param noisy without guides or noise, less of the noise is removed
   * @param threads number of threads, at least 1; the result does not depend on it
   * @return the error is estimated if the noise of the picture is known
   * @throws InterruptedException if the thread is interrupted
   */
  public static Denoised denoise(NoisyPicture noisy, int threads) throws InterruptedException {
    return denoise(noisy, threads, tile(), noise -> {});
  }

  /**
   * Denoises a picture; see {@link #denoise(NoisyPicture, int)}.
   *
   * @param left receives the noise that is left of the result, as {@link NoisyPicture.Halves} have
   *     it; no values if the noise of the picture is not known
   * @throws InterruptedException if the thread is interrupted
   */
  public static Denoised denoise(NoisyPicture noisy, int threads, Consumer<float[]> left)
      throws InterruptedException {
    return denoise(noisy, threads, tile(), left);
  }

  /** Returns about how many bytes a film of this many pixels needs besides, to be denoised. */
  public static long bytes(long pixels) {
    return BYTES_PER_PICTURE_PIXEL * pixels + BYTES_PER_PIXEL * Math.min(pixels, tile());
  }

  private static int tile() {
    long most = Runtime.getRuntime().maxMemory() / 3 / BYTES_PER_PIXEL;
    return (int) Math.max(SMALLEST_TILE, Math.min(LARGEST_TILE, most));
  }

  /** Denoises a picture in tiles of at most about a number of pixels, margins included. */
  static Denoised denoise(NoisyPicture noisy, int threads, int tile) throws InterruptedException {
    return denoise(noisy, threads, tile, noise -> {});
  }

  private static Denoised denoise(
      NoisyPicture noisy, int threads, int tile, Consumer<float[]> left)
      throws InterruptedException {
    try (Workers workers = new Workers(useful(threads, noisy))) {
      Optional<CaughtShadow> shadow = CaughtShadow.of(noisy);
      NoisyPicture lit = noisy;
      if (shadow.isPresent()) {
        float[] gray = new BuiltInDenoiser(shadow.get().picture(), workers).light(tile);
        lit = shadow.get().denoised(gray);
      }
      BuiltInDenoiser denoiser = new BuiltInDenoiser(lit, workers);
      Denoised denoised = denoiser.denoised(tile, shadow);
      left.accept(denoiser.left);
      return denoised;
    } finally {
      CompiledKernel.denoised();
    }
  }

  /** Returns how many of a number of threads are used for a picture. */
  private static int useful(int threads, NoisyPicture noisy) {
    int pixels = noisy.width() * noisy.height();
    int first = Math.min(threads, 1 + pixels / FIRST_PIXELS_PER_THREAD);
    return CompiledKernel.hasDenoised() ? threads : first;
  }

  /** Returns the denoised light. */
  private float[] light(int tile) throws InterruptedException {
    filter(tile);
    return noisy.light().isNoiseKnown() ? corrected() : result;
  }

  /** Returns the picture whose light is black where only a shadow is seen. */
  private Denoised denoised(int tile, Optional<CaughtShadow> shadow) throws InterruptedException {
    float[] light = light(tile);
    shadow.ifPresent(s -> s.blacken(light));
    OptionalDouble before = Denoised.noise(noisy, light);
    OptionalDouble error =
        before.isPresent()
            ? OptionalDouble.of(relativeError(before.getAsDouble()))
            : OptionalDouble.empty();
    return Denoised.of(noisy, light, Network.NAME, before, error);
  }

  /** Filters the whole picture. */
  private void filter(int tile) throws InterruptedException {
    int[] counts = counts(tile);
    int across =
        FilteredUnits.count(FilteredUnits.count(features.right()) * TileFilter.UNIT / counts[0])
            * TileFilter.UNIT;
    int down =
        FilteredUnits.count(FilteredUnits.count(features.bottom()) * TileFilter.UNIT / counts[1])
            * TileFilter.UNIT;
    for (int top = 0; top < features.bottom(); top += down) {
      for (int left = 0; left < features.right(); left += across) {
        filter(left, top, across, down);
      }
    }
  }

  private double relativeError(double before) {
    double sum = 0;
    for (double error : errors) {
      sum += error;
    }
    double factor = before > 0 ? UNSEEN * Elementary.exp(Elementary.log(before) / 3) : 0;
    return Math.sqrt(factor * sum / result.length);
  }

  /** Corrects pixels of a row from a column to another. */
  private interface Correction {
    void correct(int y, int first, int end);
  }

  /** Corrects all filtered pixels. */
  private void correct(Correction correction) throws InterruptedException {
    int width = FilteredUnits.count(features.right()) * TileFilter.UNIT;
    FilteredPart whole = new FilteredPart(filtered, 0, 0, width, 0);
    workers.compute(
        noisy.height(),
        (top, bottom, convolution) -> {
          for (int y = top; y < bottom; y++) {
            int row = y;
            whole.forEach(
                features.top() + y,
                (x, right) -> {
                  int first = Math.max(features.left(), x) - features.left();
                  int end = Math.min(features.right(), right) - features.left();
                  correction.correct(row, first, end);
                });
          }
        });
  }

  /**
   * Returns the result without what noise is left in single channels, with its light given back,
   * and not farther from the noisy light than the noise allows.
   */
  private float[] corrected() throws InterruptedException {
    float[] even = result.clone();
    UnevenNoise uneven = new UnevenNoise(features, result, left);
    correct((y, first, end) -> uneven.write(y, first, end, even));
    float[] corrected = even.clone();
    LostLight lost = new LostLight(features, even);
    correct((y, first, end) -> correct(lost, y, first, end, corrected));
    return corrected;
  }

  private void correct(LostLight lost, int y, int first, int end, float[] corrected) {
    float[] row = new float[3 * noisy.width()];
    double[] variances = new double[row.length];
    features.writeVariances(y, variances);
    lost.write(y, first, end, row);
    int start = y * row.length;
    for (int i = 3 * first; i < 3 * end; i++) {
      double most = FARTHEST * Math.sqrt(variances[i]);
      corrected[start + i] = Math.max(0, near(row[i], features.light(start + i), most));
    }
  }

  /** Returns the numbers of tiles beside and below each other with the least work. */
  private int[] counts(int tile) {
    int[] best = {FilteredUnits.count(features.right()), FilteredUnits.count(features.bottom())};
    double least = Double.POSITIVE_INFINITY;
    for (int x = 1; x <= FilteredUnits.count(features.right()); x++) {
      for (int y = 1; y <= FilteredUnits.count(features.bottom()); y++) {
        double width = side(features.right(), x);
        double height = side(features.bottom(), y);
        double work = x * width * y * height;
        if (width * height <= tile && work < least) {
          least = work;
          best = new int[] {x, y};
        }
      }
    }
    return best;
  }

  /** Returns the side of the largest of some equal tiles beside each other, with margins. */
  private static double side(int pixels, int tiles) {
    return pixels / (double) tiles + Math.min(2, tiles - 1) * MARGIN;
  }

  private void filter(int left, int top, int across, int down) throws InterruptedException {
    int allAcross = FilteredUnits.count(features.right()) * TileFilter.UNIT;
    int allDown = FilteredUnits.count(features.bottom()) * TileFilter.UNIT;
    int x = Math.max(0, left - MARGIN);
    int y = Math.max(0, top - MARGIN);
    int width = Math.min(allAcross, left + across + MARGIN) - x;
    int height = Math.min(allDown, top + down + MARGIN) - y;
    FilterLevel level = new TileFilter(features, filtered, workers, x, y, width, height).filtered();
    int start = Math.max(features.left(), left);
    int end = Math.min(features.right(), left + across);
    int upper = Math.max(features.top(), top);
    int lower = Math.min(features.bottom(), top + down);
    workers.compute(
        Math.max(0, lower - upper),
        (first, last, convolution) -> {
          for (int row = upper + first; row < upper + last; row++) {
            write(level, (row - y) * width - x, row, start, end);
          }
        });
  }

  /** Writes the pixels of a row from a column to another; column 0 is at an index of the level. */
  private void write(FilterLevel level, int zero, int row, int start, int end) {
    boolean isNoiseKnown = noisy.light().isNoiseKnown();
    float[][] planes = level.filtered;
    for (int column = start; column < end; column++) {
      int at = zero + column;
      int pixel = (row - features.top()) * noisy.width() + column - features.left();
      boolean isFiltered = filtered.contains(column, row);
      for (int c = 0; c < 3; c++) {
        int i = 3 * pixel + c;
        float value = features.light(i);
        if (isFiltered) {
          value = features.mixed(i, level.mix[at], planes[c][at], planes[3 + c][at]);
        }
        if (isNoiseKnown) {
          double noise =
              isFiltered
                  ? features.mixed(i, level.mix[at], planes[6 + c][at], planes[9 + c][at])
                  : features.noise(i);
          left[i] = (float) noise;
          errors[row * errorsInRow + column / TileFilter.UNIT] +=
              noise * noise / ((double) value * value + Denoised.FLOOR);
        }
        result[i] = Math.max(0, value);
      }
    }
  }

  /**
   * Limits how far a result is from the noisy light, so that pixels without noise stay. Black is no
   * evidence of that: where little light arrives, all samples of a neighborhood can miss it.
   */
  private static float near(float value, float light, double most) {
    double change = value - (double) light;
    return light == 0 ? value : (float) (light + Math.max(-most, Math.min(most, change)));
  }
}
