package io.github.lumbre.stage.internal;

import io.github.lumbre.model.ModelOption;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.util.List;

/**
 * A model whose parts move apart. It is read anew for each frame, and its pictures are decoded
 * once. One camera has all frames in its frame: parts move in straight lines, so that the first
 * frame and the last one count. Mutable.
 */
final class StagedExplosion extends StagedFrames {
  private final Stage stage;
  private final List<Double> factors;

  /** The last frame, with the camera of all. */
  private final Staging last;

  /**
   * @param factors how far the parts have moved apart in each frame, 0 to 1
   * @throws SceneFormatException if the model cannot be used
   */
  StagedExplosion(ModelSource source, Stage stage, List<Double> factors)
      throws SceneFormatException, IOException {
    super(source);
    this.stage = stage.find(Stage.CAMERA).isPresent() ? stage : stage.framed();
    this.factors = factors;
    last = source.read(stage(factors.size() - 1), false);
    last.frameWith(source.read(stage(0), false));
  }

  @Override
  public int count() {
    return factors.size();
  }

  @Override
  Stage stage(int index) {
    return stage.with(ModelOption.EXPLODE, factors.get(index));
  }

  @Override
  SceneFile built(int index) throws SceneFormatException, IOException {
    Staging model = source.read(stage(index), false);
    model.frameAs(last);
    return scene(model);
  }

  @Override
  byte[] text(int index) throws SceneFormatException {
    return last.textOf(stage(index));
  }
}
