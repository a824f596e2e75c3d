package io.github.lumbre.cli;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.RenderFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.ProblemText;
import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.audit.Finding;
import io.github.lumbre.scenefile.audit.SceneAudit;
import io.github.lumbre.scenefile.internal.Origin;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code lumbre audit}: reports questionable values in a valid scene. */
@Command(
    name = "audit",
    header = "Report physically or numerically questionable values in a scene.",
    description =
        "Trace a few thousand paths and check materials, lights, glass, textures, scale and depth."
            + " Each finding states its place in the file, what was found, the effect and the fix.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {"", "Examples:", "  lumbre audit scene.json", "  lumbre audit --strict scene.json"})
@Exits({ExitCode.OK, ExitCode.WARNINGS, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT})
final class AuditCommand extends Subcommand {
  /** The JSON format's identifier; it changes with every incompatible change of the format. */
  static final String FORMAT = "lumbre-audit-1";

  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  @Mixin private final SceneOptions options = new SceneOptions();

  @Mixin private final RenderFlags flags = new RenderFlags();

  @Option(names = "--json", description = "Print the findings as JSON.")
  private boolean json;

  @Override
  ExitCode run() throws SceneFormatException, TaskException, IOException {
    flags.validate();
    SceneFile file = options.read(flags.over(options.parser()));
    List<Finding> findings = SceneAudit.of(file);
    Messages out = out();
    (json ? json(file, findings) : text(findings)).lines().forEach(out::line);
    return options.isStrict() && SceneAudit.warnings(findings) > 0
        ? ExitCode.WARNINGS
        : ExitCode.OK;
  }

  private String text(List<Finding> findings) {
    StringBuilder out = new StringBuilder();
    for (Finding finding : findings) {
      String severity = SettingType.nameOf(finding.severity());
      out.append(String.format("%-8s %s: %s\n", severity, place(finding), finding.found()))
          .append(String.format("         effect: %s\n", finding.means()))
          .append(finding.advice().isEmpty() ? "" : "         fix: " + finding.advice() + "\n");
    }
    long warnings = SceneAudit.warnings(findings);
    return out
        + ("" + options.scene())
        + ": warnings "
        + warnings
        + ", notes "
        + (findings.size() - warnings);
  }

  private static Origin place(Finding finding) {
    return new Origin(ProblemText.place(finding.path()), finding.name());
  }

  private static String json(SceneFile file, List<Finding> findings) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("scene_sha256", file.hash());
    values.put("warnings", SceneAudit.warnings(findings));
    values.put("findings", findings.stream().map(AuditCommand::json).toList());
    return GSON.toJson(values);
  }

  private static Map<String, Object> json(Finding finding) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("severity", SettingType.nameOf(finding.severity()));
    values.put("law", finding.law());
    values.put("path", place(finding).path());
    values.put("name", finding.name());
    values.put("found", finding.found());
    values.put("means", finding.means());
    values.put("advice", finding.advice());
    return values;
  }
}
