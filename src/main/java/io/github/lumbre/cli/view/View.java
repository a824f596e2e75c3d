package io.github.lumbre.cli.view;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.Failures;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.Backdrop;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/** A local page that shows a picture or renders a scene. Close it to end the page's server. */
public final class View implements AutoCloseable {
  private static final long LOOK_MILLIS = 250;

  private final ViewSession session;
  private final ViewServer server;
  private final Optional<SceneSource> source;
  private final FileWatch watch = new FileWatch();
  private Set<Layer> recorded = Set.of();
  private Optional<Thread> renderer = Optional.empty();

  private View(ViewSession session, ViewServer server, Optional<SceneSource> source) {
    this.session = session;
    this.server = server;
    this.source = source;
  }

  /**
   * A picture with its layers.
   *
   * @param metadata attributes that describe the layers
   * @param isDisplayReferred whether it was decoded from the colors of a screen, as in a PNG or
   *     JPEG file, so that exposure and tone curve are already applied
   * @param background linear color of the screen behind a picture with alpha
   */
  public record Picture(
      Image image,
      List<ImageLayer> layers,
      Map<String, String> metadata,
      boolean isDisplayReferred,
      Optional<Rgb> background) {
    /** Creates a picture that has no alpha or keeps it. */
    public Picture(
        Image image,
        List<ImageLayer> layers,
        Map<String, String> metadata,
        boolean isDisplayReferred) {
      this(image, layers, metadata, isDisplayReferred, Optional.empty());
    }

    /** Returns this picture over its background in linear light. */
    public Picture asLight() {
      return new Picture(
          Backdrop.asLight(image, background),
          layers,
          metadata,
          isDisplayReferred,
          Optional.empty());
    }

    private Frame frame() {
      return new Frame(1, image, layers, 0, false, true, metadata, Optional.empty());
    }
  }

  /**
   * How a page starts.
   *
   * @param path of the file that is viewed
   * @param port to listen on; 0 for any that is free
   * @param other the picture to compare with
   * @param otherName its name; empty without one
   */
  public record Options(Path path, int port, Optional<Picture> other, String otherName) {
    private String name() {
      return String.valueOf(path.getFileName());
    }
  }

  /**
   * Starts the page of a scene; {@link #run} renders it.
   *
   * @throws TaskException if the port is in use
   */
  public static View of(SceneSource source, Options options) throws TaskException {
    StateJson.Look look = new StateJson.Look(Exposure.NONE, ToneCurve.SRGB, false);
    return start(
        Optional.of(source), look, new ViewSession(options.name()), options, Exposure.AUTO);
  }

  /**
   * Starts the page of a picture.
   *
   * @param exposure with which it is shown at first
   * @param automatic the one that automatic exposure is
   * @param curve with which it is shown at first
   * @throws TaskException if the port is in use
   */
  public static View of(
      Picture picture, Exposure exposure, Exposure automatic, ToneCurve curve, Options options)
      throws TaskException {
    ViewSession session = new ViewSession(options.name());
    session.show(picture.frame());
    StateJson.Look look =
        new StateJson.Look(exposure, curve, picture.isDisplayReferred(), picture.background());
    return start(Optional.empty(), look, session, options, automatic);
  }

  private static View start(
      Optional<SceneSource> source,
      StateJson.Look look,
      ViewSession session,
      Options options,
      Exposure automatic)
      throws TaskException {
    ViewRoutes routes =
        new ViewRoutes(
            session,
            source,
            look,
            options.other().map(Picture::frame),
            new StateJson.Other(
                options.otherName(), options.other().map(Picture::isDisplayReferred).orElse(false)),
            new PictureFiles(options.path(), automatic, look.background()));
    return new View(session, ViewServer.start(options.port(), routes), source);
  }

  /** Returns the address of the page, which contains a secret. */
  public URI address() {
    return server.address();
  }

  ViewSession session() {
    return session;
  }

  /**
   * Reads the scene for the first time and starts to render it.
   *
   * @param limits what ends the render besides its samples
   * @throws SceneFormatException if the scene is invalid; later, the page shows such errors
   */
  public void open(ViewLimits limits) throws SceneFormatException, TaskException, IOException {
    if (source.isPresent()) {
      SceneFile file = source.get().read(Set.of());
      session.open(file);
      Thread thread = new Thread(new ViewRenderer(session, limits), "lumbre-view");
      thread.setDaemon(true);
      thread.start();
      renderer = Optional.of(thread);
      watch.watch(source.get().files());
    }
  }

  /** Serves the page and reads the scene again when its files change, until the end. */
  public void run(BooleanSupplier isEnd) throws InterruptedException {
    while (!isEnd.getAsBoolean() && renderer.map(Thread::isAlive).orElse(true)) {
      TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
      if (source.isPresent()) {
        look(source.get());
      }
    }
  }

  private void look(SceneSource scene) {
    Set<Layer> layers = session.extraLayers();
    if (!watch.hasChanged() && layers.equals(recorded)) {
      return;
    }
    recorded = layers;
    try {
      session.open(scene.read(layers));
    } catch (SceneFormatException | TaskException | IOException e) {
      fail(Failures.problems(e));
    }
    watch.watch(scene.files());
  }

  private void fail(List<String> reasons) {
    List<String> problems = new ArrayList<>(reasons);
    problems.add("The scene cannot be read; the picture is of its last valid state.");
    session.fail(problems);
  }

  @Override
  public void close() {
    session.close();
    server.close();
    renderer.ifPresent(Thread::interrupt);
  }

  /**
   * Notices that files have changed, by their sizes and times. A change counts once the files have
   * stayed the same for one more look, so that a file which is being written is not read too early.
   * Mutable; for one thread.
   */
  private static final class FileWatch {
    private List<Path> files = List.of();
    private List<String> known = List.of();
    private List<String> last = List.of();

    /** Watches these files, as they are now. */
    void watch(Collection<Path> newFiles) {
      files = List.copyOf(new TreeSet<>(newFiles));
      known = states();
      last = known;
    }

    /** Looks at the files. Returns whether they have changed since they were last reported. */
    boolean hasChanged() {
      List<String> now = states();
      boolean isStable = now.equals(last);
      last = now;
      if (!isStable || now.equals(known)) {
        return false;
      }
      known = now;
      return true;
    }

    private List<String> states() {
      return files.stream().map(FileWatch::state).toList();
    }

    private static String state(Path file) {
      try {
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        return now.size() + " " + now.lastModifiedTime().toMillis() + " " + now.fileKey();
      } catch (IOException e) {
        return "none";
      }
    }
  }
}
