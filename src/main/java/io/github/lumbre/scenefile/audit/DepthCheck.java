package io.github.lumbre.scenefile.audit;

import io.github.lumbre.render.internal.DepthCut;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scenefile.audit.Finding.Severity;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.List;
import java.util.Locale;

/** Reports the energy lost to the path length limit. */
final class DepthCheck implements Check {
  private static final double WORTH_A_NOTE = .01;
  private static final double WORTH_A_WARNING = .05;

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    DepthCut cut;
    try {
      cut = DepthCut.of(file.scene(), file.settings());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of();
    }
    double sure = cut.share() - 2 * cut.standardError();
    if (cut.share() < WORTH_A_NOTE || sure <= 0) {
      return List.of();
    }
    boolean isPath = file.settings().mode() == Mode.PATH;
    String key = isPath ? "maxTraceDepth" : "reflectionTraceDepth";
    return List.of(
        new Finding(
            sure > WORTH_A_WARNING ? Severity.WARNING : Severity.NOTE,
            "depth",
            "$.renderOptions." + key,
            "",
            String.format(
                Locale.ROOT,
                "about %.2g %% (± %.1g) of the energy is lost to the path length limit",
                100 * cut.share(),
                100 * cut.standardError()),
            "the image is too dark by this share, mostly in bright corners and behind glass",
            isPath
                ? "raise maxTraceDepth; roulette keeps the cost of long paths low"
                : "raise reflectionTraceDepth and refractionTraceDepth"));
  }
}
