package io.github.lumbre.render;

import io.github.lumbre.camera.CameraRay;
import io.github.lumbre.integrator.GuideRecorder;
import io.github.lumbre.integrator.GuideSight;
import io.github.lumbre.integrator.Integrator;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.integrator.guiding.Guide;
import io.github.lumbre.integrator.guiding.GuideBuilder;
import io.github.lumbre.integrator.guiding.GuideRecords;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.render.internal.GuideReport;
import io.github.lumbre.render.internal.GuideReport.Outcome;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import java.util.List;
import java.util.concurrent.CancellationException;

/**
 * The pilot render of {@code --guide}. It traces paths over the full frame in passes of doubled
 * length. Each pass is guided by what the one before has learned; the last one makes the guide.
 *
 * <p>Its work is fixed. Records are taken in the order of the pixels, whatever thread found them,
 * and cost is counted in rays. The guide is therefore a function of the scene, the settings that
 * samples depend on, and the seed alone. It never changes after the pilot. Its random numbers
 * differ from the random numbers of the picture.
 */
final class GuidePilot {
  /** The largest number of paths in all passes. */
  static final int MOST_PATHS = 1 << 19;

  private static final int PASSES = 5;

  /** The pass after which the pilot ends if it has learned nothing; it has then done 7/31. */
  private static final int CHECKED_PASS = 2;

  /** The largest number of vertices that one pass keeps: 70 MB. */
  static final int MOST_RECORDS = 1 << 20;

  /**
   * Bytes of a record of 65 bytes in two arrays that each have room for another, of 60 bytes of
   * indices and values, and of a guide's trees.
   */
  private static final long BYTES_PER_RECORD = 336;

  private static final long SEED = 0x6775696465206f6eL;

  private final RenderSettings settings;
  private final Scene scene;
  private final PilotRows crew;
  private long rays;

  private GuidePilot(RenderSettings settings, Scene scene, PilotRows crew) {
    this.settings = settings.toBuilder().split(1).build();
    this.scene = scene;
    this.crew = crew;
  }

  /**
   * Pixels that are spread evenly over the full frame, in columns and rows.
   *
   * @param width width of the full frame in pixels
   * @param height height of the full frame in pixels
   * @param columns number of columns, at least 1
   * @param rows number of rows, at least 1
   */
  private record Grid(int width, int height, int columns, int rows) {
    /** Returns a grid of at most the given number of pixels, at least 1. */
    static Grid of(RenderSettings settings, int most) {
      int width = settings.width();
      int height = settings.height();
      if ((long) width * height <= most) {
        return new Grid(width, height, width, height);
      }
      double side = Math.sqrt(most * settings.aspect());
      int columns = (int) Math.max(1, Math.min(Math.min(width, most), side));
      int rows = Math.max(1, Math.min(height, most / columns));
      return new Grid(width, height, columns, rows);
    }

    /** Returns the column, in the full frame, of the pixels of a column. */
    int x(int column) {
      return (int) ((2L * column + 1) * width / (2L * columns));
    }

    /** Returns the row, in the full frame, of the pixels of a row. */
    int y(int row) {
      return (int) ((2L * row + 1) * height / (2L * rows));
    }
  }

  /** A guide, and why it is used or not. */
  record Learned(Guide guide, GuideReport report) {}

  /**
   * Returns the guide that the pilot of some settings learns.
   *
   * @param settings their guiding is not off
   * @param scene framed for the settings
   * @param crew renders the pilot
   * @throws InterruptedException if the calling thread is interrupted; all threads have then ended
   * @throws CancellationException if the crew was stopped; all threads have then ended
   * @throws RenderException if a path failed
   */
  static Learned learn(RenderSettings settings, Scene scene, PilotRows crew)
      throws InterruptedException {
    return findsLight(settings, scene)
        ? new GuidePilot(settings, scene, crew).learn()
        : new Learned(Guide.NONE, GuideReport.unused(Outcome.NO_LIGHT, 0));
  }

  /** Returns the largest number of bytes that the pilot of some settings needs. */
  static long mostBytes(RenderSettings settings) {
    long vertices = (long) paths(settings) * (settings.maxTraceDepth() + 1L);
    return BYTES_PER_RECORD * Math.min(MOST_RECORDS, vertices);
  }

  private static int paths(RenderSettings settings) {
    return (int) Math.min(MOST_PATHS, (long) settings.width() * settings.height());
  }

  /** Returns whether a scattered ray could find light. */
  static boolean findsLight(RenderSettings settings, Scene scene) {
    return settings.mode() == RenderSettings.Mode.PATH
        && settings.maxTraceDepth() > 0
        && !(scene.emitters().isEmpty() && scene.environments().isEmpty())
        && scene.primitives().stream().anyMatch(Primitive::scatters);
  }

  private Learned learn() throws InterruptedException {
    int paths = paths(settings);
    Guide guide = Guide.NONE;
    for (int pass = 0; pass < PASSES; pass++) {
      long share = ((long) paths << pass) / ((1 << PASSES) - 1);
      GuideRecords records = records(guide, (int) Math.max(1, share), pass);
      guide =
          pass == PASSES - 1
              ? GuideBuilder.build(records, guide, () -> new GuideSight(scene))
              : GuideBuilder.train(records, guide, () -> new GuideSight(scene));
      if (pass >= CHECKED_PASS && guide.isEmpty()) {
        return new Learned(Guide.NONE, GuideReport.unused(Outcome.NOTHING_LEARNED, rays));
      }
    }
    return new Learned(guide, GuideReport.used(guide, rays));
  }

  private GuideRecords records(Guide guide, int paths, int pass) throws InterruptedException {
    Integrator integrator = Integrator.of(scene, settings, guide);
    Grid grid = Grid.of(settings, paths);
    int limit = Math.max(1, MOST_RECORDS / grid.rows());
    List<Row> rows = crew.render(grid.rows(), row -> recordRow(integrator, grid, row, pass, limit));
    GuideRecords all = new GuideRecords();
    for (Row row : rows) {
      all.addAll(row.records());
      rays += row.rays();
    }
    return all;
  }

  private record Row(GuideRecords records, long rays) {}

  private Row recordRow(Integrator integrator, Grid grid, int row, int pass, int limit)
      throws InterruptedException {
    GuideRecords records = new GuideRecords(limit);
    GuideRecorder recorder = new GuideRecorder(records);
    RenderContext context = RenderContext.recordedBy(recorder);
    Sampler sampler = new SobolSampler(settings.seed() ^ (SEED + pass));
    CameraRay ray = new CameraRay();
    for (int column = 0; column < grid.columns(); column++) {
      crew.check();
      int x = grid.x(column);
      int y = grid.y(row);
      context.startSample(settings.down(y));
      // Every path has its own numbers.
      int number = row * grid.columns() + column;
      if (CameraSamples.start(scene, settings, sampler, x, y, number, ray)) {
        integrator.radiance(ray, sampler, context);
        recorder.endPath();
      }
    }
    return new Row(records, context.rays() + context.shadowRays());
  }
}
