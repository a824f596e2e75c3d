package io.github.lumbre.cli;

import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code lumbre gallery}: renders a folder of scenes into a folder of pictures. */
@Command(
    name = "gallery",
    header = "Render all scenes of a folder to pictures, and write a page about them.",
    description =
        "Each picture gets as many samples as fit into the given time, whatever its scene asks for:"
            + " a multiple of 16, at least 64.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    usageHelpWidth = 100,
    sortOptions = false,
    footer = {
      "",
      "Examples:",
      "  lumbre gallery",
      "  lumbre gallery --seconds 20 --out pictures cornell-box camera-fisheye"
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "2:The command line is wrong: also a scene that does not exist",
      "3, 4, 5:A scene is invalid, a mesh or picture of it is, or something is too large",
      "6:A picture or the page cannot be written",
      "7:A fault of the program",
      "129, 130, 143:Stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM; pictures that are complete stay"
    })
final class GalleryCommand implements Callable<Integer> {
  @Parameters(
      paramLabel = "NAME",
      arity = "0..*",
      description = "Scenes, without folder and ending. Default: all.")
  private List<String> names = List.of();

  @Option(
      names = "--scenes",
      paramLabel = "DIR",
      description = "The folder of the scenes. Default: scenes, beside the launcher.")
  private Optional<Path> scenes;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "The folder of the pictures. Default: renders, beside the launcher.")
  private Optional<Path> out;

  @Option(
      names = "--seconds",
      paramLabel = "N",
      defaultValue = "180",
      description =
          "About how long each picture may take (${DEFAULT-VALUE}). 64 samples per pixel are"
              + " rendered in any case; a warning names the scenes for which they take longer.")
  private int seconds;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 means one per processor (${DEFAULT-VALUE}).")
  private int threads;

  @Option(names = "--debug", description = "Show the stack trace of an error.")
  private boolean debug;

  @Mixin private OverwriteFlag overwrite;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, CommandException {
    require(seconds >= 1, "--seconds: expected at least 1, found " + seconds);
    new FlagChecks(spec).requireIn("--threads", 0, RenderSettings.MAX_THREADS, threads);
    SceneFolder folder = new SceneFolder(scenes.orElseGet(() -> Home.resolve("scenes")));
    List<String> selected = selected(folder.names());
    Path directory = out.orElseGet(() -> Home.resolve("renders"));
    checkOutputs(folder, selected, directory);
    makeDirectory(directory);
    GalleryPage page = GalleryPage.load(directory);
    boolean hasDisplay = Boolean.getBoolean("lumbre.tty");
    try (Interruption interruption = Interruption.listen()) {
      GalleryRenderer renderer =
          new GalleryRenderer(
              folder,
              directory,
              seconds,
              threads,
              () -> new RenderMonitor(interruption, hasDisplay));
      boolean complete = interruption.beginRender() && render(selected, renderer, page);
      return complete ? ExitCodes.OK : ExitCodes.INTERRUPTED;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCodes.INTERRUPTED;
    }
  }

  /** Renders the scenes, and brings the page up to date after each; returns false if stopped. */
  private boolean render(List<String> selected, GalleryRenderer renderer, GalleryPage page)
      throws SceneFormatException, CommandException, InterruptedException {
    Messages messages = new Messages(spec.commandLine().getErr());
    for (String scene : selected) {
      Optional<GalleryPage.Entry> entry = renderer.render(scene, messages);
      if (entry.isEmpty()) {
        return false;
      }
      page.put(entry.get());
      page.save();
    }
    return true;
  }

  /** Pictures must not replace files of the selected scenes, nor of the others in the folder. */
  private void checkOutputs(SceneFolder folder, List<String> selected, Path directory)
      throws CommandException {
    OutputGuard guard = overwrite.guard();
    for (String scene : folder.names()) {
      guard.readsScene(folder.file(scene));
    }
    for (String scene : selected) {
      guard.writes("--out", GalleryPage.picture(directory, scene), OutputContent.PICTURE);
    }
    guard.writes("--out", directory.resolve(GalleryPage.FILE), OutputContent.GALLERY_PAGE).check();
  }

  private List<String> selected(List<String> known) {
    for (String name : names) {
      require(
          known.contains(name), "expected some of " + String.join(", ", known) + ", found " + name);
    }
    return names.isEmpty() ? known : names;
  }

  private void require(boolean condition, String message) {
    if (!condition) {
      throw new ParameterException(spec.commandLine(), message);
    }
  }

  private static void makeDirectory(Path directory) throws CommandException {
    try {
      Files.createDirectories(directory);
    } catch (IOException e) {
      throw new CommandException(
          ExitCodes.OUTPUT, directory + ": expected a folder, or a place for one", e);
    }
  }
}
