package io.github.lumbre.scenefile;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelCamera;
import io.github.lumbre.model.internal.ModelNames;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scenefile.Stage.View;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.Rotations;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The camera of the scene around a model.
 *
 * @param name of the model's camera; empty if it has none, or the stage has its own
 * @param aspect width over height of the frame; empty if the model does not state it
 */
record StageCamera(String name, Lens lens, CameraPose pose, OptionalDouble aspect) {
  /**
   * Returns the camera of the model that a stage names, or its first; a camera that has the whole
   * model in its frame if the stage names a view or the model has no camera.
   *
   * @param frameAspect width of the frame over its height, for the latter
   * @throws ModelFormatException if the model lacks the camera that the stage names
   */
  static StageCamera of(Stage stage, Model model, Framing framing, double frameAspect)
      throws ModelFormatException {
    Optional<ModelCamera> own = own(stage, model);
    if (own.isPresent()) {
      return of(own.get(), Transform.IDENTITY);
    }
    View from = stage.view().orElse(View.DEFAULT);
    CameraPose pose =
        new CameraPose(
            framing.eye(from, stage.fov(), frameAspect, stage.labels()),
            new Vec3(from.elevation(), -from.azimuth(), 0));
    return new StageCamera("", Lens.pinhole(stage.fov()), pose, OptionalDouble.empty());
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

  Camera placed(double filmAspect) {
    return lens.camera(pose.position(), pose.axes(), filmAspect);
  }

  /** Returns cameras for a film of an aspect ratio; equal ones are one camera. */
  static List<Camera> placed(List<StageCamera> cameras, double filmAspect) {
    Map<StageCamera, Camera> known = new HashMap<>();
    return cameras.stream()
        .map(camera -> known.computeIfAbsent(camera, own -> own.placed(filmAspect)))
        .toList();
  }

  /** Returns the camera type's name in the scene format. */
  String type() {
    return lens instanceof Lens.Orthographic ? "Orthographic" : "Pinhole";
  }

  /**
   * Returns a camera of a model in each of its poses.
   *
   * @param name of the camera
   * @param placement of the model in the scene
   * @throws ModelFormatException if the model lacks the camera
   */
  static List<StageCamera> inPoses(Model model, String name, Transform placement)
      throws ModelFormatException {
    int index = ModelNames.index("cameras", "a camera", ModelContents.cameraNames(model), name);
    List<StageCamera> all = new ArrayList<>();
    for (Model pose : model.poses().isEmpty() ? List.of(model) : model.poses()) {
      if (pose.cameras().size() != model.cameras().size()) {
        throw Kind.MALFORMED.at("cameras", "expected the same cameras in all poses");
      }
      all.add(of(pose.cameras().get(index), placement));
    }
    return all;
  }

  /** Returns a camera of a model; its angles are rounded, as a scene file states them. */
  private static StageCamera of(ModelCamera camera, Transform placement)
      throws ModelFormatException {
    Transform toWorld = placement.times(ModelScene.TO_LEFT_HANDED).times(camera.toWorld());
    CameraPose pose =
        new CameraPose(toWorld.point(Vec3.ZERO), Rotations.degrees(ModelScene.axes(toWorld)));
    try {
      Lens lens =
          camera.lens() instanceof ModelCamera.Parallel parallel
              ? Lens.orthographic(2 * parallel.halfHeight() * toWorld.vector(Vec3.Y).length())
              : Lens.pinhole(
                  Math.toDegrees(((ModelCamera.Perspective) camera.lens()).verticalFov()));
      return new StageCamera(camera.name(), lens, pose, camera.aspect());
    } catch (IllegalArgumentException e) {
      throw Kind.MALFORMED.at(camera.location(), e.getMessage());
    }
  }
}
