package io.github.lumbre.lab.checks;

import java.util.List;
import java.util.stream.Stream;

/** All invariants. */
public final class Invariants {
  /** The rounding unit of doubles, 2^-52, the unit of some limits. */
  static final double EPSILON = 0x1p-52;

  private Invariants() {}

  /** Returns all invariants in the order in which they are printed. */
  public static List<Invariant> all() {
    return Stream.of(
            GeometryInvariants.all(),
            NumberInvariants.all(),
            MaterialInvariants.all(),
            LightInvariants.all(),
            PictureInvariants.all())
        .flatMap(List::stream)
        .toList();
  }
}
