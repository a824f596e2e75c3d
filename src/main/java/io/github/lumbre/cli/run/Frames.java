package io.github.lumbre.cli.run;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.base.text.Numbers;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.Fallback;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.ProgressBar;
import io.github.lumbre.scene.RenderSettings;
import java.io.Closeable;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The pictures that one command renders in turn. All are reserved before the first is rendered, and
 * one signal or deadline ends the whole sequence. Mutable, for one thread.
 */
public final class Frames implements AutoCloseable {
  /** The number of failed scenes that are named. */
  private static final int MOST_NAMES = 20;

  private final List<Path> targets;
  private final Interruption interruption;
  private final Deadline deadline;
  private final List<PictureOutput> pictures = new ArrayList<>();
  private Optional<Closeable> names = Optional.empty();
  private final List<Path> failed = new ArrayList<>();
  private final long start = System.nanoTime();
  private Check check = settings -> {};
  private int current;
  private boolean reserved;
  private boolean ended;
  private boolean isPartial;

  /**
   * @param targets paths of the pictures, at least one
   * @param deadline time at which the whole sequence stops
   */
  public Frames(List<Path> targets, Interruption interruption, Deadline deadline) {
    this.targets = List.copyOf(targets);
    this.interruption = interruption;
    this.deadline = deadline;
  }

  /** Checks the settings of a frame before it is rendered. */
  @FunctionalInterface
  public interface Check {
    void check(RenderSettings settings) throws TaskException;
  }

  /** Renders a picture, given its index among the targets, and returns its exit code. */
  @FunctionalInterface
  public interface Frame {
    ExitCode render(int index) throws Exception;
  }

  /** Renders the pictures in turn until one fails, and returns the highest of their exit codes. */
  public ExitCode each(Frame frame) throws Exception {
    ExitCode code = ExitCode.OK;
    for (int i = 0; i < targets.size() && !code.isFailure(); i++) {
      code = code.or(frame.render(i));
    }
    return code;
  }

  /** Sets a check of each frame besides that of its picture's format. */
  public void checkedBy(Check newCheck) {
    check = newCheck;
  }

  /**
   * Checks that the current frame can be written.
   *
   * @throws TaskException if it is too large
   */
  public void requireFits(RenderSettings settings) throws TaskException {
    picture().requireFits(settings);
    check.check(settings);
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
   * Reserves the files of all pictures. Those of several are opened one after the other, because a
   * program can hold few open files.
   *
   * @throws TaskException if one of the files cannot be written
   */
  public void reserve(Fallback fallback) throws TaskException {
    if (isSingle()) {
      reserve(PictureOutput.reserve(target(), fallback));
      return;
    }
    names = Optional.of(Failures.written(() -> OutputFile.reserve(targets)));
    targets.forEach(target -> pictures.add(PictureOutput.of(target, fallback)));
    reserved = true;
  }

  /** Sets the only picture, for one that is not a file. */
  public void reserve(PictureOutput picture) {
    pictures.add(picture);
    reserved = true;
  }

  /** Makes all pictures parts of one file, which another output writes. */
  public void reservePartsOf(Path file) {
    targets.forEach(target -> pictures.add(PictureOutput.partOf(file)));
    reserved = true;
  }

  /** Ends the sequence: the failure of the current frame is that of the others, too. */
  public void endAll() {
    ended = true;
  }

  /** Returns the paths of all pictures. */
  public List<Path> targets() {
    return targets;
  }

  /** Returns whether the files of all pictures are reserved. */
  public boolean areReserved() {
    return reserved;
  }

  /** Returns whether there is only one picture. */
  public boolean isSingle() {
    return targets.size() == 1;
  }

  /** Returns whether the current frame is the first one. */
  public boolean isFirst() {
    return current == 0;
  }

  /** Returns the index of the current frame. */
  public int index() {
    return current;
  }

  /** Returns the number of frames that are neither complete nor failed. */
  public int left() {
    return targets.size() - current;
  }

  /** Returns whether a signal or the deadline has ended the sequence. */
  public boolean haveEnded() {
    return ended;
  }

  /**
   * Returns the place of the current frame and the time until the last one is complete, {@code
   * 3/36, all in 0:01:20}; the time is that of the complete frames for each that is left.
   */
  public String place() {
    String place = "%d/%d".formatted(current + 1, targets.size());
    OptionalDouble seconds = secondsLeft();
    return seconds.isEmpty()
        ? place
        : place + ", all in " + ProgressBar.clock(seconds.getAsDouble());
  }

  /** Returns the place and the time of {@link #place} as values for JSON. */
  public Map<String, Number> placeValues() {
    Map<String, Number> place = new LinkedHashMap<>();
    place.put("frame", current + 1);
    place.put("frames", targets.size());
    secondsLeft().ifPresent(seconds -> place.put("seconds_left_in_all", seconds));
    return place;
  }

  private OptionalDouble secondsLeft() {
    return current == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(1e-9 * (System.nanoTime() - start) / current * left());
  }

  /** Returns the place and name of the current frame, {@code 3/12 c.png}; empty if it is single. */
  public String title() {
    return isSingle()
        ? ""
        : "%d/%d %s".formatted(current + 1, targets.size(), target().getFileName());
  }

  /**
   * Goes to the next frame, because the current one failed.
   *
   * @param scene scene of the current frame, for {@link #summary}
   */
  public void fail(Path scene) {
    failed.add(scene);
    isPartial = false;
    current++;
  }

  /** Returns {@code 11 of 12 pictures written, 1 failed: c.glb}. */
  public String summary() {
    String failures = failed.isEmpty() ? "" : ", " + failures();
    String written = complete() + " of " + Numbers.count(targets.size(), "picture") + " written";
    return written + partial() + failures;
  }

  /** Returns {@code , c.png is partial}; empty if the last rendered frame is complete. */
  public String partial() {
    return isPartial ? ", " + target() + " is partial" : "";
  }

  /** Returns the number of complete frames. */
  public int complete() {
    return current - failed.size();
  }

  /** Returns the number of failed frames and their first scenes. */
  private String failures() {
    int more = failed.size() - MOST_NAMES;
    String names =
        failed.stream().limit(MOST_NAMES).map(Path::toString).collect(Collectors.joining(", "));
    return failed.size() + " failed: " + names + (more > 0 ? " and " + more + " more" : "");
  }

  /** Returns the path of the current picture. */
  public Path target() {
    return targets.get(current);
  }

  /** Returns the output of the current frame. */
  public PictureOutput picture() {
    return pictures.get(current);
  }

  /**
   * Goes to the next frame, because the current one is written.
   *
   * @throws TaskException if a signal has ended the sequence, or the deadline has passed before its
   *     last frame is begun; it names the complete frames
   */
  void finish(boolean isPartialNow) throws TaskException {
    isPartial = isPartialNow;
    int partial = isPartial ? 1 : 0;
    current += 1 - partial;
    if (interruption.isRequested() && !isSingle() && left() > 0) {
      throw ended(ExitCode.INTERRUPTED, partial);
    }
    if (deadline.hasPassed() && left() > partial) {
      throw ended(ExitCode.LIMIT, partial);
    }
  }

  /** Returns the failure of the current frame; one that ends the sequence names the others. */
  Exception end(Exception failure) {
    if (ended || isSingle() || !(failure instanceof TaskException e)) {
      return failure;
    }
    boolean isEnd =
        e.code() == ExitCode.INTERRUPTED || e.code() == ExitCode.LIMIT && deadline.hasPassed();
    return isEnd ? ended(e.code(), 0) : failure;
  }

  /**
   * @param partial number of partial frames, 0 or 1
   */
  private TaskException ended(ExitCode code, int partial) {
    ended = true;
    String what =
        code == ExitCode.INTERRUPTED ? "stopped after " : "--timeout: the time ended after ";
    List<String> states = new ArrayList<>();
    if (failed.isEmpty() && current > 0) {
      states.add(names(0, current) + " complete");
    }
    if (partial > 0) {
      states.add(names(current, current + 1) + " partial");
    }
    int begun = current + partial;
    if (begun < targets.size()) {
      states.add(left() - partial + " not rendered: " + range(begun, targets.size()));
    }
    if (!failed.isEmpty()) {
      states.add(failures());
    }
    String done = complete() + " of " + Numbers.count(targets.size(), "picture");
    return new TaskException(code, what + done + ": " + String.join(", ", states));
  }

  /** Returns the names of the frames from a first one to before a last one, with a verb. */
  private String names(int from, int to) {
    return range(from, to) + (to - from == 1 ? " is" : " are");
  }

  private String range(int from, int to) {
    return (to - from == 1 ? "" : targets.get(from) + " to ") + targets.get(to - 1);
  }

  /** Releases the reserved files that are not written, in reverse order. */
  @Override
  public void close() {
    for (int i = pictures.size() - 1; i >= 0; i--) {
      pictures.get(i).close();
    }
    Failures.close(names);
  }
}
