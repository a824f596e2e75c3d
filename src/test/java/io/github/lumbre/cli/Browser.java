package io.github.lumbre.cli;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/**
 * A headless Chromium, controlled by its DevTools protocol. It shows one page at a time, and
 * records the page's console messages and network requests.
 */
final class Browser implements AutoCloseable {
  private static final List<String> NAMES =
      List.of(
          "chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome.exe");

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final Process process;
  private final Path profile;
  private final WebSocket socket;
  private final AtomicInteger lastId = new AtomicInteger();
  private final Map<Integer, CompletableFuture<JsonObject>> answers = new ConcurrentHashMap<>();
  private final List<JsonObject> events = new CopyOnWriteArrayList<>();

  private Browser(Process process, Path profile, URI page) {
    this.process = process;
    this.profile = profile;
    socket = HttpClient.newHttpClient().newWebSocketBuilder().buildAsync(page, listener()).join();
  }

  /**
   * Starts the browser from the system property {@code browser}, the environment variable
   * LUMBRE_BROWSER, or the search path.
   *
   * @throws AssertionError if there is none
   */
  static Browser start() throws IOException, InterruptedException {
    Path profile = Files.createTempDirectory("lumbre-browser-");
    List<String> command =
        new ArrayList<>(
            List.of(
                program(),
                "--headless",
                "--disable-gpu",
                "--disable-quic",
                "--disable-sync",
                "--disable-extensions",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-dev-shm-usage",
                "--hide-scrollbars",
                "--no-first-run",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile,
                "about:blank"));
    if ("root".equals(System.getProperty("user.name"))) {
      // The browser's sandbox does not work for the superuser.
      command.add(1, "--no-sandbox");
    }
    Process process =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(profile.resolve("browser.log").toFile())
            .start();
    try {
      return new Browser(process, profile, page(port(process, profile)));
    } catch (IOException | InterruptedException | RuntimeException e) {
      process.destroyForcibly();
      throw e;
    }
  }

  private static String program() {
    return Stream.of(System.getProperty("browser"), System.getenv("LUMBRE_BROWSER"))
        .filter(Objects::nonNull)
        .filter(name -> !name.isBlank())
        .findFirst()
        .or(Browser::onPath)
        .orElseThrow(
            () ->
                new AssertionError(
                    "no browser: expected one of "
                        + NAMES
                        + " on the PATH, or -Dbrowser=PROGRAM, or LUMBRE_BROWSER=PROGRAM"));
  }

  private static Optional<String> onPath() {
    return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
        .flatMap(folder -> NAMES.stream().map(name -> Path.of(folder, name)))
        .filter(Files::isExecutable)
        .map(Path::toString)
        .findFirst();
  }

  /** Returns the port on which the browser listens; the browser writes it to its profile. */
  private static int port(Process process, Path profile) throws IOException, InterruptedException {
    Path file = profile.resolve("DevToolsActivePort");
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (System.nanoTime() < end && process.isAlive()) {
      if (Files.exists(file) && !Files.readAllLines(file).isEmpty()) {
        return Integer.parseInt(Files.readAllLines(file).get(0));
      }
      Thread.sleep(50);
    }
    throw new IOException(
        "the browser did not start:\n" + Files.readString(profile.resolve("browser.log")));
  }

  /** Returns the address of the one page that is open. */
  private static URI page(int port) throws IOException, InterruptedException {
    URI list = URI.create("http://127.0.0.1:" + port + "/json/list");
    String targets =
        HttpClient.newHttpClient()
            .send(HttpRequest.newBuilder(list).build(), HttpResponse.BodyHandlers.ofString())
            .body();
    return Stream.of(JsonParser.parseString(targets).getAsJsonArray())
        .flatMap(array -> Stream.iterate(0, i -> i < array.size(), i -> i + 1).map(array::get))
        .map(target -> target.getAsJsonObject())
        .filter(target -> target.get("type").getAsString().equals("page"))
        .map(target -> URI.create(target.get("webSocketDebuggerUrl").getAsString()))
        .findFirst()
        .orElseThrow(() -> new IOException("the browser has no page: " + targets));
  }

  private WebSocket.Listener listener() {
    StringBuilder message = new StringBuilder();
    return new WebSocket.Listener() {
      @Override
      public CompletionStage<?> onText(WebSocket webSocket, CharSequence data, boolean last) {
        message.append(data);
        if (last) {
          take(JsonParser.parseString(message.toString()).getAsJsonObject());
          message.setLength(0);
        }
        webSocket.request(1);
        return null;
      }
    };
  }

  private void take(JsonObject message) {
    if (message.has("id")) {
      answers.remove(message.get("id").getAsInt()).complete(message);
    } else {
      events.add(message);
    }
  }

  /** Sends a command of the protocol and returns its result. */
  JsonObject send(String method, Map<String, ?> parameters) {
    int id = lastId.incrementAndGet();
    CompletableFuture<JsonObject> answer = new CompletableFuture<>();
    answers.put(id, answer);
    String text = new Gson().toJson(Map.of("id", id, "method", method, "params", parameters));
    socket.sendText(text, true).join();
    JsonObject message = answer.orTimeout(PATIENCE.toSeconds(), TimeUnit.SECONDS).join();
    if (message.has("error")) {
      throw new AssertionError(method + ": " + message.get("error"));
    }
    return message.getAsJsonObject("result");
  }

  /** Opens a page in a viewport, and discards the records of the last page. */
  void open(URI address, int width, int height, boolean isDark) throws InterruptedException {
    for (String domain : List.of("Page", "Runtime", "Log", "Network")) {
      send(domain + ".enable", Map.of());
    }
    send(
        "Emulation.setDeviceMetricsOverride",
        Map.of(
            "width", width,
            "height", height,
            "screenWidth", width,
            "screenHeight", height,
            "deviceScaleFactor", 1,
            "mobile", width < 500));
    Map<String, String> scheme =
        Map.of("name", "prefers-color-scheme", "value", isDark ? "dark" : "light");
    send("Emulation.setEmulatedMedia", Map.of("features", List.of(scheme)));
    events.clear();
    send("Page.navigate", Map.of("url", address.toString()));
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (named("Page.loadEventFired").isEmpty()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("the page did not load: " + address);
      }
      Thread.sleep(20);
    }
  }

  /**
   * Stops to record network requests, so that a page that is open for long takes no memory here.
   */
  void forgetRequests() {
    send("Network.disable", Map.of());
    events.removeIf(event -> event.get("method").getAsString().startsWith("Network."));
  }

  /** Returns a metric of the page, such as JSHeapUsedSize, after a garbage collection. */
  long metric(String name) {
    send("Performance.enable", Map.of());
    send("HeapProfiler.collectGarbage", Map.of());
    return send("Performance.getMetrics", Map.of()).getAsJsonArray("metrics").asList().stream()
        .map(JsonElement::getAsJsonObject)
        .filter(metric -> metric.get("name").getAsString().equals(name))
        .mapToLong(metric -> metric.get("value").getAsLong())
        .findAny()
        .orElseThrow();
  }

  /** Returns the resident memory of the processes that run pages, in bytes. */
  long rendererMemory() throws IOException {
    long sum = 0;
    for (ProcessHandle child : process.descendants().toList()) {
      Path line = Path.of("/proc", String.valueOf(child.pid()), "cmdline");
      if (Files.exists(line) && Files.readString(line).contains("--type=renderer")) {
        sum += MemoryInUse.resident(child.pid());
      }
    }
    return sum;
  }

  private List<JsonObject> named(String method) {
    return events.stream()
        .filter(event -> event.get("method").getAsString().equals(method))
        .map(event -> event.getAsJsonObject("params"))
        .toList();
  }

  /** Returns all console messages and exceptions. */
  List<String> complaints() {
    return Stream.of("Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded")
        .flatMap(method -> named(method).stream())
        .map(JsonObject::toString)
        .toList();
  }

  /** Returns the addresses that the page requested, without those inside the page. */
  List<String> requests() {
    return named("Network.requestWillBeSent").stream()
        .map(event -> event.getAsJsonObject("request").get("url").getAsString())
        .filter(url -> !url.startsWith("data:"))
        .toList();
  }

  /** Returns the value of a JavaScript expression in the page, as text. */
  String evaluate(String expression) {
    JsonObject result =
        send("Runtime.evaluate", Map.of("expression", expression, "returnByValue", true));
    if (result.has("exceptionDetails")) {
      throw new AssertionError(expression + ": " + result.get("exceptionDetails"));
    }
    return result.getAsJsonObject("result").get("value").getAsString();
  }

  /** Writes a picture of the whole page. */
  void photograph(Path file) throws IOException {
    JsonObject shot =
        send("Page.captureScreenshot", Map.of("format", "png", "captureBeyondViewport", true));
    Files.write(file, Base64.getDecoder().decode(shot.get("data").getAsString()));
  }

  @Override
  public void close() throws IOException {
    socket.abort();
    process.destroy();
    process.onExit().orTimeout(10, TimeUnit.SECONDS).exceptionally(late -> process).join();
    process.destroyForcibly();
    try (Stream<Path> files = Files.walk(profile)) {
      files.sorted((a, b) -> b.compareTo(a)).map(Path::toFile).forEach(File::delete);
    }
  }
}
