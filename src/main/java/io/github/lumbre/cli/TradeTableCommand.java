package io.github.lumbre.cli;

import com.google.gson.Gson;
import com.google.gson.JsonParseException;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.TextOutput;
import io.github.lumbre.file.FileFailure;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.trade.SceneTables;
import io.github.lumbre.lab.trade.SceneTrade;
import io.github.lumbre.lab.trade.TradeFile;
import io.github.lumbre.lab.trade.TradeTables;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code lumbre trade table}: tabulates the studies of several scenes. */
@Command(
    name = "table",
    header = "Tabulate the studies of several scenes side by side.",
    description =
        "Write tables in Markdown, and two charts with the same name and -noise.svg and"
            + " -depth.svg.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    sortOptions = false,
    footer = {"", "Example:", "  lumbre trade table a-trade.json b-trade.json -o trade.md"},
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "2:The command line is invalid, or a study does not exist or is invalid",
      "6:The tables cannot be written",
      "7:Internal error"
    })
final class TradeTableCommand implements Callable<Integer> {
  @Parameters(
      arity = "1..*",
      paramLabel = "STUDY.json",
      description = "JSON files from 'lumbre trade', in the order of the tables.")
  List<Path> studies = new ArrayList<>();

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUT.md",
      required = true,
      description = "Markdown file to write.")
  Path output;

  @Option(names = "--debug", description = "Print the stack trace of an error.")
  boolean debug;

  @Mixin OverwriteFlag overwrite;

  @Spec CommandSpec spec;

  @Override
  public Integer call() throws TaskException {
    OutputGuard guard = overwrite.guard();
    studies.forEach(study -> guard.reads(study, "a study"));
    guard
        .writes("-o", output, OutputContent.TRADE_TABLES)
        .writes("-o", beside("-noise.svg"), OutputContent.TRADE_CHART)
        .writes("-o", beside("-depth.svg"), OutputContent.TRADE_CHART)
        .check();
    List<SceneTrade> scenes = new ArrayList<>();
    for (Path study : studies) {
      scenes.add(read(study));
    }
    SceneTables tables = new SceneTables(scenes);
    try (TextOutput markdown = TextOutput.reserve(Optional.of(output));
        TextOutput noise = TextOutput.reserve(Optional.of(beside("-noise.svg")));
        TextOutput depth = TextOutput.reserve(Optional.of(beside("-depth.svg")))) {
      markdown.write(tables.markdown(CommandText.of(spec)));
      noise.write(tables.noiseChart());
      depth.write(tables.depthChart());
    }
    new Messages(spec.commandLine().getOut()).line(output.toString());
    return ExitCodes.OK;
  }

  private Path beside(String ending) {
    return Path.of(output.toString().replaceAll("\\.md$", "") + ending);
  }

  private static SceneTrade read(Path study) throws TaskException {
    try {
      TradeFile file = new Gson().fromJson(Files.readString(study), TradeFile.class);
      if (file == null || !TradeTables.FORMAT.equals(file.format)) {
        throw new TaskException(
            Kind.USAGE,
            study
                + ": expected a JSON file from 'lumbre trade' in the format "
                + TradeTables.FORMAT);
      }
      return file.trade();
    } catch (IOException e) {
      throw new TaskException(Kind.USAGE, study + ": cannot be read: " + FileFailure.reason(e), e);
    } catch (JsonParseException e) {
      throw new TaskException(Kind.USAGE, study + ": expected a JSON file from 'lumbre trade'", e);
    }
  }
}
