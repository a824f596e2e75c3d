package io.github.lumbre.scenefile.audit;

import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.ArrayList;
import java.util.List;

/** Reports the parser's warnings, and rejected samples (negative, NaN or infinite). */
final class ParserWarnings implements Check {
  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    List<Finding> findings = new ArrayList<>();
    file.warnings().forEach(warning -> findings.add(finding(warning)));
    if (pilot.rejected() > 0) {
      findings.add(
          Finding.warning(
              "radiance",
              new Origin("$", ""),
              pilot.rejected() + " of " + pilot.paths() + " pilot paths are negative or not finite",
              "they are rejected and count as black, so the image is too dark there",
              "reduce extreme intensities and factors; lumbre pixel prints the path of a pixel"));
    }
    return findings;
  }

  private static Finding finding(Problem warning) {
    return Finding.warning(
        "format",
        new Origin(warning.path().isEmpty() ? warning.file() : warning.path(), ""),
        warning.message(),
        "the render may differ from what the file states",
        "correct the file, or accept the value used instead");
  }
}
