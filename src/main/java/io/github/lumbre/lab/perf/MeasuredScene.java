package io.github.lumbre.lab.perf;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.image.Image;
import io.github.lumbre.lab.Cost;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.Trial;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** A scene that is read and rendered to be measured. Mutable: it keeps its first picture. */
public final class MeasuredScene {
  private final String name;
  private final SceneFile file;
  private final double loadSeconds;
  private final LabHost host;
  private Optional<Image> picture = Optional.empty();

  private MeasuredScene(String name, SceneFile file, double loadSeconds, LabHost host) {
    this.name = name;
    this.file = file;
    this.loadSeconds = loadSeconds;
    this.host = host;
  }

  /**
   * Reads a scene.
   *
   * @param change changes the scene after it is read
   * @throws TaskException if the scene's picture does not fit into memory
   * @throws IOException if the scene cannot be read
   */
  public static MeasuredScene read(
      Path scene, SceneParser parser, UnaryOperator<SceneFile> change, LabHost host)
      throws SceneFormatException, TaskException, IOException {
    Cost start = Cost.now();
    SceneFile file = change.apply(host.read(scene, parser));
    double loadSeconds = Cost.since(start).seconds();
    host.requireMemory(file.settings());
    return new MeasuredScene(SceneFolder.name(scene), file, loadSeconds, host);
  }

  /** Returns a copy that renders another scene, without pictures. */
  MeasuredScene with(SceneFile changed) {
    return new MeasuredScene(name, changed, loadSeconds, host);
  }

  /** Returns the file name of the scene, without its extension. */
  String name() {
    return name;
  }

  SceneFile file() {
    return file;
  }

  public RenderSettings settings() {
    return file.settings();
  }

  /**
   * Renders with 1 sample per pixel and returns the seconds of each render.
   *
   * @throws InterruptedException if the host cancels a render
   */
  public List<Double> warmUp(RenderSettings settings, int count) throws InterruptedException {
    List<Double> seconds = new ArrayList<>();
    while (seconds.size() < count) {
      seconds.add(render(settings.toBuilder().samples(1).build()).cost().seconds());
    }
    return seconds;
  }

  /**
   * Renders the same picture several times.
   *
   * @throws TaskException if a picture differs from the first that was measured of this scene
   * @throws InterruptedException if the host cancels a render
   */
  public Measurement measure(RenderSettings settings, int repeat)
      throws TaskException, InterruptedException {
    List<Cost> costs = new ArrayList<>();
    RenderStatistics statistics = RenderStatistics.ZERO;
    while (costs.size() < repeat) {
      Trial.Outcome outcome = render(settings);
      costs.add(outcome.cost());
      statistics = outcome.statistics();
      picture = picture.or(() -> Optional.of(outcome.picture()));
      if (!RasterHash.of(outcome.picture()).equals(RasterHash.of(picture()))) {
        throw ExitCode.INTERNAL.failure(name + ": renders of the same scene differ");
      }
    }
    return new Measurement(
        name, file.hash(), settings, loadSeconds, costs, statistics, RasterHash.of(picture()));
  }

  /** Returns the first picture that was measured. */
  Image picture() {
    return picture.orElseThrow();
  }

  Trial.Outcome render(RenderSettings settings) throws InterruptedException {
    return Trial.render(file.scene(), settings, host);
  }
}
