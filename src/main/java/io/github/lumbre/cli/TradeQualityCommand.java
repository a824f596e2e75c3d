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

/** {@code lumbre trade quality}: measures the error of each quality preset. */
@Command(
    name = "quality",
    header = "Measure the error of each --quality preset of 'lumbre render'.",
    description =
        "Render a reference of each scene, then the scene in each quality with several seeds. Print"
            + " a table in Markdown, each row as soon as it is measured.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    sortOptions = false,
    footer = {"", "Example:", "  lumbre trade quality scenes/cornell-box.json --time 5m"},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "2:The command line is invalid",
      "3, 4, 5:A scene is invalid, an asset cannot be decoded, or a limit is exceeded",
      "7:Internal error",
      "129, 130, 143:Stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM"
    })
final class TradeQualityCommand implements Callable<Integer> {
  private static final int SIDE = 48;

  /** The ratio of the smallest squared target error to the reference's squared error. */
  private static final double REFERENCE_MARGIN = 8;

  @Parameters(paramLabel = "SCENE", arity = "1..*", description = "JSON scene files.")
  List<Path> scenes = List.of();

  @Option(
      names = "--size",
      paramLabel = "WxH",
      converter = FlagConverters.OfSize.class,
      description = "Frame size in pixels (the scene's, scaled down to a side of 48).")
  Optional<Size> size = Optional.empty();

  @Option(
      names = "--seeds",
      paramLabel = "N",
      defaultValue = "4",
      description = "Renders of each quality, at least 3 (${DEFAULT-VALUE}).")
  int seeds;

  @Option(
      names = "--time",
      paramLabel = "DURATION",
      converter = FlagConverters.OfDuration.class,
      defaultValue = "1m",
      description =
          "Time limit per scene, half of it for the reference (${DEFAULT-VALUE}). Qualities that do"
              + " not fit are skipped.")
  Duration time;

  @Option(names = "--debug", description = "Print the stack trace of an error.")
  boolean debug;

  @Spec CommandSpec spec;

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
