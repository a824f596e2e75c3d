package io.github.lumbre.cli.view;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.Optional;

/** A scene and where its camera has been moved to. Mutable; callers synchronize. */
final class SceneCamera {
  private Optional<ParsedScene> home = Optional.empty();
  private Optional<ParsedScene> current = Optional.empty();
  private Optional<Orbit> orbit = Optional.empty();
  private Optional<CameraPose> pose = Optional.empty();

  /** Replaces the scene; the camera stays where it was moved to. */
  void open(SceneFile file) {
    boolean isFirst = home.isEmpty();
    ParsedScene opened = file.parsed();
    home = Optional.of(opened);
    orbit = isFirst || pose.isEmpty() ? Optional.of(Orbit.of(file.scene())) : orbit;
    current = Optional.of(pose.map(opened::seenFrom).orElse(opened));
  }

  boolean move(Orbit next) {
    if (home.isEmpty()) {
      return false;
    }
    orbit = Optional.of(next);
    pose = Optional.of(next.pose());
    current = home.map(file -> file.seenFrom(pose.get()));
    return true;
  }

  /** Moves the camera back to where the scene has it. */
  void goHome() {
    pose = Optional.empty();
    orbit = home.map(file -> Orbit.of(file.scene()));
    current = home;
  }

  /** Returns the scene with the camera where it is; empty before the first one is read. */
  Optional<SceneFile> scene() {
    return current.map(file -> file);
  }

  Optional<Orbit> orbit() {
    return orbit;
  }

  /** Returns where the camera has been moved to; empty if it is where the scene has it. */
  Optional<CameraPose> pose() {
    return pose;
  }
}
