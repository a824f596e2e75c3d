package io.github.lumbre.render.checkpoint;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.zip.CRC32C;

/**
 * A film with its header, as stored in a checkpoint file: header, pixels, checksum.
 * docs/film-format.md describes the bytes. The film is not copied.
 *
 * @param header the scene and settings of the film's samples, and which samples it has
 * @param film the sums of the samples
 */
public record FilmFile(FilmHeader header, Film film) {
  private static final int BUFFER_BYTES = 1 << 16;
  private static final int CHECKSUM_BYTES = 4;
  private static final int MAX_HEADER_BYTES = 1 << 24;

  public FilmFile {
    Objects.requireNonNull(header, "header");
    Objects.requireNonNull(film, "film");
    if (!header.layers().ofFilm().equals(film.layers())) {
      throw new IllegalArgumentException(
          "film: expected " + header.layers().ofFilm() + ", found " + film.layers());
    }
  }

  /**
   * Returns the film file of a running render.
   *
   * @param identity see {@link FilmHeader#identity(String, RenderSettings)}
   * @param film film of one render, whose numbers of samples become the header's only part
   * @param layers the film's layers
   * @param notes see {@link FilmHeader#notes}
   * @param statistics statistics of all samples of the film
   */
  public static FilmFile of(
      Map<String, String> identity,
      Film film,
      RecordedLayers layers,
      Map<String, String> notes,
      RenderStatistics statistics) {
    List<FilmPart> parts = List.of(FilmPart.of(film));
    return new FilmFile(
        new FilmHeader(identity, film.hasAlpha(), film.window(), layers, parts, statistics, notes),
        film);
  }

  /** Writes this film file to a reserved file, from its start. Does not commit the file. */
  void write(OutputFile output) throws IOException {
    output.restart();
    CRC32C checksum = new CRC32C();
    ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES);
    write(output, StandardCharsets.UTF_8.encode(HeaderText.of(header)), checksum);
    int pixels = (int) film.window().pixels();
    for (int pixel = 0; pixel < pixels; pixel++) {
      int bytes = film.encodedBytes(pixel);
      if (buffer.remaining() < bytes) {
        write(output, buffer.flip(), checksum);
        buffer = bytes > buffer.capacity() ? ByteBuffer.allocate(bytes) : buffer.clear();
      }
      film.encode(pixel, buffer);
    }
    write(output, buffer.flip(), checksum);
    output.write(littleEndian(CHECKSUM_BYTES).putInt((int) checksum.getValue()).flip());
  }

  private static void write(OutputFile output, ByteBuffer bytes, CRC32C checksum)
      throws IOException {
    checksum.update(bytes.duplicate());
    output.write(bytes);
  }

  /**
   * Reads a film from a file. The checksum is verified before the content is parsed.
   *
   * @throws FilmFormatException if the file is not a film, or is damaged
   * @throws IOException if the file cannot be read
   */
  public static FilmFile read(Path path) throws IOException {
    try (FileChannel channel = FileChannel.open(path)) {
      long end = verify(channel);
      channel.position(0);
      Input input = new Input(channel, end);
      FilmHeader header = input.header();
      return new FilmFile(header, input.film(header));
    }
  }

  /** Verifies the checksum, which covers all bytes before it. Returns its position. */
  private static long verify(FileChannel channel) throws IOException {
    requireMagic(channel);
    long end = channel.size() - CHECKSUM_BYTES;
    CRC32C checksum = new CRC32C();
    ByteBuffer buffer = littleEndian(BUFFER_BYTES);
    channel.position(0);
    long left = Math.max(0, end);
    while (left > 0) {
      buffer.clear().limit((int) Math.min(left, BUFFER_BYTES));
      int read = channel.read(buffer);
      if (read < 0) {
        throw new FilmFormatException("changed while it was read");
      }
      left -= read;
      checksum.update(buffer.flip());
    }
    buffer.clear().limit(CHECKSUM_BYTES);
    while (buffer.hasRemaining() && channel.read(buffer) >= 0) {
      continue;
    }
    if (buffer.hasRemaining() || buffer.flip().getInt() != (int) checksum.getValue()) {
      throw new FilmFormatException("is damaged: the checksum does not match the content");
    }
    return end;
  }

  /** Returns whether a file is a film of any format version, given its first bytes. */
  public static boolean startsIn(byte[] start) {
    return new String(start, StandardCharsets.ISO_8859_1).startsWith(HeaderText.MAGIC);
  }

  private static void requireMagic(FileChannel channel) throws IOException {
    ByteBuffer start = ByteBuffer.allocate(HeaderText.MAGIC.length());
    while (start.hasRemaining() && channel.read(start) >= 0) {
      continue;
    }
    if (!new String(start.array(), StandardCharsets.ISO_8859_1).equals(HeaderText.MAGIC)) {
      throw new FilmFormatException("is not a film, or is damaged");
    }
  }

  private static ByteBuffer littleEndian(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** The input before the checksum: header and pixels. */
  private static final class Input {
    private final FileChannel channel;
    private ByteBuffer buffer = ByteBuffer.allocate(BUFFER_BYTES).limit(0);
    private long left;

    Input(FileChannel channel, long bytes) {
      this.channel = channel;
      left = bytes;
    }

    /** Reads from the file until the buffer is full or nothing is left. */
    private void fill() throws IOException {
      buffer.compact().limit((int) Math.min(buffer.capacity(), buffer.position() + left));
      while (buffer.hasRemaining()) {
        int read = channel.read(buffer);
        if (read < 0) {
          throw new FilmFormatException("changed while it was read");
        }
        left -= read;
      }
      buffer.flip();
    }

    FilmHeader header() throws IOException {
      ByteArrayOutputStream text = new ByteArrayOutputStream();
      int last = 0;
      while (text.size() < MAX_HEADER_BYTES) {
        if (!buffer.hasRemaining()) {
          fill();
        }
        if (!buffer.hasRemaining()) {
          break;
        }
        int next = buffer.get();
        if (last == '\n' && next == '\n') {
          return parsed(text.toString(StandardCharsets.UTF_8));
        }
        text.write(next);
        last = next;
      }
      throw new FilmFormatException("is damaged: the header does not end in an empty line");
    }

    private static FilmHeader parsed(String text) throws FilmFormatException {
      String first = text.lines().findFirst().orElse("");
      if (HeaderText.VERSIONS.stream()
          .noneMatch(version -> first.equals(HeaderText.MAGIC + " " + version))) {
        throw new FilmFormatException(
            "expected '%s' with version %s, found '%s'"
                .formatted(HeaderText.MAGIC, String.join(" or ", HeaderText.VERSIONS), first));
      }
      return HeaderText.parse(text);
    }

    Film film(FilmHeader header) throws IOException {
      long pixels = header.window().pixels();
      if (left + buffer.remaining() < pixels) {
        throw new FilmFormatException("is damaged: it has fewer bytes than its window has pixels");
      }
      Film film = emptyFilm(header);
      for (int pixel = 0; pixel < pixels; pixel++) {
        if (buffer.remaining() < Film.MAX_PIXEL_BYTES && left > 0) {
          fill();
        }
        decode(film, pixel);
      }
      if (left + buffer.remaining() != 0) {
        throw new FilmFormatException("is damaged: there are extra bytes after the last pixel");
      }
      return film;
    }

    private static Film emptyFilm(FilmHeader header) throws FilmFormatException {
      int first = header.parts().stream().mapToInt(FilmPart::first).min().orElse(0);
      try {
        return header.newFilm(header.window(), first);
      } catch (ArithmeticException e) {
        throw new FilmFormatException("its layers are too large for its window");
      } catch (IllegalArgumentException e) {
        throw new FilmFormatException("is damaged: " + e.getMessage());
      }
    }

    /** Reads a pixel; those with many primitives may be longer than the buffer. */
    private void decode(Film film, int pixel) throws IOException {
      while (true) {
        int start = buffer.position();
        try {
          film.decode(pixel, buffer);
          return;
        } catch (BufferUnderflowException e) {
          if (left == 0) {
            throw new FilmFormatException(
                "pixel " + pixel + " cannot be read: the file ends early");
          }
          buffer.position(start);
          if (buffer.remaining() == buffer.capacity()) {
            buffer = ByteBuffer.allocate(Math.multiplyExact(2, buffer.capacity())).put(buffer);
            buffer.flip();
          }
          fill();
        } catch (IllegalArgumentException e) {
          throw new FilmFormatException("pixel " + pixel + " cannot be read: " + e.getMessage());
        }
      }
    }
  }
}
