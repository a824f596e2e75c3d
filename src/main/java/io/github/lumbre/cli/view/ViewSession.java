package io.github.lumbre.cli.view;

import io.github.lumbre.image.Image;
import io.github.lumbre.render.preview.Preview;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * What a page shows and what it may change: the picture, the scene, the camera, whether samples are
 * added. Thread-safe: the rendering thread, the threads of requests and the one that watches files
 * share it.
 */
public final class ViewSession {
  /** A drag whose end was not reported ends by itself after this time. */
  private static final long DRAG_NANOS = 1_500_000_000L;

  private final String name;
  private final Viewers viewers = new Viewers(System::nanoTime);
  private final ErrorHistory errors = new ErrorHistory();
  private Optional<Frame> frame = Optional.empty();
  private Optional<Image> draft = Optional.empty();
  private Optional<Frame> denoised = Optional.empty();
  private final SceneCamera camera = new SceneCamera();
  private Set<Layer> extraLayers = Set.of();
  private List<String> problems = List.of();
  private RenderClock clock = new RenderClock(() -> true);
  private long version = 1;
  private long generation;
  private long dragNanos;
  private boolean isDragging;
  private boolean isRunning = true;
  private boolean isFinished;
  private boolean isClosed;

  /**
   * @param name of the file that is viewed
   */
  public ViewSession(String name) {
    this.name = name;
  }

  /**
   * A state of the camera and the scene to render.
   *
   * @param generation changes with each of them
   * @param isDraft whether the camera is being dragged, so that a quick picture is enough
   */
  record Job(long generation, SceneFile file, boolean isDraft) {}

  String name() {
    return name;
  }

  Viewers viewers() {
    return viewers;
  }

  // ---- What is shown

  /** Shows a picture that is not rendered here. */
  public synchronized void show(Frame still) {
    frame = Optional.of(still);
    isFinished = true;
    changed();
  }

  /** Shows a preview of a generation; an earlier generation's is ignored. */
  synchronized void show(long ofGeneration, Preview preview, boolean isDraft, boolean isLast) {
    if (ofGeneration != generation) {
      return;
    }
    changed();
    Image image = preview.image();
    if (isDraft) {
      draft = Optional.of(image);
    } else {
      clock.correct(preview.totalSamples());
    }
    if (!isDraft && preview.samples() < 1 && draft.isPresent()) {
      image = Frame.filled(image, draft.get());
    }
    frame =
        Optional.of(
            new Frame(
                version,
                image,
                preview.layers(),
                preview.samples(),
                isDraft,
                isLast,
                preview.metadata(),
                isDraft ? Optional.empty() : denoised));
    preview
        .noise()
        .ifPresent(
            n ->
                errors.add(
                    new ErrorPoint(
                        clock.seconds(),
                        preview.samples(),
                        n.relativeRmse(),
                        n.upperRelativeRmse(),
                        n.isDoubtful())));
  }

  /** Shows the denoised picture of a job, if it is still the current one. */
  synchronized void showDenoised(
      Job job, Image image, double samples, Map<String, String> metadata) {
    if (!isStale(job)) {
      changed();
      Frame clean =
          new Frame(version, image, List.of(), samples, false, true, metadata, Optional.empty());
      denoised = Optional.of(clean);
      frame = frame.map(noisy -> noisy.with(clean));
    }
  }

  synchronized Optional<Frame> frame() {
    return frame;
  }

  /** Waits until there is a frame with the given layers, or the time is over. */
  Optional<Frame> frameWith(Set<Layer> layers, long millis) throws InterruptedException {
    viewers.want(layers);
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    synchronized (this) {
      while (System.nanoTime() < end && !isClosed) {
        if (frame.filter(f -> f.isDraft() || has(f, layers)).isPresent()) {
          return frame;
        }
        viewers.hurry();
        notifyAll();
        wait(50);
      }
      return frame;
    }
  }

  private static boolean has(Frame frame, Set<Layer> layers) {
    return layers.stream()
        .allMatch(
            layer -> frame.layers().stream().anyMatch(l -> LayerNames.belongsTo(l.name(), layer)));
  }

  // ---- What is rendered

  /** Starts to render a scene that was read; the camera stays where the page has moved it. */
  public synchronized void open(SceneFile file) {
    camera.open(file);
    problems = List.of();
    restart();
  }

  /** Shows problems, such as why the scene cannot be read; what is rendered stays. */
  public synchronized void fail(List<String> newProblems) {
    problems = List.copyOf(newProblems);
    changed();
  }

  private void restart() {
    generation++;
    draft = Optional.empty();
    denoised = Optional.empty();
    errors.clear();
    isFinished = false;
    clock = new RenderClock(() -> true);
    changed();
  }

  /** Sets the clock of the full render of a generation. */
  synchronized void timedBy(long ofGeneration, RenderClock newClock) {
    if (ofGeneration == generation) {
      clock = newClock;
    }
  }

  /**
   * Waits for something to render.
   *
   * @param drafted the generation of the last draft
   * @return empty if there is nothing to do for a while, or the session is closed
   */
  synchronized Optional<Job> next(long drafted) throws InterruptedException {
    if (isDragging && System.nanoTime() - dragNanos > DRAG_NANOS) {
      isDragging = false;
    }
    boolean isNew = drafted != generation;
    boolean hasWork =
        camera.scene().isPresent() && (isNew || !isDragging && (isRunning && !isFinished));
    if (hasWork && !isClosed) {
      return Optional.of(new Job(generation, camera.scene().get(), isNew));
    }
    wait(200);
    return Optional.empty();
  }

  /** Returns whether a job is no longer the current one. */
  synchronized boolean isStale(Job job) {
    return isClosed || job.generation() != generation;
  }

  /** Returns whether a full render has to pause. */
  synchronized boolean mustPause(Job job) {
    return isStale(job) || !isRunning || isDragging;
  }

  /** Marks the render of a generation as finished. */
  synchronized void finish(long ofGeneration) {
    if (ofGeneration == generation) {
      isFinished = true;
      changed();
    }
  }

  // ---- What the page changes

  synchronized void setRunning(boolean isOn) {
    isRunning = isOn;
    changed();
  }

  synchronized void move(Orbit next, boolean isStill) {
    if (camera.move(next)) {
      isDragging = !isStill;
      dragNanos = System.nanoTime();
      restart();
    }
  }

  /** Ends a drag without moving the camera. */
  synchronized void release() {
    isDragging = false;
    changed();
  }

  /** Moves the camera back to where the scene has it. */
  synchronized void goHome() {
    camera.goHome();
    isDragging = false;
    restart();
  }

  /** Records further layers from now on. Returns whether they are new. */
  synchronized boolean record(Set<Layer> layers) {
    Set<Layer> all = new LinkedHashSet<>(extraLayers);
    boolean isNew = all.addAll(layers);
    extraLayers = Set.copyOf(all);
    return isNew;
  }

  synchronized Set<Layer> extraLayers() {
    return extraLayers;
  }

  synchronized Optional<Orbit> orbit() {
    return camera.orbit();
  }

  /** Returns where the camera has been moved to; empty if it is where the scene has it. */
  synchronized Optional<MovedTo> moved() {
    return camera.moved();
  }

  /** Returns the scene as it is rendered, with the camera where it is. */
  synchronized Optional<SceneFile> scene() {
    return camera.scene();
  }

  synchronized boolean isClosed() {
    return isClosed;
  }

  /** Ends all waiting. */
  public synchronized void close() {
    isClosed = true;
    notifyAll();
  }

  private void changed() {
    version++;
    notifyAll();
  }

  // ---- The state for the page

  /** Waits until the version is another one, or the time is over. */
  synchronized void await(long known, long millis) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis);
    for (long left = millis; version == known && left > 0 && !isClosed; ) {
      wait(left);
      left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
    }
  }

  /** Returns a consistent copy of what the page shows besides the picture. */
  synchronized Snapshot snapshot() {
    Optional<RenderSettings> settings = camera.scene().map(SceneFile::settings);
    return new Snapshot(
        version,
        name,
        frame,
        status(),
        settings,
        camera.scene().map(LayerNames::recorded).orElse(List.of()),
        clock.samples(),
        clock.rate(),
        clock.seconds(),
        clock.secondsLeft(),
        errors.points(),
        problems,
        camera.moved().isPresent());
  }

  private String status() {
    if (camera.scene().isEmpty()) {
      return frame.isPresent() ? "still" : "reading";
    }
    if (isDragging) {
      return "moving";
    }
    return isFinished ? "finished" : isRunning ? "rendering" : "stopped";
  }
}
