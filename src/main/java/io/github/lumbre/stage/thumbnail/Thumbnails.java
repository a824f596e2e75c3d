package io.github.lumbre.stage.thumbnail;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.Models;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.PassLoop;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.denoise.BuiltInDenoiser;
import io.github.lumbre.render.denoise.NoisyPicture;
import io.github.lumbre.scene.Layer;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.Problem;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.StagedModel;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Renders small, denoised pictures of models that nobody vouches for. Create one for the whole
 * program; any number of threads may use it at once.
 *
 * <p>A picture is a function of the model's bytes, the stage and the size: the same pixels on every
 * machine, whatever else is rendered. Each is rendered by one thread of a pool of its own, while
 * the caller waits. There is a thread for each processor, but no more than half of the heap can
 * serve with {@link Limits#memory}. The pool begins with a model of its own, so that the classes
 * are loaded and compiled early.
 *
 * <p>{@link Limits#time} is the time from a call to its answer. A call ends in one of these ways:
 *
 * <ul>
 *   <li>It returns the picture, which is always complete.
 *   <li>{@link SceneFormatException}: the model is at fault. Of the kind {@link
 *       SceneFormatException.Kind#LIMIT}, it exceeds a limit, or takes more than half of the time
 *       itself; of the other kinds, it is damaged or of an unknown format.
 *   <li>{@link RejectedExecutionException}: the server is at fault. It is closed, too many calls
 *       wait, the time passed while others were rendered, or the heap was exhausted. The same call
 *       may succeed later.
 *   <li>{@link InterruptedException}: the calling thread was interrupted; the work is given up.
 *   <li>{@link IOException}: a stream given by the caller failed.
 * </ul>
 *
 * Whatever is given up ends within two seconds, mostly within milliseconds. Nothing is read from
 * files, but for a sky that the stage names, and nothing is written to them. A model with several
 * files comes as one ZIP archive.
 */
public final class Thumbnails implements AutoCloseable {
  /** The longest side of a picture, in pixels. */
  public static final int MAX_SIDE = 1024;

  /** The samples per pixel: with denoising, more are hardly visible at this size. */
  private static final int SAMPLES = 2;

  /** The calls that may wait for each thread. */
  private static final int WAITING = 128;

  private static final String CLOSED = "the thumbnails are closed";

  private static final int WARM_UPS = 12;
  private static final int WARM_SIDE = 64;
  private static final byte[] TETRAHEDRON =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n"
          .getBytes(StandardCharsets.US_ASCII);

  private final Stage stage;
  private final Limits limits;

  /** Limits of the reader alone: {@link #answer} watches the time of reading and rendering. */
  private final Limits withoutTime;

  private final ThreadPoolExecutor pool;

  /** Creates thumbnails on {@link Stage#DEFAULT}. */
  public Thumbnails(Limits limits) {
    this(Stage.DEFAULT, limits);
  }

  /**
   * Starts the pool.
   *
   * @param stage around the models
   * @param limits of each model; such as {@link Limits#UPLOADS} with less time
   */
  public Thumbnails(Stage stage, Limits limits) {
    this.stage = Objects.requireNonNull(stage, "stage");
    this.limits = limits;
    this.withoutTime = limits.withTime(Limits.NO_TIME_LIMIT);
    Runtime runtime = Runtime.getRuntime();
    long fitting = runtime.maxMemory() / 2 / limits.heap();
    int threads = (int) Math.max(1, Math.min(runtime.availableProcessors(), fitting));
    pool =
        new ThreadPoolExecutor(
            threads,
            threads,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(WAITING * threads),
            Thumbnails::thread,
            Thumbnails::reject);
    pool.execute(this::warmUp);
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "lumbre-thumbnail");
    thread.setDaemon(true);
    return thread;
  }

  private static void reject(Runnable work, ThreadPoolExecutor pool) {
    throw new RejectedExecutionException(pool.isShutdown() ? CLOSED : "too many calls wait");
  }

  private void warmUp() {
    try {
      for (int i = 0; i < WARM_UPS; i++) {
        picture("model.obj", TETRAHEDRON, WARM_SIDE, ImageFormat.PNG);
      }
    } catch (SceneFormatException e) {
      // The limits refuse even this model; each call reports it.
      return;
    } catch (IOException | InterruptedException | CancellationException e) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Returns the bytes of a square PNG file.
   *
   * @param name of the model, for its ending and for messages; without a known ending, the bytes
   *     state the format
   * @param model bytes of a file in one of the formats {@link Models#NAMES}; not changed meanwhile
   * @param side of the picture in pixels, from 1 to {@link #MAX_SIDE}
   * @throws SceneFormatException if the model is at fault
   * @throws RejectedExecutionException if the server is at fault
   * @throws InterruptedException if the calling thread is interrupted
   */
  public byte[] png(String name, byte[] model, int side)
      throws SceneFormatException, InterruptedException {
    return answer(name, model, side, ImageFormat.PNG);
  }

  /**
   * Returns the bytes of a square PNG file; see {@link #png(String, byte[], int)}. The calling
   * thread reads the stream first, for as long as that takes, and without holding up others.
   *
   * @param model is read to its end, or to one byte more than {@link Limits#bytes}; not closed
   * @throws IOException if the stream fails
   */
  public byte[] png(String name, InputStream model, int side)
      throws SceneFormatException, IOException, InterruptedException {
    return answer(name, limits.bytesOf(model), side, ImageFormat.PNG);
  }

  /** Returns the bytes of a square JPEG file; see {@link #png(String, byte[], int)}. */
  public byte[] jpeg(String name, byte[] model, int side)
      throws SceneFormatException, InterruptedException {
    return answer(name, model, side, ImageFormat.JPG);
  }

  /** Returns the bytes of a square JPEG file; see {@link #png(String, InputStream, int)}. */
  public byte[] jpeg(String name, InputStream model, int side)
      throws SceneFormatException, IOException, InterruptedException {
    return answer(name, limits.bytesOf(model), side, ImageFormat.JPG);
  }

  private byte[] answer(String name, byte[] model, int side, ImageFormat format)
      throws SceneFormatException, InterruptedException {
    if (side < 1 || side > MAX_SIDE) {
      throw new IllegalArgumentException("side: expected 1 to " + MAX_SIDE + ", found " + side);
    }
    Optional<String> excess = Limits.excess("pixels", limits.pixels(), (long) side * side);
    if (excess.isPresent()) {
      throw new IllegalArgumentException("side: " + excess.get());
    }
    Objects.requireNonNull(model, "model");
    String known = safe(name);
    String shown = name.isBlank() ? known : PrintableText.path(name);
    Request request = new Request(() -> picture(known, model, side, format));
    try {
      pool.execute(request);
      return request.get(limits.time().toNanos(), TimeUnit.NANOSECONDS);
    } catch (TimeoutException e) {
      throw late(shown, request);
    } catch (CancellationException e) {
      throw new RejectedExecutionException(CLOSED, e);
    } catch (ExecutionException e) {
      throw failure(e.getCause(), shown);
    } finally {
      if (request.cancel(true)) {
        pool.remove(request);
      }
    }
  }

  /**
   * Returns a name with the ending, if it is of a model, and nothing else of what was given: names
   * of strangers need not be paths.
   */
  private static String safe(String name) {
    String ending = name.substring(name.lastIndexOf('.') + 1);
    return "model" + (Models.isModelName("." + ending) ? "." + ending : "");
  }

  private byte[] picture(String name, byte[] model, int side, ImageFormat format)
      throws SceneFormatException, IOException, InterruptedException {
    SceneFile file =
        StagedModel.read(
                name,
                model,
                ModelFolder.NONE,
                stage,
                new SceneParser()
                    .limitedTo(withoutTime)
                    .overriding(settings -> small(settings, side)))
            .scene();
    FilmRenderer renderer = new FilmRenderer(file.settings(), file.scene()).on(pool);
    Film film = renderer.newFilm();
    new PassLoop(renderer, film).run(Progress.NONE);
    return format.bytes(
        BuiltInDenoiser.denoise(NoisyPicture.of(film), 1).image(), file.settings().development());
  }

  private static RenderSettings small(RenderSettings settings, int side) {
    return settings.toBuilder()
        .size(side, side)
        .samples(SAMPLES)
        .threads(1)
        .set(
            Setting.LAYERS,
            Layer.setOf(Layer.DENOISING_ALBEDO, Layer.DENOISING_NORMAL, Layer.DENOISING_ALPHA))
        .build();
  }

  private RuntimeException late(String name, Request request) throws SceneFormatException {
    double seconds = limits.time().toMillis() / 1e3;
    if (request.seconds() > seconds / 2) {
      throw new SceneFormatException(
          SceneFormatException.Kind.LIMIT,
          List.of(
              new Problem(name, "", "expected a model that is rendered within " + seconds + " s")));
    }
    return new RejectedExecutionException("too busy to render a model within " + seconds + " s");
  }

  /** Returns an exception with the name that the caller gave to the model. */
  private static SceneFormatException named(SceneFormatException e, String name) {
    SceneFormatException named =
        new SceneFormatException(
            e.kind(),
            e.problems().stream()
                .map(problem -> new Problem(name, problem.path(), problem.message()))
                .toList());
    named.initCause(e);
    return named;
  }

  private static RuntimeException failure(Throwable cause, String name)
      throws SceneFormatException {
    if (cause instanceof SceneFormatException e) {
      throw named(e, name);
    }
    if (cause instanceof OutOfMemoryError) {
      return new RejectedExecutionException("the heap is exhausted", cause);
    }
    if (cause instanceof InterruptedException
        || cause instanceof IOException
        || cause instanceof CancellationException) {
      return new RejectedExecutionException(CLOSED, cause);
    }
    if (cause instanceof RuntimeException e) {
      return e;
    }
    throw new AssertionError(cause);
  }

  /**
   * Ends all work, and waits for it. Calls that have no picture yet, and later ones, end with a
   * {@link RejectedExecutionException}.
   */
  @Override
  public void close() {
    for (Runnable waiting : pool.shutdownNow()) {
      if (waiting instanceof Request request) {
        request.cancel(false);
      }
    }
    try {
      pool.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
