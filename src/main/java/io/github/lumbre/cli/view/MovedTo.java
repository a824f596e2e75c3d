package io.github.lumbre.cli.view;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.scenefile.internal.CameraPose;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.stage.internal.MovedCamera;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Where a camera has been moved to.
 *
 * @param lens of the camera; empty if it is that of the scene
 * @param flags that give this camera before a model; empty if none do
 */
record MovedTo(CameraPose pose, Optional<Lens> lens, Optional<List<String>> flags) {
  /** A camera of a scene around a model is what flags can say; others keep their lens. */
  static MovedTo of(ParsedScene home, Orbit orbit) {
    CameraPose pose = orbit.pose();
    // Flags state what a camera looks at, and the vertical is upright.
    if (home.model().isPresent() && pose.rotation().z() == 0) {
      double height =
          orbit.isParallel() ? orbit.height() : Projection.frameHeight(home.scene().camera());
      Optional<MovedTo> said =
          MovedCamera.of(home, pose.position(), orbit.target(), orbit.isParallel(), height)
              .map(MovedTo::new);
      if (said.isPresent()) {
        return said.get();
      }
    }
    Optional<Lens> lens =
        orbit.isParallel() ? Optional.of(Lens.orthographic(orbit.height())) : Optional.empty();
    return new MovedTo(pose, lens, Optional.empty());
  }

  private MovedTo(MovedCamera moved) {
    this(moved.camera().pose(), Optional.of(moved.camera().lens()), Optional.of(moved.flags()));
  }

  /** Returns a scene as this camera sees it. */
  ParsedScene seen(ParsedScene home) {
    return lens.isPresent()
        ? home.seenBy(new PlacedCamera("", lens.get(), pose, OptionalDouble.empty()))
        : home.seenFrom(pose);
  }
}
