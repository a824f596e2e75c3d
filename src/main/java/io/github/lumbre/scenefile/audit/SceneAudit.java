package io.github.lumbre.scenefile.audit;

import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.audit.Finding.Severity;
import io.github.lumbre.scenefile.internal.ParsedScene;
import java.util.Comparator;
import java.util.List;

/** Checks a valid scene for physically or numerically questionable properties. Stateless. */
public final class SceneAudit {
  private static final List<Check> CHECKS =
      List.of(
          new VisibilityCheck(),
          new LightCheck(),
          new ParserWarnings(),
          new ReflectanceCheck(),
          new UnusedAssets(),
          new GlassCheck(),
          new ScaleCheck(),
          new NormalMapCheck(),
          new TextureSizeCheck(),
          new DepthCheck());

  private SceneAudit() {}

  /**
   * Returns the findings, warnings first, and those without a fix last; empty if there are none.
   * Renders a small pilot, and is deterministic for a scene. If the calling thread is interrupted,
   * findings may be missing and the interrupt status stays set.
   */
  public static List<Finding> of(SceneFile file) {
    ParsedScene scene = file.parsed();
    Pilot pilot = Pilot.of(scene);
    return CHECKS.stream()
        .flatMap(check -> check.of(scene, pilot).stream())
        .sorted(Comparator.comparing(Finding::severity).thenComparing(f -> f.advice().isEmpty()))
        .toList();
  }

  /** Returns the number of findings that are warnings. */
  public static long warnings(List<Finding> findings) {
    return findings.stream().filter(f -> f.severity() == Severity.WARNING).count();
  }
}
