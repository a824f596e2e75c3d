package io.github.lumbre.material;

/** A value of a material that varies over a surface. Immutable. */
public sealed interface Channel permits ColorChannel, ScalarChannel, NormalChannel {
  /** Returns whether the value is known to be the same everywhere. */
  default boolean isConstant() {
    return false;
  }
}
