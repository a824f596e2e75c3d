package io.github.lumbre.cli.view;

import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.PixelPlace;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.internal.CameraPose;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Semaphore;

/** What the page may ask for and do. Thread-safe. */
final class ViewRoutes {
  /**
   * The longest wait for a new state; shorter than the time after which a page counts as closed.
   */
  private static final long WAIT_MILLIS = 2000;

  /** The longest wait for a layer, which comes with the next preview. */
  private static final long LAYER_MILLIS = 5000;

  private static final double MAX_TURN = 3600;
  private static final double MAX_MOVE = 100;

  private final ViewSession session;
  private final Optional<SceneSource> source;
  private final StateJson.Look look;
  private final Optional<Frame> other;
  private final StateJson.Other otherState;
  private final PictureFiles files;

  /** Paths and picture files take time: one at a time. */
  private final Semaphore slow = new Semaphore(1);

  /**
   * @param source reads the scene; empty for a picture that is not rendered here
   * @param other the picture to compare with
   * @param otherState what the page has to know of it
   */
  ViewRoutes(
      ViewSession session,
      Optional<SceneSource> source,
      StateJson.Look look,
      Optional<Frame> other,
      StateJson.Other otherState,
      PictureFiles files) {
    this.session = session;
    this.source = source;
    this.look = look;
    this.other = other;
    this.otherState = otherState;
    this.files = files;
  }

  Answer get(String path, Query query) throws InterruptedException, IOException {
    return switch (path) {
      case "/" -> page();
      case "/state" -> state(query);
      case "/image" -> image(query);
      case "/names" -> names(query);
      case "/other" -> other.map(ViewRoutes::exact).orElseGet(ViewRoutes::missing);
      case "/pixel" -> alone(() -> pixel(query));
      case "/camera" -> camera();
      case "/command" -> command();
      case "/save" -> alone(() -> save(query));
      default -> missing();
    };
  }

  private static Answer missing() {
    return Answer.refused(404, "not found");
  }

  private static Answer page() {
    String nonce = RequestGuard.random().token();
    return Answer.page(Page.text(nonce), nonce);
  }

  /** Work that takes time. */
  interface Work {
    Answer run() throws InterruptedException, IOException;
  }

  private Answer alone(Work work) throws InterruptedException, IOException {
    slow.acquire();
    try {
      return work.run();
    } finally {
      slow.release();
    }
  }

  private Answer state(Query query) throws InterruptedException {
    boolean isHidden = query.number("hidden", 0, 1, 0) == 1;
    boolean isDenoised = isDenoised(query);
    if (!isHidden) {
      session.viewers().seen();
      if (isDenoised) {
        session.viewers().wantDenoised();
      }
    }
    session.viewers().spend(1_000_000 * query.number("cost", 0, 5000, 0));
    session.await(query.number("since", 0, Long.MAX_VALUE, 0), WAIT_MILLIS);
    return Answer.json(StateJson.of(session.snapshot(), look(), otherState));
  }

  /** Returns whether a page shows the denoised picture if there is one. */
  static boolean isDenoised(Query query) {
    return query.number("denoised", 0, 1, 0) == 1;
  }

  private StateJson.Look look() {
    return session
        .scene()
        .map(SceneFile::settings)
        .map(s -> new StateJson.Look(s.exposure(), s.toneCurve(), false, s.background()))
        .orElse(look);
  }

  private Answer image(Query query) throws InterruptedException {
    String name = query.text("layer").orElse("");
    boolean isExact = query.number("exact", 0, 1, 0) == 1;
    Set<Layer> needed = LayerNames.layerOf(name).map(Set::of).orElse(Set.of());
    Optional<SceneFile> scene = session.scene();
    if (scene.filter(file -> !LayerNames.kinds(file).containsAll(needed)).isPresent()) {
      return Answer.nothingYet();
    }
    Optional<Frame> frame =
        needed.isEmpty() || scene.isEmpty()
            ? session.frame()
            : session.frameWith(needed, LAYER_MILLIS);
    if (frame.isEmpty()) {
      return missing();
    }
    boolean isDenoised = isDenoised(query);
    if (isDenoised) {
      session.viewers().wantDenoised();
    }
    Optional<Frame> denoised = isDenoised ? frame.get().denoised() : Optional.empty();
    long start = System.nanoTime();
    Answer answer =
        bytes(denoised.orElse(frame.get()), name, isExact)
            .orElseGet(() -> needed.isEmpty() ? missing() : Answer.nothingYet());
    if (query.number("auto", 0, 1, 0) == 1) {
      double factor = files.automatic(frame.get(), scene).factor(frame.get().image());
      answer = answer.with("Automatic-Exposure", String.valueOf(factor));
    }
    if (denoised.isPresent()) {
      answer = answer.with("Denoised-Samples", String.valueOf(denoised.get().samples()));
    }
    session.viewers().spend(System.nanoTime() - start);
    return answer;
  }

  /** Returns the picture or a layer of a frame; empty if the frame does not have it. */
  private static Optional<Answer> bytes(Frame frame, String name, boolean isExact) {
    if (name.isEmpty()) {
      return Optional.of(Answer.bytes(PictureBytes.of(frame.image(), isExact, frame.version())));
    }
    Optional<ImageLayer> layer =
        frame
            .layer(name)
            .or(() -> frame.layers().stream().filter(l -> isPart(l, name)).findFirst());
    return layer
        .map(l -> PictureBytes.of(l, isExact || LayerNames.isMatte(l.name()), frame.version()))
        .map(Answer::bytes);
  }

  private static boolean isPart(ImageLayer layer, String name) {
    return Layer.named(name).filter(l -> LayerNames.belongsTo(layer.name(), l)).isPresent();
  }

  /** Returns the names of the items of a matte by their ids, which are the bits of its values. */
  private Answer names(Query query) {
    String name = query.text("layer").orElse("");
    JsonObject names = new JsonObject();
    session.frame().ifPresent(frame -> LayerNames.items(frame, name, names::addProperty));
    return Answer.json(names.toString());
  }

  private static Answer exact(Frame frame) {
    return Answer.bytes(PictureBytes.of(frame.image(), true, frame.version()));
  }

  private Answer pixel(Query query) {
    if (session.scene().isEmpty()) {
      throw new IllegalArgumentException("a finished picture has no paths; view its scene");
    }
    SceneFile file = session.scene().get();
    RenderSettings settings = file.settings();
    int x = (int) query.number("x", 0, settings.width() - 1L, 0);
    int y = (int) query.number("y", 0, settings.height() - 1L, 0);
    Optional<Integer> only =
        query.text("sample").isPresent()
            ? Optional.of((int) query.number("sample", 0, RenderSettings.MAX_SAMPLES - 1L, 0))
            : Optional.empty();
    double done = session.frame().filter(f -> !f.isDraft()).map(Frame::samples).orElse(1.);
    int samples = (int) Math.max(1, Math.min(settings.samples(), Math.ceil(done)));
    return Answer.json(new PixelPaths(file, new PixelPlace(x, y)).json(samples, only));
  }

  private Answer camera() throws IOException {
    if (source.isEmpty() || session.scene().isEmpty()) {
      throw new IllegalArgumentException("a picture has no camera");
    }
    Optional<MovedTo> moved = session.moved();
    CameraPose pose =
        moved
            .map(MovedTo::pose)
            .orElseGet(() -> CameraPose.of(session.scene().get().scene().camera()));
    return Answer.json(CameraJson.of(source.get().text(), pose, moved.flatMap(MovedTo::lens)));
  }

  /** Returns the command line that renders what the page shows; "" if there is none. */
  private Answer command() {
    Optional<RenderLine> line = source.flatMap(SceneSource::command);
    Optional<MovedTo> moved = session.moved();
    Optional<SceneFile> scene = session.scene();
    String text =
        line.isEmpty() || scene.isEmpty() || moved.filter(m -> m.flags().isEmpty()).isPresent()
            ? ""
            : moved
                .flatMap(MovedTo::flags)
                .map(flags -> line.get().movedTo(flags, scene.get().settings()))
                .orElse(line.get())
                .text(scene.get().settings());
    JsonObject answer = new JsonObject();
    answer.addProperty("command", text);
    return Answer.json(answer.toString());
  }

  private Answer save(Query query) throws InterruptedException, IOException {
    Optional<SceneFile> scene = session.scene();
    Set<Layer> layers = scene.map(LayerNames::kinds).orElse(Set.of());
    boolean isExr = query.text("format").equals(Optional.of("exr"));
    Optional<Frame> frame =
        isExr && !layers.isEmpty() ? session.frameWith(layers, LAYER_MILLIS) : session.frame();
    return frame.isEmpty() ? missing() : files.of(frame.get(), scene, session, query);
  }

  /**
   * Carries out a command of the page.
   *
   * @param body a JSON object with the name of the action
   */
  Answer post(String path, String body) {
    if (!path.equals("/do")) {
      return missing();
    }
    try {
      act(object(body));
    } catch (UnsupportedOperationException | IllegalStateException e) {
      throw new IllegalArgumentException(
          "action and layer: expected texts; still: expected true or false", e);
    }
    return Answer.json("{}");
  }

  private void act(JsonObject command) {
    String action = command.has("action") ? command.get("action").getAsString() : "";
    switch (action) {
      case "stop" -> session.setRunning(false);
      case "continue" -> session.setRunning(true);
      case "home" -> session.goHome();
      case "release" -> session.release();
      case "move" -> move(command);
      case "record" -> record(command);
      default -> throw new IllegalArgumentException("action: found an unknown one");
    }
  }

  private static JsonObject object(String body) {
    try {
      return JsonParser.parseString(body).getAsJsonObject();
    } catch (JsonParseException | IllegalStateException | StackOverflowError e) {
      throw new IllegalArgumentException("expected a JSON object", e);
    }
  }

  private void move(JsonObject command) {
    Optional<Orbit> orbit = session.orbit();
    if (orbit.isEmpty()) {
      return;
    }
    Orbit next =
        orbit
            .get()
            .turned(number(command, "right", MAX_TURN), number(command, "up", MAX_TURN))
            .moved(number(command, "panRight", MAX_MOVE), number(command, "panUp", MAX_MOVE))
            .nearer(Math.exp(number(command, "zoom", 5)));
    boolean isStill = command.has("still") && command.get("still").getAsBoolean();
    session.move(next, isStill);
  }

  private static double number(JsonObject command, String name, double limit) {
    if (!command.has(name)) {
      return 0;
    }
    double value;
    try {
      value = command.get(name).getAsDouble();
    } catch (NumberFormatException | UnsupportedOperationException | IllegalStateException e) {
      throw new IllegalArgumentException(name + ": expected a number", e);
    }
    if (!(Math.abs(value) <= limit)) {
      throw new IllegalArgumentException(
          name + ": expected at most " + limit + " in magnitude, found " + value);
    }
    return value;
  }

  private void record(JsonObject command) {
    String name = command.has("layer") ? command.get("layer").getAsString() : "";
    Set<Layer> layers =
        name.equals("denoised")
            ? Layer.FOR_DENOISING
            : Layer.named(name)
                .map(Set::of)
                .orElseThrow(() -> new IllegalArgumentException("layer: found an unknown one"));
    session.record(layers);
  }
}
