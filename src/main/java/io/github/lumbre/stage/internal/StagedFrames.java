package io.github.lumbre.stage.internal;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.util.Optional;

/**
 * The frames of a model, each on a stage of its own. The first one that is asked for is kept: its
 * files are in the hashes of all. Mutable.
 */
abstract class StagedFrames extends ModelSequence {
  final ModelSource source;

  StagedFrames(ModelSource source) {
    this.source = source;
  }

  /** Returns the stage of a frame. */
  abstract Stage stage(int index);

  /** Returns the scene of a frame; see {@link #frame}. */
  abstract SceneFile built(int index) throws SceneFormatException, IOException;

  /** Returns the text of the scene of a frame. */
  abstract byte[] text(int index) throws SceneFormatException, IOException;

  /** Returns the model of the first frame that was built, which has kept its files. */
  abstract Optional<Staging> first();

  @Override
  public final SceneFile frame(int index) throws SceneFormatException, IOException {
    return source.timed(() -> built(index));
  }

  @Override
  public final String hash(int index) throws SceneFormatException, IOException {
    if (first().isEmpty()) {
      frame(0);
    }
    return source.timed(() -> first().orElseThrow().hashOf(text(index)));
  }
}
