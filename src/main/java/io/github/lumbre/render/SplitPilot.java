package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.PathOptions;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.render.SplitCells.Place;
import io.github.lumbre.sampling.Hash;
import io.github.lumbre.sampling.Sampler;
import io.github.lumbre.sampling.SobolSampler;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.ArrayList;
import java.util.List;

/**
 * The pilot render of {@code --split auto}. It renders pixels that are spread over the full frame
 * with 1 and with 4 branches, and with 1 branch and 4 times as many samples. From their errors and
 * rays, {@link SplitChoice} chooses a number of branches for each of {@link SplitCells}.
 *
 * <p>Its work is fixed, and each row of pixels is one thread's. Sums are taken in a fixed order,
 * and cost is counted in rays. The plan is therefore a function of the scene, the settings that
 * samples depend on, and the seed alone. It is the same for any crop, threads and number of
 * samples. The random numbers are not those of the picture. Immutable and stateless.
 */
final class SplitPilot {
  /** Samples in a block: the mean of a block is compared with that of the other sequence. */
  static final int SAMPLES = 8;

  /** Independent sequences of samples. The difference of two means is their error. */
  private static final int SEQUENCES = 2;

  /** Halves of the pilot: even and odd blocks of each sequence. */
  private static final int HALVES = 2;

  /** Blocks of unsplit samples in a sequence; together, they are a longer render. */
  private static final int BLOCKS = SplitChoice.LONGER;

  /** The number of branches that is compared with 1. */
  private static final int BRANCHES = 4;

  /** The most work for a pixel, in samples of unsplit paths. */
  static final int WORK = SEQUENCES * SAMPLES * (BLOCKS + HALVES * BRANCHES);

  /** The largest share of a render's work. */
  static final double LARGEST_SHARE = .02;

  /** Cells of the plan's grid for each pixel of the pilot, if the frame has as many pixels. */
  private static final int GRID = 16;

  private static final long SEED = 0x73706c6974206f6eL;

  private final RenderSettings settings;
  private final Scene scene;
  private final PilotSamples samples;
  private final PilotRows crew;
  private final PilotGrid pixels;

  private SplitPilot(RenderSettings settings, Scene scene, PilotRows crew) {
    this.settings = settings;
    this.scene = scene;
    this.crew = crew;
    Integrator planned =
        new PathTracer(scene, PathOptions.of(settings).splitInto(PathOptions.PLANNED));
    samples = new PilotSamples(settings, scene, planned);
    pixels = PilotGrid.of(settings, settings.splitPilot());
  }

  /**
   * Returns what the pilot of some settings chooses.
   *
   * @param scene framed for the settings
   * @param crew renders the rows
   * @throws InterruptedException if the calling thread is interrupted; all threads have then ended
   * @throws PilotRows.Stopped if the crew was stopped
   * @throws RenderException if a path failed
   */
  static SplitReport choose(RenderSettings settings, Scene scene, PilotRows crew)
      throws InterruptedException, PilotRows.Stopped {
    if (!findsLight(settings, scene)) {
      return SplitReport.without(SplitReport.Reason.NO_LIGHT, 0);
    }
    if (settings.splitPilot() == 0) {
      return SplitReport.without(SplitReport.Reason.SHORT, 0);
    }
    return new SplitPilot(settings, scene, crew).choose();
  }

  /** Returns whether branches could find light. */
  private static boolean findsLight(RenderSettings settings, Scene scene) {
    return settings.mode() == RenderSettings.Mode.PATH
        && settings.maxTraceDepth() > 0
        && !(scene.emitters().isEmpty() && scene.environments().isEmpty())
        && scene.primitives().stream().anyMatch(Primitive::scatters);
  }

  private SplitReport choose() throws InterruptedException, PilotRows.Stopped {
    List<Pixel> rendered = new ArrayList<>();
    crew.render(pixels.rows(), this::row).forEach(rendered::addAll);
    long rays = rendered.stream().mapToLong(p -> p.rays + p.splitRays).sum();
    SplitCells cells = SplitCells.of(rendered.stream().map(p -> p.place).toList());
    SplitChoice.Chosen chosen = new SplitChoice(sums(rendered, cells)).choose();
    if (chosen.bound() <= 1) {
      return SplitReport.without(SplitReport.Reason.NOT_BETTER, rays);
    }
    return new SplitReport(
        plan(cells, chosen.exponents()),
        SplitReport.Reason.BETTER,
        chosen.gain(),
        chosen.bound(),
        rays);
  }

  /** The means of the samples of a pixel, by sequence and block, and their rays. */
  private static final class Pixel {
    final Place place;
    final Rgb[][] means = new Rgb[SEQUENCES][BLOCKS];
    final Rgb[][] splitMeans = new Rgb[SEQUENCES][HALVES];
    long rays;
    long splitRays;

    Pixel(Place place) {
      this.place = place;
    }
  }

  private List<Pixel> row(int row) throws InterruptedException, PilotRows.Stopped {
    RenderContext context = new RenderContext();
    List<Pixel> done = new ArrayList<>();
    for (int column = 0; column < pixels.columns(); column++) {
      crew.check();
      done.add(pixel(pixels.x(column), pixels.y(row), context));
    }
    return done;
  }

  private Pixel pixel(int x, int y, RenderContext context) {
    Pixel pixel = new Pixel(place(x, y));
    for (int sequence = 0; sequence < SEQUENCES; sequence++) {
      Sampler sampler = sampler(sequence);
      long start = context.rays() + context.shadowRays();
      context.splitInto(1);
      for (int block = 0; block < BLOCKS; block++) {
        pixel.means[sequence][block] = mean(context, sampler, x, y, block);
      }
      long middle = context.rays() + context.shadowRays();
      context.splitInto(BRANCHES);
      for (int block = 0; block < HALVES; block++) {
        pixel.splitMeans[sequence][block] = mean(context, sampler, x, y, block);
      }
      pixel.rays += middle - start;
      pixel.splitRays += context.rays() + context.shadowRays() - middle;
    }
    return pixel;
  }

  private Sampler sampler(int sequence) {
    return new SobolSampler(Hash.of(settings.seed() ^ SEED, sequence));
  }

  /** Returns the mean of {@link #SAMPLES} samples of a pixel: those of a block of a sequence. */
  private Rgb mean(RenderContext context, Sampler sampler, int x, int y, int block) {
    return samples.mean(x, y, block * SAMPLES, SAMPLES, sampler, context);
  }

  /** Returns a pixel with the surface that its first sample of the pilot sees first. */
  private Place place(int x, int y) {
    CameraRay ray = new CameraRay();
    if (!CameraSamples.start(scene, settings, sampler(0), x, y, 0, ray)) {
      return new Place(-1, x, y);
    }
    NearestHit hit = new NearestHit();
    hit.aim(ray.toRay());
    return new Place(scene.intersect(hit) ? hit.shape() : -1, x, y);
  }

  private double[][][][] sums(List<Pixel> rendered, SplitCells cells) {
    double[] squares = PilotErrors.squares(pixels, rendered.stream().map(SplitPilot::all).toList());
    double[] errors = new double[HALVES * squares.length];
    double[] longErrors = new double[squares.length];
    for (int i = 0; i < squares.length; i++) {
      Rgb[][] means = rendered.get(i).means;
      for (int half = 0; half < HALVES; half++) {
        errors[HALVES * i + half] = error(means, half, squares[i]);
      }
      longErrors[i] = PilotErrors.of(mean(means[0]), mean(means[1]), squares[i]);
    }
    double limit = PilotErrors.limit(errors);
    double longLimit = PilotErrors.limit(longErrors);
    double[][][][] sums =
        new double[HALVES][SplitChoice.GROUPS][cells.count()][SplitChoice.KINDS];
    for (int i = 0; i < squares.length; i++) {
      Pixel pixel = rendered.get(i);
      Rgb[][] split = pixel.splitMeans;
      int cell = cells.cell(pixel.place);
      for (int half = 0; half < HALVES; half++) {
        double[] sum = sums[half][i % SplitChoice.GROUPS][cell];
        sum[SplitChoice.ERROR] += Math.min(limit, errors[HALVES * i + half]);
        sum[SplitChoice.LONG_ERROR] += Math.min(longLimit, longErrors[i]);
        sum[SplitChoice.SPLIT_ERROR] +=
            Math.min(limit, PilotErrors.of(split[0][half], split[1][half], squares[i]));
        sum[SplitChoice.RAYS] += (double) pixel.rays / BLOCKS;
        sum[SplitChoice.SPLIT_RAYS] += (double) pixel.splitRays / HALVES;
      }
    }
    return sums;
  }

  /** Returns the mean error of the blocks of unsplit samples in a half of the pilot. */
  private static double error(Rgb[][] means, int half, double square) {
    double sum = 0;
    for (int block = half; block < BLOCKS; block += HALVES) {
      sum += PilotErrors.of(means[0][block], means[1][block], square);
    }
    return sum * HALVES / BLOCKS;
  }

  /** Returns the means of both sequences of unsplit samples. */
  private static Rgb[] all(Pixel pixel) {
    return new Rgb[] {mean(pixel.means[0]), mean(pixel.means[1])};
  }

  private static Rgb mean(Rgb[] blocks) {
    Rgb sum = Rgb.BLACK;
    for (Rgb block : blocks) {
      sum = sum.plus(block);
    }
    return sum.times(1. / blocks.length);
  }

  /** Returns the plan for the whole frame. */
  private SplitPlan plan(SplitCells cells, int[] exponents)
      throws InterruptedException, PilotRows.Stopped {
    int most = Math.min(SplitPlan.MOST_CELLS, GRID * settings.splitPilot());
    PilotGrid grid = PilotGrid.of(settings, most);
    byte[] plan = new byte[grid.columns() * grid.rows()];
    List<byte[]> rows =
        crew.render(
            grid.rows(),
            row -> {
              byte[] line = new byte[grid.columns()];
              for (int column = 0; column < line.length; column++) {
                crew.check();
                int cell = cells.cell(place(grid.x(column), grid.y(row)));
                line[column] = (byte) exponents[cell];
              }
              return line;
            });
    for (int row = 0; row < rows.size(); row++) {
      System.arraycopy(rows.get(row), 0, plan, row * grid.columns(), grid.columns());
    }
    return new SplitPlan(settings.width(), settings.height(), grid.columns(), grid.rows(), plan);
  }
}
