package io.github.lumbre.cli.view;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.Optional;

/** A scene and where its camera has been moved to. Mutable; callers synchronize. */
final class SceneCamera {
  private Optional<ParsedScene> home = Optional.empty();
  private Optional<ParsedScene> current = Optional.empty();
  private Optional<Orbit> orbit = Optional.empty();
  private Optional<MovedTo> moved = Optional.empty();

  /** Replaces the scene; the camera stays where it was moved to. */
  void open(SceneFile file) {
    boolean isFirst = home.isEmpty();
    ParsedScene opened = file.parsed();
    home = Optional.of(opened);
    orbit = isFirst || moved.isEmpty() ? Optional.of(Orbit.of(file.scene())) : orbit;
    moved = moved.map(place -> MovedTo.of(opened, orbit.get()));
    current = Optional.of(moved.map(place -> place.seen(opened)).orElse(opened));
  }

  boolean move(Orbit next) {
    if (home.isEmpty()) {
      return false;
    }
    orbit = Optional.of(next);
    moved = home.map(file -> MovedTo.of(file, next));
    current = home.map(file -> moved.get().seen(file));
    return true;
  }

  /** Moves the camera back to where the scene has it. */
  void goHome() {
    moved = Optional.empty();
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
  Optional<MovedTo> moved() {
    return moved;
  }
}
