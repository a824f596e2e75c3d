package io.github.lumbre.lab.perf;

import io.github.lumbre.image.Image;
import io.github.lumbre.lab.LabHost;
import io.github.lumbre.lab.MemoryCheck;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.metrics.PictureNoise;
import io.github.lumbre.lab.perf.PerfResult.Repetition;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.scene.RenderSettings;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Renders scenes by a plan, and measures time, memory and noise. */
public final class PerfRunner {
  private final PerfPlan plan;
  private final LabHost host;

  /** Unwinds a cancelled measurement. */
  private static final class Stopped extends Exception {
    private static final long serialVersionUID = 1;
  }

  /** The times of a scene with one number of threads, and one of its renders. */
  private record Timed(
      RenderSettings settings, WarmUp warmUp, List<Repetition> repetitions, TimedRender render) {}

  /**
   * @param host reads the scenes and displays each render
   */
  public PerfRunner(PerfPlan plan, LabHost host) {
    this.plan = plan;
    this.host = host;
  }

  /**
   * Measures a scene and returns one result for each number of threads; empty if stopped.
   *
   * @throws TaskException if the scene cannot be read, if the picture does not fit into memory, or
   *     if two renders of the scene differ
   */
  public Optional<List<PerfResult>> run(Path scene)
      throws SceneFormatException, TaskException, InterruptedException {
    long start = System.nanoTime();
    SceneParser parser = new SceneParser().overriding(plan::over);
    SceneFile file = plan.over(host.read(scene, parser));
    double loadSeconds = (System.nanoTime() - start) * 1e-9;
    MemoryCheck.require(file.settings(), FilmLayers.NONE);
    try {
      return Optional.of(run(SceneFolder.name(scene), file, loadSeconds));
    } catch (Stopped e) {
      return Optional.empty();
    }
  }

  private List<PerfResult> run(String scene, SceneFile file, double loadSeconds)
      throws TaskException, InterruptedException, Stopped {
    List<Timed> all = new ArrayList<>();
    for (int threads : plan.threads()) {
      all.add(time(scene, file, file.settings().toBuilder().threads(threads).build()));
    }
    Image picture = all.get(0).render.result().image();
    String hash = RasterHash.of(picture);
    for (Timed timed : all) {
      requireSame(scene, hash, timed.render);
    }
    // Measure the noise last, because renders in between would warm up the timed ones.
    PictureNoise noise = noise(file, picture);
    return all.stream()
        .map(
            timed ->
                new PerfResult(
                    scene,
                    file.hash(),
                    timed.settings,
                    loadSeconds,
                    timed.warmUp,
                    timed.repetitions,
                    timed.render.result().statistics(),
                    hash,
                    noise))
        .toList();
  }

  private Timed time(String scene, SceneFile file, RenderSettings settings)
      throws TaskException, InterruptedException, Stopped {
    List<Double> cold = shortRenders(file, settings, plan.warmup());
    if (plan.warmup() > 0) {
      // Long renders, whose rate is measured here, would change the kernel sooner or later.
      file.scene().changeKernel(() -> true);
    }
    List<Repetition> repetitions = new ArrayList<>();
    TimedRender first = render(file, settings);
    repetitions.add(repetition(first));
    String hash = RasterHash.of(first.result().image());
    while (repetitions.size() < plan.repeat()) {
      TimedRender render = render(file, settings);
      requireSame(scene, hash, render);
      repetitions.add(repetition(render));
    }
    int warmRenders = cold.isEmpty() ? 0 : PerfPlan.WARM_RENDERS;
    WarmUp warmUp = new WarmUp(cold, shortRenders(file, settings, warmRenders));
    return new Timed(settings, warmUp, repetitions, first);
  }

  /** Renders with 1 sample per pixel and returns the seconds of each render. */
  private List<Double> shortRenders(SceneFile file, RenderSettings settings, int count)
      throws InterruptedException, Stopped {
    RenderSettings single = settings.toBuilder().samples(1).build();
    List<Double> seconds = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      seconds.add(render(file, single).seconds());
    }
    return seconds;
  }

  private PictureNoise noise(SceneFile file, Image first) throws InterruptedException, Stopped {
    RenderSettings settings = file.settings().toBuilder().threads(0).build();
    List<Image> pictures = new ArrayList<>(List.of(first));
    while (pictures.size() < 2 * plan.pairs()) {
      long seed = settings.seed() + pictures.size();
      RenderSettings other = settings.toBuilder().seed(seed).build();
      pictures.add(render(file, other).result().image());
    }
    return PictureNoise.of(pictures);
  }

  private TimedRender render(SceneFile file, RenderSettings settings)
      throws InterruptedException, Stopped {
    TimedRender render;
    try (LabHost.Display display = host.display()) {
      render = TimedRender.of(file.scene(), settings, display);
    }
    if (!render.result().complete()) {
      throw new Stopped();
    }
    return render;
  }

  private static Repetition repetition(TimedRender render) {
    return new Repetition(render.seconds(), render.cpuSeconds(), render.allocatedBytes());
  }

  private static void requireSame(String scene, String hash, TimedRender render)
      throws TaskException {
    if (!RasterHash.of(render.result().image()).equals(hash)) {
      throw new TaskException(Kind.INTERNAL, scene + ": renders of the same scene differ");
    }
  }
}
