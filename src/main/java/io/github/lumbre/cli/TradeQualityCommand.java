package io.github.lumbre.cli;

import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.FlagConverters;
import io.github.lumbre.cli.option.Quality;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.lab.trade.QualityStudy;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.RenderSettings.Size;
import io.github.lumbre.scene.SettingType;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code lumbre trade quality}: measures the error that each quality of a render has. */
@Command(
    name = "quality",
    header = "Measure how wrong each --quality of render is.",
    description =
        "Renders a reference of each scene, then the scene in each quality with several seeds, and"
            + " prints a table in Markdown, a row as soon as it is known.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    usageHelpWidth = 100,
    sortOptions = false,
    footer = {"", "Example:", "  lumbre trade quality scenes/cornell-box.json --time 5m"},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "2:The command line is wrong",
      "3, 4, 5:A scene is invalid, a mesh or picture of it is, or something is too large",
      "7:A fault of the program",
      "129, 130, 143:Stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM"
    })
final class TradeQualityCommand implements Callable<Integer> {
  private static final int SIDE = 48;

  /** How many times less than the least squared error the reference's is to be. */
  private static final double REFERENCE_MARGIN = 8;

  @Parameters(paramLabel = "SCENE", arity = "1..*", description = "Scenes, JSON files.")
  private List<Path> scenes = List.of();

  @Option(
      names = "--size",
      paramLabel = "WxH",
      converter = FlagConverters.OfSize.class,
      description = "Size in pixels (the scene's, shrunk to a side of 48).")
  private Optional<Size> size = Optional.empty();

  @Option(
      names = "--seeds",
      paramLabel = "N",
      defaultValue = "4",
      description = "Renders of each quality, at least 3 (${DEFAULT-VALUE}).")
  private int seeds;

  @Option(
      names = "--time",
      paramLabel = "T",
      converter = FlagConverters.OfDuration.class,
      defaultValue = "1m",
      description =
          "The most for each scene, half of it for its reference (${DEFAULT-VALUE}). Qualities that"
              + " do not fit are left out.")
  private Duration time;

  @Option(names = "--debug", description = "Show the stack trace of an error.")
  private boolean debug;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, TaskException {
    new FlagChecks(spec).requireIn("--seeds", 3, 1000, seeds);
    Messages out = new Messages(spec.commandLine().getOut());
    out.line("| scene | pixels | reference | quality | samples | error | largest error | bias |");
    out.line("|---|---|--:|---|--:|--:|--:|--:|");
    try {
      for (Path scene : scenes) {
        measure(scene, out);
      }
      return ExitCodes.OK;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCodes.INTERRUPTED;
    }
  }

  private void measure(Path scene, Messages out)
      throws SceneFormatException, TaskException, InterruptedException {
    Messages errors = new Messages(spec.commandLine().getErr());
    SceneFile file = SceneFolder.load(scene, new SceneParser().inMode(Mode.PATH));
    errors.warnings(file.warnings());
    RenderSettings settings = framed(file.settings());
    double least = Quality.REFERENCE.targetError();
    QualityStudy study =
        new QualityStudy(
            file.scene(), settings, least * least / REFERENCE_MARGIN, time.toMillis() * 1e-3);
    for (Quality quality : Quality.values()) {
      List<String> cells =
          new ArrayList<>(
              List.of(
                  SceneFolder.name(scene),
                  settings.width() + "x" + settings.height(),
                  study.referenceCell(),
                  SettingType.nameOf(quality)));
      cells.addAll(
          study
              .measure(quality.targetError(), quality.depth(), seeds)
              .map(QualityStudy::cells)
              .orElse(List.of("no time", "", "", "")));
      out.line("| " + String.join(" | ", cells) + " |");
    }
  }

  private RenderSettings framed(RenderSettings inScene) {
    return size
        .map(s -> inScene.toBuilder().size(s.width(), s.height()).build())
        .orElseGet(() -> SampleBudget.shrunk(inScene, SIDE))
        .toBuilder()
        .threads(0)
        .clamp(Double.POSITIVE_INFINITY)
        .build();
  }
}
