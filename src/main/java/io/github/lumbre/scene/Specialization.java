package io.github.lumbre.scene;

/**
 * Work that a scene may not require: decided once, when the scene is complete. The picture has the
 * same bits with a shortcut and without.
 */
public enum Specialization {
  /** Where no texture varies a material, how it scatters is made once and not at every hit. */
  UNIFORM_MATERIALS,

  /** Of one emitter none is chosen: no random number is made for that, and no weights. */
  ONE_EMITTER
}
