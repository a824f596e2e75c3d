package io.github.lumbre.examples;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.stage.thumbnail.Thumbnails;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/**
 * The example server as a process, by the command of the page: it is asked to stop, and killed. The
 * seconds under load are the system property lumbre.server.seconds.
 */
@Timeout(value = 15, unit = TimeUnit.MINUTES)
@DisabledOnOs(OS.WINDOWS)
class ThumbnailServerProcessTest {
  private static final int SECONDS = Integer.getInteger("lumbre.server.seconds", 9);
  private static final int CLIENTS = 32;

  /** Kills under load; each ends in a restart. */
  private static final int KILLS = Math.max(2, SECONDS / 20);

  private static final String MODEL = "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";
  private static final Map<String, Integer> BROKEN =
      Map.of("v 0 0 0\nf 1 2 99\n", 422, "v 0 0 0\n" + "f 1 1 1\n".repeat(1_200_000), 413);

  /** The right picture of the model. */
  private static byte[] expected;

  private final HttpClient client =
      HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
  private volatile Process server;
  private int port;

  @BeforeAll
  static void render() throws Exception {
    Limits patient = Limits.UPLOADS.withTime(Duration.ofMinutes(5));
    try (Thumbnails thumbnails = new Thumbnails(patient)) {
      expected = thumbnails.png("a.obj", MODEL.getBytes(StandardCharsets.US_ASCII), 64);
    }
  }

  @BeforeEach
  void start() throws Exception {
    start(0);
  }

  @AfterEach
  void end() {
    server.destroyForcibly();
  }

  /** Starts the server by the command in the container of the page, on this machine. */
  private void start(int at) throws IOException {
    String page = Files.readString(Path.of("../docs/servers.md"));
    String entry = "\nENTRYPOINT ";
    int from = page.indexOf(entry) + entry.length();
    String[] words =
        new Gson().fromJson(page.substring(from, page.indexOf("]\n", from) + 1), String[].class);
    List<String> command = new ArrayList<>(List.of(words));
    command.set(0, Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.replaceAll(
        word ->
            switch (word) {
              case "-XX:MaxRAMPercentage=75" -> "-Xmx512m";
              case "/app:/app/*" -> System.getProperty("java.class.path");
              case "8080" -> "" + at;
              case "0.0.0.0" -> "127.0.0.1";
              default -> word;
            });
    server = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    BufferedReader out = server.inputReader();
    String line = out.readLine();
    assertThat(line).startsWith("listening on port ");
    port = Integer.parseInt(line.substring(line.lastIndexOf(' ') + 1));
  }

  private HttpRequest.Builder request(String path) {
    return HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
        .timeout(Duration.ofMinutes(2));
  }

  private HttpResponse<byte[]> post(String model) throws IOException, InterruptedException {
    return client.send(
        request("/thumbnail/obj").POST(HttpRequest.BodyPublishers.ofString(model)).build(),
        HttpResponse.BodyHandlers.ofByteArray());
  }

  private int health() throws IOException, InterruptedException {
    return client
        .send(request("/health").build(), HttpResponse.BodyHandlers.discarding())
        .statusCode();
  }

  @Test
  void anAnswerThatRunsIsFinishedWhenTheServerIsAskedToStop() throws Exception {
    assertThat(health()).isEqualTo(200);
    assertThat(pictureWithin(60)).as("it has begun, so that the upload is read in time").isTrue();
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      send(
          socket,
          "POST /thumbnail/obj HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n"
              + ("Content-Length: " + MODEL.length() + "\r\n\r\n")
              + MODEL.substring(0, 20));
      Thread.sleep(1000); // until a thread of the server reads the upload
      server.destroy();
      while (health() == 200) {
        Thread.sleep(20);
      }
      assertThat(health()).isEqualTo(503);
      assertThat(post(MODEL).statusCode()).isEqualTo(503);
      send(socket, MODEL.substring(20));
      byte[] answer = socket.getInputStream().readAllBytes();
      String head = new String(answer, StandardCharsets.ISO_8859_1);
      assertThat(head).startsWith("HTTP/1.1 200 ");
      assertThat(head.substring(head.indexOf("\r\n\r\n") + 4).getBytes(StandardCharsets.ISO_8859_1))
          .isEqualTo(expected);
    }
    assertThat(server.waitFor(10, TimeUnit.SECONDS)).isTrue();
    assertThat(server.exitValue()).isEqualTo(143);
  }

  @Test
  void aServerWithoutWorkStopsAtOnce() throws Exception {
    long start = System.nanoTime();
    server.destroy();
    assertThat(server.waitFor(5, TimeUnit.SECONDS)).isTrue();
    assertThat(System.nanoTime() - start).isLessThan(5_000_000_000L);
    assertThat(server.exitValue()).isEqualTo(143);
  }

  private static void send(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
  }

  @Test
  void everyAnswerIsRightAnErrorOrAClosedConnection() throws Exception {
    ExecutorService clients = Executors.newFixedThreadPool(CLIENTS);
    List<Future<Map<String, Integer>>> counts = new ArrayList<>();
    Map<String, Integer> all = new TreeMap<>();
    try {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS);
      for (int i = 0; i < CLIENTS; i++) {
        int number = i;
        counts.add(clients.submit(() -> load(number, end)));
      }
      for (int kill = 0; kill < KILLS; kill++) {
        Thread.sleep(1000L * SECONDS / (KILLS + 1));
        server.destroyForcibly().waitFor();
        start(port);
        assertThat(pictureWithin(60)).as("a picture after restart " + kill).isTrue();
      }
      for (Future<Map<String, Integer>> count : counts) {
        count.get().forEach((outcome, n) -> all.merge(outcome, n, Integer::sum));
      }
    } finally {
      clients.shutdownNow();
    }
    System.out.printf("%d s, %d kills, answers: %s%n", SECONDS, KILLS, all);
    assertThat(all.keySet()).isSubsetOf("picture", "error", "busy", "slow", "closed");
    assertThat(all).containsKeys("picture", "closed");
  }

  private boolean pictureWithin(int seconds) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
    while (System.nanoTime() < end) {
      if (outcome(MODEL, 200).equals("picture")) {
        return true;
      }
    }
    return false;
  }

  /** Sends models until a time, and counts what became of them. */
  private Map<String, Integer> load(int number, long end) throws InterruptedException {
    List<String> broken = BROKEN.keySet().stream().sorted().toList();
    Map<String, Integer> counts = new TreeMap<>();
    for (int i = number; System.nanoTime() < end; i++) {
      String model = i % 5 == 0 ? broken.get(i / 5 % broken.size()) : MODEL;
      counts.merge(outcome(model, BROKEN.getOrDefault(model, 200)), 1, Integer::sum);
    }
    return counts;
  }

  private String outcome(String model, int status) throws InterruptedException {
    try {
      HttpResponse<byte[]> answer = post(model);
      if (answer.statusCode() == 503) {
        return "busy";
      }
      String text = new String(answer.body(), StandardCharsets.ISO_8859_1);
      if (answer.statusCode() == 413 && text.contains("rendered within")) {
        return "slow"; // the machine is so busy that the model took half of its time
      }
      if (answer.statusCode() != status) {
        return "status " + answer.statusCode() + " instead of " + status;
      }
      boolean isRight = status != 200 || Arrays.equals(answer.body(), expected);
      return status != 200 ? "error" : isRight ? "picture" : "wrong picture";
    } catch (HttpTimeoutException e) {
      return "no answer";
    } catch (IOException e) {
      Thread.sleep(50); // the server may be starting
      return "closed";
    }
  }
}
