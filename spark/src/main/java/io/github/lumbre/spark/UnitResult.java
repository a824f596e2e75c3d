package io.github.lumbre.spark;

import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmLayers;
import io.github.lumbre.render.RenderStatistics;
import java.io.ByteArrayOutputStream;
import java.io.Serializable;
import java.nio.ByteBuffer;
import java.util.stream.IntStream;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * The film of a finished unit, compressed.
 *
 * @param filmBytes size of the film before compression
 * @param seconds that the unit took on one core
 */
record UnitResult(
    WorkUnit unit,
    boolean hasAlpha,
    byte[] film,
    int filmBytes,
    RenderStatistics statistics,
    double seconds)
    implements Serializable {
  /** Returns the result of a unit whose samples are in a film. */
  static UnitResult of(WorkUnit unit, Film film, RenderStatistics statistics, double seconds) {
    int pixels = unit.width() * unit.height();
    long most = IntStream.range(0, pixels).mapToLong(film::encodedBytes).sum();
    ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(most));
    for (int pixel = 0; pixel < pixels; pixel++) {
      film.encode(pixel, bytes);
    }
    bytes.flip();
    int size = bytes.limit();
    return new UnitResult(unit, film.hasAlpha(), deflated(bytes), size, statistics, seconds);
  }

  private static byte[] deflated(ByteBuffer bytes) {
    Deflater deflater = new Deflater(Deflater.BEST_SPEED);
    try {
      deflater.setInput(bytes);
      deflater.finish();
      ByteArrayOutputStream out = new ByteArrayOutputStream(bytes.limit());
      byte[] buffer = new byte[1 << 16];
      while (!deflater.finished()) {
        out.write(buffer, 0, deflater.deflate(buffer));
      }
      return out.toByteArray();
    } finally {
      deflater.end();
    }
  }

  /**
   * Returns the film of the unit's tile.
   *
   * @param layers of the render's films
   */
  Film decoded(FilmLayers layers) {
    Film decoded = new Film(unit.tile(), hasAlpha, unit.first(), layers);
    int pixels = unit.width() * unit.height();
    ByteBuffer bytes = ByteBuffer.allocate(filmBytes);
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(film);
      while (!inflater.finished()) {
        if (inflater.inflate(bytes) == 0 && !inflater.finished()) {
          throw new IllegalStateException("incomplete film of " + unit);
        }
      }
    } catch (DataFormatException e) {
      throw new IllegalStateException("damaged film of " + unit, e);
    } finally {
      inflater.end();
    }
    bytes.flip();
    for (int pixel = 0; pixel < pixels; pixel++) {
      decoded.decode(pixel, bytes);
    }
    return decoded;
  }
}
