package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.file.Disk;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.render.RenderStatistics.RejectedSample;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.zip.CRC32C;

/**
 * Creates films with pseudorandom samples, which are a function of the pixel and the sample number.
 */
public final class FilmFixture {
  public static final Crop FRAME = new Crop(0, 0, 12, 7);

  static final Map<String, String> IDENTITY =
      FilmHeader.identity(
          "ab12", new RenderSettings.Builder().size(FRAME.width(), FRAME.height()).build());

  static final Map<String, String> NOTES = Map.of("scene", "a\\b\nc: d\u00e4");

  private FilmFixture() {}

  /** The number of samples of each pixel. */
  public interface Counts {
    int of(int x, int y);
  }

  public static FilmFile file(Crop window, int first, Counts counts) {
    Film film = new Film(window, true, first);
    RenderStatistics faults = RenderStatistics.ZERO;
    for (int y = window.y(); y < window.y() + window.height(); y++) {
      for (int x = window.x(); x < window.x() + window.width(); x++) {
        for (int sample = first; sample < first + counts.of(x, y); sample++) {
          add(film, x, y, sample);
          faults = faults.plus(faults(x, y, sample));
        }
      }
    }
    return FilmFile.of(IDENTITY, film, RecordedLayers.NONE, NOTES, faults);
  }

  /** Returns the faults of a sample: some are rejected, some saturated. */
  private static RenderStatistics faults(int x, int y, int sample) {
    int kind = (7 * x + 5 * y + 3 * sample) % 11;
    return kind == 0
        ? RenderStatistics.ofFaults(1, List.of(new RejectedSample(x, y, sample)), 0)
        : RenderStatistics.ofFaults(0, List.of(), kind == 1 ? 2 : 0);
  }

  private static void add(Film film, int x, int y, int sample) {
    Random random = new Random(31L * (31 * x + y) + sample);
    ByteBuffer pixel = ByteBuffer.allocate(Film.MAX_PIXEL_BYTES);
    pixel.put((byte) 1).put((byte) random.nextInt(2));
    for (int channel = 0; channel < 3; channel++) {
      pixel.put((byte) random.nextInt(128)).putLong(random.nextLong());
    }
    pixel.putLong(0);
    Film one = new Film(new Crop(x, y, 1, 1), true, sample);
    one.decode(0, pixel.flip());
    film.addAll(one);
  }

  /** Returns the encoded contents of all pixels, for comparison. */
  public static byte[] pixels(Film film) {
    int pixels = film.window().width() * film.window().height();
    ByteBuffer bytes =
        ByteBuffer.allocate(IntStream.range(0, pixels).map(film::encodedBytes).sum());
    for (int pixel = 0; pixel < pixels; pixel++) {
      film.encode(pixel, bytes);
    }
    return Arrays.copyOf(bytes.array(), bytes.position());
  }

  /** Returns what pixels hold, but for the halves, which not every order of additions keeps. */
  static byte[] sums(Film film) {
    int pixels = film.window().width() * film.window().height();
    ByteBuffer bytes = ByteBuffer.allocate(pixels * Film.MAX_PIXEL_BYTES);
    for (int pixel = 0; pixel < pixels; pixel++) {
      int before = bytes.position();
      film.encode(pixel, bytes);
      bytes.position(Math.max(before + 1, bytes.position() - Long.BYTES));
    }
    return Arrays.copyOf(bytes.array(), bytes.position());
  }

  /** A disk that fails at one of its steps. */
  static final class FailingDisk implements Disk {
    /** Simulates the kill of the program. */
    static final class Killed extends Error {
      private static final long serialVersionUID = 1;
    }

    private final boolean kills;
    private final int chunk;
    private int left;

    /**
     * @param steps the number of steps that succeed
     * @param kills whether the failing step kills the program, or throws an exception
     * @param chunk the maximum number of bytes that a step writes
     */
    FailingDisk(int steps, boolean kills, int chunk) {
      left = steps;
      this.kills = kills;
      this.chunk = chunk;
    }

    /** Returns a disk that never fails and does not sync. */
    static FailingDisk never() {
      return new FailingDisk(Integer.MAX_VALUE, false, Integer.MAX_VALUE);
    }

    boolean hasFailed() {
      return left < 0;
    }

    private void step() throws IOException {
      left--;
      if (left == -1 || kills && left < 0) {
        if (kills) {
          throw new Killed();
        }
        throw new IOException("No space left on device");
      }
    }

    @Override
    public void write(FileChannel channel, ByteBuffer buffer) throws IOException {
      int size = Math.min(chunk, buffer.remaining());
      ByteBuffer part = buffer.slice().limit(size);
      if (left == 0) {
        // The failing step writes half of its bytes.
        channel.write(part.limit(size / 2));
      }
      step();
      channel.write(part);
      buffer.position(buffer.position() + size);
    }

    @Override
    public void force(FileChannel channel) throws IOException {
      step();
    }

    @Override
    public void forceDirectory(Path directory) {}

    @Override
    public void move(Path from, Path to) throws IOException {
      step();
      Disk.super.move(from, to);
    }
  }

  /** Returns a file's content before its checksum. */
  static byte[] content(Path path) throws IOException {
    byte[] whole = Files.readAllBytes(path);
    return Arrays.copyOf(whole, whole.length - Integer.BYTES);
  }

  /** Writes a file with this content and the checksum of it. */
  static void writeSealed(Path path, byte[] content) throws IOException {
    CRC32C checksum = new CRC32C();
    checksum.update(content);
    ByteBuffer bytes = ByteBuffer.allocate(content.length + Integer.BYTES);
    bytes.order(ByteOrder.LITTLE_ENDIAN).put(content).putInt((int) checksum.getValue());
    Files.write(path, bytes.array());
  }

  /** Checks that a file with this content and the checksum of it is refused. */
  static void assertRefused(Path path, byte[] content, String reason) throws IOException {
    writeSealed(path, content);
    assertThatThrownBy(() -> FilmFile.read(path))
        .isInstanceOf(FilmFormatException.class)
        .hasMessageContaining(reason);
  }

  static void assertRefused(Path path, String content, String reason) throws IOException {
    assertRefused(path, content.getBytes(StandardCharsets.ISO_8859_1), reason);
  }
}
