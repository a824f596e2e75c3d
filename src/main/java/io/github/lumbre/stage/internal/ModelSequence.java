package io.github.lumbre.stage.internal;

import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The frames of a turntable, an animation or an explosion of a model. They share what does not
 * change between them, and have one camera or one way of framing. Mutable; confined to one thread
 * at a time.
 */
public abstract class ModelSequence {
  /** The largest number of frames. */
  public static final int MAX_FRAMES = 10_000;

  /**
   * What moves.
   *
   * @param turns number of frames around the model; 0 for an animation
   * @param views the views of these frames; empty for one turn from the view of the stage
   * @param animation name of the animation, or its index; empty without one
   * @param rate frames per second of an animation
   * @param explosion how far the parts of the model have moved apart in each frame; empty if they
   *     do not move
   * @param isAligned whether parallel views have the same scale
   */
  public record Motion(
      int turns,
      List<View> views,
      String animation,
      FrameRate rate,
      List<Double> explosion,
      boolean isAligned) {
    private static final double TURN_DEGREES = 360;

    /** The time in which parts move apart. */
    private static final double SECONDS_OF_EXPLOSION = 2;

    public Motion {
      views = List.copyOf(views);
      explosion = List.copyOf(explosion);
      Objects.requireNonNull(animation, "animation");
      Objects.requireNonNull(rate, "rate");
      if (turns < 0 || turns > MAX_FRAMES) {
        throw new IllegalArgumentException(
            "turns: expected 0 to " + MAX_FRAMES + ", found " + turns);
      }
    }

    /** Returns one turn around a model. */
    public static Motion turntable(int turns) {
      return new Motion(turns, List.of(), "", new FrameRate(1, 1), List.of(), false);
    }

    /**
     * Returns the standard views of a model, in order.
     *
     * @param isAligned whether parallel views have the same scale
     */
    public static Motion ofViews(boolean isAligned) {
      List<View> views = List.copyOf(View.standard().values());
      return new Motion(
          views.size(), views, "", new FrameRate(1, 1), List.of(), isAligned);
    }

    /** Returns a whole animation. */
    public static Motion animation(String name, FrameRate rate) {
      return new Motion(0, List.of(), name, rate, List.of(), false);
    }

    /** Returns parts that move apart for 2 seconds, from the first frame to the last. */
    public static Motion explosion(double from, double to, FrameRate rate) {
      double wanted = Math.rint(SECONDS_OF_EXPLOSION * rate.frames() / rate.seconds());
      int last = (int) Math.max(1, Math.min(wanted, MAX_FRAMES) - 1);
      List<Double> factors =
          IntStream.rangeClosed(0, last)
              .mapToObj(i -> ((last - i) * from + i * to) / last)
              .toList();
      return new Motion(0, List.of(), "", rate, factors, false);
    }

    /** Returns the stage of a frame around the model. */
    public Stage stage(Stage first, int index) {
      View start = first.find(Stage.VIEW).orElse(View.DEFAULT);
      return first.seenFrom(
          views.isEmpty() ? start.turned(TURN_DEGREES * index / turns) : views.get(index));
    }
  }

  /**
   * Reads a model.
   *
   * @param model path; with a content, its name in no folder
   * @param content bytes of the file; empty to read it
   * @param stage the first view of a turntable
   * @throws SceneFormatException if the model cannot be used, or lacks the animation
   * @throws IOException if the model exists but cannot be read, or the thread is interrupted
   */
  public static ModelSequence of(
      SceneParser parser, Path model, Optional<byte[]> content, Stage stage, Motion motion)
      throws SceneFormatException, IOException {
    return of(
        content.isPresent()
            ? ModelSource.of(parser, model.toString(), content.get(), ModelFolder.NONE)
            : ModelSource.of(parser, model),
        stage,
        motion);
  }

  /** Reads a model; see {@link #of(SceneParser, Path, Optional, Stage, Motion)}. */
  public static ModelSequence of(ModelSource source, Stage stage, Motion motion)
      throws SceneFormatException, IOException {
    return source.timed(
        () -> {
          if (motion.turns() > 0) {
            return new StagedViews(source, stage, motion);
          }
          return motion.explosion().isEmpty()
              ? new StagedAnimation(source, stage, motion.animation(), motion.rate())
              : new StagedExplosion(source, stage, motion.explosion());
        });
  }

  /** Returns the number of frames, at least 1. */
  public abstract int count();

  /**
   * Returns the scene of a frame.
   *
   * @param index from 0
   * @throws SceneFormatException if the model cannot be used
   * @throws IOException if a file cannot be read, or the thread is interrupted
   */
  public abstract SceneFile frame(int index) throws SceneFormatException, IOException;

  /** Returns the hash of the scene of a frame, in less time; see {@link #frame}. */
  public abstract String hash(int index) throws SceneFormatException, IOException;
}
