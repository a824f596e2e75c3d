package io.github.lumbre.cli.mcp;

import io.github.lumbre.base.file.FileFailure;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.cli.output.JsonSummary;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.Models;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.scenefile.internal.PartTable;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.internal.ViewNumbers;
import java.io.IOException;
import java.nio.file.Path;
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

  Studio(Roots roots, Limits limits) {
    this.roots = roots;
    this.limits = limits;
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

    /** Adds what is seen from a direction. */
    void describe(String view, SceneFile seen, JsonSummary summary) {
      ViewNumbers numbers = ViewNumbers.of(seen.scene(), seen.settings(), parts());
      summary.putView("view", view, seen.settings(), numbers, parts());
    }

    /** Returns the scene of the view with which it was read. */
    SceneFile first() {
      return views.scene();
    }

    /**
     * Returns the scene from a direction, for a picture of a size in pixels.
     *
     * @param samples per pixel
     */
    synchronized SceneFile seenFrom(View view, int width, int height, int samples)
        throws ToolException {
      try {
        SceneFile seen = views.seenFrom(view, width, height);
        return seen.with(seen.settings().toBuilder().samples(samples).build());
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
    Path file = roots.file(name);
    if (!Models.isModelName(file.getFileName().toString())) {
      throw new ToolException(PrintableText.quoted(name) + ": expected a model: " + Models.NAMES);
    }
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
      Interrupts.check();
      String reason = FileFailure.reason(e);
      throw new ToolException(PrintableText.quoted(name) + ": cannot be read: " + reason, e);
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

  private static ToolException failure(SceneFormatException e) {
    return new ToolException(
        e.problems().stream().map(Problem::toString).collect(Collectors.joining("\n")), e);
  }
}
