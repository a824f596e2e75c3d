package io.github.lumbre.examples;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.model.Models;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.parser.Stage;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * An example: a server that answers a model with its thumbnail. {@code POST /thumbnail/stl} with
 * the bytes of an STL file returns a PNG; so do glb, ply and obj.
 *
 * <p>An upload is read first, within a number of bytes and a time, so that a slow or endless one
 * stops nobody else. Only then does it wait for a permit: as many models are parsed and rendered at
 * once as fit into the heap. All renders share one pool of threads and keep {@link Limits}. Nothing
 * is written to files.
 */
public final class ThumbnailServer implements AutoCloseable {
  private static final String PATH = "/thumbnail/";
  private static final int SIDE = 64;
  private static final int SAMPLES = 4;
  private static final int PATIENCE_SECONDS = 60;

  /** What is read of the rest of a refused upload, as a multiple of the limit of bytes. */
  private static final int REST = 4;

  /** The most connections at once; each holds a thread, and an upload in memory. */
  private static final int MAX_CONNECTIONS = 64;

  static {
    // Of the JDK's server, before it is loaded: seconds until a request must be read, and an answer
    // taken; milliseconds between checks. Afterwards it closes the connection.
    System.setProperty("sun.net.httpserver.maxReqTime", "10");
    System.setProperty("sun.net.httpserver.maxRspTime", "120");
    System.setProperty("sun.net.httpserver.timerMillis", "500");
  }

  private final Limits limits;
  private final HttpServer http;
  private final ExecutorService handlers;
  private final ExecutorService renderers;

  /** Permits for models in memory: the heap divided by what one may need. */
  private final Semaphore models;

  /** Starts a server on a free port of the local host. */
  public ThumbnailServer(Limits limits) throws IOException {
    this.limits = limits;
    long uploads = Runtime.getRuntime().maxMemory() / (4 * limits.bytes());
    handlers =
        new ThreadPoolExecutor(
            0,
            (int) Math.max(2, Math.min(uploads, MAX_CONNECTIONS)),
            1,
            TimeUnit.MINUTES,
            new SynchronousQueue<>());
    int processors = Runtime.getRuntime().availableProcessors();
    renderers = Executors.newFixedThreadPool(processors);
    long atOnce = Runtime.getRuntime().maxMemory() / (2 * limits.memory());
    models = new Semaphore((int) Math.max(1, Math.min(2L * processors, atOnce)), true);
    http = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    http.createContext(PATH, this::answer);
    http.setExecutor(handlers);
    http.start();
  }

  /** Returns the port. */
  public int port() {
    return http.getAddress().getPort();
  }

  private void answer(HttpExchange exchange) throws IOException {
    try (exchange) {
      answerOpen(exchange);
    }
  }

  private void answerOpen(HttpExchange exchange) throws IOException {
    try {
      String ending = exchange.getRequestURI().getPath().substring(PATH.length());
      boolean isModel = Models.isModelName("model." + ending);
      if (!exchange.getRequestMethod().equals("POST") || !isModel) {
        reply(exchange, 404, "expected POST /thumbnail/ and one of " + Models.NAMES);
        return;
      }
      int most = (int) Math.min(limits.bytes() + 1, Integer.MAX_VALUE);
      byte[] model = exchange.getRequestBody().readNBytes(most);
      if (!models.tryAcquire(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        reply(exchange, 503, "busy");
        return;
      }
      try {
        reply(exchange, 200, thumbnail("model." + ending, model));
      } finally {
        models.release();
      }
    } catch (SceneFormatException e) {
      boolean tooLarge = e.kind() == SceneFormatException.Kind.LIMIT;
      reply(exchange, tooLarge ? 413 : 422, e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      reply(exchange, 503, "stopped");
    }
  }

  private byte[] thumbnail(String name, byte[] model)
      throws SceneFormatException, IOException, InterruptedException {
    SceneParser parser =
        new SceneParser()
            .limitedTo(limits)
            .overriding(settings -> settings.toBuilder().size(SIDE, SIDE).samples(SAMPLES).build());
    Stage stage = Stage.DEFAULT.seenFrom(Stage.View.of("iso"));
    SceneFile file = parser.parse(name, model, stage);
    RenderResult result =
        new PictureRenderer(file.settings())
            .on(renderers)
            .limitedTo(limits)
            .render(file.scene(), Progress.NONE);
    return result.image().toPng(file.settings().development());
  }

  private void reply(HttpExchange exchange, int status, String text) throws IOException {
    reply(exchange, status, text.getBytes(StandardCharsets.UTF_8));
  }

  private void reply(HttpExchange exchange, int status, byte[] body) throws IOException {
    // Some of what is left of the upload is read and dropped, so that most clients can read the
    // answer; the rest is cut off with the connection.
    drop(exchange.getRequestBody(), REST * limits.bytes());
    exchange.getResponseHeaders().set("Content-Type", status == 200 ? "image/png" : "text/plain");
    exchange.sendResponseHeaders(status, body.length);
    try (OutputStream out = exchange.getResponseBody()) {
      out.write(body);
    }
  }

  private static void drop(InputStream body, long most) throws IOException {
    byte[] buffer = new byte[8192];
    int count = 0;
    for (long left = most; left > 0 && count >= 0; left -= count) {
      count = body.read(buffer);
    }
  }

  /** Stops: interrupts all work, which ends within two seconds. */
  @Override
  public void close() {
    http.stop(0);
    handlers.shutdownNow();
    renderers.shutdownNow();
  }
}
