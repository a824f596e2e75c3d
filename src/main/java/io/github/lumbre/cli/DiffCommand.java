package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.diff.ChangePage;
import io.github.lumbre.cli.diff.ChangeReport;
import io.github.lumbre.cli.diff.ModelPair;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.cli.output.JsonText;
import io.github.lumbre.cli.output.MemoryCheck;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.TextOutput;
import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.difference.ModelDifference;
import io.github.lumbre.model.difference.PartChange;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.Progress;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre diff}: says what changed between two models. */
@Command(
    name = "diff",
    modelTransformer = SettingFlags.Adder.class,
    header = "Say what changed between two models.",
    description =
        "Pair the parts of two models by name and by shape, and list those that were added,"
            + " removed, moved, changed or renamed. The order of parts, vertices and triangles does"
            + " not matter.",
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre diff bracket-1.step.glb bracket-2.step.glb",
      "  lumbre diff old.stl new.stl -o what-changed.html --up z"
    })
@Exits(
    value = {
      ExitCode.OK, ExitCode.DIFFERENT, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT,
      ExitCode.OUTPUT, ExitCode.INTERRUPTED
    },
    different = "something changed")
final class DiffCommand extends Subcommand {
  private static final RenderSettings USUAL = RenderSettings.builder().size(640, 480).build();

  @Parameters(index = "0", paramLabel = "OLD", description = "Model file.")
  private Path old;

  @Parameters(index = "1", paramLabel = "NEW", description = "Model file to compare it with.")
  private Path now;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "PAGE.html",
      description = "Write a page with pictures of both, and of the difference.")
  private Optional<Path> page = Optional.empty();

  @Option(
      names = "--size",
      paramLabel = "WxH|N",
      description = "Size of each picture of the page in pixels (640x480).")
  private Optional<FrameSize> size = Optional.empty();

  @Option(
      names = "--tolerance",
      paramLabel = "LENGTH",
      description =
          "Largest distance of vertices that count as the same, in the unit of the new file"
              + " (5e-6 of the models' diagonal).")
  private Optional<Double> tolerance = Optional.empty();

  @Option(names = "--json", description = "Print the changes as JSON.")
  private boolean json;

  @Mixin
  private final ModelFlags flags =
      new ModelFlags()
          .without("one camera, from --view, frames both models", Stage.CAMERA)
          .without("parts are compared where they are", ModelOption.EXPLODE);

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run()
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    for (Path model : List.of(old, now)) {
      require(ModelReader.isModel(model), model + ": expected a model file: " + Models.NAMES);
    }
    tolerance.ifPresent(
        length ->
            require(
                length > 0 && length < Double.POSITIVE_INFINITY,
                "--tolerance: expected a finite number > 0, found " + length));
    size.ifPresent(checks()::requireSize);
    Stage stage = flags.stage();
    OutputGuard guard = overwrite.guard().reads(old, "a model").reads(now, "a model");
    page.ifPresent(file -> guard.writes("-o", file, OutputContent.DIFF_PAGE));
    guard.check();
    try (TextOutput output = TextOutput.reserve(page)) {
      ModelPair pair =
          ModelPair.<TaskException>read(
              options -> read(old, options), options -> read(now, options), stage);
      warn(old, pair.old().model());
      warn(now, pair.now().model());
      ChangeReport report = pair.report(tolerance);
      if (page.isPresent()) {
        output.write(page(pair.ofOld(), pair.ofNow(), report));
      }
      print(report);
      return report.found().changes().isEmpty() ? ExitCode.OK : ExitCode.DIFFERENT;
    }
  }

  private void warn(Path path, Model model) {
    model.warnings().forEach(warning -> errors().warning(path + ": " + warning));
  }

  private static ModelDifference.Side read(Path path, ModelOptions options)
      throws TaskException, IOException {
    String name = path.getFileName().toString();
    try {
      byte[] content = ModelReader.bytes(path, options.limits());
      ModelFolder folder =
          ModelFolder.of(path.toAbsolutePath().getParent(), options.get(ModelOption.ASSETS));
      Model model = ModelReader.read(name, content, folder, options);
      return new ModelDifference.Side(model, ModelReader.motions(name, content, folder, options));
    } catch (ModelFormatException e) {
      throw Failures.ofModel(path, e);
    } catch (IOException e) {
      throw FileFailure.named(path, e);
    }
  }

  private String page(Stage ofOld, Stage ofNew, ChangeReport report)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    StagedModel before = views(old, ofOld);
    StagedModel after = views(now, ofNew);
    RenderSettings shown = size.map(s -> s.over(USUAL)).orElse(USUAL);
    List<SceneFile> both =
        StagedModel.seenTogether(before, after, shown.width(), shown.height());
    return ChangePage.of(
        side(old, both.get(0)),
        side(now, both.get(1)),
        report.found().changes(),
        report.summary(),
        report.lines(),
        String.join("; ", report.found().notCompared()));
  }

  private static StagedModel views(Path model, Stage stage)
      throws SceneFormatException, IOException {
    SceneParser parser =
        new SceneParser().overriding(s -> s.toBuilder().samples(Denoising.MODEL_SAMPLES).build());
    return StagedModel.read(model, stage.framed(), parser);
  }

  private ChangePage.Side side(Path path, SceneFile file)
      throws TaskException, InterruptedException {
    String name = String.valueOf(path.getFileName());
    Messages messages = errors();
    MemoryCheck.require(file.settings(), FilmLayers.of(file.settings(), file.scene()));
    DisplayLight picture =
        CleanPicture.of(file, name, note -> messages.line(path + ": " + note), Progress.NONE);
    return new ChangePage.Side(path, file, picture);
  }

  private void print(ChangeReport report) {
    Messages out = out();
    ModelDifference.Result found = report.found();
    List<String> lines = report.lines();
    if (json) {
      JsonText.pretty(report.values(old.toString(), now.toString())).lines().forEach(out::line);
      return;
    }
    out.line("%s against %s: %s".formatted(now, old, report.summary()));
    int width = found.changes().stream().mapToInt(change -> change.name().length()).max().orElse(0);
    for (int i = 0; i < lines.size(); i++) {
      PartChange change = found.changes().get(i);
      String name = change.name() + " ".repeat(width - change.name().length());
      out.line(
          "%-8s %s  %s"
              .formatted(ChangePage.word(change.kind()), name, lines.get(i))
              .stripTrailing());
    }
    if (!found.notCompared().isEmpty()) {
      out.line("not compared: " + String.join("; ", found.notCompared()));
    }
    page.ifPresent(file -> out.line("page       " + file));
  }
}
