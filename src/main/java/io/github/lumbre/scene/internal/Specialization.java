package io.github.lumbre.scene.internal;

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
  ONE_EMITTER
}
