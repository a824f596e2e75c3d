package io.github.lumbre.cli;

import io.github.lumbre.cli.RenderCommand.Course;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.run.FinishedFrames;
import io.github.lumbre.cli.run.Frames;
import io.github.lumbre.cli.run.PictureExposure;
import io.github.lumbre.cli.run.RenderMonitor;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.lab.Numbers;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.internal.ModelSequence;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/** Renders the frames of a turntable or an animation in turn. Mutable, for one run. */
final class RenderSequence {
  private final RenderOptions options;
  private final boolean isDenoised;
  private final FrameRender render;
  private final FinishedFrames finished;
  private List<Path> all = List.of();
  private List<Integer> part = List.of();

  /** Renders the current frame and returns its exit code. */
  interface FrameRender {
    int run(Course course, Frames frames, PictureExposure exposing)
        throws SceneFormatException, TaskException;
  }

  /**
   * @param isDenoised whether the pictures are denoised
   */
  RenderSequence(RenderOptions options, boolean isDenoised, FrameRender render) {
    this.options = options;
    this.isDenoised = isDenoised;
    this.render = render;
    Set<String> keywords = PictureMetadata.identifying();
    if (options.budgets.areGiven() || options.quality.isAdaptive()) {
      keywords.remove(PictureMetadata.SAMPLES);
    }
    finished = new FinishedFrames(keywords);
  }

  /**
   * Renders the frames that are wanted and not there.
   *
   * @param target path of the pictures without their numbers
   * @return the highest of their exit codes
   */
  int run(Course course, Path target) throws SceneFormatException, TaskException {
    Path scene = options.scene.scene();
    options.run.failing(new JsonSummary("render", scene), () -> plan(course, target));
    List<Integer> missing =
        part.stream().filter(index -> !finished.contains(all.get(index))).toList();
    List<Path> targets = missing.stream().map(all::get).toList();
    int code = ExitCodes.OK;
    int written = 0;
    if (!missing.isEmpty()) {
      PictureExposure exposing = PictureExposure.ofAll(finished.exposure());
      try (Frames frames = new Frames(targets, course.interruption(), course.deadline())) {
        for (int i = 0; i < missing.size() && code <= ExitCodes.WARNINGS; i++) {
          options.scene.choose(missing.get(i));
          options.run.about(frames);
          code = Math.max(code, render.run(course, frames, exposing));
        }
        written = missing.size() - frames.left();
      }
    }
    Duration time = Duration.between(course.start(), Instant.now());
    options.run.summarize(summary(written, targets), time);
    return code;
  }

  /** Returns {@code 30 of 36 pictures written, 6 were complete: a-000.png to a-035.png}. */
  private String summary(int written, List<Path> targets) {
    int kept = part.size() - targets.size();
    return written
        + " of "
        + Numbers.count(part.size(), "picture")
        + " written"
        + (kept > 0 ? ", " + kept + (kept == 1 ? " was" : " were") + " complete" : "")
        + ": "
        + all.get(part.get(0))
        + (part.size() > 1 ? " to " + all.get(part.get(part.size() - 1)) : "");
  }

  /** Finds out which frames there are, and which of them are complete. */
  private int plan(Course course, Path target) throws SceneFormatException, TaskException {
    int count = options.sequence.motion().orElseThrow().turns();
    boolean isContinued = options.sequence.areContinued();
    if (count == 0 || isContinued) {
      Path scene = options.scene.scene();
      try (RenderMonitor monitor = options.run.monitor(course.interruption(), course.deadline())) {
        ModelSequence sequence =
            monitor.reading(scene, () -> options.scene.sequence(options.parser()));
        count = sequence.count();
        all = Frames.numbered(target, count);
        if (isContinued) {
          requireMetadata(target);
          monitor.reading(scene, () -> find(sequence));
        }
      }
    }
    all = Frames.numbered(target, count);
    part = options.sequence.part(count);
    requireExposure();
    return ExitCodes.OK;
  }

  private static void requireMetadata(Path target) throws TaskException {
    Optional<ImageFormat> format = ImageFormat.of(target);
    if (!format.equals(Optional.of(ImageFormat.PNG))
        && !format.equals(Optional.of(ImageFormat.EXR))) {
      throw new TaskException(
          Kind.USAGE,
          "--continue: expected PNG or OpenEXR pictures (-o), which state their scene, found "
              + target);
    }
  }

  /** Requires that an automatic exposure is the one of the first frame. */
  private void requireExposure() throws TaskException {
    if (options.flags.isExposureAutomatic() && part.get(0) > 0 && finished.exposure().isEmpty()) {
      throw new TaskException(
          Kind.USAGE,
          "--exposure auto: is chosen from the first frame, which is not among --frames; render"
              + " --frames 0 first and use --continue, or give a number of stops");
    }
  }

  /** Finds the frames that are complete; also those that this run would not render. */
  private FinishedFrames find(ModelSequence sequence) throws SceneFormatException, TaskException {
    options.scene.choose(0);
    SceneFile first = options.scene.read(options.parser());
    Map<String, String> expected =
        PictureMetadata.of(options.scene.scene(), first, first.settings());
    OptionalDouble error = options.targetError();
    error.ifPresent(e -> expected.put(PictureMetadata.TARGET_ERROR, Numbers.percent(e)));
    if (isDenoised) {
      expected.put(PictureMetadata.DENOISED, "");
    }
    for (int i = 0; i < all.size(); i++) {
      if (Files.exists(all.get(i))) {
        expected.put(PictureMetadata.SCENE_HASH, options.scene.hash(i));
        finished.add(all.get(i), expected);
      }
    }
    return finished;
  }
}
