package io.github.lumbre.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.OutputFile;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FilmFileTest {
  @TempDir private Path directory;
  private Path path;
  private FilmFile film;

  @BeforeEach
  void writeFilm() throws IOException {
    path = directory.resolve("a.film");
    film = FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> (x + y) % 5);
    write(film);
  }

  private void write(FilmFile file) throws IOException {
    try (OutputFile output = OutputFile.open(path)) {
      file.write(output);
      output.commit();
    }
  }

  @Test
  void filmIsReadAsItWasWritten() throws IOException {
    FilmFile read = FilmFile.read(path);
    assertThat(read.header()).isEqualTo(film.header());
    assertThat(FilmFixture.pixels(read.film())).isEqualTo(FilmFixture.pixels(film.film()));
    assertThat(read.header().parts()).containsExactly(new FilmPart(FilmFixture.FRAME, 0, 0, 4));
  }

  @Test
  void filmsThatSayNothingOfFaultsHaveNone() throws IOException {
    write(new FilmFile(withoutFaults(film.header()), film.film()));
    assertThat(Files.readString(path, StandardCharsets.ISO_8859_1))
        .doesNotContain("rejected: ", "saturated: ");
    assertThat(FilmFile.read(path).header().faults()).isEqualTo(RenderStatistics.ZERO);
  }

  private static FilmHeader withoutFaults(FilmHeader header) {
    return header.withParts(header.window(), header.parts(), RenderStatistics.ZERO);
  }

  /** As those of versions that knew of no revision. */
  @Test
  void valuesThatOneOfTwoFilmsDoesNotHaveAreDifferences() {
    Map<String, String> older = new LinkedHashMap<>(FilmFixture.IDENTITY);
    older.remove(FilmHeader.REVISION);
    FilmHeader header = film.header();
    FilmHeader old =
        new FilmHeader(
            older, true, header.window(), header.parts(), header.faults(), header.notes());
    assertThatThrownBy(() -> old.requireSame(FilmFixture.IDENTITY, "a", "b"))
        .isInstanceOf(FilmMismatchException.class)
        .hasMessage("revision: a has nothing, b has " + FilmRenderer.REVISION);
    assertThatThrownBy(() -> header.requireSame(older, "a", "b"))
        .isInstanceOf(FilmMismatchException.class)
        .hasMessage("revision: a has " + FilmRenderer.REVISION + ", b has nothing");
  }

  @Test
  void filmsLargerThanTheBufferAreReadAsTheyWereWritten() throws IOException {
    FilmFile large = FilmFixture.file(new Crop(5, 3, 200, 100), 7, (x, y) -> x % 2);
    write(large);
    assertThat(Files.size(path)).isGreaterThan(1 << 17);
    FilmFile read = FilmFile.read(path);
    assertThat(FilmFixture.pixels(read.film())).isEqualTo(FilmFixture.pixels(large.film()));
    assertThat(read.film().firstSample()).isEqualTo(7);
  }

  /** Every bit of the header and 1000 random ones of the rest, and every kind of cut. */
  @Test
  void damageIsDetected() throws IOException {
    byte[] whole = Files.readAllBytes(path);
    int header = new String(whole, StandardCharsets.ISO_8859_1).indexOf("\n\n") + 2;
    Random random = new Random(50);
    for (int i = 0; i < 8 * header + 1000; i++) {
      int bit = i < 8 * header ? i : 8 * header + random.nextInt(8 * (whole.length - header));
      byte[] damaged = whole.clone();
      damaged[bit / 8] ^= (byte) (1 << bit % 8);
      assertRefused(damaged);
    }
    for (int length = 0; length < whole.length; length += 1 + random.nextInt(20)) {
      assertRefused(Arrays.copyOf(whole, length));
    }
    assertRefused(Arrays.copyOf(whole, whole.length + 1));
  }

  private void assertRefused(byte[] bytes) throws IOException {
    Files.write(path, bytes);
    assertThatThrownBy(() -> FilmFile.read(path)).isInstanceOf(FilmFormatException.class);
    assertThat(Files.readAllBytes(path)).isEqualTo(bytes);
  }

  @Test
  void otherFilesAreNoFilms() throws IOException {
    for (String text : new String[] {"", "hello", "{\"a\": 1}", "LUMBRE-FILM 1\n"}) {
      assertRefused(text.getBytes(StandardCharsets.UTF_8));
    }
  }
}
