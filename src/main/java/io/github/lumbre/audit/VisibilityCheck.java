package io.github.lumbre.audit;

import io.github.lumbre.parser.SceneFile;
import java.util.List;
import java.util.stream.IntStream;

/** Objects that neither the camera nor scattered light seems to hit. */
final class VisibilityCheck implements Check {
  @Override
  public List<Finding> of(SceneFile file, Pilot pilot) {
    List<Integer> unmet =
        IntStream.range(0, file.scene().primitives().size())
            .filter(i -> pilot.met(i) == 0)
            // Lights are reported by their own check.
            .filter(i -> file.scene().primitives().get(i).emission().isEmpty())
            .boxed()
            .toList();
    if (unmet.isEmpty()) {
      return List.of();
    }
    String others = unmet.size() == 1 ? "" : ", and " + (unmet.size() - 1) + " other objects";
    return List.of(
        Finding.note(
            "unseen",
            file.origins().primitives().get(unmet.get(0)),
            "none of " + pilot.paths() + " paths met it" + others,
            "it is outside the view and lights little, is behind the camera or inside something,"
                + " turns its back (planes are one-way), or is very small",
            "nothing, if that is meant; else turn it, or make a plane twoSided"));
  }
}
