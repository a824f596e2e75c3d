package io.github.lumbre.scene.internal;

import io.github.lumbre.camera.Viewpoint;
import io.github.lumbre.material.Material;
import io.github.lumbre.scene.Backplate;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a scene was built from in code. Immutable.
 *
 * @param viewpoint of the camera; empty if the scene was given a camera for one aspect ratio
 * @param nodes in the order in which they were added
 * @param materialNames names of materials, by identity
 * @param backplate what the camera sees instead of environment lights; empty if it sees these
 */
public record SceneDescription(
    Optional<Viewpoint> viewpoint,
    List<SceneNode> nodes,
    Map<Material, String> materialNames,
    Optional<Backplate> backplate) {
  public SceneDescription {
    nodes = List.copyOf(nodes);
    materialNames = Collections.unmodifiableMap(new IdentityHashMap<>(materialNames));
  }

  /** Returns the same description with another viewpoint. */
  public SceneDescription seenFrom(Optional<Viewpoint> other) {
    return new SceneDescription(other, nodes, materialNames, backplate);
  }
}
