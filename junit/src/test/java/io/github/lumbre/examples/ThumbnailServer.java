package io.github.lumbre.examples;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.stage.thumbnail.Thumbnails;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Phaser;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * An example: a server that answers a model with its thumbnail. {@code POST /thumbnail/stl} with
 * the bytes of an STL file returns a PNG; so do the other formats.
 *
 * <p>{@code GET /health} answers 200, and 503 from the moment that the server is asked to stop.
 * Then it refuses new models, finishes the running ones, and closes.
 *
 * <p>Each connection has a thread, which reads the upload within a number of bytes and a time. Only
 * then does the model wait for a thread that renders, so that a slow or endless upload stops nobody
 * else.
 */
public final class ThumbnailServer implements AutoCloseable {
  private static final String PATH = "/thumbnail/";
  private static final int SIDE = 64;

  /** The most connections at once; each holds a thread, and an upload in memory. */
  private static final int MAX_CONNECTIONS = 64;

  static {
    // Of the JDK's server, before it is loaded: seconds until a request must be read, and an answer
    // taken; milliseconds between checks. Afterwards it closes the connection. Of a refused upload
    // it reads and drops some bytes, so that most clients can read the answer.
    System.setProperty("sun.net.httpserver.maxReqTime", "10");
    System.setProperty("sun.net.httpserver.maxRspTime", "120");
    System.setProperty("sun.net.httpserver.timerMillis", "500");
    System.setProperty("sun.net.httpserver.drainAmount", "4194304");
  }

  private final Thumbnails thumbnails;
  private final HttpServer http;
  private final ExecutorService handlers;
  private final Duration patience;

  /** Answers that are being made, and the server itself until it stops. */
  private final Phaser running = new Phaser(1);

  private volatile boolean stopping;

  /**
   * Serves until the process is asked to end, as by SIGTERM.
   *
   * @param args the port, 0 for a free one; and the address, without which only programs on this
   *     machine can connect. In a container, the address is 0.0.0.0
   */
  public static void main(String[] args) throws IOException {
    int port = args.length > 0 ? Integer.parseInt(args[0]) : 8080;
    InetAddress address =
        args.length > 1 ? InetAddress.getByName(args[1]) : InetAddress.getLoopbackAddress();
    Limits limits = Limits.UPLOADS.withBytes(8 << 20).withTime(Duration.ofSeconds(20));
    ThumbnailServer server = new ThumbnailServer(limits, new InetSocketAddress(address, port));
    Runtime.getRuntime().addShutdownHook(new Thread(server::stop));
    System.out.println("listening on port " + server.port());
  }

  /** Starts a server on a free port of the local host. */
  public ThumbnailServer(Limits limits) throws IOException {
    this(limits, new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
  }

  /** Starts a server at an address. */
  public ThumbnailServer(Limits limits, InetSocketAddress address) throws IOException {
    patience = limits.time();
    long uploads = Runtime.getRuntime().maxMemory() / (4 * limits.bytes());
    int most = (int) Math.max(2, Math.min(uploads, MAX_CONNECTIONS));
    handlers = new ThreadPoolExecutor(0, most, 1, TimeUnit.MINUTES, new SynchronousQueue<>());
    thumbnails = new Thumbnails(limits);
    http = HttpServer.create(address, 0);
    http.createContext(PATH, this::answerUnlessStopping);
    http.createContext("/health", this::answerHealth);
    http.setExecutor(handlers);
    http.start();
  }

  /** Returns the port. */
  public int port() {
    return http.getAddress().getPort();
  }

  private void answerHealth(HttpExchange exchange) throws IOException {
    reply(exchange, stopping ? 503 : 200, stopping ? "stopping" : "ok");
  }

  private void answerUnlessStopping(HttpExchange exchange) throws IOException {
    if (stopping) {
      reply(exchange, 503, "stopping");
      return;
    }
    running.register();
    try {
      answer(exchange);
    } finally {
      running.arriveAndDeregister();
    }
  }

  private void answer(HttpExchange exchange) throws IOException {
    try {
      String ending = exchange.getRequestURI().getPath().substring(PATH.length());
      byte[] png = thumbnails.png("." + ending, exchange.getRequestBody(), SIDE);
      reply(exchange, 200, "image/png", png);
    } catch (SceneFormatException e) {
      boolean isTooLarge = e.kind() == SceneFormatException.Kind.LIMIT;
      reply(exchange, isTooLarge ? 413 : 422, e.getMessage());
    } catch (RejectedExecutionException | InterruptedException e) {
      reply(exchange, 503, "busy, or stopped");
    }
  }

  private static void reply(HttpExchange exchange, int status, String message)
      throws IOException {
    reply(exchange, status, "text/plain; charset=utf-8", message.getBytes(StandardCharsets.UTF_8));
  }

  private static void reply(HttpExchange exchange, int status, String type, byte[] body)
      throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type);
    exchange.sendResponseHeaders(status, body.length);
    exchange.getResponseBody().write(body);
    exchange.close();
  }

  /**
   * Stops gracefully: refuses new models with 503, waits until the running ones are answered, but
   * no longer than a model may take, and closes.
   */
  public void stop() {
    stopping = true;
    try {
      running.awaitAdvanceInterruptibly(
          running.arrive(), patience.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (TimeoutException e) {
      System.err.println("gave up what was not answered within " + patience.toSeconds() + " s");
    }
    close();
  }

  /** Stops at once: interrupts all work, which ends within two seconds. */
  @Override
  public void close() {
    http.stop(0);
    thumbnails.close();
    handlers.shutdownNow();
  }
}
