package io.github.lumbre.scenefile;

import io.github.lumbre.scenefile.internal.ModelSequence;
import java.io.IOException;
import java.util.Optional;

/**
 * The frames of a model, each on a stage of its own. The first one that is asked for is kept: its
 * files are in the hashes of all. Mutable.
 */
abstract class StagedFrames extends ModelSequence {
  final SceneParser parser;
  private final Source source;
  private final String name;

  /** Reads the model as a stage wants it. */
  @FunctionalInterface
  interface Source {
    /**
     * Returns the model.
     *
     * @param isFrame whether it may have nothing to show, in one frame of an animation
     */
    StagedModel read(Stage stage, boolean isFrame) throws SceneFormatException, IOException;
  }

  /**
   * @param name of the model, for messages
   */
  StagedFrames(SceneParser parser, Source source, String name) {
    this.parser = parser;
    this.source = source;
    this.name = name;
  }

  /** Returns the stage of a frame. */
  abstract Stage stage(int index);

  /** Returns the scene of a frame; see {@link #frame}. */
  abstract SceneFile built(int index) throws SceneFormatException, IOException;

  /** Returns the text of the scene of a frame. */
  abstract byte[] text(int index) throws SceneFormatException, IOException;

  /** Returns the model of the first frame that was built, which has kept its files. */
  abstract Optional<StagedModel> first();

  final StagedModel read(Stage stage, boolean isFrame) throws SceneFormatException, IOException {
    return source.read(stage, isFrame);
  }

  @Override
  public final SceneFile frame(int index) throws SceneFormatException, IOException {
    return timed(() -> built(index));
  }

  @Override
  public final String hash(int index) throws SceneFormatException, IOException {
    if (first().isEmpty()) {
      frame(0);
    }
    return timed(() -> first().orElseThrow().hashOf(text(index)));
  }

  private <T> T timed(TimedReading<T> reading) throws SceneFormatException, IOException {
    return TimedReading.of(parser.settings().limits(), new Problems(name, true), reading);
  }
}
