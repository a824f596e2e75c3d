package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.cli.run.CleanPicture;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.Models;
import io.github.lumbre.model.difference.ModelDifference;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ModelContents;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Reads and renders the models of calls, and keeps the last ones. Thread-safe. */
final class Studio {
  /** The models that are kept take at most one part in so many of the heap. */
  private static final int KEPT_PART = 4;

  private final Roots roots;
  private final Limits limits;
  private final ModelCache<Staged> kept =
      new ModelCache<>(Runtime.getRuntime().maxMemory() / KEPT_PART);
  private volatile Optional<Last> last = Optional.empty();

  Studio(Roots roots, Limits limits) {
    this.roots = roots;
    this.limits = limits;
  }

  /**
   * The size of a picture.
   *
   * @param width in pixels
   * @param height in pixels
   * @param samples per pixel
   */
  record Frame(int width, int height, int samples) {}

  /**
   * A finished picture.
   *
   * @param notes about labels that have no room
   */
  record Finished(DisplayLight picture, List<String> notes) {
    Finished {
      notes = List.copyOf(notes);
    }
  }

  /** What a picture is made of. */
  private record PictureKey(List<Object> identity, RenderSettings settings) {}

  /** The last picture: a caller may ask about its pixels. */
  private record Last(PictureKey key, Finished finished) {}

  /** Builds the scene of a camera. */
  private interface Sight {
    SceneFile seen() throws SceneFormatException;
  }

  /** What scenes are made of. */
  private record Key(Path file, String hash, Stage stage) {}

  /** A model on its stage, which is read once for all pictures of it. Thread-safe. */
  static final class Staged {
    private final Path file;
    private final StagedModel views;
    private final SeenFiles others;
    private Optional<PartTable> parts = Optional.empty();

    private Staged(Path file, StagedModel views, SeenFiles others) {
      this.file = file;
      this.views = views;
      this.others = others;
    }

    Path file() {
      return file;
    }

    /** Returns the parts of the model. */
    synchronized PartTable parts() {
      if (parts.isEmpty()) {
        ParsedScene scene = first().parsed();
        parts = Optional.of(scene.model().orElseThrow().parts(scene.scene()));
      }
      return parts.get();
    }

    /** Returns a summary of a tool's result: the model, and what a picture of it lacks. */
    JsonSummary summary(String tool) {
      JsonSummary summary = new JsonSummary(tool, "model", file);
      summary.put("warnings", first().warnings().stream().map(Problem::toString).toList());
      return summary;
    }

    /** Returns the scene of the view with which it was read. */
    SceneFile first() {
      return views.scene();
    }

    /** Returns how lengths of results are rounded. */
    Rounding rounding() {
      ModelContents model = first().parsed().model().orElseThrow();
      return Rounding.of(model.min(), model.max());
    }

    /** Returns what the camera of a stage sees, in a frame. */
    Shot shot(Stage stage, String title, Frame frame) throws ToolException {
      return new Shot(
          file, title, seenOn(stage, frame), parts(), List.of(), List.of(this, stage));
    }

    /** Returns what the camera of a stage sees, which frames this model and another one. */
    Shot shotBeside(Staged other, Stage stage, Frame frame) throws ToolException {
      String title = file.getFileName().toString();
      SceneFile seen =
          seen(frame, () -> views.seenBeside(other.views, stage, frame.width, frame.height));
      return new Shot(file, title, seen, parts(), List.of(), List.of(this, other, stage));
    }

    private SceneFile seenOn(Stage stage, Frame frame) throws ToolException {
      return seen(frame, () -> views.seenOn(stage, frame.width, frame.height));
    }

    private synchronized SceneFile seen(Frame frame, Sight sight) throws ToolException {
      try {
        SceneFile seen = sight.seen();
        return seen.with(seen.settings().toBuilder().samples(frame.samples).build());
      } catch (SceneFormatException e) {
        throw failure(e);
      }
    }
  }

  /**
   * Returns a model.
   *
   * @param name path of its file, as the client gives it
   * @param stage its camera and view do not count
   * @throws java.util.concurrent.CancellationException if the call is cancelled
   */
  Staged model(String name, Stage stage) throws ToolException {
    Path file = modelFile(name);
    try {
      byte[] content = Roots.content(file, limits);
      Stage seen = stage.seenFrom(View.DEFAULT);
      Key key = new Key(file, Sha256.of(content), seen);
      ModelFolder folder = Roots.folderOf(file, limits.bytes());
      Optional<Staged> known = kept.get(key);
      if (known.isPresent() && known.get().others.areSame(folder)) {
        return known.get();
      }
      Staged staged = read(file, content, new SeenFiles(folder), seen);
      kept.put(key, staged, staged.views.memory());
      return staged;
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private Staged read(Path file, byte[] content, SeenFiles others, Stage stage)
      throws ToolException, IOException {
    SceneParser parser = new SceneParser().limitedTo(limits);
    try {
      String name = file.getFileName().toString();
      StagedModel views = StagedModel.read(name, content, others, stage, parser);
      return new Staged(file, views, others);
    } catch (SceneFormatException e) {
      throw failure(e);
    }
  }

  /**
   * Reads the content of a model, without the scene around it.
   *
   * @param name path of its file, as the client gives it
   */
  ModelDifference.Side content(String name, ModelOptions options) throws ToolException {
    Path file = modelFile(name);
    String shown = file.getFileName().toString();
    ModelOptions limited = options.limitedTo(limits);
    try {
      byte[] content = Roots.content(file, limits);
      if (content.length > limits.bytes()) {
        throw new ToolException(shown + ": expected at most " + limits.bytes() + " bytes");
      }
      ModelFolder folder = Roots.folderOf(file, limits.bytes());
      Model model = ModelReader.read(shown, content, folder, limited);
      return new ModelDifference.Side(
          model, ModelReader.motions(shown, content, folder, limited));
    } catch (ModelFormatException e) {
      throw new ToolException(new Problem(shown, e.location(), e.detail()).toString(), e);
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private Path modelFile(String name) throws ToolException {
    Path file = roots.file(name);
    if (!Models.isModelName(file.getFileName().toString())) {
      throw new ToolException(PrintableText.quoted(name) + ": expected a model: " + Models.NAMES);
    }
    return file;
  }

  /** Returns whether a name is that of a scene, and not of a model. */
  static boolean isScene(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(".json");
  }

  /**
   * Returns a scene in JSON with its own camera. Its settings count within the bounds of a frame.
   *
   * @param name path of its file, as the client gives it
   * @throws java.util.concurrent.CancellationException if the call is cancelled
   */
  Shot scene(String name, SceneFrame frame) throws ToolException {
    Path path = roots.file(name);
    SceneParser parser = new SceneParser().limitedTo(limits).overriding(frame::within);
    try {
      SceneFile file = parser.parse(Roots.content(path, limits), path);
      PartTable none = PartTable.of(file.scene(), Map.of());
      List<Object> identity = List.of(path, file.hash());
      return new Shot(path, "camera", file, none, frame.notes(), identity);
    } catch (SceneFormatException e) {
      throw failure(e);
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  private static ToolException unreadable(String name, IOException e) {
    Interrupts.check();
    String reason = FileFailure.reason(e);
    return new ToolException(PrintableText.quoted(name) + ": cannot be read: " + reason, e);
  }

  /** Returns the picture of a shot; the last one is kept. */
  Finished picture(Shot shot, CallProgress progress) throws InterruptedException {
    PictureKey key = new PictureKey(shot.identity(), shot.file().settings());
    Optional<Last> before = last.filter(kept -> kept.key.equals(key));
    if (before.isPresent()) {
      return before.get().finished;
    }
    List<String> notes = new ArrayList<>(shot.notes());
    Finished made =
        new Finished(CleanPicture.of(shot.file(), shot.title(), notes::add, progress), notes);
    last = Optional.of(new Last(key, made));
    return made;
  }

  private static ToolException failure(SceneFormatException e) {
    return new ToolException(
        e.problems().stream().map(Problem::toString).collect(Collectors.joining("\n")), e);
  }
}
