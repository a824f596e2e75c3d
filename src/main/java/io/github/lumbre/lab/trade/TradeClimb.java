package io.github.lumbre.lab.trade;

import io.github.lumbre.compare.PictureError;
import io.github.lumbre.image.Image;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderStatistics;
import java.util.function.DoubleSupplier;

/**
 * A setting rendered with one seed to increasing numbers of samples, with the time used. Mutable,
 * not thread-safe.
 */
final class TradeClimb {
  private final TradeSetting setting;
  private final DoubleSupplier cpuSeconds;
  private final FilmRenderer renderer;
  private final Film film;
  private double seconds;
  private double cpu;
  private int samples;

  /**
   * @param cpuSeconds supplies the CPU time of the process so far
   */
  TradeClimb(TradeSetting setting, long seed, DoubleSupplier cpuSeconds) {
    this.setting = setting;
    this.cpuSeconds = cpuSeconds;
    renderer = setting.renderer(seed);
    film = renderer.newFilm();
  }

  /** Adds samples until each pixel has a given number. */
  void to(int goal) throws InterruptedException {
    double cpuStart = cpuSeconds.getAsDouble();
    double start = clock();
    climb(renderer, film, goal);
    seconds += clock() - start;
    cpu += cpuSeconds.getAsDouble() - cpuStart;
    samples = goal;
  }

  /**
   * Returns the current picture and its error against a reference. Its time includes that of
   * developing and denoising this picture.
   */
  TradeTrial against(Image truth) throws InterruptedException {
    double cpuStart = cpuSeconds.getAsDouble();
    double start = clock();
    Image picture = setting.develop(film);
    return new TradeTrial(
        setting,
        samples,
        seconds + clock() - start,
        cpu + cpuSeconds.getAsDouble() - cpuStart,
        PictureError.of(picture, truth),
        picture);
  }

  /** Returns the film with the samples so far. */
  Film film() {
    return film;
  }

  /** Returns the number of samples per pixel so far. */
  int samples() {
    return samples;
  }

  /** Returns the wall-clock time so far, in seconds. */
  double seconds() {
    return seconds;
  }

  /** Returns the seconds since an arbitrary origin. */
  static double clock() {
    return System.nanoTime() * 1e-9;
  }

  /** Adds samples to a film, in growing passes, until each pixel has a given number. */
  static RenderStatistics climb(FilmRenderer renderer, Film film, int goal)
      throws InterruptedException {
    return new PassLoop(renderer, film, renderer.schedule(goal)).run(Progress.NONE).statistics();
  }
}
