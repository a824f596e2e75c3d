package io.github.lumbre.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.Outcome;
import io.github.lumbre.cli.TinyScene;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.LinearReader;
import io.github.lumbre.preview.Preview;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What a display server receives, and what happens if it does not take it. */
@Timeout(120)
class DisplayServerTest {
  private static final DisplayServer.Patience SHORT =
      new DisplayServer.Patience(
          Duration.ofSeconds(2),
          Duration.ofSeconds(1),
          Duration.ofSeconds(4),
          Duration.ofMillis(100));

  @TempDir private Path directory;
  private final List<String> warnings = new CopyOnWriteArrayList<>();

  /** An image of a viewer: the values of each channel. */
  private static final class Viewer {
    private final Map<String, float[]> channels = new TreeMap<>();
    private int width;
    private int height;
    private int creations;

    /** Reads packets until the connection ends. */
    static CompletableFuture<Viewer> on(ServerSocket server) {
      return CompletableFuture.supplyAsync(
          () -> {
            Viewer viewer = new Viewer();
            try (Socket socket = server.accept();
                DataInputStream in = new DataInputStream(socket.getInputStream())) {
              while (true) {
                int length = Integer.reverseBytes(in.readInt());
                ByteBuffer packet = ByteBuffer.wrap(in.readNBytes(length - 4));
                assertThat(packet.remaining()).isEqualTo(length - 4);
                viewer.take(packet.order(ByteOrder.LITTLE_ENDIAN));
              }
            } catch (EOFException e) {
              return viewer;
            } catch (IOException e) {
              throw new AssertionError(e);
            }
          });
    }

    private void take(ByteBuffer in) {
      int type = in.get();
      in.get(); // focus
      assertThat(text(in)).isEqualTo("tiny.json");
      if (type == 4) {
        creations++;
        width = in.getInt();
        height = in.getInt();
        channels.clear();
        int count = in.getInt();
        IntStream.range(0, count).forEach(i -> channels.put(text(in), new float[width * height]));
      } else {
        assertThat(type).isEqualTo(6);
        update(in);
      }
    }

    private void update(ByteBuffer in) {
      int count = in.getInt();
      List<String> names = IntStream.range(0, count).mapToObj(i -> text(in)).toList();
      int x = in.getInt();
      int y = in.getInt();
      int columns = in.getInt();
      int rows = in.getInt();
      long[] offsets = IntStream.range(0, count).mapToLong(i -> in.getLong()).toArray();
      long[] strides = IntStream.range(0, count).mapToLong(i -> in.getLong()).toArray();
      float[] values = new float[in.remaining() / 4];
      in.asFloatBuffer().get(values);
      assertThat(values).hasSize(count * columns * rows);
      for (int i = 0; i < count; i++) {
        float[] channel = channels.get(names.get(i));
        for (int pixel = 0; pixel < columns * rows; pixel++) {
          channel[(y + pixel / columns) * width + x + pixel % columns] =
              values[(int) (offsets[i] + pixel * strides[i])];
        }
      }
    }

    private static String text(ByteBuffer in) {
      StringBuilder bytes = new StringBuilder();
      for (byte b = in.get(); b != 0; b = in.get()) {
        bytes.append((char) (b & 0xff));
      }
      byte[] raw = bytes.toString().getBytes(StandardCharsets.ISO_8859_1);
      return new String(raw, StandardCharsets.UTF_8);
    }
  }

  private static ServerSocket server() throws IOException {
    return new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"));
  }

  private static InetSocketAddress address(ServerSocket server) {
    return InetSocketAddress.createUnresolved("127.0.0.1", server.getLocalPort());
  }

  private static Preview preview(int width, int height, float value) {
    float[] rgb = new float[3 * width * height];
    Arrays.fill(rgb, value);
    Image image = new Image(width, height, rgb, new float[0]);
    return new Preview(image, List.of(), 1, 1, true, Optional.empty(), Map.of());
  }

  /**
   * The packets of PyPI's tevclient 1.0.4 for the same pictures: {@code packet.create_image("box
   * é.json", 2, 2, ["R", "G", "B", "normal.X"])} and {@code packet.update_image}.
   */
  @Test
  void packetsAreThoseOfTevclient() {
    String name = "box é.json";
    assertThat(hex(TevPackets.create(name, 2, 2, List.of("R", "G", "B", "normal.X"))))
        .isEqualTo(
            "2d0000000401626f7820c3a92e6a736f6e000200000002000000040000005200470042006e6f726d616c2e"
                + "5800");
    float[] rgb = {.5f, 1, 2, 3, .25f, 0, 1e-3f, 65504, -1, 7, 8, 9};
    assertThat(hex(TevPackets.update(name, 2, List.of("R", "G", "B"), 0, 2, rgb)))
        .isEqualTo(
            "8c0000000600626f7820c3a92e6a736f6e0003000000520047004200000000000000000002000000020000"
                + "000000000000000000010000000000000002000000000000000300000000000000030000000000000003"
                + "000000000000000000003f0000803f00000040000040400000803e000000006f12833a00e07f47000080"
                + "bf0000e0400000004100001041");
    float[] depth = new float[14];
    System.arraycopy(new float[] {.5f, 1, 2, 4}, 0, depth, 10, 4);
    assertThat(hex(TevPackets.update(name, 2, List.of("depth.Z"), 5, 2, depth)))
        .isEqualTo(
            "4e0000000600626f7820c3a92e6a736f6e000100000064657074682e5a00000000000500000002000000"
                + "02000000000000000000000001000000000000000000003f0000803f0000004000008040");
  }

  private static String hex(byte[] bytes) {
    return HexFormat.of().formatHex(bytes);
  }

  @Test
  void renderAppearsWithItsLayers() throws Exception {
    Path scene = TinyScene.write(directory, TinyScene.JSON);
    Path exr = directory.resolve("a.exr");
    try (ServerSocket server = server()) {
      CompletableFuture<Viewer> viewer = Viewer.on(server);
      Outcome outcome =
          Outcome.of(
              "render",
              scene + "",
              "-o",
              exr + "",
              "--layers",
              "normal,depth,variance",
              "-s",
              "8",
              "--display-server",
              "127.0.0.1:" + server.getLocalPort());
      assertThat(outcome.exitCode()).as(outcome.err()).isZero();
      assertThat(outcome.err()).doesNotContain("warning: --display");
      Viewer seen = viewer.get(30, TimeUnit.SECONDS);
      float[] rgb = LinearReader.read(exr).rgb();
      for (int c = 0; c < 3; c++) {
        float[] channel = seen.channels.get("RGB".substring(c, c + 1));
        for (int i = 0; i < channel.length; i++) {
          assertThat(channel[i]).isEqualTo(rgb[3 * i + c]);
        }
      }
      LayeredImage file = LayeredImage.read(exr);
      ImageLayer depth = file.layer("depth").orElseThrow();
      assertThat(seen.channels.get("depth.Z")).isEqualTo(depth.values());
      assertThat(seen.channels).containsKeys("normal.X", "normal.Y", "normal.Z", "variance.R");
      assertThat(seen.creations).isEqualTo(1);
    }
  }

  @Test
  void absentServerIsReportedOnce() throws Exception {
    Path scene = TinyScene.write(directory, TinyScene.JSON);
    int port;
    try (ServerSocket server = server()) {
      port = server.getLocalPort();
    }
    Outcome outcome =
        Outcome.of(
            "render",
            scene + "",
            "-o",
            directory + "/b.png",
            "--display-server",
            "127.0.0.1:" + port);
    assertThat(outcome.exitCode()).isZero();
    assertThat(outcome.err().lines().filter(line -> line.contains("--display-server")))
        .hasSize(1)
        .first()
        .asString()
        .contains("127.0.0.1:" + port, "the render continues");
    assertThat(directory.resolve("b.png")).exists();
  }

  @Test
  void hangingServerIsGivenUp() throws Exception {
    try (ServerSocket server = server()) {
      DisplayServer display =
          DisplayServer.start(address(server), "tiny.json", warnings::add, SHORT);
      try (Socket silent = server.accept()) {
        assertThat(silent.isConnected()).isTrue();
        long start = System.nanoTime();
        display.show(preview(2000, 2000, 1)); // more than any buffer holds
        Thread.sleep(200);
        assertThat(display.isWatching()).isFalse();
        assertThat(System.nanoTime() - start).isLessThan(1_000_000_000L);
        display.close();
        assertThat(warnings).hasSize(1).first().asString().contains("takes nothing");
        assertThat(display.isWatching()).isFalse();
      }
    }
  }

  @Test
  void vanishingServerIsReportedOnce() throws Exception {
    try (ServerSocket server = server()) {
      DisplayServer display =
          DisplayServer.start(address(server), "tiny.json", warnings::add, SHORT);
      server.accept().close();
      for (int i = 0; i < 50 && warnings.isEmpty(); i++) {
        display.show(preview(500, 500, i));
        Thread.sleep(50);
      }
      display.show(preview(500, 500, 1));
      display.close();
      assertThat(warnings).hasSize(1);
      assertThat(display.isWatching()).isFalse();
    }
  }

  @Test
  void viewerThatComesBackReceivesThePicture() throws Exception {
    int port;
    try (ServerSocket first = server()) {
      port = first.getLocalPort();
    }
    InetSocketAddress address = InetSocketAddress.createUnresolved("127.0.0.1", port);
    DisplayServer display = DisplayServer.start(address, "tiny.json", warnings::add, SHORT);
    awaitUrgent(display, false);
    try (ServerSocket server = new ServerSocket(port, 1, InetAddress.getByName("127.0.0.1"))) {
      awaitUrgent(display, true);
      try (Socket vanishing = server.accept()) {
        display.show(preview(5, 4, 0));
        assertThat(vanishing.getInputStream().read()).isNotNegative();
      }
      CompletableFuture<Viewer> viewer = Viewer.on(server);
      for (int i = 0; i < 40; i++) {
        display.show(preview(5, 4, 1));
        Thread.sleep(50);
      }
      display.show(preview(5, 4, 2));
      display.close();
      Viewer seen = viewer.get(30, TimeUnit.SECONDS);
      assertThat(seen.creations).isEqualTo(1);
      assertThat(seen.channels.get("R")).containsOnly(2);
    }
    assertThat(warnings).hasSize(1);
  }

  private void awaitUrgent(DisplayServer display, boolean isUrgent) throws InterruptedException {
    for (int i = 0; i < 300 && (display.isUrgent() != isUrgent || warnings.isEmpty()); i++) {
      Thread.sleep(50);
    }
    assertThat(display.isUrgent()).isEqualTo(isUrgent);
  }

  @Test
  void resumedRenderAppears() throws Exception {
    Path scene = TinyScene.write(directory, TinyScene.JSON);
    Path film = directory.resolve("a.film");
    Path png = directory.resolve("a.png");
    Outcome.of("render", scene + "", "-o", png + "", "--checkpoint", film + "", "-s", "2");
    try (ServerSocket server = server()) {
      CompletableFuture<Viewer> viewer = Viewer.on(server);
      String address = "127.0.0.1:" + server.getLocalPort();
      Path exr = directory.resolve("a.exr");
      Outcome outcome =
          Outcome.of("resume", film + "", "-s", "8", "-o", exr + "", "--display-server", address);
      assertThat(outcome.exitCode()).as(outcome.err()).isZero();
      Viewer seen = viewer.get(30, TimeUnit.SECONDS);
      float[] rgb = LinearReader.read(exr).rgb();
      float[] green = seen.channels.get("G");
      for (int i = 0; i < green.length; i++) {
        assertThat(green[i]).isEqualTo(rgb[3 * i + 1]);
      }
    }
  }

  @Test
  void latestPreviewWinsAndSizesMayChange() throws Exception {
    try (ServerSocket server = server()) {
      CompletableFuture<Viewer> viewer = Viewer.on(server);
      DisplayServer display =
          DisplayServer.start(address(server), "tiny.json", warnings::add, SHORT);
      List<Preview> all = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        all.add(preview(30 + i % 2, 7, i));
      }
      all.forEach(display::show);
      display.close();
      Viewer seen = viewer.get(30, TimeUnit.SECONDS);
      assertThat(seen.width).isEqualTo(31);
      assertThat(seen.channels.get("G")).containsOnly(19);
      assertThat(warnings).isEmpty();
    }
  }

  @Test
  void wrongAddressesAreRefused() {
    for (String wrong : new String[] {"", ":1", "host:", "host:x", "host:0", "host:70000"}) {
      Outcome.of("render", "scene.json", "--display-server", wrong)
          .assertFailed(2, "--display-server");
    }
  }
}
