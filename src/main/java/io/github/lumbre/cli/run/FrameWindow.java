package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.MemoryEstimate;
import io.github.lumbre.render.PassListener;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.PassResult;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.Denoised;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.render.denoise.internal.SeenFrame;
import io.github.lumbre.render.denoise.internal.SharedFrames;
import io.github.lumbre.scenefile.SceneFile;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;

/**
 * The frames of a sequence around the current one, with which it is denoised. Frames are rendered
 * ahead, in their order; those that this command does not write are rendered for their neighbors
 * alone. Films of frames ahead are kept as far as memory allows, otherwise they are rendered again.
 * What a frame becomes depends on nothing but the frames around it. Mutable, for one run.
 */
public final class FrameWindow {
  private final List<Path> targets;
  private final boolean isClosed;
  private Set<Integer> wanted = Set.of();
  private final Set<Integer> unwritten = new HashSet<>();

  /** The frames that are rendered and not written yet. */
  private final Map<Integer, Sampled> ahead = new HashMap<>();

  /** The frames that others still need, denoised by themselves. */
  private final TreeMap<Integer, SeenFrame> seen = new TreeMap<>();
  private final Set<Integer> rendered = new HashSet<>();
  private int current;
  private int again;

  /** The largest number of rendered frames that are kept; 0 before it is known. */
  private int mostKept;

  /**
   * @param targets paths of all frames of the sequence
   * @param isClosed whether the first frame follows the last one
   */
  public FrameWindow(List<Path> targets, boolean isClosed) {
    this.targets = List.copyOf(targets);
    this.isClosed = isClosed;
  }

  /** Sets the numbers of the frames that are written. */
  public void write(List<Integer> numbers) {
    wanted = Set.copyOf(numbers);
    unwritten.addAll(numbers);
  }

  /** Returns with how many other frames a frame is denoised, for its metadata. */
  public String note(int index) {
    return Numbers.count(around(index).size() - 1, "neighbor");
  }

  /** Reads frames, and limits their renders. */
  public interface Source {
    SceneFile read(int index) throws Exception;

    /**
     * @param left number of frames that are still to be rendered, this one included
     */
    RunBudget budget(SceneFile file, int left) throws Exception;
  }

  /**
   * A frame with all its samples.
   *
   * @param seconds rendering time
   * @param denoised the picture, denoised by itself
   */
  record Sampled(
      SceneFile file,
      FilmRenderer renderer,
      Film film,
      RenderStatistics statistics,
      double seconds,
      RunBudget budget,
      Denoised denoised) {}

  /** How frames are rendered. */
  public record Work(
      Path scene,
      Engine engine,
      Denoising denoising,
      int firstSample,
      RenderMonitor monitor,
      Messages messages) {}

  /** Chooses the current frame. */
  public void choose(int index) {
    current = index;
  }

  /** Returns the number of the current frame. */
  public int current() {
    return current;
  }

  /** Returns the scene of the current frame, if it is rendered. */
  public Optional<SceneFile> file() {
    return Optional.ofNullable(ahead.get(current)).map(Sampled::file);
  }

  /** Returns the limits of the current frame, if it is rendered. */
  public Optional<RunBudget> budget() {
    return Optional.ofNullable(ahead.get(current)).map(Sampled::budget);
  }

  /** Returns the {@link #note} of the current frame. */
  String note() {
    return note(current);
  }

  /** Returns the current frame, which is rendered. */
  Sampled sampled() {
    return ahead.get(current);
  }

  /** Returns how often a frame was rendered for its neighbors alone. */
  public int again() {
    return again;
  }

  /**
   * Returns about how many bytes the frames of a window need, besides the render of one of them.
   *
   * @param isClosed whether the first frame follows the last one, so that both ends are kept
   */
  public static long bytes(long pixels, boolean isClosed) {
    long frames = (isClosed ? 4L : 2L) * SharedFrames.REACH + 1;
    return pixels * (frames * SeenFrame.BYTES_PER_PIXEL + SharedFrames.BYTES_PER_PIXEL);
  }

  /** Returns whether the memory is known to suffice. Later, it also holds frames of the window. */
  public boolean hasMemory() {
    return mostKept > 0;
  }

  /**
   * Requires memory for the frames of a window, and finds out how many frames ahead can be kept.
   *
   * @param one estimate for the render of a frame that has just been read
   * @throws TaskException if it does not suffice
   */
  public void require(MemoryEstimate one) throws TaskException {
    long needed = one.neededBytes() + bytes(one.pixels(), isClosed);
    if (needed > one.maxHeapBytes()) {
      throw ExitCode.LIMIT.failure(
          "frames that are denoised with each other need %s of memory, but the maximum heap size"
                  .formatted(MemoryEstimate.mebibytes(needed))
              + " is %s; %s, or use --no-denoise"
                  .formatted(
                      MemoryEstimate.mebibytes(one.maxHeapBytes()), MemoryCheck.advice(needed)));
    }
    // Frames of a turntable share their scene.
    long each = one.filmBytes() + (isClosed ? 0 : one.sceneBytes());
    long left = one.maxHeapBytes() - needed - BuiltInDenoiser.bytes(one.pixels());
    mostKept = 1 + (int) Math.max(0, Math.min(2L * SharedFrames.REACH, left / each));
  }

  /**
   * Renders the frames around the current one that are not rendered.
   *
   * @throws CancellationException if a signal or the deadline ends a render
   */
  public void render(Source source, Work work) throws Exception {
    for (int index : new TreeSet<>(around(current))) {
      if (!seen.containsKey(index) || index == current && !ahead.containsKey(index)) {
        render(index, source, work);
      }
    }
  }

  /** Returns the numbers of a frame and of those around it. */
  private List<Integer> around(int index) {
    List<Integer> numbers = new ArrayList<>(List.of(index));
    numbers.addAll(neighbors(index, -1));
    numbers.addAll(neighbors(index, 1));
    return numbers;
  }

  /** Returns the numbers of the frames to one side, the nearest first. */
  private List<Integer> neighbors(int index, int step) {
    int count = targets.size();
    int reach = isClosed ? Math.min(SharedFrames.REACH, (count - 1) / 2) : SharedFrames.REACH;
    return IntStream.rangeClosed(1, reach)
        .map(i -> index + step * i)
        .filter(i -> isClosed || 0 <= i && i < count)
        .map(i -> Math.floorMod(i, count))
        .boxed()
        .toList();
  }

  /** Returns the number of frames that are still to be rendered, if none is rendered twice. */
  private int left() {
    Set<Integer> needed = new HashSet<>();
    wanted.forEach(index -> needed.addAll(around(index)));
    needed.removeAll(rendered);
    return Math.max(1, needed.size());
  }

  private void render(int index, Source source, Work work) throws Exception {
    SceneFile file = source.read(index);
    RunBudget budget = source.budget(file, left());
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene());
    Film film = renderer.newFilm(work.firstSample);
    boolean isTimed = budget.secondsLeft().isPresent();
    PassLoop loop =
        new PassLoop(work.engine.over(work.scene, file, renderer, isTimed), film);
    long start = System.nanoTime();
    RenderMonitor monitor = work.monitor;
    monitor.limited(budget);
    monitor.started(budget.isOpen() ? 0 : film.window().pixels() * file.settings().samples());
    monitor.film(film);
    PassResult passes = loop.run(budget.watch(), PassListener.NONE, monitor);
    if (!passes.complete()) {
      throw new CancellationException("stopped");
    }
    double seconds = 1e-9 * (System.nanoTime() - start);
    Denoised denoised = denoised(index, file, film, work);
    boolean isFirst = rendered.add(index);
    again += wanted.contains(index) && isFirst ? 0 : 1;
    if (index == current || wanted.contains(index) && isFirst && ahead.size() < mostKept) {
      ahead.put(
          index,
          new Sampled(file, renderer, film, passes.statistics(), seconds, budget, denoised));
    }
  }

  /** Denoises a frame by itself, and looks at what it shows. */
  private Denoised denoised(int index, SceneFile file, Film film, Work work) {
    int threads = work.denoising.withThreads(file.settings().threads()).usedThreads();
    return work.monitor
        .finishing(
            "denoising",
            () -> {
              NoisyPicture noisy = NoisyPicture.of(film);
              if (wanted.contains(index)) {
                work.denoising.advise(noisy, targets.get(index).toString(), work.messages);
              }
              List<float[]> left = new ArrayList<>();
              Denoised denoised = BuiltInDenoiser.denoise(noisy, threads, left::add);
              Optional<SeenFrame> like =
                  Optional.ofNullable(seen.floorEntry(index))
                      .or(() -> Optional.ofNullable(seen.firstEntry()))
                      .map(Map.Entry::getValue);
              SeenFrame frame =
                  SeenFrame.of(
                      file.scene(),
                      file.settings(),
                      noisy,
                      denoised.image(),
                      left.get(0),
                      like,
                      threads);
              seen.put(index, frame);
              return denoised;
            })
        .orElseThrow(() -> new CancellationException("stopped"));
  }

  /** Drops the frames that no frame needs which is still to be written. */
  private void forget() {
    Set<Integer> needed = new HashSet<>();
    unwritten.forEach(index -> needed.addAll(around(index)));
    seen.keySet().retainAll(needed);
  }

  /**
   * Returns the current frame, mixed with those around it. It is then written.
   *
   * @param threads number of threads; the result does not depend on it
   * @throws CancellationException if it is stopped
   */
  Denoised mixed(int threads, RenderMonitor monitor) {
    Denoised alone = ahead.remove(current).denoised();
    Denoised mixed =
        monitor
            .finishing(
                "denoising",
                () ->
                    new Denoised(
                        SharedFrames.mixed(seen.get(current), seen(-1), seen(1), threads),
                        alone.engine(),
                        alone.change(),
                        alone.relativeNoise(),
                        alone.relativeError()))
            .orElseThrow(() -> new CancellationException("stopped"));
    unwritten.remove(current);
    forget();
    return mixed;
  }

  /** Returns the frames to one side that have the size of the current one. */
  private List<SeenFrame> seen(int step) {
    SeenFrame own = seen.get(current);
    return neighbors(current, step).stream().map(seen::get).takeWhile(own::hasSizeOf).toList();
  }
}
