package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.ImportFlag;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PlanReport;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.cli.run.Run;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.geometry.internal.MeshEdges;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.internal.HeapNeed;
import io.github.lumbre.model.internal.ModelAnimation;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.scenefile.internal.SceneContents;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code lumbre check}: reads a scene as a render would, and prints its contents. */
@Command(
    name = "check",
    modelTransformer = SettingFlags.Adder.class,
    header = "Validate a scene and print its contents without rendering it.",
    footer = {"", "Example:", "  lumbre check --strict scene.json"})
@Exits({ExitCode.OK, ExitCode.WARNINGS, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT})
final class CheckCommand extends Subcommand {
  private static final int MOST_NAMES = 20;

  @Mixin private final SceneOptions options = new SceneOptions();

  @Mixin private final ImportFlag imports = new ImportFlag();

  @Option(names = "--json", description = "Print the contents as one line of JSON.")
  private boolean json;

  @Option(
      names = "--plan",
      description = "Also print which rendering steps this scene does not need and skips.")
  private boolean plan;

  @Override
  ExitCode run() throws Exception {
    Messages out = out();
    Messages errors = errors();
    imports.validate();
    options.importBy(imports);
    options.announce(errors);
    if (!json) {
      SceneFile file = options.load(parser(), errors);
      describe(file, out);
      if (plan) {
        new PlanReport(file).print(out);
      }
      return ExitCode.OK;
    }
    JsonSummary report = new JsonSummary("check", options.scene());
    return new Run(Interruption.none(), Optional.of(out), Optional.empty())
        .of(report, () -> describe(options.load(parser(), errors), report));
  }

  /** Returns a parser for the settings with which {@code render} writes its default picture. */
  private SceneParser parser() throws TaskException {
    SceneParser parser = options.parser().searchedLater();
    return options.isModel()
        ? parser.overriding(s -> s.toBuilder().samples(Denoising.MODEL_SAMPLES).build())
        : parser;
  }

  private static ExitCode describe(SceneFile file, JsonSummary report) {
    report.putScene(file);
    ParsedScene parsed = file.parsed();
    report.putContents(parsed.contents());
    if (parsed.model().isPresent()) {
      ModelContents model = parsed.model().get();
      report.put("heap_bytes", need(parsed).bytes());
      report.putModel(model, model.parts(parsed.scene()));
    }
    return ExitCode.OK;
  }

  private void describe(SceneFile file, Messages out) throws TaskException {
    RenderSettings settings = file.settings();
    ParsedScene parsed = file.parsed();
    SceneContents contents = parsed.contents();
    out.line("scene      " + options.scene() + " is valid");
    out.line("camera     " + contents.camera());
    out.line("size       " + settings.width() + "x" + settings.height() + " pixels");
    out.line("mode       " + settings.mode().name().toLowerCase(Locale.ROOT) + depths(settings));
    out.line(
        "samples    %s per pixel%s"
            .formatted(settings.samples(), options.isModel() ? ", denoised" : ""));
    out.line("shapes     " + contents.shapes());
    out.line("meshes     " + contents.meshes());
    out.line("triangles  " + contents.triangles());
    if (contents.points() > 0) {
      out.line("points     " + contents.points());
    }
    out.line("lights     " + contents.lights());
    Optional<ModelContents> model = parsed.model();
    List<String> names = model.map(ModelContents::materials).orElse(List.of());
    String materials = listed(names.stream().map(CheckCommand::quoted));
    out.line("materials  " + contents.materials() + (materials.isEmpty() ? "" : ": " + materials));
    out.line("textures   " + contents.textures());
    if (model.isPresent()) {
      out.line("memory     " + need(parsed).text() + " of heap");
      describe(model.get(), model.get().parts(parsed.scene()), out);
    }
    out.line("warnings   " + file.warnings().size());
  }

  /** Returns the triangles of all meshes of a model, each counted once, and its points. */
  private static HeapNeed need(ParsedScene model) {
    long triangles =
        model.scene().primitives().stream()
            .flatMap(primitive -> MeshEdges.meshOf(primitive.shape()).stream())
            .distinct()
            .mapToLong(TriangleMesh::triangleCount)
            .sum();
    return new HeapNeed(triangles, model.contents().points());
  }

  /** Prints the names that flags take, and the bounds of a model. */
  private static void describe(ModelContents model, PartTable parts, Messages out) {
    line("cameras   ", listed(model.cameras().stream().map(CheckCommand::quoted)), out);
    line("animations", listed(model.animations().stream().map(CheckCommand::shown)), out);
    line("variants  ", listed(model.variants().stream().map(CheckCommand::quoted)), out);
    Stream<String> names = parts.parts().stream().map(part -> quoted(part.name()));
    out.line("parts      " + parts.parts().size() + ": " + listed(names));
    Vec3 size = model.max().minus(model.min());
    out.line(
        "bounds     %s to %s, size %s x %s x %s"
            .formatted(
                shown(model.min()),
                shown(model.max()),
                shown(size.x()),
                shown(size.y()),
                shown(size.z())));
  }

  private static void line(String title, String names, Messages out) {
    if (!names.isEmpty()) {
      out.line(title + " " + names);
    }
  }

  private static String listed(Stream<String> items) {
    List<String> all = items.toList();
    int more = Math.max(0, all.size() - MOST_NAMES);
    return all.stream().limit(MOST_NAMES).collect(Collectors.joining(", "))
        + (more == 0 ? "" : " and " + more + " more");
  }

  private static String shown(ModelAnimation animation) {
    return quoted(animation.name())
        + (animation.seconds().isPresent()
            ? " (" + shown(animation.seconds().getAsDouble()) + " s)"
            : "");
  }

  private static String quoted(String name) {
    return '"' + name + '"';
  }

  private static String shown(Vec3 v) {
    return "(" + shown(v.x()) + ", " + shown(v.y()) + ", " + shown(v.z()) + ")";
  }

  private static String shown(double value) {
    return new BigDecimal(value).round(new MathContext(4)).stripTrailingZeros().toPlainString();
  }

  private static String depths(RenderSettings settings) {
    return switch (settings.mode()) {
      case PATH -> ", depth " + settings.maxTraceDepth();
      case RAY ->
          ", reflection depth %s, refraction depth %s"
              .formatted(settings.reflectionTraceDepth(), settings.refractionTraceDepth());
    };
  }
}
