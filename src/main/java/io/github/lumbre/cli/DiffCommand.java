package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.base.text.Quantities;
import io.github.lumbre.cli.diff.ChangePage;
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
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.difference.FileSpace;
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
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
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
  private static final String FORMAT = "lumbre-diff-1";
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

  @Mixin private final ModelFlags flags = new ModelFlags();

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
    require(
        !spec.commandLine().getParseResult().hasMatchedOption("--camera"),
        "--camera: cannot be used; one camera, from --view, frames both models");
    Stage stage = flags.stage();
    OutputGuard guard = overwrite.guard().reads(old, "a model").reads(now, "a model");
    page.ifPresent(file -> guard.writes("-o", file, OutputContent.DIFF_PAGE));
    guard.check();
    try (TextOutput output = TextOutput.reserve(page)) {
      Stage ofOld = beside(now, old, stage);
      Stage ofNew = beside(old, now, stage);
      ModelDifference.Side before = read(old, ofOld);
      ModelDifference.Side after = read(now, ofNew);
      warn(old, before.model());
      warn(now, after.model());
      double near =
          tolerance.isPresent()
              ? ModelDifference.space(after.model()).inWorld(tolerance.get())
              : ModelDifference.tolerance(before.model(), after.model());
      ModelDifference.Result found = ModelDifference.between(before, after, near);
      List<String> lines =
          found.changes().stream().map(change -> text(change, found.space())).toList();
      if (page.isPresent()) {
        output.write(page(ofOld, ofNew, found, lines));
      }
      print(found, lines, near);
      return found.changes().isEmpty() ? ExitCode.OK : ExitCode.DIFFERENT;
    }
  }

  private void warn(Path path, Model model) {
    model.warnings().forEach(warning -> errors().warning(path + ": " + warning));
  }

  /**
   * Returns the stage of a model: if it states its axis and unit, and the other one does not, the
   * flags for these are meant for the other one.
   */
  private Stage beside(Path other, Path model, Stage stage) throws TaskException, IOException {
    ModelOptions options = stage.options();
    Stage own = stage.reading(options.oriented(Optional.empty(), OptionalDouble.empty()));
    boolean isCorrected = !own.equals(stage);
    return isCorrected && statesUnit(model, own) && !statesUnit(other, own) ? own : stage;
  }

  private boolean statesUnit(Path model, Stage own) throws TaskException, IOException {
    return !read(model, own).model().unit().isEmpty();
  }

  private ModelDifference.Side read(Path path, Stage stage) throws TaskException, IOException {
    String name = path.getFileName().toString();
    ModelOptions options = stage.options().mayLackFiles(true);
    try {
      byte[] content = Files.readAllBytes(path);
      ModelFolder folder =
          ModelFolder.of(
              path.toAbsolutePath().getParent(), stage.options().get(ModelOption.ASSETS));
      Model model = ModelReader.read(name, content, folder, options);
      return new ModelDifference.Side(model, ModelReader.motions(name, content, folder, options));
    } catch (ModelFormatException e) {
      throw Failures.ofModel(path, e);
    } catch (IOException e) {
      throw FileFailure.named(path, e);
    }
  }

  private String page(Stage ofOld, Stage ofNew, ModelDifference.Result found, List<String> lines)
      throws SceneFormatException, TaskException, IOException, InterruptedException {
    StagedModel before = views(old, ofOld);
    StagedModel after = views(now, ofNew);
    View view = ofNew.find(Stage.VIEW).orElse(View.DEFAULT);
    RenderSettings shown = size.map(s -> s.over(USUAL)).orElse(USUAL);
    return ChangePage.of(
        side(old, before.seenBeside(after, view, shown.width(), shown.height())),
        side(now, after.seenBeside(before, view, shown.width(), shown.height())),
        found.changes(),
        summary(found),
        lines,
        String.join("; ", found.notCompared()));
  }

  private static StagedModel views(Path model, Stage stage)
      throws SceneFormatException, IOException {
    View view = stage.find(Stage.VIEW).orElse(View.DEFAULT);
    SceneParser parser =
        new SceneParser().overriding(s -> s.toBuilder().samples(Denoising.MODEL_SAMPLES).build());
    return StagedModel.read(model, stage.seenFrom(view), parser);
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

  /** Returns the numbers of changes by their kinds. */
  private static String summary(ModelDifference.Result found) {
    Map<PartChange.Kind, Integer> counts = new EnumMap<>(PartChange.Kind.class);
    found.changes().forEach(change -> counts.merge(change.kind(), 1, Integer::sum));
    List<String> texts = new ArrayList<>();
    counts.forEach((kind, count) -> texts.add(count + " " + ChangePage.word(kind)));
    String unchanged = found.notCompared().isEmpty() ? "the same" : "without a change found";
    texts.add(found.same() + " " + unchanged);
    return String.join(", ", texts);
  }

  private static String text(PartChange change, FileSpace space) {
    List<String> texts = new ArrayList<>();
    if (change.kind() == PartChange.Kind.MOVED) {
      if (change.distance() > 0) {
        texts.add("by " + space.text(change.shift()));
      }
      if (change.degrees() > 0) {
        texts.add("turned by " + Quantities.text(change.degrees()) + " degrees");
      }
    }
    texts.addAll(change.details());
    if (change.old().isPresent()
        && change.now().isPresent()
        && !change.old().equals(change.now())) {
      texts.add("was " + PrintableText.quoted(change.old().get()));
    }
    return String.join(", ", texts);
  }

  private void print(ModelDifference.Result found, List<String> lines, double near) {
    Messages out = out();
    if (json) {
      JsonText.pretty(values(found, near)).lines().forEach(out::line);
      return;
    }
    out.line("%s against %s: %s".formatted(now, old, summary(found)));
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

  private Map<String, Object> values(ModelDifference.Result found, double near) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("format", FORMAT);
    values.put("old", old.toString());
    values.put("new", now.toString());
    values.put("unit", found.space().unit());
    values.put("tolerance", found.space().length(near));
    values.put(found.notCompared().isEmpty() ? "same" : "withoutChangeFound", found.same());
    values.put("notCompared", found.notCompared());
    values.put("changes", found.changes().stream().map(DiffCommand::values).toList());
    return values;
  }

  private static Map<String, Object> values(PartChange change) {
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("kind", ChangePage.word(change.kind()));
    values.put("of", change.of().name().toLowerCase(Locale.ROOT));
    change.old().ifPresent(name -> values.put("old", name));
    change.now().ifPresent(name -> values.put("new", name));
    if (change.kind() == PartChange.Kind.MOVED) {
      Vec3 shift = change.shift();
      values.put("shift", List.of(shift.x(), shift.y(), shift.z()));
      values.put("distance", change.distance());
      values.put("degrees", change.degrees());
    }
    values.put("details", change.details());
    values.put("parts", Math.max(change.oldParts().size(), change.nowParts().size()));
    return values;
  }
}
