package io.github.lumbre.model.internal;

import java.util.List;

/**
 * What the file of a model states of its motion beside the pose that is shown.
 *
 * @param keys for each animation, in the order of the file, a text that identifies its keys: two
 *     animations that move the same nodes alike have the same text
 * @param deformations what changes the shapes of meshes in other poses, in words
 */
public record ModelMotions(List<String> keys, List<String> deformations) {
  public static final ModelMotions NONE = new ModelMotions(List.of(), List.of());

  public ModelMotions {
    keys = List.copyOf(keys);
    deformations = List.copyOf(deformations);
  }
}
