package io.github.lumbre.cli.option;

import io.github.lumbre.image.animation.AnimationFormat;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.stage.internal.ModelSequence;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The flags that render several frames of a model. */
@Command(optionListHeading = Headings.SEQUENCE)
public final class SequenceFlags extends Flags {
  private static final FrameRate DEFAULT_RATE = new FrameRate(25, 1);

  /** The time of a turntable, unless that takes more frames per second than a GIF can have. */
  private static final int SECONDS_OF_A_TURN = 5;

  private static final int MOST_PER_SECOND = 50;

  @Option(
      names = "--turntable",
      paramLabel = "N",
      description =
          "Render N pictures of a model from around it, numbered from 000: OUT with -000 before its"
              + " ending; or one file, if OUT ends in .gif, .apng, .mp4 or .webm.")
  private Optional<Integer> turntable;

  @Option(
      names = "--animation",
      paramLabel = "NAME",
      description =
          "Render a whole animation of a model, to before its end, where a loop begins again; OUT"
              + " is as for --turntable.")
  private Optional<String> animation;

  @Option(
      names = "--fps",
      paramLabel = "N",
      description =
          "Frames per second of an animation and of one file: 25, 12.5 or 30000/1001 (25; a"
              + " turntable turns once in 5 s).")
  private Optional<FrameRate> fps;

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

  @Option(
      names = "--ffmpeg",
      paramLabel = "PATH",
      description =
          "Program that writes .mp4 and .webm, or its folder (LUMBRE_FFMPEG, or ffmpeg in the"
              + " PATH).")
  private Optional<Path> ffmpeg;

  /**
   * Checks the values before anything is read.
   *
   * @param joined path of the one file that is written, if it is one
   * @param scenes number of scenes
   * @throws ParameterException that names the flag, if a value is wrong
   */
  public void validate(Optional<Path> joined, int scenes) {
    turntable.ifPresent(n -> checks().requireIn("--turntable", 1, ModelSequence.MAX_FRAMES, n));
    require(
        turntable.isEmpty() || animation.isEmpty(),
        "--turntable and --animation: expected only one of them");
    require(
        animation.isEmpty() || !isGiven(FactorRange.FLAG),
        FactorRange.FLAG + ": cannot be combined with --animation");
    require(
        turntable.isEmpty() || explosion().isEmpty(),
        FactorRange.FLAG + ": expected one number with --turntable, found a range");
    boolean isSequence = areGiven() || joined.isPresent() && scenes > 1;
    require(
        joined.isEmpty() || isSequence,
        joined.orElse(Path.of(""))
            + ": requires --turntable, --animation, --explode A..B or several scenes; a picture ends"
            + " in one of "
            + ImageFormat.endings());
    require(
        fps.isEmpty()
            || animation.isPresent()
            || explosion().isPresent()
            || joined.isPresent()
            || isGiven("--shutter"),
        "--fps: requires --animation, --shutter or a file that ends in "
            + AnimationFormat.endings());
    require(
        frames.isEmpty() || isSequence,
        "--frames: requires --turntable, --animation or --explode A..B");
    require(
        !continued || isSequence,
        "--continue: requires --turntable, --animation or --explode A..B");
    require(
        ffmpeg.isEmpty()
            || joined.flatMap(AnimationFormat::of).filter(f -> f.isVideo()).isPresent(),
        "--ffmpeg: requires a file that ends in .mp4 or .webm");
  }

  /** Returns whether several frames of a model are rendered. */
  public boolean areGiven() {
    return turntable.isPresent() || animation.isPresent() || explosion().isPresent();
  }

  /** Returns the range of {@code --explode}; empty if it has one number or is not given. */
  private Optional<FactorRange> explosion() {
    String text = spec.commandLine().getParseResult().matchedOptionValue(FactorRange.FLAG, "0");
    try {
      return Optional.of(FactorRange.of(text)).filter(FactorRange::isRange);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(
          spec.commandLine(), FactorRange.FLAG + ": " + e.getMessage(), e);
    }
  }

  /** Returns the first flag that asks for several frames. */
  public String name() {
    String other = animation.isPresent() ? "--animation" : FactorRange.FLAG;
    return turntable.isPresent() ? "--turntable" : other;
  }

  /** Returns what moves; empty for a single picture. */
  public Optional<Motion> motion() {
    return turntable
        .map(Motion::turntable)
        .or(() -> animation.map(name -> Motion.animation(name, rate())))
        .or(() -> explosion().map(e -> Motion.explosion(e.first(), e.last(), rate())));
  }

  /** Returns the frames per second. */
  public FrameRate rate() {
    return fps.or(() -> turntable.map(SequenceFlags::rateOfTurntable)).orElse(DEFAULT_RATE);
  }

  private static FrameRate rateOfTurntable(int frames) {
    return frames > MOST_PER_SECOND * SECONDS_OF_A_TURN
        ? new FrameRate(MOST_PER_SECOND, 1)
        : new FrameRate(frames, SECONDS_OF_A_TURN);
  }

  /** Returns the path of the program that writes videos; empty if it is not given. */
  public Optional<Path> ffmpeg() {
    return ffmpeg;
  }

  /** Returns whether only a part of the frames is rendered. */
  public boolean havePart() {
    return frames.isPresent();
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
