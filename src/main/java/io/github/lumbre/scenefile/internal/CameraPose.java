package io.github.lumbre.scenefile.internal;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * The place of a camera, as a scene file states it for a camera without a parent.
 *
 * @param position {@code localPosition}: the eye, in world space
 * @param rotation {@code localRotation}: degrees about z first, then x, then y
 */
public record CameraPose(Vec3 position, Vec3 rotation) {
  public CameraPose {
    Objects.requireNonNull(position, "position");
    Objects.requireNonNull(rotation, "rotation");
  }

  /** Returns the pose of a camera; its angles are rounded. */
  public static CameraPose of(Camera camera) {
    return new CameraPose(camera.position(), Rotations.degrees(camera.axes()));
  }

  /**
   * Returns a camera at this pose, with the bits of one that is read from a scene file with these
   * numbers.
   */
  public Camera place(Camera camera) {
    return camera.movedTo(position, axes());
  }

  /** Returns the right, up and forward directions, with the bits of a scene file's camera. */
  public Frame axes() {
    Transform turn = Transform.IDENTITY.times(Transform.rotationDegrees(rotation));
    return new Frame(turn.vector(Vec3.X), turn.vector(Vec3.Y), turn.vector(Vec3.Z));
  }
}
