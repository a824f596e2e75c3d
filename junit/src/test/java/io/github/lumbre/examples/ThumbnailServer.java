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
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * An example: a server that answers a model with its thumbnail. {@code POST /thumbnail/stl} with
 * the bytes of an STL file returns a PNG; so do the other formats.
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

  /** Starts a server on a free port of the local host. */
  public ThumbnailServer(Limits limits) throws IOException {
    long uploads = Runtime.getRuntime().maxMemory() / (4 * limits.bytes());
    int most = (int) Math.max(2, Math.min(uploads, MAX_CONNECTIONS));
    handlers = new ThreadPoolExecutor(0, most, 1, TimeUnit.MINUTES, new SynchronousQueue<>());
    thumbnails = new Thumbnails(limits);
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
    try {
      String ending = exchange.getRequestURI().getPath().substring(PATH.length());
      reply(exchange, 200, thumbnails.png("." + ending, exchange.getRequestBody(), SIDE));
    } catch (SceneFormatException e) {
      boolean isTooLarge = e.kind() == SceneFormatException.Kind.LIMIT;
      reply(exchange, isTooLarge ? 413 : 422, e.getMessage().getBytes(StandardCharsets.UTF_8));
    } catch (RejectedExecutionException | InterruptedException e) {
      reply(exchange, 503, "busy, or stopped".getBytes(StandardCharsets.UTF_8));
    }
  }

  private static void reply(HttpExchange exchange, int status, byte[] body) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", status == 200 ? "image/png" : "text/plain");
    exchange.sendResponseHeaders(status, body.length);
    exchange.getResponseBody().write(body);
    exchange.close();
  }

  /** Stops: interrupts all work, which ends within two seconds. */
  @Override
  public void close() {
    http.stop(0);
    thumbnails.close();
    handlers.shutdownNow();
  }
}
