package io.github.lumbre.cli.view;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import io.github.lumbre.lab.TaskException;
import io.github.lumbre.lab.TaskException.Kind;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
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

  private static final int THREADS = 8;
  private static final int QUEUE = 32;
  private static final int BACKLOG = 16;

  static {
    // Limits of the JDK's server, in seconds; without nodelay, each answer waits for 40 ms.
    System.setProperty("sun.net.httpserver.maxReqTime", "20");
    System.setProperty("sun.net.httpserver.maxRspTime", "120");
    System.setProperty("sun.net.httpserver.idleInterval", "60");
    System.setProperty("sun.net.httpserver.maxReqHeaders", "64");
    System.setProperty("sun.net.httpserver.nodelay", "true");
  }

  private final HttpServer server;
  private final ThreadPoolExecutor threads;
  private final RequestGuard guard;
  private final ViewRoutes routes;

  private ViewServer(HttpServer server, RequestGuard guard, ViewRoutes routes) {
    this.server = server;
    this.guard = guard;
    this.routes = routes;
    threads =
        new ThreadPoolExecutor(
            THREADS,
            THREADS,
            1,
            TimeUnit.MINUTES,
            new ArrayBlockingQueue<>(QUEUE),
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
      throw new TaskException(
          Kind.OUTPUT,
          "--port: cannot listen on 127.0.0.1:%d (%s); choose another port, or 0 for any that is free"
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
      exchange.sendResponseHeaders(
          answer.status(), answer.body().length == 0 ? -1 : answer.body().length);
      try (OutputStream out = exchange.getResponseBody()) {
        out.write(answer.body());
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
    String rest = guard.rest(path);
    try {
      return exchange.getRequestMethod().equals("POST")
          ? routes.post(rest, new String(body, StandardCharsets.UTF_8))
          : routes.get(rest, Query.of(Optional.ofNullable(uri.getRawQuery()).orElse("")));
    } catch (IllegalArgumentException e) {
      return Answer.refused(400, String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Answer.refused(503, "the program ends");
    } catch (OutOfMemoryError e) {
      return Answer.refused(503, "not enough memory for this answer");
    }
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
