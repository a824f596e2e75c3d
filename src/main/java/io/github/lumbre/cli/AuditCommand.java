package io.github.lumbre.cli;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import io.github.lumbre.audit.Finding;
import io.github.lumbre.audit.SceneAudit;
import io.github.lumbre.cli.option.RenderFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.scene.SettingType;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code lumbre audit}: tells what is questionable in a scene that can be rendered. */
@Command(
    name = "audit",
    header = "Tell what is physically or numerically questionable in a scene.",
    description =
        "Follows a few thousand paths and looks at materials, lights, glass, textures, scale and"
            + " depth. Each finding tells where in the file, what was found, what it means and what"
            + " to do.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    modelTransformer = SettingFlags.Adder.class,
    usageHelpWidth = 100,
    sortOptions = false,
    abbreviateSynopsis = true,
    footer = {"", "Examples:", "  lumbre audit scene.json", "  lumbre audit --strict scene.json"},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done, whatever was found",
      "1:There are warnings, and --strict makes them errors",
      "2:The command line is wrong",
      "3:The scene is missing, unreadable or invalid",
      "4:A mesh or picture of the scene cannot be decoded",
      "5:Something is larger than a limit or than memory",
      "7:A fault of the program"
    })
final class AuditCommand implements Callable<Integer> {
  /** What tells the JSON from others; it changes when older readers would misunderstand. */
  static final String FORMAT = "lumbre-audit-1";

  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  @Mixin private SceneOptions options;

  @Mixin private RenderFlags flags;

  @Option(names = "--json", description = "Print JSON, for programs.")
  private boolean json;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, TaskException {
    flags.validate();
    SceneFile file = options.read(flags.over(options.parser()));
    List<Finding> findings = SceneAudit.of(file);
    Messages out = new Messages(spec.commandLine().getOut());
    (json ? json(file, findings) : text(findings)).lines().forEach(out::line);
    return options.isStrict() && SceneAudit.warnings(findings) > 0
        ? ExitCodes.WARNINGS
        : ExitCodes.OK;
  }

  private String text(List<Finding> findings) {
    StringBuilder out = new StringBuilder();
    for (Finding finding : findings) {
      String severity = SettingType.nameOf(finding.severity());
      out.append(String.format("%-8s %s: %s\n", severity, finding.path(), finding.found()))
          .append(String.format("         means: %s\n", finding.means()))
          .append(finding.advice().isEmpty() ? "" : "         to do: " + finding.advice() + "\n");
    }
    long warnings = SceneAudit.warnings(findings);
    return out
        + ("" + options.scene())
        + ": warnings "
        + warnings
        + ", notes "
        + (findings.size() - warnings);
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
    values.put("path", finding.path().path());
    values.put("name", finding.path().name());
    values.put("found", finding.found());
    values.put("means", finding.means());
    values.put("advice", finding.advice());
    return values;
  }
}
