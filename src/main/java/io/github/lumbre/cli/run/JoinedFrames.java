package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.image.animation.AnimationFormat;
import io.github.lumbre.image.animation.AnimationFrames;
import io.github.lumbre.image.animation.AnimationWriter;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.PictureTexts;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An animation in one file, whose frames are pictures in a folder beside it until all are complete.
 * Mutable, for one run.
 */
public final class JoinedFrames implements AutoCloseable {
  private final Path target;
  private final FrameRate rate;
  private final AnimationWriter writer;
  private Optional<OutputFile> file = Optional.empty();
  private Optional<String> loss = Optional.empty();

  private JoinedFrames(Path target, FrameRate rate, AnimationWriter writer) {
    this.target = target;
    this.rate = rate;
    this.writer = writer;
  }

  /** Returns the folder of the frames, {@code a.gif.frames} for {@code a.gif}. */
  public static Path folder(Path target) {
    return target.resolveSibling(target.getFileName() + ".frames");
  }

  /** Returns the path of the frames without their numbers, {@code a.gif.frames/a.png}. */
  public static Path picture(Path target) {
    String name = target.getFileName().toString();
    String base = name.substring(0, name.lastIndexOf('.'));
    return folder(target).resolve(base + ImageFormat.PNG.ending());
  }

  /**
   * Finds the writer of an animation, and reserves its file.
   *
   * @param target path with the ending of an animation
   * @param ffmpeg path of the program that writes videos, if it is given
   * @throws TaskException if the format cannot have the rate, the program is not found, or the file
   *     cannot be written
   * @throws InterruptedException if the thread is interrupted
   */
  public static JoinedFrames reserve(Path target, FrameRate rate, Optional<Path> ffmpeg)
      throws TaskException, InterruptedException {
    try {
      AnimationFormat.of(target).orElseThrow().requireFits(rate);
      JoinedFrames joined = new JoinedFrames(target, rate, writer(target, ffmpeg));
      joined.file = Optional.of(Failures.written(() -> OutputFile.open(target)));
      return joined;
    } catch (IllegalArgumentException e) {
      throw ExitCode.USAGE.failure(target + ": " + e.getMessage(), e);
    }
  }

  /**
   * Checks that the file can have frames of a size.
   *
   * @throws TaskException if it cannot
   */
  public void requireFits(Crop window) throws TaskException {
    try {
      writer.requireFits(window.width(), window.height());
    } catch (IllegalArgumentException e) {
      throw ExitCode.LIMIT.failure(target + ": " + e.getMessage(), e);
    }
  }

  /** Returns the writer; for a video it needs an installed program. */
  private static AnimationWriter writer(Path target, Optional<Path> ffmpeg)
      throws TaskException, InterruptedException {
    try {
      return AnimationFormat.of(target).orElseThrow().writer(ffmpeg, System.getenv());
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(
          target + ": needs the program ffmpeg (--ffmpeg): " + e.getMessage(), e);
    }
  }

  /**
   * Writes the file, and deletes the frames and their folder, unless it has other files.
   *
   * @param frames all frames, complete
   * @throws TaskException if that fails, or a signal or the deadline ends it; the frames are kept
   */
  public void join(List<Path> frames, RenderMonitor monitor) throws TaskException {
    try {
      String activity = "writing " + target.getFileName();
      if (monitor.unlessStopped(activity, () -> written(frames)).isEmpty()) {
        throw incomplete(monitor.isOutOfTime());
      }
    } catch (UncheckedIOException e) {
      // A terminal's Ctrl-C also ends the program that writes a video.
      throw monitor.isCancelled()
          ? incomplete(monitor.isOutOfTime())
          : ExitCode.OUTPUT.failure(
              "%s: cannot be written: %s; %s"
                  .formatted(target, FileFailure.reason(e.getCause()), advice()),
              e);
    }
    try {
      for (Path frame : frames) {
        Files.deleteIfExists(frame);
      }
      Files.deleteIfExists(folder(target));
    } catch (DirectoryNotEmptyException e) {
      // Other files are not ours to delete.
      return;
    } catch (IOException e) {
      throw ExitCode.OUTPUT.failure(
          target + ": is complete, but its frames cannot be deleted: " + FileFailure.reason(e), e);
    }
  }

  /** Returns what the frames have and the file lacks; empty if it lacks nothing. */
  public Optional<String> loss() {
    return loss;
  }

  private Path written(List<Path> frames) throws InterruptedException {
    try {
      Map<String, String> texts = PictureTexts.read(frames.get(0));
      texts.keySet().retainAll(PictureMetadata.ofAllFrames());
      AnimationFrames opened = AnimationFrames.open(frames, rate);
      if (opened.haveAlpha()) {
        loss = AnimationFormat.of(target).flatMap(AnimationFormat::lostTransparency);
      }
      writer.write(opened, texts, file.orElseThrow());
      return target;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns the exception for a sequence that ended before the file was written.
   *
   * @param deadline which ended it if it has passed; otherwise a signal did
   */
  public TaskException incomplete(Deadline deadline) {
    return incomplete(deadline.hasPassed());
  }

  private TaskException incomplete(boolean isOutOfTime) {
    return new TaskException(
        isOutOfTime ? ExitCode.LIMIT : ExitCode.INTERRUPTED,
        (isOutOfTime ? "--timeout: the time ended" : "stopped")
            + " before "
            + target
            + " was written; "
            + advice());
  }

  private String advice() {
    return "its complete frames are in "
        + folder(target)
        + "; the same command with --continue goes on with them";
  }

  /** Releases the file if it was not written. */
  @Override
  public void close() {
    Failures.close(file);
  }
}
