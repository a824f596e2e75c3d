package io.github.lumbre.cli;

import io.github.lumbre.cli.option.FlagChecks;
import io.github.lumbre.cli.option.Home;
import io.github.lumbre.cli.option.OverwriteFlag;
import io.github.lumbre.cli.option.Version;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.output.OutputContent;
import io.github.lumbre.cli.output.OutputGuard;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.cli.output.PictureOutput;
import io.github.lumbre.cli.output.Summary;
import io.github.lumbre.cli.run.CommandLineHost;
import io.github.lumbre.cli.run.Denoising;
import io.github.lumbre.cli.run.Interruption;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import io.github.lumbre.lab.gallery.GalleryPage;
import io.github.lumbre.lab.gallery.GalleryRenderer;
import io.github.lumbre.lab.gallery.GalleryRenderer.Rendered;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
    header = "Render all scenes of a folder and write a page of the pictures.",
    description =
        "Give each picture as many samples per pixel as fit into --seconds: a multiple of 16, at"
            + " least 64. This overrides the scene's samples.",
    mixinStandardHelpOptions = true,
    versionProvider = Version.class,
    sortOptions = false,
    footer = {
      "",
      "Examples:",
      "  lumbre gallery",
      "  lumbre gallery --seconds 20 --denoise --out pictures cornell-box camera-fisheye"
    },
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:Done",
      "2:The command line is invalid, or a scene does not exist",
      "3, 4, 5:A scene is invalid, an asset cannot be decoded, or a limit is exceeded",
      "6:A picture or the page cannot be written",
      "7:Internal error",
      "129, 130, 143:Stopped by SIGHUP, SIGINT (Ctrl-C), SIGTERM; complete pictures are kept"
    })
final class GalleryCommand implements Callable<Integer> {
  private static final int BITS = 8;

  @Parameters(
      paramLabel = "NAME",
      arity = "0..*",
      description = "Scene names without folder and extension (all).")
  List<String> names = List.of();

  @Option(
      names = "--scenes",
      paramLabel = "DIR",
      description = "Folder of the scenes (scenes, beside the launcher).")
  Optional<Path> scenes;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Folder of the pictures (renders, beside the launcher).")
  Optional<Path> out;

  @Option(
      names = "--seconds",
      paramLabel = "SECONDS",
      defaultValue = "180",
      description =
          "Approximate time per picture in seconds (${DEFAULT-VALUE}). A warning names scenes whose"
              + " first 64 samples per pixel take longer.")
  int seconds;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Number of threads; 0: one per processor (${DEFAULT-VALUE}).")
  int threads;

  @Option(
      names = "--denoise",
      description =
          "Denoise the pictures with the built-in denoiser. The page states the noise before.")
  boolean denoise;

  @Option(names = "--debug", description = "Print the stack trace of an error.")
  boolean debug;

  @Mixin OverwriteFlag overwrite;

  @Spec CommandSpec spec;

  @Override
  public Integer call() throws SceneFormatException, TaskException {
    require(seconds >= 1, "--seconds: expected at least 1, found " + seconds);
    new FlagChecks(spec).requireIn("--threads", 0, RenderSettings.MAX_THREADS, threads);
    SceneFolder folder = new SceneFolder(scenes.orElseGet(() -> Home.resolve("scenes")));
    List<String> selected = selected(folder.names());
    Path directory = out.orElseGet(() -> Home.resolve("renders"));
    checkOutputs(folder, selected, directory);
    makeDirectory(directory);
    GalleryPage page = GalleryPage.load(directory);
    boolean hasDisplay = Boolean.getBoolean("lumbre.tty");
    Messages messages = new Messages(spec.commandLine().getErr());
    try (Interruption interruption = Interruption.listen()) {
      GalleryRenderer renderer =
          new GalleryRenderer(
              folder,
              seconds,
              threads,
              denoise,
              new CommandLineHost(interruption, hasDisplay, messages));
      boolean complete =
          interruption.beginRender() && render(folder, selected, renderer, page, messages);
      return complete ? ExitCodes.OK : ExitCodes.INTERRUPTED;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCodes.INTERRUPTED;
    }
  }

  /** Renders the scenes and updates the page after each. Returns false if stopped. */
  private static boolean render(
      SceneFolder folder,
      List<String> selected,
      GalleryRenderer renderer,
      GalleryPage page,
      Messages messages)
      throws SceneFormatException, TaskException, InterruptedException {
    for (String scene : selected) {
      try (PictureOutput output = PictureOutput.reserve(page.picture(scene))) {
        Optional<Rendered> rendered = renderer.render(scene);
        if (rendered.isEmpty()) {
          return false;
        }
        write(folder.file(scene), rendered.get(), output, messages);
        page.put(GalleryPage.Entry.of(scene, rendered.get()));
        page.save();
      }
    }
    return true;
  }

  private static void write(Path scene, Rendered rendered, PictureOutput output, Messages messages)
      throws TaskException {
    RenderSettings settings = rendered.settings();
    Map<String, String> metadata =
        new LinkedHashMap<>(
            PictureMetadata.of(scene, rendered.file(), settings, rendered.seconds()));
    rendered.denoised().map(Denoising::metadata).ifPresent(metadata::putAll);
    output.write(
        rendered.picture(),
        new ImageWriter.Options(settings.exposure(), settings.toneCurve(), BITS, metadata));
    Summary summary = new Summary(settings, rendered.result(), rendered.seconds());
    summary.printRejected(scene, messages);
    summary.print(output.target(), messages);
  }

  /** Checks that no picture replaces a file of any scene in the folder. */
  private void checkOutputs(SceneFolder folder, List<String> selected, Path directory)
      throws TaskException {
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

  private static void makeDirectory(Path directory) throws TaskException {
    try {
      Files.createDirectories(directory);
    } catch (IOException e) {
      throw new TaskException(
          Kind.OUTPUT, directory + ": cannot be created; expected a writable folder", e);
    }
  }
}
