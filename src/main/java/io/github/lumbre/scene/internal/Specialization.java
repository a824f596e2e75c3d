package io.github.lumbre.scene.internal;

import io.github.lumbre.scene.Primitive;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/**
 * A specialization: work that a render can skip for a given scene, decided when the scene is built.
 * Pictures with and without it are bit-identical.
 */
public enum Specialization {
  /** The BSDFs of materials without varying textures are created once and not at every hit. */
  UNIFORM_MATERIALS,

  /**
   * With a single emitter, the selection of a light is skipped: it needs no random number and no
   * weights.
   */
  ONE_EMITTER;

  public static Set<Specialization> of(List<Primitive> primitives, int emitters) {
    Set<Specialization> all = EnumSet.noneOf(Specialization.class);
    if (primitives.stream().anyMatch(primitive -> primitive.material().isUniform())) {
      all.add(UNIFORM_MATERIALS);
    }
    if (emitters == 1) {
      all.add(ONE_EMITTER);
    }
    return Set.copyOf(all);
  }
}
