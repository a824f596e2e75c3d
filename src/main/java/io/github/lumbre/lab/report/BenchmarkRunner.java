package io.github.lumbre.lab.report;

import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.MemoryCheck;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.metrics.Interval;
import io.github.lumbre.lab.perf.RasterHash;
import io.github.lumbre.lab.perf.TimedRender;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.RenderResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Renders rows of the report's table and measures their times. */
public final class BenchmarkRunner {
  private final SceneFolder scenes;
  private final BenchmarkPlan plan;
  private final SceneParser parser;
  private final LabHost host;

  /** The recorded data of a render. */
  private record Timed(
      boolean complete, double seconds, RenderStatistics statistics, String hash) {}

  /**
   * @param parser parser of the scenes
   * @param host reads the scenes and displays each render
   */
  public BenchmarkRunner(SceneFolder scenes, BenchmarkPlan plan, SceneParser parser, LabHost host) {
    this.scenes = scenes;
    this.parser = parser;
    this.plan = plan;
    this.host = host;
  }

  public BenchmarkPlan plan() {
    return plan;
  }

  /**
   * Measures a row and returns the result; empty if stopped.
   *
   * @throws TaskException if the scene cannot be read, if the picture does not fit into memory, or
   *     if two renders of the row differ
   */
  public Optional<BenchmarkResult> run(ReportRow row)
      throws SceneFormatException, TaskException, InterruptedException {
    long start = System.nanoTime();
    SceneParser ofRow = parser.inMode(row.mode()).overriding(inScene -> settings(row, inScene));
    SceneFile file = host.read(scenes.file(row.scene()), ofRow);
    double loadSeconds = secondsSince(start);
    MemoryCheck.require(file.settings(), FilmLayers.NONE);

    RenderSettings single = file.settings().toBuilder().samples(1).build();
    for (int i = 0; i < plan.warmup(); i++) {
      if (!render(file, single).result().complete()) {
        return Optional.empty();
      }
    }
    return measure(row, file, loadSeconds);
  }

  private RenderSettings settings(ReportRow row, RenderSettings inScene) {
    return row.over(inScene).toBuilder()
        .samples(row.samplesAt(plan.share()))
        .threads(plan.threads())
        .build();
  }

  private Optional<BenchmarkResult> measure(ReportRow row, SceneFile file, double loadSeconds)
      throws TaskException, InterruptedException {
    List<Timed> renders = new ArrayList<>();
    for (int i = 0; i < plan.repeat(); i++) {
      Timed timed = time(file);
      if (!timed.complete) {
        return Optional.empty();
      }
      renders.add(timed);
    }
    Timed first = renders.get(0);
    if (!renders.stream().allMatch(timed -> timed.hash.equals(first.hash))) {
      throw new TaskException(
          Kind.INTERNAL, "row " + row.number() + ": renders of the same scene differ");
    }
    return Optional.of(
        new BenchmarkResult(
            row,
            file.settings().samples(),
            plan.threads(),
            loadSeconds,
            Interval.median(renders.stream().mapToDouble(Timed::seconds).toArray()),
            first.statistics,
            file.hash(),
            first.hash));
  }

  private Timed time(SceneFile file) throws InterruptedException {
    TimedRender render = render(file, file.settings());
    RenderResult result = render.result();
    return new Timed(
        result.complete(), render.seconds(), result.statistics(), RasterHash.of(result.image()));
  }

  private TimedRender render(SceneFile file, RenderSettings settings) throws InterruptedException {
    try (LabHost.Display display = host.display()) {
      return TimedRender.of(file.scene(), settings, display);
    }
  }

  private static double secondsSince(long start) {
    return (System.nanoTime() - start) * 1e-9;
  }
}
