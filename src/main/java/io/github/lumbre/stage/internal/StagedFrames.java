package io.github.lumbre.stage.internal;

import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.Stage;
import java.io.IOException;
import java.util.Optional;

/**
 * The frames of a model, each on a stage of its own. The first one that is asked for is kept: its
 * files are in the hashes of all. Mutable.
 */
abstract class StagedFrames extends ModelSequence {
  final ModelSource source;
  private final DecodedPictures pictures = new DecodedPictures();

  /** The model of the first frame that was built, which has kept its files. */
  private Optional<Staging> first = Optional.empty();

  StagedFrames(ModelSource source) {
    this.source = source;
  }

  /** Returns the stage of a frame. */
  abstract Stage stage(int index);

  /** Returns the scene of a frame; see {@link #frame}. */
  abstract SceneFile built(int index) throws SceneFormatException, IOException;

  /** Returns the text of the scene of a frame. */
  abstract byte[] text(int index) throws SceneFormatException, IOException;

  /** Returns the scene of a model that was read for a frame; its pictures are decoded once. */
  final ParsedScene scene(Staging model) throws SceneFormatException {
    if (first.isEmpty()) {
      model.keepFiles();
    }
    ParsedScene scene = model.scene(pictures);
    if (first.isEmpty()) {
      first = Optional.of(model);
    }
    return scene;
  }

  /** Returns the model of the first frame, once it is built. */
  final Staging first() {
    return first.orElseThrow();
  }

  @Override
  public final SceneFile frame(int index) throws SceneFormatException, IOException {
    return source.timed(() -> built(index));
  }

  @Override
  public final String hash(int index) throws SceneFormatException, IOException {
    if (first.isEmpty()) {
      frame(0);
    }
    return source.timed(() -> first().hashOf(text(index)));
  }
}
