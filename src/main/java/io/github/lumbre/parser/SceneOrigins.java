package io.github.lumbre.parser;

import java.util.List;

/**
 * Where in its file everything of a scene stands.
 *
 * @param primitives the object of each of the scene's primitives, in their order
 * @param materials the material asset of each of them; {@link Origin#NONE} for those without
 * @param emitters the object of each of the scene's emitters, in their order
 */
public record SceneOrigins(List<Origin> primitives, List<Origin> materials, List<Origin> emitters) {
  public SceneOrigins {
    primitives = List.copyOf(primitives);
    materials = List.copyOf(materials);
    emitters = List.copyOf(emitters);
  }
}
