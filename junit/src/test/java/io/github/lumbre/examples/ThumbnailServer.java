package io.github.lumbre.examples;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.model.ModelReader;
import io.github.lumbre.parser.ModelSetup;
import io.github.lumbre.parser.SceneFile;
import io.github.lumbre.parser.SceneFormatException;
import io.github.lumbre.parser.SceneParser;
import io.github.lumbre.render.BucketRenderer;
import io.github.lumbre.render.Progress;
import io.github.lumbre.render.RenderResult;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * An example: a server that answers a model with its thumbnail. {@code POST /thumbnail/stl} with
 * the bytes of an STL file returns a PNG; so do glb, ply and obj.
 *
 * <p>All renders share one pool of threads. Models are read and rendered within {@link Limits}, and
 * only as many at once as fit into the heap. Nothing is written to files.
 */
public final class ThumbnailServer implements AutoCloseable {
  private static final String PATH = "/thumbnail/";
  private static final int SIDE = 64;
  private static final int SAMPLES = 4;
  private static final int CONNECTIONS = 16;
  private static final int PATIENCE_SECONDS = 60;

  private final Limits limits;
  private final HttpServer http;
  private final ExecutorService handlers = Executors.newFixedThreadPool(CONNECTIONS);
  private final ExecutorService renderers;

  /** Permits for models in memory: the heap divided by what one may need. */
  private final Semaphore models;

  /** Starts a server on a free port of the local host. */
  public ThumbnailServer(Limits limits) throws IOException {
    this.limits = limits;
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
      if (!exchange.getRequestMethod().equals("POST") || !ModelReader.ENDINGS.contains(ending)) {
        reply(exchange, 404, "expected POST /thumbnail/ and one of " + ModelReader.ENDINGS);
        return;
      }
      if (!models.tryAcquire(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
        reply(exchange, 503, "busy");
        return;
      }
      try {
        int most = (int) Math.min(limits.bytes() + 1, Integer.MAX_VALUE);
        byte[] model = exchange.getRequestBody().readNBytes(most);
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
    ModelSetup setup = ModelSetup.DEFAULT.seenFrom(ModelSetup.View.of("iso"));
    SceneFile file = parser.parse(name, model, setup);
    RenderResult result =
        new BucketRenderer(file.settings())
            .on(renderers)
            .limitedTo(limits)
            .render(file.scene(), Progress.NONE);
    return result.image().toPng(file.settings().development());
  }

  private static void reply(HttpExchange exchange, int status, String text) throws IOException {
    reply(exchange, status, text.getBytes(StandardCharsets.UTF_8));
  }

  private static void reply(HttpExchange exchange, int status, byte[] body) throws IOException {
    // What is left of the upload is read and dropped, so that the client can read the answer.
    exchange.getRequestBody().transferTo(OutputStream.nullOutputStream());
    exchange.getResponseHeaders().set("Content-Type", status == 200 ? "image/png" : "text/plain");
    exchange.sendResponseHeaders(status, body.length);
    try (OutputStream out = exchange.getResponseBody()) {
      out.write(body);
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
