package io.github.lumbre.stage.internal;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.stage.Stage;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** Which options of a camera exclude each other. Stateless. */
public final class CameraChoice {
  /** The first of each pair leaves no choice for the second. */
  private static final List<List<ModelOption<?>>> EXCLUSIVE =
      List.of(
          List.of(Stage.CAMERA, Stage.VIEW),
          List.of(Stage.CAMERA, Stage.EYE),
          List.of(Stage.CAMERA, Stage.FIT),
          List.of(Stage.CAMERA, Stage.PARALLEL),
          List.of(Stage.CAMERA, Stage.PERSPECTIVE),
          List.of(Stage.EYE, Stage.VIEW),
          List.of(Stage.PARALLEL, Stage.PERSPECTIVE),
          List.of(Stage.PARALLEL, Stage.FOV),
          List.of(Stage.SCALE, Stage.ZOOM));

  private CameraChoice() {}

  /**
   * Returns what is wrong with the options of a stage's camera, for messages; empty if they agree.
   *
   * @param name of an option, as the caller states it
   */
  public static Optional<String> contradiction(
      Stage stage, Function<ModelOption<?>, String> name) {
    for (List<ModelOption<?>> pair : EXCLUSIVE) {
      if (pair.stream().allMatch(option -> isGiven(option, stage))) {
        return Optional.of(
            "%s and %s: expected only one of them"
                .formatted(name.apply(pair.get(0)), name.apply(pair.get(1))));
      }
    }
    Optional<Vec3> target = stage.find(Stage.TARGET);
    if (target.isPresent() && stage.find(Stage.EYE).isEmpty()) {
      return Optional.of(
          "%s: requires %s; %s puts a part into the middle"
              .formatted(
                  name.apply(Stage.TARGET), name.apply(Stage.EYE), name.apply(Stage.FIT)));
    }
    return target.isPresent() && target.equals(stage.find(Stage.EYE))
        ? Optional.of(
            "%s and %s: expected two different points, found %s for both"
                .formatted(
                    name.apply(Stage.EYE),
                    name.apply(Stage.TARGET),
                    Stage.EYE.type().format(target.get())))
        : Optional.empty();
  }

  private static <T> boolean isGiven(ModelOption<T> option, Stage stage) {
    return stage.find(option).isPresent() && !stage.find(option).equals(option.defaultValue());
  }
}
