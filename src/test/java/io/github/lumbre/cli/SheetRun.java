package io.github.lumbre.cli;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.cli.mcp.Mcp;
import io.github.lumbre.cli.mcp.McpClient;
import io.github.lumbre.cli.option.ModelFlags;
import io.github.lumbre.cli.option.SettingFlags;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.thumbnail.Thumbnails;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/**
 * Runs commands of {@link SheetOfHashesTest} in a folder. They are those of the command line, where
 * T stands for the folder, and these:
 *
 * <ul>
 *   <li>{@code call TOOL ARGUMENTS} calls a tool of the server;
 *   <li>{@code message METHOD} sends the server another message;
 *   <li>{@code thumbnail MODEL png|jpeg FLAGS} renders a thumbnail on a stage.
 * </ul>
 *
 * Mutable: it keeps what was printed, and a client of the server that the first call starts.
 */
final class SheetRun implements AutoCloseable {
  private static final Limits LIMITS = Limits.UPLOADS.withTime(Duration.ofMinutes(2));
  private static final int SIDE = 24;

  private final Path folder;
  private final StringBuilder exit = new StringBuilder();
  private final StringBuilder out = new StringBuilder();
  private final StringBuilder err = new StringBuilder();

  private Optional<McpClient> client = Optional.empty();

  private SheetRun(Path folder) {
    this.folder = folder;
  }

  /** Flags of a stage, without a command. */
  @Command(modelTransformer = SettingFlags.Adder.class)
  static final class Staged {
    @Mixin private ModelFlags model;
  }

  /** Writes the models into an empty folder, in which commands can be run once. */
  static SheetRun in(Path folder) throws IOException {
    SheetModels.write(folder);
    return new SheetRun(folder);
  }

  /**
   * Runs commands that are separated by {@code &&}, also after one that fails.
   *
   * @return what they printed, their exit codes and the files that they wrote, by name, without
   *     what differs between runs
   */
  Map<String, byte[]> outputs(String commands) throws Exception {
    Map<String, byte[]> before = files();
    for (String command : commands.split(" && ")) {
      run(command);
    }
    SteadyBytes steady = new SteadyBytes(folder);
    Map<String, byte[]> outputs = new LinkedHashMap<>();
    printed()
        .forEach(
            (name, text) -> outputs.put(name, steady.text(text).getBytes(StandardCharsets.UTF_8)));
    files()
        .forEach(
            (name, bytes) -> {
              if (!Arrays.equals(bytes, before.get(name))) {
                outputs.put(name, steady.file(name, bytes));
              }
            });
    return outputs;
  }

  /** Returns the exit codes and the printed texts that are not empty. */
  private Map<String, String> printed() {
    Map<String, String> printed = new LinkedHashMap<>();
    printed.put("exit", exit.toString());
    printed.put("out", out.toString());
    printed.put("err", err.toString());
    printed.values().removeIf(String::isEmpty);
    return printed;
  }

  private Map<String, byte[]> files() throws IOException {
    Map<String, byte[]> files = new TreeMap<>();
    for (Path file : Folders.below(folder, "")) {
      String name = folder.relativize(file).toString().replace('\\', '/');
      files.put(name, Files.readAllBytes(file));
    }
    return files;
  }

  private void run(String command) throws Exception {
    String[] words = command.split(" ");
    switch (words[0]) {
      case "call" ->
          answer(McpClient.line(1, words[1], words.length > 2 ? command.split(" ", 3)[2] : ""));
      case "message" -> answer(message(words[1]));
      case "thumbnail" -> thumbnail(words);
      default -> {
        Outcome outcome = Outcome.in(folder, command);
        exit.append(exit.isEmpty() ? "" : " ").append(outcome.exitCode());
        out.append(outcome.out());
        err.append(outcome.err());
      }
    }
  }

  private static String message(String method) {
    String meta = McpClient.META.substring(0, McpClient.META.length() - 1);
    return ("{'jsonrpc':'2.0','id':1,'method':'" + method + "','params':{" + meta + "}}\n")
        .replace('\'', '"');
  }

  private void answer(String message) throws IOException, InterruptedException {
    if (client.isEmpty()) {
      client = Optional.of(new McpClient((in, to) -> Mcp.serve(List.of(folder), in, to)));
    }
    client.get().send(message);
    out.append(client.get().next()).append('\n');
  }

  private void thumbnail(String[] words) throws Exception {
    String[] flags = Outcome.words(folder, String.join(" ", words));
    Staged staged = new Staged();
    new CommandLine(staged).parseArgs(Arrays.copyOfRange(flags, 3, flags.length));
    Stage stage = staged.model.stage();
    byte[] model = Files.readAllBytes(folder.resolve(words[1]));
    try (Thumbnails thumbnails = new Thumbnails(stage, LIMITS)) {
      byte[] picture =
          words[2].equals("png")
              ? thumbnails.png(words[1], model, SIDE)
              : thumbnails.jpeg(words[1], model, SIDE);
      Files.write(folder.resolve("thumbnail." + words[2]), picture);
    } catch (SceneFormatException e) {
      err.append(e.kind()).append(": ").append(e.getMessage()).append('\n');
    }
  }

  /** Ends the server. */
  @Override
  public void close() throws IOException {
    if (client.isPresent()) {
      client.get().close();
    }
  }
}
