package io.github.lumbre.stage.internal;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import java.io.IOException;
import java.util.Optional;
import java.util.stream.IntStream;

/** One turn around a model, or its standard views. It is read and built once. Mutable. */
final class StagedViews extends StagedFrames {
  private final Stage stage;
  private final Motion motion;
  private Optional<ParsedScene> scene = Optional.empty();

  StagedViews(ModelSource source, Stage stage, Motion motion) {
    super(source);
    this.stage = stage;
    this.motion = motion;
  }

  @Override
  public int count() {
    return motion.turns();
  }

  @Override
  Stage stage(int index) {
    return motion.stage(stage, index);
  }

  @Override
  SceneFile built(int index) throws SceneFormatException, IOException {
    if (scene.isPresent()) {
      return first().seenFrom(stage(index), scene.get());
    }
    Staging read = source.read(stage(index), false);
    if (motion.isAligned()) {
      read.align(IntStream.range(0, count()).mapToObj(this::stage).toList());
    }
    scene = Optional.of(scene(read));
    return scene.get();
  }

  @Override
  byte[] text(int index) throws SceneFormatException {
    return first().textOf(stage(index));
  }
}
