package io.github.lumbre.audit;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathVertex;
import io.github.lumbre.integrator.PathVertex.Gathered;
import io.github.lumbre.integrator.PathVertex.Source;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;

/**
 * A few thousand paths, spread over the frame: what they meet, where their light comes from, and
 * what more depth would add. The same for the same scene.
 */
final class Pilot {
  private static final int COLUMNS = 64;
  private static final int ROWS = 48;
  private static final int SAMPLES = 2;

  /** By how much deeper it looks than the scene asks. */
  private static final int DEEPER = 32;

  private final SceneFile file;
  private final RenderSettings settings;
  private final long[] met;
  private final double[] lightOfEmitter;
  private final Differences differences = new Differences();
  private int paths;
  private int rejected;
  private double light;

  /** Sums of what deeper paths add, for its mean and standard error. */
  private static final class Differences {
    private int count;
    private double sum;
    private double squares;

    void add(double difference) {
      count++;
      sum += difference;
      squares += difference * difference;
    }

    double error() {
      double mean = sum / count;
      return Math.sqrt(Math.max(0, squares / count - mean * mean) * count);
    }
  }

  private Pilot(SceneFile file) {
    this.file = file;
    settings = file.settings();
    met = new long[file.scene().primitives().size()];
    lightOfEmitter = new double[file.scene().emitters().size()];
  }

  /** Follows the paths. */
  static Pilot of(SceneFile file) {
    Pilot pilot = new Pilot(file);
    pilot.run();
    return pilot;
  }

  private void run() {
    boolean isPath = settings.mode() == Mode.PATH;
    PixelReplay deep = new PixelReplay(file.scene(), deeper());
    PixelReplay shallow = isPath ? deep : new PixelReplay(file.scene(), settings);
    for (int row = 0; row < ROWS; row++) {
      for (int column = 0; column < COLUMNS; column++) {
        int x = (int) ((column + .5) / COLUMNS * settings.width());
        int y = (int) ((row + .5) / ROWS * settings.height());
        for (int sample = 0; sample < SAMPLES; sample++) {
          // Where the frame has fewer pixels than the grid, each time another sample.
          int number = sample + SAMPLES * (column + COLUMNS * row);
          PixelReplay.Sample taken = shallow.sample(x, y, number);
          note(taken, isPath ? settings.maxTraceDepth() : Integer.MAX_VALUE);
          if (!isPath && !taken.rejected()) {
            differences.add(grey(deep.sample(x, y, number).film()) - grey(taken.film()));
          }
        }
      }
    }
  }

  private RenderSettings deeper() {
    return settings.toBuilder()
        .maxTraceDepth(deeper(settings.maxTraceDepth()))
        .rayDepths(deeper(settings.reflectionTraceDepth()), deeper(settings.refractionTraceDepth()))
        .build();
  }

  private static int deeper(int depth) {
    return (int) Math.min(RenderSettings.MAX_DEPTH, depth + Math.max(DEEPER, 3L * depth));
  }

  /**
   * Takes a path in.
   *
   * @param depth how many of its vertices scatter in the scene's own settings
   */
  private void note(PixelReplay.Sample sample, int depth) {
    paths++;
    if (sample.rejected()) {
      rejected++;
      return;
    }
    double beyond = 0;
    for (int i = 0; i < sample.vertices().size(); i++) {
      PathVertex vertex = sample.vertices().get(i);
      vertex.meeting().ifPresent(meeting -> met[meeting.primitive()]++);
      for (Gathered found : vertex.gathered()) {
        boolean isMet = found.source() == Source.EMISSION || found.source() == Source.BACKGROUND;
        boolean isCut = isMet ? i > depth : i >= depth;
        double amount = grey(found.contribution());
        beyond += isCut ? amount : 0;
        light += isCut ? 0 : amount;
        if (found.emitter() >= 0) {
          lightOfEmitter[found.emitter()] += amount;
        }
      }
    }
    if (settings.mode() == Mode.PATH) {
      differences.add(beyond);
    }
  }

  private static double grey(Rgb colour) {
    return (colour.r() + colour.g() + colour.b()) / 3;
  }

  /** Returns how many paths there were. */
  int paths() {
    return paths;
  }

  /** Returns how many of them had no radiance. */
  int rejected() {
    return rejected;
  }

  /** Returns how often a primitive was met. */
  long met(int primitive) {
    return met[primitive];
  }

  /** Returns the share of the light found that comes from an emitter; 0 if there is no light. */
  double share(int emitter) {
    double all = light + Math.max(0, differences.sum);
    return all > 0 ? lightOfEmitter[emitter] / all : 0;
  }

  /** Tells whether any light was found. */
  boolean sawLight() {
    return light > 0;
  }

  /** Returns the share of all light that the scene's depth cuts off. */
  double cut() {
    double all = light + differences.sum;
    return all > 0 ? Math.max(0, differences.sum) / all : 0;
  }

  /** Returns the standard error of {@link #cut}. */
  double cutError() {
    double all = light + differences.sum;
    return all > 0 ? differences.error() / all : 0;
  }
}
