package io.github.lumbre.audit;

import io.github.lumbre.parser.Origin;
import io.github.lumbre.parser.Problem;
import io.github.lumbre.parser.SceneFile;
import java.util.ArrayList;
import java.util.List;

/** What the parser warned of, and samples that are no radiance. */
final class ParserWarnings implements Check {
  @Override
  public List<Finding> of(SceneFile file, Pilot pilot) {
    List<Finding> findings = new ArrayList<>();
    file.warnings().forEach(warning -> findings.add(finding(warning)));
    if (pilot.rejected() > 0) {
      findings.add(
          Finding.warning(
              "radiance",
              new Origin("$", ""),
              pilot.rejected() + " of " + pilot.paths() + " paths are negative or not finite",
              "they count as black: the picture is too dark there",
              "look for lights or factors near the limits of numbers; lumbre pixel shows a path"));
    }
    return findings;
  }

  private static Finding finding(Problem warning) {
    return Finding.warning(
        "format",
        new Origin(warning.path().isEmpty() ? "$" : warning.path(), ""),
        warning.message(),
        "the render differs from what the scene states",
        "correct the value, or accept what it is taken as");
  }
}
