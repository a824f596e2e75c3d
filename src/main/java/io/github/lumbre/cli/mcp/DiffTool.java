package io.github.lumbre.cli.mcp;

import io.github.lumbre.cli.diff.ChangePage;
import io.github.lumbre.cli.diff.ChangePicture;
import io.github.lumbre.cli.diff.ChangeReport;
import io.github.lumbre.cli.diff.ModelPair;
import io.github.lumbre.cli.mcp.Studio.Frame;
import io.github.lumbre.cli.mcp.Studio.Staged;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.difference.PartChange;
import io.github.lumbre.scene.internal.SettingTypes.NumberType;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Says what changed between two models. */
record DiffTool(Studio studio) implements Tool {
  private static final Input<String> OLD =
      Input.requiredText("old", "Path of the model before the change.");

  private static final Input<String> NEW =
      Input.requiredText("new", "Path of the model after the change.");

  private static final Input<Optional<Double>> TOLERANCE =
      Input.number(
          "tolerance",
          new NumberType(Range.above(0, Double.MAX_VALUE)),
          "Largest distance of vertices that count as the same, in the unit of the new file;"
              + " without it, 5e-6 of the models' diagonal.");

  @Override
  public String name() {
    return "diff";
  }

  @Override
  public String title() {
    return "Say what changed between two models";
  }

  @Override
  public String description() {
    return "Pairs the parts of two 3D models by name and by shape, lists those that were added,"
        + " removed, moved, changed or renamed, and returns three PNG pictures by the same camera:"
        + " the old model, the new one, and the new one with the changes in color.";
  }

  @Override
  public List<Input<?>> inputs() {
    List<Input<?>> inputs =
        new ArrayList<>(
            List.of(
                OLD, NEW, TOLERANCE, RenderTool.WIDTH, RenderTool.HEIGHT, RenderTool.SAMPLES));
    inputs.addAll(ModelInputs.allBut(Stage.CAMERA, ModelOption.EXPLODE));
    return inputs;
  }

  @Override
  public List<Output> outputs() {
    return List.of(
        Output.text("format", "Changes with incompatible changes."),
        Output.text("old", "Path of the old model."),
        Output.text("new", "Path of the new model."),
        Output.text("unit", "Of lengths: that of the new file; empty if it states none."),
        Output.number("tolerance", "Largest distance of vertices that count as the same."),
        Output.count("same", "Number of parts that are the same.").optional(),
        Output.count("withoutChangeFound", "The same, if not everything was compared.").optional(),
        Output.texts("notCompared", "What was not compared."),
        Output.objects(
            "changes",
            "What changed.",
            Output.text("kind", "added, removed, moved, changed or renamed."),
            Output.text("of", "part, light, camera, animation or variant."),
            Output.text("old", "Name in the old model.").optional(),
            Output.text("new", "Name in the new model.").optional(),
            Output.numbers("shift", 3, "Of a moved part, in the axes of the new file.").optional(),
            Output.number("distance", "Of a moved part.").optional(),
            Output.number("degrees", "Rotation of a moved part.").optional(),
            Output.texts("details", "In words."),
            Output.count("parts", "Number of parts that the change stands for.")),
        Output.text("summary", "Numbers of changes by their kinds."),
        Output.textsByName("colors", "Colors of the third picture by what they mean."),
        SummaryOutputs.WARNINGS,
        SummaryOutputs.NOTES);
  }

  @Override
  public Outcome call(Arguments arguments, CallProgress progress)
      throws ToolException, InterruptedException {
    String old = arguments.get(OLD);
    String now = arguments.get(NEW);
    ModelPair pair = pair(old, now, ModelInputs.stage(arguments));
    ChangeReport report = pair.report(arguments.get(TOLERANCE));
    Staged before = studio.model(old, pair.ofOld());
    Staged after = studio.model(now, pair.ofNow());
    Frame frame = RenderTool.frame(arguments);
    progress.expect(2L * frame.width() * frame.height() * frame.samples());
    Seen oldSeen = seen(before.shotBeside(after, pair.ofOld(), frame), progress);
    Seen newSeen = seen(after.shotBeside(before, pair.ofNow(), frame), progress);
    ChangePicture.Drawn drawn = drawn(oldSeen, newSeen, report);
    DisplayLight changes = new DisplayLight(drawn.image(), ImageWriter.Options.ROUNDED);
    Map<String, Object> values = report.values(old, now);
    values.put("summary", report.summary());
    values.put("colors", colors(drawn));
    values.put("warnings", both(oldSeen.warnings(), newSeen.warnings()));
    values.put("notes", both(oldSeen.picture.notes(), newSeen.picture.notes()));
    return new Outcome(
        List.of(png(oldSeen.picture.picture()), png(newSeen.picture.picture()), png(changes)),
        rounding(before, after, report).values(values),
        Optional.of(text(report, values)));
  }

  /** A model with its picture. */
  private record Seen(Shot shot, Studio.Finished picture) {
    List<String> warnings() {
      return shot.file().warnings().stream().map(Problem::toString).toList();
    }
  }

  private Seen seen(Shot shot, CallProgress progress) throws InterruptedException {
    return new Seen(shot, studio.picture(shot, progress));
  }

  private static ChangePicture.Drawn drawn(Seen old, Seen now, ChangeReport report) {
    return ChangePicture.of(
        old.shot.file().parsed(),
        old.picture.picture().image(),
        now.shot.file().parsed(),
        now.picture.picture().image(),
        report.found().changes());
  }

  /** Returns the colors of what is drawn, by its words. */
  private static Map<String, String> colors(ChangePicture.Drawn drawn) {
    Map<String, String> colors = new LinkedHashMap<>();
    drawn.colors().forEach((word, color) -> colors.put(word, ChangePage.css(color)));
    return colors;
  }

  private static List<String> both(List<String> first, List<String> second) {
    return Stream.concat(first.stream(), second.stream()).toList();
  }

  private ModelPair pair(String old, String now, Stage stage) throws ToolException {
    try {
      return ModelPair.<ToolException>read(
          options -> studio.content(old, options), options -> studio.content(now, options), stage);
    } catch (IOException e) {
      throw new ToolException("the models cannot be read: " + e.getMessage(), e);
    }
  }

  private static byte[] png(DisplayLight picture) {
    return ImageFormat.PNG.bytes(picture.image(), picture.options());
  }

  private static Rounding rounding(Staged before, Staged after, ChangeReport report) {
    Bounds3 box = box(before).union(box(after));
    double diagonal = report.found().space().length(box.max().minus(box.min()).length());
    return Rounding.of(Vec3.ZERO, new Vec3(diagonal, 0, 0));
  }

  private static Bounds3 box(Staged model) {
    ModelContents contents = model.first().parsed().model().orElseThrow();
    return new Bounds3(contents.min(), contents.max());
  }

  /** Returns the lines that the command prints, and what the colors mean. */
  private static String text(ChangeReport report, Map<String, Object> values) {
    List<String> lines = new ArrayList<>();
    lines.add(values.get("new") + " against " + values.get("old") + ": " + report.summary());
    List<PartChange> changes = report.found().changes();
    List<String> texts = report.lines();
    for (int i = 0; i < changes.size(); i++) {
      PartChange change = changes.get(i);
      String what = ChangePage.word(change.kind()) + " " + change.name();
      lines.add(texts.get(i).isEmpty() ? what : what + ": " + texts.get(i));
    }
    report.found().notCompared().forEach(what -> lines.add("not compared: " + what));
    ((Map<?, ?>) values.get("colors"))
        .forEach((word, color) -> lines.add("color " + color + ": " + word));
    ((List<?>) values.get("warnings")).forEach(warning -> lines.add("warning: " + warning));
    return String.join("\n", lines);
  }
}
