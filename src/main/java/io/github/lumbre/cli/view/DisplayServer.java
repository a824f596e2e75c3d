package io.github.lumbre.cli.view;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.preview.Preview;
import io.github.lumbre.preview.PreviewListener;
import io.github.lumbre.scene.Layer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * Sends previews to an image viewer that speaks tev's protocol. A thread of its own sends, always
 * the latest preview; the render never waits for the viewer. If the viewer cannot be reached,
 * closes the connection, or takes nothing for some time, a warning is printed once, and the thread
 * tries to connect again from time to time.
 */
public final class DisplayServer implements PreviewListener, AutoCloseable {
  /** The default port of tev. */
  public static final int DEFAULT_PORT = 14158;

  /** The largest number of values in a packet. */
  private static final int PACKET_VALUES = 1 << 18;

  private static final int LOOK_MILLIS = 100;

  /**
   * How long the viewer may take.
   *
   * @param connect to accept the connection
   * @param packet to take one packet
   * @param end to take the last preview, after the render
   * @param pause until the next attempt to connect
   */
  record Patience(Duration connect, Duration packet, Duration end, Duration pause) {
    static final Patience USUAL =
        new Patience(
            Duration.ofSeconds(3),
            Duration.ofSeconds(10),
            Duration.ofSeconds(20),
            Duration.ofSeconds(5));
  }

  private final InetSocketAddress address;
  private final String name;
  private final Consumer<String> warnings;
  private final Patience patience;
  private final Thread thread = new Thread(this::run, "lumbre-display");
  private Optional<Preview> next = Optional.empty();
  private Optional<Socket> socket = Optional.empty();
  private long packetStart;
  private boolean isSending;
  private boolean isEnding;
  private boolean isAway;
  private boolean hasWarned;

  /** Whether the viewer has received nothing since it was connected. */
  private boolean isNew;

  private long costNanos;

  /** The size and the channels of the viewer's image; they belong to the thread. */
  private String created = "";

  private DisplayServer(
      InetSocketAddress address, String name, Consumer<String> warnings, Patience patience) {
    this.address = address;
    this.name = name;
    this.warnings = warnings;
    this.patience = patience;
  }

  /**
   * Starts to connect to a viewer.
   *
   * @param address of the viewer; its name is looked up by the thread that sends
   * @param name of the image in the viewer
   * @param warnings receives at most one line
   */
  public static DisplayServer start(
      InetSocketAddress address, String name, Consumer<String> warnings) {
    return start(address, name, warnings, Patience.USUAL);
  }

  static DisplayServer start(
      InetSocketAddress address, String name, Consumer<String> warnings, Patience patience) {
    DisplayServer server = new DisplayServer(address, name, warnings, patience);
    server.thread.setDaemon(true);
    server.thread.start();
    return server;
  }

  @Override
  public synchronized void show(Preview preview) {
    if (!isAway) {
      next = Optional.of(preview);
      notifyAll();
    }
  }

  /** Returns whether the viewer is there and has taken the last preview. */
  @Override
  public synchronized boolean isWatching() {
    if (isSending && System.nanoTime() - packetStart > patience.packet().toNanos()) {
      fail("takes nothing for " + patience.packet().toSeconds() + " s");
    }
    return !isAway && (isEnding || next.isEmpty() && !isSending);
  }

  /** Returns whether the viewer was connected and has received nothing yet. */
  @Override
  public synchronized boolean isUrgent() {
    return isNew && next.isEmpty();
  }

  /** Returns all layers: those that the render records are shown. */
  @Override
  public Set<Layer> layers() {
    return Layer.setOf(Layer.values());
  }

  @Override
  public synchronized double secondsElsewhere() {
    double seconds = costNanos * 1e-9 / Runtime.getRuntime().availableProcessors();
    costNanos = 0;
    return seconds;
  }

  /** Announces the last preview, which is shown even if the viewer is still busy. */
  public synchronized void end() {
    isEnding = true;
  }

  private void run() {
    try {
      do {
        try (Socket connected = new Socket()) {
          sendOver(connected);
        } catch (IOException e) {
          fail(String.valueOf(e.getMessage()));
        }
      } while (isToRetry());
    } catch (InterruptedException e) {
      // The program ends.
      fail("stopped");
    }
  }

  private void sendOver(Socket connected) throws IOException, InterruptedException {
    synchronized (this) {
      socket = Optional.of(connected);
    }
    InetSocketAddress resolved = new InetSocketAddress(address.getHostString(), address.getPort());
    if (resolved.isUnresolved()) {
      throw new IOException("unknown host");
    }
    connected.connect(resolved, (int) patience.connect().toMillis());
    created = "";
    synchronized (this) {
      isAway = false;
      isNew = true;
    }
    for (Optional<Preview> preview = take(); preview.isPresent(); preview = take()) {
      send(preview.get(), connected.getOutputStream());
      done();
    }
  }

  /** Waits before the next attempt to connect. Returns whether to make one. */
  private synchronized boolean isToRetry() throws InterruptedException {
    long end = System.nanoTime() + patience.pause().toNanos();
    while (!isEnding && System.nanoTime() < end) {
      wait(LOOK_MILLIS);
    }
    return !isEnding;
  }

  private synchronized Optional<Preview> take() throws InterruptedException {
    while (next.isEmpty() && !isEnding && !isAway) {
      wait();
    }
    Optional<Preview> taken = next;
    next = Optional.empty();
    isSending = taken.isPresent();
    isNew &= taken.isEmpty();
    packetStart = System.nanoTime();
    return taken;
  }

  private synchronized void done() {
    isSending = false;
    notifyAll();
  }

  private synchronized void fail(String reason) {
    isAway = true;
    isNew = false;
    next = Optional.empty();
    isSending = false;
    if (!hasWarned) {
      hasWarned = true;
      warnings.accept(
          "warning: --display-server: %s:%d: %s; the render continues without it until it is back"
              .formatted(address.getHostString(), address.getPort(), reason));
    }
    try {
      // This also ends a write that the viewer does not read.
      if (socket.isPresent()) {
        socket.get().close();
      }
    } catch (IOException e) {
      // It is not used any more.
      socket = Optional.empty();
    }
    notifyAll();
  }

  private void send(Preview preview, OutputStream out) throws IOException {
    Image image = preview.image();
    List<ImageLayer> layers = new ArrayList<>(List.of(picture(image)));
    layers.addAll(preview.layers());
    List<String> channels = layers.stream().flatMap(layer -> names(layer).stream()).toList();
    String shape = image.width() + "x" + image.height() + channels;
    if (!shape.equals(created)) {
      write(out, TevPackets.create(name, image.width(), image.height(), channels));
      created = shape;
    }
    for (ImageLayer layer : layers) {
      int inRow = layer.width() * layer.channels().size();
      int most = Math.max(1, PACKET_VALUES / inRow);
      for (int y = 0; y < layer.height(); y += most) {
        int rows = Math.min(most, layer.height() - y);
        write(out, TevPackets.update(name, layer.width(), names(layer), y, rows, layer.values()));
      }
    }
    out.flush();
  }

  private void write(OutputStream out, byte[] packet) throws IOException {
    synchronized (this) {
      packetStart = System.nanoTime();
    }
    out.write(packet);
    synchronized (this) {
      costNanos += System.nanoTime() - packetStart;
    }
  }

  /** Returns the picture as a layer; colors are multiplied by alpha, as in OpenEXR files. */
  private static ImageLayer picture(Image image) {
    int width = image.width();
    int height = image.height();
    if (!image.hasAlpha()) {
      return new ImageLayer(
          "", List.of("R", "G", "B"), ImageLayer.Precision.FLOAT, width, height, image.rgb());
    }
    float[] values = new float[4 * width * height];
    for (int i = 0; i < width * height; i++) {
      float alpha = image.alpha(i % width, i / width);
      for (int c = 0; c < 3; c++) {
        values[4 * i + c] = alpha * image.rgb()[3 * i + c];
      }
      values[4 * i + 3] = alpha;
    }
    List<String> channels = List.of("R", "G", "B", "A");
    return new ImageLayer("", channels, ImageLayer.Precision.FLOAT, width, height, values);
  }

  private static List<String> names(ImageLayer layer) {
    String prefix = layer.name().isEmpty() ? "" : layer.name() + ".";
    return layer.channels().stream().map(prefix::concat).toList();
  }

  /** Waits until the last preview is sent, but not long, and closes the connection. */
  @Override
  public void close() {
    long end = System.nanoTime() + patience.end().toNanos();
    try {
      synchronized (this) {
        isEnding = true;
        notifyAll();
        while (!isAway && (isSending || next.isPresent()) && System.nanoTime() < end) {
          wait(LOOK_MILLIS);
          isWatching();
        }
        if (isSending || next.isPresent()) {
          fail("takes the last picture too slowly");
        }
      }
      thread.join(TimeUnit.SECONDS.toMillis(1));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
