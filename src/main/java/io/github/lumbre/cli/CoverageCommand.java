package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.FlagConverters.OfShare;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.lab.checks.Coverage;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Mode;
import io.github.lumbre.scene.Setting.Group;
import io.github.lumbre.scene.internal.FrameSize;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code lumbre coverage}: counts how often errors exceed their bounds, for one scene. */
@Command(
    name = "coverage",
    header = "Count how often errors of a scene exceed their noise bounds.",
    description =
        "Render the scene with many seeds, compare each picture with a reference, and print a line"
            + " for each number of samples and each target error. A bound of 95 %% fails for about"
            + " one picture of twenty.",
    sortOptions = false,
    modelTransformer = SettingFlags.Adder.class,
    footer = {
      "",
      "Examples:",
      "  lumbre coverage scenes/cornell-box.json",
      "  lumbre coverage lamp.glb --sky white -s 16,64,256 --target-error 10%%,5%% --seeds 200"
    })
@Exits(
    value = {
      ExitCode.OK, ExitCode.DIFFERENT, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT,
      ExitCode.INTERRUPTED
    },
    different = "more bounds fail: with a confidence of 95 %%, this has a probability below 0.1 %%")
final class CoverageCommand extends Subcommand {
  /** Of a bound that holds, more failures than a cell may have are less probable than this. */
  private static final double CHANCE = .001;

  /** The samples of all references together, as a multiple of the largest number of samples. */
  private static final int REFERENCE_FACTOR = 64;

  @Mixin private final SceneOptions options = new SceneOptions();

  @Option(
      names = {"-s", "--samples"},
      paramLabel = "N",
      split = ",",
      description = "Numbers of samples per pixel, increasing, separated by commas (16,32,64).")
  private List<Integer> samples = List.of(16, 32, 64);

  @Option(
      names = "--target-error",
      paramLabel = "PERCENT",
      split = ",",
      converter = OfShare.class,
      description = "Also render to these errors, separated by commas.")
  private List<Double> targets = List.of();

  @Option(
      names = "--seeds",
      paramLabel = "N",
      description = "Number of pictures in a line (60).")
  private int seeds = 60;

  @Option(
      names = "--reference",
      paramLabel = "N",
      description = "Samples per pixel of the reference (64 times the largest of --samples).")
  private Optional<Integer> reference = Optional.empty();

  @Option(
      names = "--size",
      paramLabel = "WxH|N",
      description = "Size of the frame in pixels (24x24).")
  private FrameSize size = FrameSize.of("24x24");

  @Option(names = "--adaptive", description = "Give noisy pixels more samples.")
  private boolean adaptive;

  @Mixin
  private final SettingFlags settings = new SettingFlags("", Group.TRANSPORT, Group.SAMPLING);

  @Override
  ExitCode run() throws SceneFormatException, TaskException, IOException {
    checkFlags();
    SceneFile file =
        options.load(
            options.parser().inMode(Mode.PATH).overriding(inScene -> changed(inScene)), errors());
    require(
        file.settings().window().pixels() >= 64,
        "--size: expected at least 64 pixels; smaller frames have no bound");
    int most = samples.get(samples.size() - 1);
    int referenceSamples =
        reference.orElse(Math.min(RenderSettings.MAX_SAMPLES / REFERENCE_FACTOR, most))
            * (reference.isPresent() ? 1 : REFERENCE_FACTOR);
    Coverage coverage = new Coverage(file.scene(), file.settings(), seeds, referenceSamples);
    boolean holds = true;
    for (Coverage.Cell cell : coverage.ofSamples(samples)) {
      holds &= isPrintedAndHolds(cell.line(), cell.chance());
    }
    for (double target : targets) {
      Coverage.Cell cell = coverage.ofTarget(target, RenderSettings.MAX_SAMPLES);
      holds &= isPrintedAndHolds(cell.line(), cell.chance());
    }
    return holds ? ExitCode.OK : ExitCode.DIFFERENT;
  }

  private void checkFlags() {
    settings.validate(spec);
    checks().requireSize(size);
    requireIn("--seeds", 2, 100_000, seeds);
    reference.ifPresent(n -> requireIn("--reference", 8, RenderSettings.MAX_SAMPLES, n));
    for (int i = 0; i < samples.size(); i++) {
      int least = i == 0 ? 2 : samples.get(i - 1) + 1;
      requireIn("--samples", least, RenderSettings.MAX_SAMPLES, samples.get(i));
    }
  }

  private RenderSettings changed(RenderSettings inScene) {
    RenderSettings.Builder builder = size.over(inScene).toBuilder().adaptive(adaptive);
    settings.override(builder);
    return builder.build();
  }

  private boolean isPrintedAndHolds(String line, double chance) {
    out().line(line);
    return chance >= CHANCE;
  }
}
