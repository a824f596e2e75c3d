package io.github.lumbre.cli.view;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import io.github.lumbre.base.ExitCode;
import io.github.lumbre.base.TaskException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * The server of the local page. It listens on the loopback address only, answers requests that a
 * {@link RequestGuard} accepts, and limits their number, their size and their time.
 */
public final class ViewServer implements AutoCloseable {
  /** The largest body of a request, in bytes. */
  static final int MAX_BODY = 16 << 10;

  /** The longest address of a request. */
  static final int MAX_ADDRESS = 2048;

  /**
   * The largest number of connections whose request is read or answered; others are closed. The
   * JDK's server reads a request in the thread that answers it, so that a client that sends half a
   * request holds a thread until its time is over.
   */
  private static final int MAX_CONNECTIONS = 256;

  /** The largest number of answers that are computed at once. */
  private static final int MAX_WORK = 8;

  private static final int BACKLOG = 128;

  static {
    // Limits of the JDK's server, in seconds, and how often it checks the limits of requests
    // and answers, in milliseconds. Without nodelay, each answer waits for 40 ms.
    System.setProperty("sun.net.httpserver.maxReqTime", "1");
    System.setProperty("sun.net.httpserver.timerMillis", "250");
    System.setProperty("sun.net.httpserver.maxRspTime", "120");
    System.setProperty("sun.net.httpserver.idleInterval", "60");
    System.setProperty("sun.net.httpserver.maxReqHeaders", "64");
    System.setProperty("sun.net.httpserver.nodelay", "true");
  }

  private final HttpServer server;
  private final ThreadPoolExecutor threads;
  private final RequestGuard guard;
  private final ViewRoutes routes;
  private final Semaphore work = new Semaphore(MAX_WORK);

  private ViewServer(HttpServer server, RequestGuard guard, ViewRoutes routes) {
    this.server = server;
    this.guard = guard;
    this.routes = routes;
    threads =
        new ThreadPoolExecutor(
            0,
            MAX_CONNECTIONS,
            1,
            TimeUnit.MINUTES,
            new SynchronousQueue<>(),
            task -> {
              Thread thread = new Thread(task, "lumbre-page");
              thread.setDaemon(true);
              return thread;
            });
  }

  /**
   * Starts a server.
   *
   * @param port to listen on; 0 for any that is free
   * @throws TaskException if the port is in use
   */
  static ViewServer start(int port, ViewRoutes routes) throws TaskException {
    try {
      InetAddress loopback = InetAddress.getByAddress("localhost", new byte[] {127, 0, 0, 1});
      HttpServer http = HttpServer.create(new InetSocketAddress(loopback, port), BACKLOG);
      ViewServer server = new ViewServer(http, RequestGuard.random(), routes);
      http.createContext("/", server::handle);
      http.setExecutor(server.threads);
      http.start();
      return server;
    } catch (IOException e) {
      throw ExitCode.PORT.failure(
          ("--port: cannot listen on 127.0.0.1:%d (%s); choose another port, or 0 for any that is"
                  + " free")
              .formatted(port, e.getMessage()),
          e);
    }
  }

  /** Returns the address of the page, which contains the token. */
  public URI address() {
    return URI.create("http://127.0.0.1:%d/%s/".formatted(port(), guard.token()));
  }

  int port() {
    return server.getAddress().getPort();
  }

  private void handle(HttpExchange exchange) throws IOException {
    try (exchange) {
      Answer answer = answer(exchange);
      answer.headers().forEach(exchange.getResponseHeaders()::set);
      exchange.getResponseHeaders().set("Content-Type", answer.type());
      exchange.getResponseHeaders().set("Cache-Control", "no-store");
      exchange.getResponseHeaders().set("X-Content-Type-Options", "nosniff");
      exchange.getResponseHeaders().set("Referrer-Policy", "no-referrer");
      exchange.getResponseHeaders().set("Cross-Origin-Resource-Policy", "same-origin");
      int length = answer.body().length;
      boolean isHead = exchange.getRequestMethod().equals("HEAD");
      if (isHead) {
        exchange.getResponseHeaders().set("Content-Length", String.valueOf(length));
      }
      exchange.sendResponseHeaders(answer.status(), isHead || length == 0 ? -1 : length);
      if (!isHead) {
        try (OutputStream out = exchange.getResponseBody()) {
          out.write(answer.body());
        }
      }
    }
  }

  private Answer answer(HttpExchange exchange) throws IOException {
    URI uri = exchange.getRequestURI();
    if (uri.toString().length() > MAX_ADDRESS) {
      return Answer.refused(414, "expected an address of at most " + MAX_ADDRESS + " characters");
    }
    String path = Optional.ofNullable(uri.getPath()).orElse("");
    Optional<RequestGuard.Refusal> refusal =
        guard.refusal(
            new RequestGuard.Request(
                exchange.getRequestMethod(),
                path,
                header(exchange, "Host"),
                header(exchange, "Origin"),
                header(exchange, "Sec-Fetch-Site")));
    if (refusal.isPresent()) {
      return Answer.refused(refusal.get().status(), refusal.get().text());
    }
    byte[] body = exchange.getRequestBody().readNBytes(MAX_BODY + 1);
    if (body.length > MAX_BODY) {
      return Answer.refused(413, "expected at most " + MAX_BODY + " bytes");
    }
    return exchange.getRequestMethod().equals("POST")
        ? computed(() -> routes.post(guard.rest(path), new String(body, StandardCharsets.UTF_8)))
        : computed(
            () ->
                routes.get(
                    guard.rest(path), Query.of(Optional.ofNullable(uri.getRawQuery()).orElse(""))));
  }

  /** Computes an answer to a request that is read and accepted, a few at a time. */
  private Answer computed(ViewRoutes.Work question) throws IOException {
    try {
      work.acquire();
    } catch (InterruptedException e) {
      return ended();
    }
    try {
      return question.run();
    } catch (IllegalArgumentException e) {
      return Answer.refused(400, String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      return ended();
    } catch (OutOfMemoryError e) {
      return Answer.refused(503, "not enough memory for this answer");
    } finally {
      work.release();
    }
  }

  private static Answer ended() {
    Thread.currentThread().interrupt();
    return Answer.refused(503, "the program ends");
  }

  private static Optional<String> header(HttpExchange exchange, String name) {
    return Optional.ofNullable(exchange.getRequestHeaders().getFirst(name));
  }

  @Override
  public void close() {
    server.stop(0);
    threads.shutdownNow();
  }
}
