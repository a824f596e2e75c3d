package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.RenderCommand.Invocation;
import io.github.lumbre.cli.option.SequenceFlags;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.run.Engine;
import io.github.lumbre.cli.run.FinishedFrames;
import io.github.lumbre.cli.run.FrameWindow;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.JoinedFrames;
import io.github.lumbre.cli.run.PictureExposure;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.cli.run.Run;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * Renders the frames of a turntable, of an animation or of several scenes in turn, and joins them
 * if they belong into one file. Mutable, for one run.
 */
final class RenderSequence {
  private static final String GO_ON = "; the same command with --continue goes on";

  private final RenderOptions options;
  private final Engine engine;
  private final FrameRender render;
  private final Invocation invocation;

  /** The path of the one file, or of the pictures without their numbers. */
  private final Path target;

  private final boolean isJoined;
  private final FinishedFrames finished;
  private List<Path> all = List.of();
  private List<Integer> part = List.of();
  private List<Integer> missing = List.of();
  private Optional<JoinedFrames> file = Optional.empty();
  private Optional<String> size = Optional.empty();
  private int written;
  private String partial = "";
  private boolean isDenoised;
  private Optional<FrameWindow> window = Optional.empty();

  /** Renders the current frame and returns its exit code. */
  interface FrameRender {
    ExitCode run(Invocation invocation, Frames frames, PictureExposure exposing) throws Exception;
  }

  /**
   * @param target path of the one file, or of the pictures without their numbers
   */
  RenderSequence(
      RenderOptions options, Engine engine, FrameRender render, Invocation shared, Path target) {
    this.options = options;
    this.engine = engine;
    this.render = render;
    invocation = shared;
    this.target = target;
    isJoined = options.to.animation().isPresent();
    Set<String> keywords = PictureMetadata.identifying();
    if (options.budgets.areGiven() || options.quality.isAdaptive()) {
      keywords.remove(PictureMetadata.SAMPLES);
    }
    finished = new FinishedFrames(keywords);
  }

  /**
   * Renders the frames that are wanted and not there.
   *
   * @return the highest of their exit codes
   */
  ExitCode run() throws Exception {
    JsonSummary report = new JsonSummary("render", options.scene.scene());
    Run border = options.run.border(invocation.interruption(), Optional.empty());
    border.failing(report, this::plan);
    if (!isJoined || options.sequence.havePart()) {
      ExitCode code = render();
      options.run.summarize(summary(), sinceStart());
      return code;
    }
    return border.of(report, () -> join(report));
  }

  private Duration sinceStart() {
    return Duration.between(invocation.start(), Instant.now());
  }

  private ExitCode render() throws Exception {
    ExitCode code = ExitCode.OK;
    if (missing.isEmpty()) {
      return code;
    }
    PictureExposure exposing = PictureExposure.ofAll(finished.exposure());
    List<Path> targets = missing.stream().map(all::get).toList();
    try (Frames frames = new Frames(targets, invocation.interruption(), invocation.deadline())) {
      frames.checkedBy(this::requireFits);
      code =
          frames.each(
              index -> {
                choose(missing.get(index));
                window.ifPresent(around -> around.choose(missing.get(index)));
                options.run.about(frames);
                return render(frames, exposing);
              });
      written = missing.size() - frames.left();
      partial = frames.partial();
    }
    return code;
  }

  /** Returns the frames that are denoised with each other; empty if each is by itself. */
  private Optional<FrameWindow> window(Path picture) throws TaskException {
    boolean isShared =
        options.sequence.areGiven()
            && all.size() > 1
            && options.denoising(picture, engine).filter(d -> d.program().isEmpty()).isPresent();
    return isShared
        ? Optional.of(
            new FrameWindow(all, options.sequence.motion().orElseThrow().turns() > 0))
        : Optional.empty();
  }

  private ExitCode render(Frames frames, PictureExposure exposing) throws Exception {
    try {
      return render.run(invocation.with(window), frames, exposing);
    } catch (TaskException e) {
      throw frames.haveEnded() && isJoined
          ? new TaskException(e.code(), e.getMessage() + GO_ON, e)
          : e;
    }
  }

  /** Requires that a frame suits the one file and has the size of the frames before. */
  private void requireFits(RenderSettings settings) throws TaskException {
    Crop window = settings.window();
    if (file.isPresent()) {
      file.get().requireFits(window);
    }
    if (isJoined && size.isPresent() && !size.get().equals(sizeOf(window))) {
      throw ExitCode.USAGE.failure(
          "%s: has %s pixels, expected %s, as the frames before; set one size with --size"
              .formatted(options.scene.scene(), sizeOf(window), size.get()));
    }
    size = Optional.of(sizeOf(window));
  }

  private static String sizeOf(Crop window) {
    return window.width() + "x" + window.height();
  }

  /** Renders the frames and joins all into one file. */
  private ExitCode join(JsonSummary report) throws Exception {
    try (JoinedFrames joined = reserved()) {
      file = Optional.of(joined);
      ExitCode code = render();
      if (written < missing.size()) {
        if (code.isFailure()) {
          return code;
        }
        throw joined.incomplete(invocation.deadline());
      }
      options.run.aboutAll();
      try (RenderMonitor monitor = monitor()) {
        joined.join(all, monitor);
      }
      joined
          .loss()
          .ifPresent(loss -> options.run.errors().line("warning: " + target + ": " + loss));
      report.put("output", target.toString());
      report.put("frames", all.size());
      report.put("frames_kept", finished.size());
      report.put("fps", options.sequence.rate().toString());
      report.put("seconds", 1e-9 * sinceStart().toNanos());
      options.run.summarize(
          "%s: %s%s, %s frames per second%s"
              .formatted(
                  target,
                  Numbers.count(all.size(), "frame"),
                  (isDenoised ? ", denoised" : "") + neighbors(),
                  options.sequence.rate(),
                  kept() > 0 ? "; " + keptText() : ""),
          sinceStart());
      return code;
    }
  }

  private JoinedFrames reserved() throws Exception {
    try (RenderMonitor monitor = monitor()) {
      SequenceFlags flags = options.sequence;
      return monitor.reading(
          target, () -> JoinedFrames.reserve(target, flags.rate(), flags.ffmpeg()));
    }
  }

  /**
   * Returns {@code 30 of 36 pictures written, denoised, 6 were complete: a-000.png to a-035.png}.
   */
  private String summary() {
    return written
        + " of "
        + Numbers.count(part.size(), "picture")
        + " written"
        + (isDenoised ? ", denoised" : "")
        + neighbors()
        + partial
        + (kept() > 0 ? ", " + keptText() : "")
        + ": "
        + all.get(part.get(0))
        + (part.size() > 1 ? " to " + all.get(part.get(part.size() - 1)) : "");
  }

  /** Returns {@code , 6 neighbors rendered again}; empty if there are none. */
  private String neighbors() {
    int again = window.map(FrameWindow::again).orElse(0);
    return again == 0 ? "" : ", " + Numbers.count(again, "neighbor") + " rendered again";
  }

  private int kept() {
    return part.size() - missing.size();
  }

  private String keptText() {
    return kept() + (kept() == 1 ? " was" : " were") + " complete";
  }

  private RenderMonitor monitor() {
    return options.run.monitor(invocation.interruption(), invocation.deadline());
  }

  /** Chooses the scene of a frame. */
  private void choose(int index) {
    if (options.sequence.areGiven()) {
      options.scene.choose(index);
    } else {
      options.scene.choose(invocation.scenes().get(index));
    }
  }

  /** Finds out which frames there are, and which of them are complete. */
  private ExitCode plan() throws Exception {
    Path pictures = isJoined ? JoinedFrames.picture(target) : target;
    isDenoised = options.denoising(pictures, engine).isPresent();
    if (isJoined) {
      options.checkOutputs(invocation.scenes(), "-o", List.of());
      requireNoFrames();
    }
    try (RenderMonitor monitor = monitor()) {
      all = Frames.numbered(pictures, count(monitor));
      part = options.sequence.part(all.size());
      window = window(pictures);
      if (options.sequence.areContinued()) {
        requireMetadata(pictures);
        monitor.reading(options.scene.scene(), this::find);
      }
    }
    requireExposure();
    missing = part.stream().filter(index -> !finished.contains(all.get(index))).toList();
    window.ifPresent(around -> around.write(missing));
    return ExitCode.OK;
  }

  private int count(RenderMonitor monitor) throws Exception {
    if (!options.sequence.areGiven()) {
      return invocation.scenes().size();
    }
    int turns = options.sequence.motion().orElseThrow().turns();
    if (turns > 0) {
      return turns;
    }
    return monitor.reading(
        options.scene.scene(), () -> options.scene.sequence(options.parser()).count());
  }

  /** Requires that there are no frames of an earlier run, unless they are continued. */
  private void requireNoFrames() throws TaskException {
    Path folder = JoinedFrames.folder(target);
    if (!options.sequence.areContinued() && !options.sequence.havePart() && Files.exists(folder)) {
      throw ExitCode.OUTPUT.failure(
          folder
              + ": exists, with frames of an earlier run; go on with them by --continue, or remove"
              + " the folder");
    }
  }

  private static void requireMetadata(Path pictures) throws TaskException {
    Optional<ImageFormat> format = ImageFormat.of(pictures);
    if (!format.equals(Optional.of(ImageFormat.PNG))
        && !format.equals(Optional.of(ImageFormat.EXR))) {
      throw ExitCode.USAGE.failure(
          "--continue: expected PNG or OpenEXR pictures (-o), which state their scene, found "
              + pictures);
    }
  }

  /** Requires that an automatic exposure is the one of the first frame. */
  private void requireExposure() throws TaskException {
    if (options.flags.isExposureAutomatic() && part.get(0) > 0 && finished.exposure().isEmpty()) {
      throw ExitCode.USAGE.failure(
          "--exposure auto: is chosen from the first frame, which is not among --frames; render"
              + " --frames 0 first and use --continue, or give a number of stops");
    }
  }

  /** Finds the frames that are complete; also those that this run would not render. */
  private FinishedFrames find() throws Exception {
    Optional<SceneFile> first = Optional.empty();
    for (int i = 0; i < all.size(); i++) {
      if (Files.exists(all.get(i))) {
        choose(i);
        if (first.isEmpty() || !options.sequence.areGiven()) {
          first = Optional.of(options.announced().load(options.parser(), options.run.errors()));
        }
        finished.add(all.get(i), expected(i, first.get()));
      }
    }
    return finished;
  }

  /** Returns the metadata of a frame as it would be rendered now. */
  private Map<String, String> expected(int index, SceneFile file)
      throws SceneFormatException, TaskException, IOException {
    boolean isDrawing = options.isDrawing();
    Map<String, String> expected =
        isDrawing
            ? PictureMetadata.ofDrawing(options.scene.scene(), file)
            : PictureMetadata.of(options.scene.scene(), file, file.settings());
    if (options.sequence.areGiven()) {
      expected.put(PictureMetadata.SCENE_HASH, options.scene.hash(index));
    }
    OptionalDouble error = isDrawing ? OptionalDouble.empty() : options.targetError();
    error.ifPresent(e -> expected.put(PictureMetadata.TARGET_ERROR, Numbers.percent(e)));
    options
        .denoising(all.get(index), engine)
        .ifPresent(denoising -> expected.put(PictureMetadata.DENOISED, ""));
    window.ifPresent(around -> expected.put(PictureMetadata.DENOISED_WITH, around.note(index)));
    return expected;
  }
}
