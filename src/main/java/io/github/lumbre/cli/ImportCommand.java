package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.TextFile;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.internal.ModelFormat;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre import}: writes the scene that a model file gets when rendered by itself. */
@Command(
    name = "import",
    modelTransformer = SettingFlags.Adder.class,
    header = "Write a scene file for a model, to edit.",
    description =
        "The scene is the one that 'lumbre render MODEL' renders with the same flags. It names the"
            + " model file and does not copy it.",
    footer = {"", "Example:", "  lumbre import helmet.glb --view iso -o helmet.json"})
@Exits({ExitCode.OK, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.OUTPUT})
final class ImportCommand extends Subcommand {
  @Parameters(paramLabel = "MODEL", description = "Model: " + ModelFormat.TITLES + ".")
  private Path model;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "SCENE",
      description =
          "Scene file to write, in the folder of the model and the sky's picture or above it (the"
              + " model's name with .json, beside the model).")
  private Optional<Path> output;

  @Mixin
  private final ModelFlags flags =
      new ModelFlags()
          .without("a scene file holds no labels", Stage.LABEL)
          .without("a scene file does not hold which lines are hidden", Stage.HIDDEN)
          .without(
              "a scene may use only files in its own folder or below", ModelOption.ASSETS);

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run() throws SceneFormatException, TaskException, IOException {
    require(ModelReader.isModel(model), model + ": expected a model file: " + Models.NAMES);
    Path target = output.orElseGet(this::beside);
    require(
        !ModelReader.isModelName(target.toString()),
        "--output: expected a name that ends in .json, found " + target);
    Stage stage = flags.stage();
    Path folder = target.toAbsolutePath().normalize().getParent();
    for (Path used : stage.files(model)) {
      require(
          used.startsWith(folder),
          "--output: expected a scene file in a folder that contains "
              + used
              + ", found "
              + target
              + "; a scene may use only files in its own folder or below");
    }
    OutputGuard guard =
        overwrite.guard().reads(model, "the model").writes("-o", target, OutputContent.SCENE);
    guard.check();
    SceneFile scene = StagedModel.readIn(folder, model, stage).scene();
    guard.checkAssets(model, scene.assetPaths(target));
    String text = scene.text().orElseThrow().pretty() + "\n";
    requireUnedited(target, text);
    TextFile.write(target, text);
    return ExitCode.OK;
  }

  /** Refuses to replace a scene with other content, which somebody may have edited. */
  private void requireUnedited(Path target, String text) throws TaskException, IOException {
    if (overwrite.isGiven() || !Files.exists(target) || Files.size(target) == 0) {
      return;
    }
    if (!Arrays.equals(Files.readAllBytes(target), text.getBytes(StandardCharsets.UTF_8))) {
      throw ExitCode.OUTPUT.failure(
          target + ": is a different scene, which may be edited; --overwrite replaces it");
    }
  }

  private Path beside() {
    String name = model.getFileName().toString();
    return model.resolveSibling(name.substring(0, name.lastIndexOf('.')) + ".json");
  }
}
