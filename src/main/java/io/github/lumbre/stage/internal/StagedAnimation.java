package io.github.lumbre.stage.internal;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.animation.FrameRate;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * An animation of a model from its start to before its end, where a loop begins again. The model is
 * read anew for each pose, and its pictures are decoded once.
 *
 * <p>A camera that is not the model's stands still. It has in its frame the poses at 0, 1/16, 2/16
 * and so on of the animation, whatever the number of frames, and the ground is below them all.
 * Mutable.
 */
final class StagedAnimation extends StagedFrames {
  /** The number of equal parts of the animation, at whose ends its poses are framed. */
  private static final int FRAMED_PARTS = 16;

  /** A last frame that is nearer to the end than this share of a frame is at the end. */
  private static final double AT_END = 1e-3;

  private final Stage stage;
  private final String animation;
  private final FrameRate rate;
  private final double seconds;
  private final int count;

  /** The start, or the first frame that shows something of the model. */
  private final Stage shown;

  private final boolean hasOwnCamera;
  private final boolean isFramed;
  private Optional<Staging> framed = Optional.empty();

  /**
   * @param animation name or index of the animation
   * @param rate frames per second
   * @throws SceneFormatException if the model cannot be used, lacks the animation, or has too many
   *     frames
   */
  StagedAnimation(ModelSource source, Stage stage, String animation, FrameRate rate)
      throws SceneFormatException, IOException {
    super(source);
    this.stage = stage;
    this.animation = animation;
    this.rate = rate;
    Staging atStart = source.read(at(0), true);
    seconds = seconds(atStart);
    count = frames(atStart);
    shown = shown(atStart);
    hasOwnCamera = atStart.hasOwnCamera();
    isFramed = stage.get(Stage.GROUND) || !stage.labels().isEmpty() || !hasOwnCamera;
  }

  /**
   * Returns the start, or the first frame that shows something of the model.
   *
   * @throws SceneFormatException if there is none
   */
  private Stage shown(Staging atStart) throws SceneFormatException, IOException {
    for (int i = 0; i < count && !atStart.hasSurface(); i++) {
      if (source.read(stage(i), true).hasSurface()) {
        return stage(i);
      }
    }
    if (!atStart.hasSurface()) {
      // The error of a single picture states why nothing is shown.
      source.read(at(0), false);
    }
    return at(0);
  }

  private double seconds(Staging model) throws SceneFormatException {
    List<ModelAnimation> all = model.animations();
    for (int i = 0; i < all.size(); i++) {
      boolean isNamed = all.get(i).name().equals(animation);
      if (isNamed || hasNone(all) && Integer.toString(i).equals(animation)) {
        return all.get(i).seconds().orElseThrow(() -> endless(model, "states no length"));
      }
    }
    throw endless(model, "found none in the model");
  }

  private boolean hasNone(List<ModelAnimation> all) {
    return all.stream().noneMatch(each -> each.name().equals(animation));
  }

  private SceneFormatException endless(Staging model, String found) {
    return model.failure(
        Kind.ASSET, "animations", "animation " + PrintableText.quoted(animation) + ": " + found);
  }

  private int frames(Staging model) throws SceneFormatException {
    double frames = Math.max(1, Math.ceil(seconds * rate.frames() / rate.seconds() - AT_END));
    Optional<String> excess =
        Limits.excess("frames of the animation", MAX_FRAMES, (long) Math.min(frames, 1e15));
    if (excess.isPresent()) {
      throw model.failure(Kind.LIMIT, "animations", excess.get());
    }
    return (int) frames;
  }

  @Override
  public int count() {
    return count;
  }

  @Override
  Stage stage(int index) {
    Stage still = at((double) ((long) index * rate.seconds()) / rate.frames());
    return source.inMotion(still);
  }

  private Stage at(double time) {
    return stage.reading(stage.options().with(ModelOption.POSE, new Pose(animation, time)));
  }

  /** Returns the model at a frame, with the frame's camera. */
  private Staging posed(int index) throws SceneFormatException, IOException {
    Staging model = source.read(stage(index), true);
    if (isFramed) {
      model.frame(framed().framing());
    }
    return model;
  }

  /** Returns a model that has all poses in its frame. */
  private Staging framed() throws SceneFormatException, IOException {
    if (framed.isEmpty()) {
      Staging model = source.read(shown, true);
      for (int i = 1; i <= FRAMED_PARTS; i++) {
        Stage pose = at(seconds * i / FRAMED_PARTS);
        model.frame(model.framing().with(source.read(pose, true).framing()));
      }
      framed = Optional.of(model);
    }
    return framed.get();
  }

  @Override
  SceneFile built(int index) throws SceneFormatException, IOException {
    return scene(posed(index));
  }

  @Override
  byte[] text(int index) throws SceneFormatException, IOException {
    Stage of = stage(index);
    Staging model = hasOwnCamera ? posed(index) : framed();
    return model.textOf(of);
  }
}
