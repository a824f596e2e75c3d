package io.github.lumbre.scenefile.audit;

import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.List;
import java.util.stream.IntStream;

/** Reports a camera that sees nothing, and objects that no ray of the pilot render hits. */
final class VisibilityCheck implements Check {
  private static final String LAW = "unseen";

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    int objects = file.scene().primitives().size();
    if (objects > 0 && IntStream.range(0, objects).allMatch(i -> pilot.met(i) == 0)) {
      return List.of(
          Finding.warning(
              LAW,
              new Origin("$", ""),
              "the camera sees no object: none of " + pilot.paths() + " pilot paths hits one",
              "the image shows the background alone",
              "turn or move the camera, or check where the objects are"));
    }
    List<Integer> unmet =
        IntStream.range(0, file.scene().primitives().size())
            .filter(i -> pilot.met(i) == 0)
            // LightCheck reports lights.
            .filter(i -> file.scene().primitives().get(i).emission().isEmpty())
            .boxed()
            .toList();
    if (unmet.isEmpty()) {
      return List.of();
    }
    String others = unmet.size() == 1 ? "" : ", and " + (unmet.size() - 1) + " other objects";
    return List.of(
        Finding.note(
            LAW,
            file.origins().primitives().get(unmet.get(0)),
            "none of " + pilot.paths() + " pilot paths hit it" + others,
            "it may be out of view, inside another object, very small, or a one-sided plane seen"
                + " from behind",
            "if this is not intended, move or turn it, or make a plane twoSided"));
  }
}
