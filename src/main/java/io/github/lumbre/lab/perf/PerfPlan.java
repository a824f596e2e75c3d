package io.github.lumbre.lab.perf;

import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scene.internal.SceneInside;
import io.github.lumbre.scene.internal.Specialization;
import io.github.lumbre.scenefile.SceneFile;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * The plan of a measurement: how scenes are rendered and timed.
 *
 * @param size frame size; empty for the scene's, scaled down to {@link #SIDE}
 * @param samples samples per pixel, at least 1
 * @param threads numbers of threads, each at least 1; every scene is timed with each of them
 * @param warmup number of untimed renders with 1 sample per pixel before the timed ones
 * @param repeat number of timed renders, at least 1
 * @param pairs number of pairs of renders with different seeds that measure the noise, at least 1
 * @param without specializations that are switched off
 * @param adaptive whether noisy pixels get more samples
 * @param split number of branches that paths are split into, at least 1
 */
public record PerfPlan(
    Optional<FrameSize> size,
    int samples,
    List<Integer> threads,
    int warmup,
    int repeat,
    int pairs,
    Set<Specialization> without,
    boolean adaptive,
    int split) {
  /** The longer side, in pixels, that frames are scaled down to. */
  static final int SIDE = 320;

  /** The number of renders with 1 sample per pixel after the timed ones, if there is a warm-up. */
  static final int WARM_RENDERS = 5;

  public PerfPlan {
    threads = List.copyOf(threads);
    without = Set.copyOf(without);
  }

  /** Returns a scene's settings with the plan's changes, except the number of threads. */
  RenderSettings over(RenderSettings inScene) {
    RenderSettings sized =
        size.map(s -> s.over(inScene)).orElseGet(() -> SampleBudget.shrunk(inScene, SIDE));
    return sized.toBuilder().samples(samples).adaptive(adaptive).split(split).build();
  }

  /** Returns the baseline of this plan: all specializations, uniform samples, no path splitting. */
  PerfPlan plain() {
    return new PerfPlan(size, samples, threads, warmup, repeat, pairs, Set.of(), false, 1);
  }

  /** Returns a scene with the plan's specializations switched off. */
  SceneFile over(SceneFile file) {
    Scene scene = file.scene();
    for (Specialization shortcut : without) {
      scene = SceneInside.of(scene).without(shortcut);
    }
    return file.with(scene);
  }

  String sentences() {
    String counts = threads.stream().map(String::valueOf).collect(Collectors.joining(", "));
    return String.format(
            "Threads: %s. Warm-up renders of 1 sample per pixel: %d. Timed renders: %d (median"
                + " reported). Pairs of seeds for the noise: %d.",
            counts, warmup, repeat, pairs)
        + (without.isEmpty() ? "" : " Without the specializations " + new TreeSet<>(without) + ".")
        + (adaptive ? " Adaptive sampling." : "")
        + (split > 1 ? " Paths split into " + split + "." : "");
  }
}
