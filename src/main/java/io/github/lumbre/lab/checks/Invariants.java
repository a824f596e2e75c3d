package io.github.lumbre.lab.checks;

import java.util.List;
import java.util.stream.Stream;

/** All laws. */
public final class Invariants {
  /** The rounding unit of doubles, in which some laws count. */
  static final double EPSILON = 0x1p-52;

  private Invariants() {}

  /** Returns all laws, in the order in which they are told. */
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
