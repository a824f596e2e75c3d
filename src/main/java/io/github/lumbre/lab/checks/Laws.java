package io.github.lumbre.lab.checks;

import java.util.List;
import java.util.stream.Stream;

/** All laws. */
public final class Laws {
  /** The rounding unit of doubles, in which some laws count. */
  static final double EPSILON = 0x1p-52;

  private Laws() {}

  /** Returns all laws, in the order in which they are told. */
  public static List<Law> all() {
    return Stream.of(
            GeometryLaws.all(),
            NumberLaws.all(),
            MaterialLaws.all(),
            LightLaws.all(),
            PictureLaws.all())
        .flatMap(List::stream)
        .toList();
  }
}
