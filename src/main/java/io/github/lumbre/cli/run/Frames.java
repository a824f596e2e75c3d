package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.lab.Numbers;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.parser.SceneFormatException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The pictures that one command renders in turn. All are reserved before the first is rendered, and
 * one signal or deadline ends the whole sequence. Mutable, for one thread.
 */
public final class Frames implements AutoCloseable {
  private final List<Path> targets;
  private final Interruption interruption;
  private final Deadline deadline;
  private final List<PictureOutput> pictures = new ArrayList<>();
  private final List<DenoisedPicture> denoised = new ArrayList<>();
  private int complete;

  /** Renders the current frame and returns its exit code. */
  @FunctionalInterface
  public interface Rendering {
    int run() throws SceneFormatException, TaskException;
  }

  /**
   * @param targets paths of the pictures, at least one
   * @param deadline time at which the whole sequence stops
   */
  public Frames(List<Path> targets, Interruption interruption, Deadline deadline) {
    this.targets = List.copyOf(targets);
    this.interruption = interruption;
    this.deadline = deadline;
  }

  /**
   * Returns the paths of several pictures: {@code a-000.png}, {@code a-001.png} and so on for
   * {@code a.png}.
   *
   * @param path with an ending
   */
  public static List<Path> numbered(Path path, int count) {
    String name = path.getFileName().toString();
    int dot = name.lastIndexOf('.');
    String pattern = "%s-%03d%s";
    return IntStream.range(0, count)
        .mapToObj(i -> pattern.formatted(name.substring(0, dot), i, name.substring(dot)))
        .map(path::resolveSibling)
        .toList();
  }

  /**
   * Reserves the files of all pictures.
   *
   * @param denoising denoiser of the denoised pictures beside them, if they are wanted
   * @throws TaskException if one of the files cannot be written
   */
  public void reserve(Optional<Denoising> denoising, Fallback fallback) throws TaskException {
    for (Path target : targets) {
      pictures.add(PictureOutput.reserve(target, fallback));
      denoised.add(DenoisedPicture.reserve(denoising, target, fallback));
    }
  }

  /** Sets the only picture, for one that is not a file. */
  public void reserve(PictureOutput picture) {
    pictures.add(picture);
    denoised.add(DenoisedPicture.NONE);
  }

  /** Returns the paths of all pictures. */
  public List<Path> targets() {
    return targets;
  }

  /** Returns whether nothing is reserved yet. */
  public boolean isEmpty() {
    return pictures.isEmpty();
  }

  /** Returns whether there is only one picture. */
  public boolean isSingle() {
    return targets.size() == 1;
  }

  /** Returns whether the current frame is the first one. */
  public boolean isFirst() {
    return complete == 0;
  }

  /** Returns the number of frames that are not complete. */
  public int left() {
    return targets.size() - complete;
  }

  /** Returns the output of the current frame. */
  public PictureOutput picture() {
    return pictures.get(complete);
  }

  /** Returns the denoised output of the current frame. */
  public DenoisedPicture denoised() {
    return denoised.get(complete);
  }

  /**
   * Renders the current frame and goes to the next one.
   *
   * @param report receives the result of the frame
   * @throws TaskException if a signal ends the sequence, or the deadline passes before its last
   *     frame is begun; it names the complete frames
   */
  public int render(JsonSummary report, Rendering frame)
      throws SceneFormatException, TaskException {
    int exitCode;
    try {
      exitCode = frame.run();
    } catch (TaskException e) {
      boolean hasEnded = e.kind() == Kind.STOPPED || e.kind() == Kind.LIMIT && deadline.hasPassed();
      throw hasEnded && !isSingle() ? ended(e.kind(), 0) : e;
    }
    int partial = report.isPartial() ? 1 : 0;
    complete += 1 - partial;
    if (interruption.isRequested() && !isSingle() && left() > 0) {
      throw ended(Kind.STOPPED, partial);
    }
    if (deadline.hasPassed() && left() > partial) {
      throw ended(Kind.LIMIT, partial);
    }
    return exitCode;
  }

  /**
   * @param partial number of partial frames, 0 or 1
   */
  private TaskException ended(Kind kind, int partial) {
    String what = kind == Kind.STOPPED ? "stopped after " : "--timeout: the time ended after ";
    List<String> states = new ArrayList<>();
    if (complete > 0) {
      states.add(names(0, complete) + " complete");
    }
    if (partial > 0) {
      states.add(names(complete, complete + 1) + " partial");
    }
    if (complete + partial < targets.size()) {
      states.add(names(complete + partial, targets.size()) + " not rendered");
    }
    String done = complete + " of " + Numbers.count(targets.size(), "picture");
    return new TaskException(kind, what + done + ": " + String.join(", ", states));
  }

  /** Returns the names of the frames from a first one to before a last one, with a verb. */
  private String names(int from, int to) {
    String last = targets.get(to - 1).toString();
    return to - from == 1 ? last + " is" : targets.get(from) + " to " + last + " are";
  }

  /** Releases the reserved files that are not written, in reverse order. */
  @Override
  public void close() {
    denoised.forEach(DenoisedPicture::close);
    for (int i = pictures.size() - 1; i >= 0; i--) {
      pictures.get(i).close();
    }
  }
}
