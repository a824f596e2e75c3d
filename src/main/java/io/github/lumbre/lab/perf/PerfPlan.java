package io.github.lumbre.lab.perf;

import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Specialization;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * How scenes are rendered and timed.
 *
 * @param size of the frame; empty means the scene's, shrunk to {@link #SIDE}
 * @param samples per pixel, at least 1
 * @param threads how many, each at least 1; every scene is timed with each number
 * @param warmup how many renders of one sample per pixel come before the timed ones
 * @param repeat how many renders are timed, at least 1
 * @param pairs of renders with seeds of their own that tell the noise, at least 1
 * @param without what the renderer is not to leave out though the scenes do not require it
 * @param adaptive whether noisy pixels get more of the samples
 * @param split how many ways paths go on, at least 1
 */
public record PerfPlan(
    Optional<Size> size,
    int samples,
    List<Integer> threads,
    int warmup,
    int repeat,
    int pairs,
    Set<Specialization> without,
    boolean adaptive,
    int split) {
  /** The longer side, in pixels, that frames are shrunk to. */
  static final int SIDE = 320;

  /** How many renders of one sample per pixel come after the timed ones, if any came before. */
  static final int WARM_RENDERS = 5;

  public PerfPlan {
    threads = List.copyOf(threads);
    without = Set.copyOf(without);
  }

  /** Returns a scene's settings as the plan changes them, but for the number of threads. */
  RenderSettings over(RenderSettings inScene) {
    RenderSettings sized =
        size.map(s -> inScene.toBuilder().size(s.width(), s.height()).build())
            .orElseGet(() -> SampleBudget.shrunk(inScene, SIDE));
    return sized.toBuilder().samples(samples).adaptive(adaptive).split(split).build();
  }

  /** Returns the same plan with all shortcuts, even samples and paths that are not split. */
  PerfPlan plain() {
    return new PerfPlan(size, samples, threads, warmup, repeat, pairs, Set.of(), false, 1);
  }

  /** Returns a scene that takes no shortcut which the plan does without. */
  SceneFile over(SceneFile file) {
    Scene scene = file.scene();
    for (Specialization shortcut : without) {
      scene = scene.without(shortcut);
    }
    return file.with(scene);
  }

  /** Returns all of it as sentences. */
  String sentences() {
    String counts = threads.stream().map(String::valueOf).collect(Collectors.joining(", "));
    return "Threads: "
        + counts
        + ". Warm-up renders of 1 sample per pixel: "
        + warmup
        + ". Timed renders: "
        + repeat
        + ", of which the median counts. Pairs of seeds for the noise: "
        + pairs
        + "."
        + (without.isEmpty() ? "" : " Without the shortcuts " + new TreeSet<>(without) + ".")
        + (adaptive ? " Adaptive." : "")
        + (split > 1 ? " Paths split into " + split + "." : "");
  }
}
