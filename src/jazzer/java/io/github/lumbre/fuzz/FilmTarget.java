package io.github.lumbre.fuzz;

import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmFormatException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.zip.CRC32C;

/** Any bytes as a film, with the checksum that is theirs. */
public final class FilmTarget {
  private static final String NAME = "fuzzed.film";
  private static final Path FILM = TargetFiles.file(NAME);

  private FilmTarget() {}

  /** Reads a film; what else it throws is a defect. */
  public static void fuzzerTestOneInput(byte[] content) throws IOException {
    CRC32C checksum = new CRC32C();
    checksum.update(content);
    ByteBuffer film = ByteBuffer.allocate(content.length + Integer.BYTES);
    film.order(ByteOrder.LITTLE_ENDIAN).put(content).putInt((int) checksum.getValue());
    TargetFiles.write(NAME, film.array());
    try {
      FilmFile.read(FILM);
    } catch (FilmFormatException e) {
      return;
    }
  }
}
