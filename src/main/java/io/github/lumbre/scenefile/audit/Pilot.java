package io.github.lumbre.scenefile.audit;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.path.PathVertex;
import io.github.lumbre.integrator.path.PathVertex.FoundLight;
import io.github.lumbre.integrator.path.PathVertex.Source;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.List;

/**
 * A pilot render: a grid of 64 × 48 points over the full frame with 2 samples each, up to 32
 * vertices deeper than the scene's path length limit. It counts the objects that its paths hit, and
 * the light that they find. Deterministic for a scene.
 */
final class Pilot {
  private static final int COLUMNS = 64;
  private static final int ROWS = 48;
  private static final int SAMPLES = 2;

  /** The number of vertices beyond the scene's path length limit. */
  private static final int DEEPER = 32;

  private final ParsedScene file;
  private final RenderSettings settings;
  private final long[] met;
  private final double[] lightOfEmitter;
  private int paths;
  private int rejected;
  private double light;
  private double lightBeyond;

  private Pilot(ParsedScene file) {
    this.file = file;
    settings = file.settings();
    met = new long[file.scene().primitives().size()];
    lightOfEmitter = new double[file.scene().emitters().size()];
  }

  /** Traces the paths of the pilot render. */
  static Pilot of(ParsedScene file) {
    Pilot pilot = new Pilot(file);
    pilot.run();
    return pilot;
  }

  private void run() {
    boolean isPath = settings.mode() == Mode.PATH;
    PixelReplay replay = new PixelReplay(file.scene(), isPath ? deeper() : settings);
    for (int row = 0; row < ROWS; row++) {
      for (int column = 0; column < COLUMNS; column++) {
        int x = (int) ((column + .5) / COLUMNS * settings.width());
        int y = (int) ((row + .5) / ROWS * settings.height());
        for (int sample = 0; sample < SAMPLES; sample++) {
          // Unique numbers: grid points that share a pixel get different samples.
          int number = sample + SAMPLES * (column + COLUMNS * row);
          note(replay.sample(x, y, number), isPath ? settings.maxTraceDepth() : Integer.MAX_VALUE);
        }
      }
    }
  }

  private RenderSettings deeper() {
    return settings.toBuilder()
        .split(1)
        .maxTraceDepth(Math.min(RenderSettings.MAX_DEPTH, settings.maxTraceDepth() + DEEPER))
        .build();
  }

  /**
   * Adds a path to the counts.
   *
   * @param depth the path length limit of the scene's own settings, in scattering vertices
   */
  private void note(PixelReplay.Sample sample, int depth) {
    paths++;
    if (sample.rejected()) {
      rejected++;
      return;
    }
    for (int i = 0; i < sample.vertices().size(); i++) {
      PathVertex vertex = sample.vertices().get(i);
      vertex.hit().ifPresent(hit -> met[hit.primitive()]++);
      for (FoundLight found : lights(vertex)) {
        boolean isCut = i + furtherScatterings(found.source()) > depth;
        double amount = gray(vertex.throughput().times(found.weighted()));
        lightBeyond += isCut ? amount : 0;
        light += isCut ? 0 : amount;
        if (found.emitter() >= 0) {
          lightOfEmitter[found.emitter()] += amount;
        }
      }
    }
  }

  /** Returns how often light is scattered from its source to the vertex's ray. */
  private static int furtherScatterings(Source source) {
    return switch (source) {
      case EMISSION, ENVIRONMENT, LENS -> 0;
      case LIGHT, AMBIENT -> 1;
      case MIRROR, REFRACTION -> 2;
    };
  }

  private static List<FoundLight> lights(PathVertex vertex) {
    return vertex.contributions().stream().flatMap(c -> c.lights().stream()).toList();
  }

  private static double gray(Rgb color) {
    return (color.r() + color.g() + color.b()) / 3;
  }

  int paths() {
    return paths;
  }

  /** Returns the number of rejected paths, whose radiance is negative, NaN or infinite. */
  int rejected() {
    return rejected;
  }

  /** Returns how often a path hit a primitive. */
  long met(int primitive) {
    return met[primitive];
  }

  /** Returns a light's share of the light found, 0 to 1; 0 if there is none. */
  double share(int emitter) {
    double all = light + lightBeyond;
    return all > 0 ? lightOfEmitter[emitter] / all : 0;
  }

  /** Returns whether any path found light within the scene's path length limit. */
  boolean sawLight() {
    return light > 0;
  }
}
