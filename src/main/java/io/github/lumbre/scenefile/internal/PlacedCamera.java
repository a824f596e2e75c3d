package io.github.lumbre.scenefile.internal;

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
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * The camera of the scene around a model, or one of the model.
 *
 * @param name of the model's camera; empty if it has none, or the scene has its own
 * @param aspect width over height of the frame; empty if the model does not state it
 */
public record PlacedCamera(String name, Lens lens, CameraPose pose, OptionalDouble aspect) {
  public Camera placed(double filmAspect) {
    return lens.camera(pose.position(), pose.axes(), filmAspect);
  }

  /** Returns cameras for a film of an aspect ratio; equal ones are one camera. */
  public static List<Camera> placed(List<PlacedCamera> cameras, double filmAspect) {
    Map<PlacedCamera, Camera> known = new HashMap<>();
    return cameras.stream()
        .map(camera -> known.computeIfAbsent(camera, own -> own.placed(filmAspect)))
        .toList();
  }

  /** Returns the camera type's name in the scene format. */
  public String type() {
    return lens instanceof Lens.Orthographic ? "Orthographic" : "Pinhole";
  }

  /**
   * Returns a camera of a model in each of its poses.
   *
   * @param name of the camera
   * @param placement of the model in the scene
   * @throws ModelFormatException if the model lacks the camera
   */
  public static List<PlacedCamera> inPoses(Model model, String name, Transform placement)
      throws ModelFormatException {
    int index = ModelNames.index("cameras", "a camera", ModelContents.cameraNames(model), name);
    List<PlacedCamera> all = new ArrayList<>();
    for (Model pose : model.poses().isEmpty() ? List.of(model) : model.poses()) {
      if (pose.cameras().size() != model.cameras().size()) {
        throw Kind.MALFORMED.at("cameras", "expected the same cameras in all poses");
      }
      all.add(of(pose.cameras().get(index), placement));
    }
    return all;
  }

  /** Returns a camera of a model; its angles are rounded, as a scene file states them. */
  public static PlacedCamera of(ModelCamera camera, Transform placement)
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
      return new PlacedCamera(camera.name(), lens, pose, camera.aspect());
    } catch (IllegalArgumentException e) {
      throw Kind.MALFORMED.at(camera.location(), e.getMessage());
    }
  }
}
