package io.github.lumbre.examples;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * The example server under load: several clients send good and hostile models. The number of
 * requests is the system property lumbre.server.requests.
 */
@Timeout(value = 10, unit = TimeUnit.MINUTES)
class ThumbnailServerTest {
  private static final int REQUESTS = Integer.getInteger("lumbre.server.requests", 64);
  private static final int CLIENTS = 8;
  private static final int ROUNDS = 4;

  /** Heap that may be in use at the end of a round beyond the first; the JIT and caches fill it. */
  private static final long MAX_GROWTH = 24L << 20;

  private static final Limits LIMITS =
      Limits.UPLOADS
          .withBytes(1 << 20)
          .withTriangles(20_000)
          .withTexels(1 << 20)
          .withMemory(64 << 20)
          .withTime(Duration.ofSeconds(30));

  private record Upload(String ending, byte[] content, int status) {}

  private static Upload text(String ending, String content, int status) {
    return new Upload(ending, content.getBytes(StandardCharsets.US_ASCII), status);
  }

  private static byte[] stl(int triangles, int claimed) {
    ByteBuffer stl = ByteBuffer.allocate(84 + 50 * triangles).order(ByteOrder.LITTLE_ENDIAN);
    stl.putInt(80, claimed);
    for (int i = 0; i < triangles; i++) {
      for (int k = 0; k < 9; k++) {
        float corner = (i * 7 + k * 13) % 11 * .1f;
        stl.putFloat(84 + 50 * i + 12 + 4 * k, corner);
      }
    }
    return stl.array();
  }

  /** Good models and hostile ones. */
  private static Map<String, Upload> uploads() {
    String triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n";
    String ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            + "property float z\nelement face %s\nproperty list uchar int vertex_indices\n"
            + "end_header\n0 0 0\n1 0 0\n0 1 1\n3 0 1 2\n";
    byte[] huge = new byte[3 << 20];
    Arrays.fill(huge, (byte) '\n');
    Map<String, Upload> all = new LinkedHashMap<>();
    all.put("small stl", new Upload("stl", stl(12, 12), 200));
    all.put("larger stl", new Upload("stl", stl(2000, 2000), 200));
    all.put("obj", text("obj", triangle, 200));
    all.put("ply", text("ply", ply.formatted("1"), 200));
    all.put("too many bytes", new Upload("obj", huge, 413));
    all.put("too many triangles", text("obj", triangle + "f 1 2 3\n".repeat(30_000), 413));
    all.put("claims 4e9 triangles", new Upload("stl", stl(2, -1), 422));
    all.put("claims 1e9 faces", text("ply", ply.formatted("1000000000"), 413));
    all.put("numbers that are none", text("obj", "v a b c\nf 1 2 3\n", 422));
    all.put("vertices that are missing", text("obj", "v 0 0 0\nf 1 2 99\n", 422));
    all.put("not a number", text("obj", "v nan 0 0\nv 1e999 0 0\nf 1 2 1\n", 422));
    all.put(
        "other files",
        text(
            "gltf",
            "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
                + "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":"
                + "[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,"
                + "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,"
                + "\"byteLength\":36}],\"buffers\":[{\"byteLength\":36,\"uri\":\"../../etc/passwd\"}]}",
            422));
    all.put("deep JSON", text("gltf", "[".repeat(500_000), 413));
    all.put(
        "noise",
        new Upload("glb", "glTF\2\0\0\0\377noise".getBytes(StandardCharsets.ISO_8859_1), 422));
    all.put("nothing", new Upload("stl", new byte[0], 422));
    all.put("another format", text("exe", "MZ", 422));
    return all;
  }

  /**
   * Returns the least heap in use over two seconds: the server may still read the rest of refused
   * uploads, but what leaks stays.
   */
  private static long usedHeap() throws InterruptedException {
    long least = Long.MAX_VALUE;
    for (int i = 0; i < 10; i++) {
      System.gc();
      Thread.sleep(200);
      Runtime runtime = Runtime.getRuntime();
      least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
    }
    return least;
  }

  @Test
  void everyUploadIsAnsweredAndMemoryStaysFlat() throws Exception {
    Map<String, Upload> uploads = uploads();
    List<String> names = List.copyOf(uploads.keySet());
    Map<String, byte[]> answers = new ConcurrentHashMap<>();
    List<Double> seconds = Collections.synchronizedList(new ArrayList<>());
    List<Long> heap = new ArrayList<>();
    Map<Integer, Integer> statuses = new TreeMap<>();
    ExecutorService clients = Executors.newFixedThreadPool(CLIENTS);
    try (ThumbnailServer server = new ThumbnailServer(LIMITS)) {
      HttpClient client = HttpClient.newHttpClient();
      for (int round = 0; round < ROUNDS; round++) {
        List<Future<Integer>> sent = new ArrayList<>();
        for (int i = round * REQUESTS / ROUNDS; i < (round + 1) * REQUESTS / ROUNDS; i++) {
          String name = names.get(i % 2 == 0 ? i / 2 % 4 : 4 + i / 2 % (names.size() - 4));
          sent.add(
              clients.submit(() -> send(client, server.port(), name, uploads, answers, seconds)));
        }
        for (Future<Integer> answer : sent) {
          statuses.merge(answer.get(), 1, Integer::sum);
        }
        heap.add(usedHeap());
      }
    } finally {
      clients.shutdownNow();
    }
    report(seconds, heap, statuses);
    assertThat(statuses.values().stream().mapToInt(Integer::intValue).sum()).isEqualTo(REQUESTS);
    assertThat(heap.get(ROUNDS - 1) - heap.get(0)).isLessThan(MAX_GROWTH);
    assertThat(liveThreads()).as("threads of the server").isEmpty();
  }

  private static int send(
      HttpClient client,
      int port,
      String name,
      Map<String, Upload> uploads,
      Map<String, byte[]> answers,
      List<Double> seconds)
      throws IOException, InterruptedException {
    Upload upload = uploads.get(name);
    HttpRequest request =
        HttpRequest.newBuilder(
                URI.create("http://127.0.0.1:" + port + "/thumbnail/" + upload.ending()))
            .timeout(java.time.Duration.ofMinutes(2))
            .POST(HttpRequest.BodyPublishers.ofByteArray(upload.content()))
            .build();
    long start = System.nanoTime();
    HttpResponse<byte[]> response = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
    seconds.add((System.nanoTime() - start) * 1e-9);
    String text = new String(response.body(), StandardCharsets.ISO_8859_1);
    assertThat(response.statusCode()).as(name + ": " + text).isEqualTo(upload.status());
    if (upload.status() == 200) {
      // All answers to one model are the same picture.
      byte[] first = answers.putIfAbsent(name, response.body());
      assertThat(response.body()).isEqualTo(first == null ? response.body() : first);
    }
    return response.statusCode();
  }

  private static List<String> liveThreads() throws InterruptedException {
    for (int wait = 0; wait < 20; wait++) {
      if (poolThreads().isEmpty()) {
        return List.of();
      }
      Thread.sleep(100);
    }
    return poolThreads();
  }

  private static List<String> poolThreads() {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("pool-") || name.startsWith("lumbre-"))
        .toList();
  }

  private static void report(
      List<Double> seconds, List<Long> heap, Map<Integer, Integer> statuses) {
    double[] sorted = seconds.stream().mapToDouble(s -> s).sorted().toArray();
    System.out.printf("requests by status: %s%n", statuses);
    for (double share : new double[] {.5, .9, .99, 1}) {
      int index = (int) Math.ceil(share * sorted.length) - 1;
      System.out.printf("latency %.0f %%: %.3f s%n", 100 * share, sorted[index]);
    }
    System.out.printf(
        "heap in use after each quarter: %s MiB%n", heap.stream().map(b -> b >> 20).toList());
  }

  @Test
  void answersStateWhatTheyAre() throws Exception {
    try (ThumbnailServer server = new ThumbnailServer(LIMITS)) {
      HttpClient client = HttpClient.newHttpClient();
      for (String path : List.of("/health", "/thumbnail/obj")) {
        HttpRequest request =
            HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + server.port() + path))
                .POST(HttpRequest.BodyPublishers.ofString("no model"))
                .build();
        HttpResponse<String> answer = client.send(request, HttpResponse.BodyHandlers.ofString());
        assertThat(answer.headers().firstValue("Content-Type"))
            .as(path)
            .hasValue("text/plain; charset=utf-8");
      }
    }
  }

  /** More uploads stall than there are permits for models. */
  @Test
  void stalledUploadsStopNobody() throws Exception {
    List<Socket> stalled = new ArrayList<>();
    try (ThumbnailServer server = new ThumbnailServer(LIMITS)) {
      int permits = 2 * Runtime.getRuntime().availableProcessors();
      for (int i = 0; i < permits + 4; i++) {
        stalled.add(upload(server, "Content-Length: 1000\r\n\r\nv 0 0"));
      }
      long start = System.nanoTime();
      HttpRequest request =
          HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + server.port() + "/thumbnail/stl"))
              .POST(HttpRequest.BodyPublishers.ofByteArray(stl(12, 12)))
              .build();
      HttpResponse<byte[]> answer =
          HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofByteArray());
      assertThat(answer.statusCode()).isEqualTo(200);
      assertThat(System.nanoTime() - start).isLessThan(TimeUnit.SECONDS.toNanos(8));
      // The stalled ones are closed after their time.
      for (Socket socket : stalled) {
        socket.setSoTimeout(30_000);
        assertThat(endsOf(socket)).isTrue();
      }
    } finally {
      for (Socket socket : stalled) {
        socket.close();
      }
    }
  }

  @Test
  void anEndlessUploadIsCut() throws Exception {
    try (ThumbnailServer server = new ThumbnailServer(LIMITS);
        Socket socket = upload(server, "Transfer-Encoding: chunked\r\n\r\n")) {
      byte[] chunk =
          ("10000\r\n" + "v 0 0 0\n".repeat(8192) + "\r\n").getBytes(StandardCharsets.US_ASCII);
      long most = 64L * LIMITS.bytes();
      long sent = 0;
      try {
        while (sent < most) {
          socket.getOutputStream().write(chunk);
          sent += chunk.length;
        }
      } catch (IOException e) {
        // The server has closed the connection.
      }
      assertThat(sent).isLessThan(most);
    }
  }

  private static Socket upload(ThumbnailServer server, String rest) throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    String head = "POST /thumbnail/obj HTTP/1.1\r\nHost: localhost\r\n" + rest;
    socket.getOutputStream().write(head.getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  /** Returns whether the server closes a connection. */
  private static boolean endsOf(Socket socket) throws IOException {
    try {
      return socket.getInputStream().readAllBytes().length >= 0;
    } catch (SocketTimeoutException e) {
      return false;
    } catch (SocketException e) {
      return true;
    }
  }
}
