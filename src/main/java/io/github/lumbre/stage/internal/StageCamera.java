package io.github.lumbre.stage.internal;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelNames;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Chooses the camera of the scene around a model. */
final class StageCamera {
  private StageCamera() {}

  /**
   * Returns the camera of the model that a stage names, or its first; a camera that has the whole
   * model in its frame if the stage names a view or the model has no camera.
   *
   * @param frameAspect width of the frame over its height, for the latter
   * @throws ModelFormatException if the model lacks the camera that the stage names
   */
  static PlacedCamera of(Stage stage, Model model, Framing framing, double frameAspect)
      throws ModelFormatException {
    Optional<ModelCamera> own = own(stage, model);
    if (own.isPresent()) {
      return PlacedCamera.of(own.get(), Transform.IDENTITY);
    }
    View from = stage.view().orElse(View.DEFAULT);
    CameraPose pose =
        new CameraPose(
            framing.eye(from, stage.fov(), frameAspect, stage.labels()),
            new Vec3(from.elevation(), -from.azimuth(), 0));
    return new PlacedCamera("", Lens.pinhole(stage.fov()), pose, OptionalDouble.empty());
  }

  /**
   * Returns the camera of the model that a stage uses; empty if the whole model is framed.
   *
   * @throws ModelFormatException if the model lacks the camera that the stage names
   */
  static Optional<ModelCamera> own(Stage stage, Model model) throws ModelFormatException {
    if (stage.camera().isEmpty()) {
      return stage.view().isPresent() ? Optional.empty() : model.cameras().stream().findFirst();
    }
    List<String> names = ModelContents.cameraNames(model);
    int index = ModelNames.index("cameras", "a camera", names, stage.camera().get());
    return Optional.of(model.cameras().get(index));
  }
}
