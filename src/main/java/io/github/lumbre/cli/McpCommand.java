package io.github.lumbre.cli;

import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.cli.mcp.Mcp;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code lumbre mcp}: renders models for other programs, such as agents that make them. */
@Command(
    name = "mcp",
    header = "Render models for other programs, by the Model Context Protocol.",
    description =
        "Read messages of the Model Context Protocol from standard input and answer them on"
            + " standard output, so that programs, such as language models that make parts, can see"
            + " their models. A client starts the command; docs/mcp.md has its configuration.",
    footer = {"", "Example:", "  lumbre mcp --root parts"})
@Exits({ExitCode.OK, ExitCode.ABSENT, ExitCode.INTERRUPTED})
final class McpCommand extends Subcommand {
  @Option(
      names = "--root",
      paramLabel = "DIR",
      description = "Folder from which models may be read; repeatable (none).")
  private List<Path> roots = List.of();

  @Override
  ExitCode run() throws TaskException {
    for (Path root : roots) {
      require(Files.isDirectory(root), "--root: expected a folder, found none at " + root);
    }
    try {
      Mcp.serve(
          roots, new FileInputStream(FileDescriptor.in), new FileOutputStream(FileDescriptor.out));
      return ExitCode.OK;
    } catch (IOException e) {
      throw ExitCode.USAGE.failure("standard input: " + FileFailure.reason(e), e);
    }
  }
}
