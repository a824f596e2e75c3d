package io.github.lumbre.lab.checks;

import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.image.compare.PictureError;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.stopping.Budget;
import io.github.lumbre.render.stopping.BudgetWatch;
import io.github.lumbre.render.stopping.NoiseEstimate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * How often a picture's error exceeds the bound that its own samples give: the same scene is
 * rendered with many seeds, and each picture is compared with a reference.
 *
 * <p>The reference is the mean of {@value #REFERENCES} pictures with independent seeds. Their
 * differences give its own error, which is subtracted from each picture's.
 */
public final class Coverage {
  private static final int REFERENCES = 4;

  /** The first seed of the judged pictures. The references have the seeds −1 to −4. */
  private static final long FIRST_SEED = 1000;

  /** A picture is far beyond its bound if its error exceeds it by this factor. */
  private static final double FAR = 1.25;

  private final Scene scene;
  private final RenderSettings settings;
  private final int seeds;
  private final double[] reference;
  private final double referenceError;

  /**
   * Renders the reference on all processors.
   *
   * @param settings the settings of all pictures; their seed and samples are not used
   * @param seeds number of judged pictures
   * @param referenceSamples samples per pixel of all references together
   */
  public Coverage(Scene scene, RenderSettings settings, int seeds, int referenceSamples) {
    this.scene = scene;
    this.settings = settings.toBuilder().threads(1).build();
    this.seeds = seeds;
    int each = Math.max(1, referenceSamples / REFERENCES);
    List<float[]> references =
        IntStream.range(0, REFERENCES)
            .parallel()
            .mapToObj(i -> rendered(-1 - i, each).develop().rgb())
            .toList();
    reference = new double[references.get(0).length];
    references.forEach(picture -> Arrays.setAll(reference, i -> reference[i] + picture[i]));
    Arrays.setAll(reference, i -> reference[i] / REFERENCES);
    double squares = references.stream().mapToDouble(this::relativeMse).sum();
    referenceError = squares / REFERENCES / (REFERENCES - 1);
  }

  /**
   * The pictures of one number of samples, or of one target error.
   *
   * @param name {@code 32 samples} or {@code 10 %}
   */
  public record Cell(String name, List<Judged> pictures, double referenceError) {
    public long beyond() {
      return pictures.stream().filter(p -> p.error() > p.bound()).count();
    }

    /**
     * Returns the probability of at least this many failures, if each of the bounds fails with a
     * probability of 5 %.
     */
    public double chance() {
      int count = pictures.size();
      double probability = 0;
      double term = Elementary.pow(Budget.CONFIDENCE, count);
      for (int i = 0; i < beyond(); i++) {
        probability += term;
        term *= (count - i) / (i + 1.0) * (1 - Budget.CONFIDENCE) / Budget.CONFIDENCE;
      }
      return Math.max(0, 1 - probability);
    }

    /** Returns the number of pictures that have reached the target error; 0 without one. */
    public long reached() {
      return pictures.stream().filter(Judged::hasReachedTarget).count();
    }

    /** Returns the number of pictures whose error exceeds 1.25 times the bound. */
    public long farBeyond() {
      return pictures.stream().filter(Judged::isFarBeyond).count();
    }

    /** Returns the number of pictures whose bound is said to be doubtful. */
    public long doubtful() {
      return pictures.stream().filter(Judged::isDoubtful).count();
    }

    /** Returns the median of estimate over error. */
    public double estimateRatio() {
      return median(p -> p.estimate() / p.error());
    }

    /** Returns the median of bound over error. */
    public double boundRatio() {
      return median(p -> p.bound() / p.error());
    }

    public double meanSamples() {
      return pictures.stream().mapToDouble(Judged::samples).average().orElseThrow();
    }

    /** Returns the root of the mean squared error. */
    public double error() {
      double squares = pictures.stream().mapToDouble(p -> p.error() * p.error()).sum();
      return Math.sqrt(squares / pictures.size());
    }

    /** Returns the reference's squared error over the mean one of the pictures. */
    public double referenceShare() {
      return referenceError / (error() * error());
    }

    private double median(ToDoubleFunction<Judged> value) {
      return pictures.stream()
          .mapToDouble(value)
          .sorted()
          .skip(pictures.size() / 2)
          .findFirst()
          .orElseThrow();
    }

    /** Returns a line for people. */
    public String line() {
      return "%-11s %d of %d beyond (%d by a quarter, %d doubtful); error %s, estimate/error %.2f, "
              .formatted(
                  name,
                  beyond(),
                  pictures.size(),
                  farBeyond(),
                  doubtful(),
                  Numbers.percent(error()),
                  estimateRatio())
          + "bound/error %.2f, %.1f samples per pixel, reference %s of the squared error"
              .formatted(boundRatio(), meanSamples(), Numbers.percent(referenceShare()));
    }
  }

  /**
   * A picture beside the reference; errors are relative root mean squared errors.
   *
   * @param bound infinite if there is none
   */
  record Judged(
      double error,
      double estimate,
      double bound,
      boolean isDoubtful,
      boolean hasReachedTarget,
      double samples) {
    boolean isFarBeyond() {
      return error > FAR * bound;
    }
  }

  /** Returns a cell for each of some increasing numbers of samples per pixel. */
  public List<Cell> ofSamples(List<Integer> samples) {
    List<List<Judged>> all =
        IntStream.range(0, seeds).parallel().mapToObj(seed -> judged(seed, samples)).toList();
    List<Cell> cells = new ArrayList<>();
    for (int i = 0; i < samples.size(); i++) {
      int cell = i;
      List<Judged> pictures = all.stream().map(picture -> picture.get(cell)).toList();
      cells.add(new Cell(Numbers.count(samples.get(i), "sample"), pictures, referenceError));
    }
    return cells;
  }

  private List<Judged> judged(int seed, List<Integer> samples) {
    FilmRenderer renderer = renderer(FIRST_SEED + seed);
    Film film = renderer.newFilm();
    List<Judged> judged = new ArrayList<>();
    for (int goal : samples) {
      run(renderer, film, new Budget(goal, OptionalDouble.empty(), Budget.CONFIDENCE));
      judged.add(judged(film, NoiseEstimate.of(film, Budget.CONFIDENCE).orElseThrow(), false));
    }
    return judged;
  }

  /** Returns the cell of renders that stop at a target error, or after some samples per pixel. */
  public Cell ofTarget(double target, int mostSamples) {
    List<Judged> pictures =
        IntStream.range(0, seeds)
            .parallel()
            .mapToObj(seed -> stopped(seed, new Budget(mostSamples, OptionalDouble.of(target), .95)))
            .toList();
    return new Cell(Numbers.percent(target), pictures, referenceError);
  }

  private Judged stopped(int seed, Budget budget) {
    FilmRenderer renderer = renderer(FIRST_SEED + seed);
    Film film = renderer.newFilm();
    BudgetWatch watch = run(renderer, film, budget);
    return judged(film, watch.estimate(film).orElseThrow(), watch.isMet());
  }

  private Judged judged(Film film, NoiseEstimate noise, boolean hasReachedTarget) {
    double squared = relativeMse(film.develop().rgb()) - referenceError;
    return new Judged(
        Math.sqrt(Math.max(squared, Double.MIN_NORMAL)),
        noise.relativeRmse(),
        noise.upperRelativeRmse(),
        noise.isDoubtful(),
        hasReachedTarget,
        film.meanSamples());
  }

  private Film rendered(long seed, int samples) {
    FilmRenderer renderer = renderer(seed);
    Film film = renderer.newFilm();
    run(renderer, film, Budget.ofSamples(samples));
    return film;
  }

  private FilmRenderer renderer(long seed) {
    return new FilmRenderer(settings.toBuilder().seed(seed).build(), scene);
  }

  private static BudgetWatch run(FilmRenderer renderer, Film film, Budget budget) {
    BudgetWatch watch = new BudgetWatch(budget);
    try {
      new PassLoop(renderer, film, renderer.schedule(budget.samples()))
          .run(watch, PassListener.NONE, Progress.NONE);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    }
    return watch;
  }

  private double relativeMse(float[] picture) {
    double sum = 0;
    for (int i = 0; i < picture.length; i++) {
      double error = picture[i] - reference[i];
      sum += error * error / (reference[i] * reference[i] + PictureError.FLOOR);
    }
    return sum / picture.length;
  }
}
