package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.cli.option.DevelopFlags;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.run.FilmInput;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code lumbre develop}: makes a picture from a checkpoint file, without rendering. */
@Command(
    name = "develop",
    header = "Make a picture from a checkpoint file, without rendering.",
    modelTransformer = SettingFlags.Adder.class,
    abbreviateSynopsis = true,
    footer = {"", "Example:", "  lumbre develop night.film -o night.png --exposure 1.5"})
@Exits({ExitCode.OK, ExitCode.FILM, ExitCode.LIMIT, ExitCode.OUTPUT})
final class DevelopCommand extends Subcommand {
  @Parameters(
      paramLabel = "FILM",
      description = "Checkpoint file from 'lumbre render --checkpoint'.")
  private Path film;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT",
      required = true,
      description =
          "Picture to write: PNG or JPEG for the screen, OpenEXR or PFM for linear light, by its"
              + " ending.")
  private Path output;

  @Mixin private final DevelopFlags flags = new DevelopFlags();

  @Mixin private final OverwriteFlag overwrite = new OverwriteFlag();

  @Override
  ExitCode run() throws Exception {
    flags.validate();
    checks().requirePicture(output);
    overwrite.guard().readsFilm(film).writes("-o", output, OutputContent.PICTURE).check();
    Messages messages = errors();
    flags.develop(film, () -> FilmInput.read(film, messages), output);
    return ExitCode.OK;
  }
}
