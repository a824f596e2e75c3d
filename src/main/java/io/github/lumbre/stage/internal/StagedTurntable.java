package io.github.lumbre.stage.internal;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.io.IOException;
import java.util.Optional;

/** One turn around a model, which is read and built once. Mutable. */
final class StagedTurntable extends StagedFrames {
  private static final double TURN_DEGREES = 360;

  private final Stage stage;
  private final int count;
  private Optional<Staging> model = Optional.empty();
  private Optional<ParsedScene> scene = Optional.empty();

  /**
   * @param stage of the first frame
   */
  StagedTurntable(ModelSource source, Stage stage, int count) {
    super(source);
    this.stage = stage;
    this.count = count;
  }

  @Override
  public int count() {
    return count;
  }

  @Override
  Stage stage(int index) {
    View first = stage.find(Stage.VIEW).orElse(View.DEFAULT);
    return stage.seenFrom(first.turned(TURN_DEGREES * index / count));
  }

  @Override
  Optional<Staging> first() {
    return model;
  }

  @Override
  SceneFile built(int index) throws SceneFormatException, IOException {
    if (scene.isPresent()) {
      return model.orElseThrow().seenFrom(stage(index), scene.get());
    }
    Staging read = source.read(stage(index), false);
    read.keepFiles();
    scene = Optional.of(read.scene());
    model = Optional.of(read);
    return scene.get();
  }

  @Override
  byte[] text(int index) throws SceneFormatException {
    return model.orElseThrow().textOf(stage(index));
  }
}
