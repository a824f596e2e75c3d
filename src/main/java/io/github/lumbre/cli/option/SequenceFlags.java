package io.github.lumbre.cli.option;

import io.github.lumbre.parser.internal.ModelSequence;
import io.github.lumbre.parser.internal.ModelSequence.Motion;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that render several frames of a model. */
@Command(optionListHeading = Headings.SEQUENCE)
public final class SequenceFlags extends Flags {
  private static final double DEFAULT_FPS = 25;
  private static final double MAX_FPS = 1000;

  @Option(
      names = "--turntable",
      paramLabel = "N",
      description =
          "Write N pictures of a model from around it, numbered from 000: OUT with -000 before its"
              + " ending.")
  private Optional<Integer> turntable;

  @Option(
      names = "--animation",
      paramLabel = "NAME",
      description =
          "Write the pictures of a whole animation of a model, numbered as those of --turntable, to"
              + " before its end, where a loop begins again.")
  private Optional<String> animation;

  @Option(
      names = "--fps",
      paramLabel = "N",
      description = "Frames per second of an animation (25).")
  private Optional<Double> fps;

  @Option(
      names = "--frames",
      paramLabel = "A..B",
      description =
          "Render only frames A to B, by the numbers in their names; or one, A; or part I (from 0)"
              + " of N of them, I/N; auto: the part of this process in a job array.")
  private Optional<String> frames;

  @Option(
      names = "--continue",
      description =
          "Keep the frames that are complete, and render the missing ones. All must be of the same"
              + " scene and settings, by the metadata in PNG and OpenEXR pictures.")
  private boolean continued;

  /**
   * Checks the values before anything is read.
   *
   * @throws ParameterException that names the flag, if a value is wrong
   */
  public void validate() {
    turntable.ifPresent(n -> checks().requireIn("--turntable", 1, ModelSequence.MAX_FRAMES, n));
    require(
        turntable.isEmpty() || animation.isEmpty(),
        "--turntable and --animation: expected only one of them");
    require(fps.isEmpty() || animation.isPresent(), "--fps: requires --animation");
    fps.ifPresent(
        f -> require(f > 0 && f <= MAX_FPS, "--fps: expected more than 0 to 1000, found " + f));
    require(frames.isEmpty() || areGiven(), "--frames: requires --turntable or --animation");
    require(!continued || areGiven(), "--continue: requires --turntable or --animation");
  }

  /** Returns whether several frames of a model are rendered. */
  public boolean areGiven() {
    return turntable.isPresent() || animation.isPresent();
  }

  /** Returns the first flag that asks for several frames. */
  public String name() {
    return turntable.isPresent() ? "--turntable" : "--animation";
  }

  /** Returns what moves; empty for a single picture. */
  public Optional<Motion> motion() {
    return turntable
        .map(Motion::turntable)
        .or(() -> animation.map(name -> Motion.animation(name, fps.orElse(DEFAULT_FPS))));
  }

  /** Returns whether frames that are complete are kept. */
  public boolean areContinued() {
    return continued;
  }

  /**
   * Returns the numbers of the frames that are rendered, in order.
   *
   * @param count number of all frames
   * @throws ParameterException if there are no such frames
   */
  public List<Integer> part(int count) {
    if (frames.isEmpty()) {
      return IntStream.range(0, count).boxed().toList();
    }
    String text = frames.get();
    int dots = text.indexOf("..");
    if (dots < 0 && !text.matches("[0-9]+")) {
      return share(text, count);
    }
    int first = number(dots < 0 ? text : text.substring(0, dots));
    int last = number(dots < 0 ? text : text.substring(dots + 2));
    require(
        first <= last && last < count,
        "--frames: expected frames from 0 to " + (count - 1) + ", such as 0..4, found " + text);
    return IntStream.rangeClosed(first, last).boxed().toList();
  }

  private List<Integer> share(String text, int count) {
    try {
      Share share = Share.parse(text, System.getenv());
      return IntStream.range(share.first(count, "frame"), share.end(count)).boxed().toList();
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), "--frames: " + e.getMessage(), e);
    }
  }

  private int number(String text) {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new ParameterException(
          spec.commandLine(), "--frames: expected A..B, A, I/N or auto, found " + frames.get(), e);
    }
  }
}
