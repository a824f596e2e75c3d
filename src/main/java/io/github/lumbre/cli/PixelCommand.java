package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.option.KernelFlag;
import io.github.lumbre.cli.option.RenderFlags;
import io.github.lumbre.cli.option.SceneOptions;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.PixelJson;
import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.cli.output.PixelReport;
import io.github.lumbre.render.PixelReplay;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import java.io.IOException;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre pixel}: repeats the samples of one pixel and prints how they arise. */
@Command(
    name = "pixel",
    header = "Repeat the samples of one pixel and explain its value.",
    description =
        "Print the objects in the pixel, and its mean, variance and brightest samples; with"
            + " --sample, the path of that sample, vertex by vertex. With the same scene, seed,"
            + " size, mode and depth, the samples are bit-identical to the samples of the render.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {
      "",
      "Examples:",
      "  lumbre pixel scene.json 120,80",
      "  lumbre pixel scene.json 120,80 --sample 17",
      "  lumbre pixel scene.json 120,80 --sample 17 --seed 5 --json"
    })
@Exits({
  ExitCode.OK, ExitCode.WARNINGS, ExitCode.SCENE, ExitCode.ASSET, ExitCode.LIMIT, ExitCode.REJECTED
})
final class PixelCommand extends Subcommand {
  /** The number of brightest samples that are printed. */
  private static final int SHOWN = 8;

  @Mixin private final SceneOptions options = new SceneOptions();

  @Parameters(
      index = "1",
      paramLabel = "x,y",
      description = "Pixel of the full frame; 0,0 is the top left.")
  private PixelPlace pixel;

  @Option(
      names = "--sample",
      paramLabel = "N",
      description = "Print the path of sample N; the first sample is 0.")
  private Optional<Integer> sample;

  @Mixin private final RenderFlags flags = new RenderFlags();

  @Mixin private final KernelFlag kernel = new KernelFlag();

  @Option(names = "--json", description = "Print the result as JSON, with all digits.")
  private boolean json;

  @Override
  ExitCode run() throws SceneFormatException, TaskException, IOException {
    flags.validate();
    kernel.validate();
    sample.ifPresent(n -> requireIn("--sample", 0, RenderSettings.MAX_SAMPLES - 1, n));
    SceneParser parser = kernel.over(flags.over(options.parser()));
    SceneFile file = options.load(parser, errors());
    RenderSettings settings = file.settings();
    requireIn("x", 0, settings.width() - 1, pixel.x());
    requireIn("y", 0, settings.height() - 1, pixel.y());
    PixelReplay replay = new PixelReplay(file.scene(), settings);
    PixelReport report = new PixelReport(file, pixel);
    Messages out = out();
    boolean rejected;
    if (sample.isPresent()) {
      PixelReplay.Sample one = replay.sample(pixel.x(), pixel.y(), sample.get());
      rejected = one.rejected();
      print(json ? PixelJson.text(report, one) : report.text(one), out);
    } else {
      PixelReplay.Pixel all = replay.pixel(pixel.x(), pixel.y(), SHOWN);
      rejected = all.rejected() > 0;
      print(json ? PixelJson.text(report, all) : report.text(all), out);
    }
    return rejected && options.isStrict() ? ExitCode.INTERNAL : ExitCode.OK;
  }

  private static void print(String text, Messages out) {
    text.lines().forEach(out::line);
  }
}
