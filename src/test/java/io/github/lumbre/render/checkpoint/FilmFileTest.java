package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.render.Film;
import io.github.lumbre.render.FilmRenderer;
import io.github.lumbre.render.RenderStatistics;
import io.github.lumbre.scene.RenderSettings.Crop;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the format of film files and the detection of damage. */
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

  /** Films of older versions have no revision, for example. */
  @Test
  void valuesThatOneOfTwoFilmsDoesNotHaveAreDifferences() {
    Map<String, String> older = new LinkedHashMap<>(FilmFixture.IDENTITY);
    older.remove(FilmHeader.REVISION);
    FilmHeader header = film.header();
    FilmHeader old =
        new FilmHeader(
            older,
            true,
            header.window(),
            RecordedLayers.NONE,
            header.parts(),
            header.faults(),
            header.notes());
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

  /**
   * Changes each bit of the header and 1000 random bits of the rest, and truncates the file in all
   * ways.
   */
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
    FilmFixture.assertRefused(path, ascii("hello, this is no film"), "is not a film");
  }

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  @Test
  void filmsWithTheRightChecksumAndTheWrongContentAreRefusedForTheReason() throws IOException {
    byte[] content = FilmFixture.content(path);
    String text = new String(content, StandardCharsets.ISO_8859_1);
    int pixels = text.indexOf("\n\n") + 2;
    FilmFixture.assertRefused(
        path, Arrays.copyOf(content, content.length + 1), "after the last pixel");
    // As many bytes too many in the buffer as behind it.
    int twice = content.length + 2 * ((1 << 16) - content.length);
    FilmFixture.assertRefused(path, Arrays.copyOf(content, twice), "after the last pixel");
    FilmFixture.assertRefused(
        path, Arrays.copyOf(content, content.length - 1), "pixel 83 cannot be read");
    FilmFixture.assertRefused(
        path, Arrays.copyOf(content, pixels + 83), "fewer bytes than its window has pixels");
    FilmFixture.assertRefused(
        path, Arrays.copyOf(content, pixels - 1), "the header does not end in an empty line");
    FilmFixture.assertRefused(
        path, ascii(text.replace("LUMBRE-FILM 1", "LUMBRE-FILM 3")), "found 'LUMBRE-FILM 3'");
    FilmFixture.assertRefused(path, ascii(text.replace("seed: 0", "seed 0")), "found 'seed 0'");
    FilmFixture.assertRefused(
        path,
        ascii(text.replace("samples covered sums first-mean", "x")),
        "pixel: unknown layout 'x'");
    FilmFixture.assertRefused(
        path, ascii(text.replace("window: 0", "window: -1")), "window: invalid value '-1");
    FilmFixture.assertRefused(
        path, ascii(withRejected(text, "-1")), "rejected: invalid value '-1'");
    FilmFixture.assertRefused(path, ascii(withRejected(text, "x")), "rejected: invalid value 'x'");
  }

  private static String withRejected(String text, String count) {
    return text.replaceFirst("\nrejected: \\d+", "\nrejected: " + count);
  }

  @Test
  void aByteForEachPixelIsEnoughForAnEmptyFilm() throws IOException {
    FilmFile empty = FilmFixture.file(FilmFixture.FRAME, 3, (x, y) -> 0);
    write(empty);
    String text = new String(FilmFixture.content(path), StandardCharsets.ISO_8859_1);
    assertThat(text.length() - text.indexOf("\n\n") - 2).isEqualTo(12 * 7);
    FilmFile read = FilmFile.read(path);
    assertThat(read.film().totalSamples()).isZero();
    assertThat(read.film().firstSample()).isEqualTo(3);
  }

  /**
   * Notes of increasing length move the pixels across all positions relative to the first buffer
   * ends.
   */
  @Test
  void anyLengthIsReadAsItWasWritten() throws IOException {
    byte[] pixels = FilmFixture.pixels(film.film());
    FilmHeader header = film.header();
    int base = FilmFixture.content(path).length;
    for (int buffers = 1; buffers <= 2; buffers++) {
      for (int length : lengthsAround(buffers << 16, base, pixels.length)) {
        Map<String, String> notes = new LinkedHashMap<>(header.notes());
        notes.put("x", "y".repeat(length));
        write(
            new FilmFile(
                new FilmHeader(
                    header.identity(),
                    true,
                    header.window(),
                    RecordedLayers.NONE,
                    header.parts(),
                    header.faults(),
                    notes),
                film.film()));
        FilmFile read = FilmFile.read(path);
        assertThat(read.header().notes()).isEqualTo(notes);
        assertThat(FilmFixture.pixels(read.film())).isEqualTo(pixels);
      }
    }
  }

  /** Returns note lengths for which the end of the file or of its header is near a position. */
  private static int[] lengthsAround(int place, int base, int pixels) {
    return IntStream.rangeClosed(-12, 4)
        .flatMap(offset -> IntStream.of(place - base + offset, place - base + offset + pixels))
        .toArray();
  }

  @Test
  void headersShorterThanSixteenMebibytesAreRead() throws IOException {
    String text = new String(FilmFixture.content(path), StandardCharsets.ISO_8859_1);
    int header = text.indexOf("\n\n");
    int room = (1 << 24) - header - "\nnote x: ".length() - 2;
    String longest = text.substring(0, header) + "\nnote x: " + "y".repeat(room);
    FilmFixture.writeSealed(path, ascii(longest + text.substring(header)));
    assertThat(FilmFile.read(path).header().notes().get("x")).hasSize(room);
    FilmFixture.assertRefused(
        path,
        ascii(longest + "y" + text.substring(header)),
        "the header does not end in an empty line");
    String endless = "LUMBRE-FILM 1\nnote x: " + "y".repeat(1 << 24);
    FilmFixture.assertRefused(path, ascii(endless), "the header does not end in an empty line");
  }

  @Test
  void aFilmWrittenTwiceIsThatOfTheSecondTime() throws IOException {
    byte[] once = Files.readAllBytes(path);
    try (OutputFile output = OutputFile.open(path)) {
      FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> 9).write(output);
      film.write(output);
      output.commit();
    }
    assertThat(Files.readAllBytes(path)).isEqualTo(once);
  }

  @Test
  void filmsWithoutAlphaAreReadAsTheyWereWritten() throws IOException {
    Film opaque = new Film(new Crop(0, 0, 2, 1), false, 0);
    opaque.decode(0, ByteBuffer.wrap(new byte[] {0}));
    FilmFile file =
        FilmFile.of(
            FilmFixture.IDENTITY, opaque, RecordedLayers.NONE, Map.of(), RenderStatistics.ZERO);
    write(file);
    FilmFile read = FilmFile.read(path);
    assertThat(read.header()).isEqualTo(file.header());
    assertThat(read.film().hasAlpha()).isFalse();
  }

  @Test
  void theFirstRejectedSamplesMayBeUnknown() throws IOException {
    String text = new String(FilmFixture.content(path), StandardCharsets.ISO_8859_1);
    assertThat(text).contains("first-rejected: ");
    FilmFixture.writeSealed(
        path, ascii(text.replaceFirst("first-rejected: [^\n]*", "first-rejected: ")));
    RenderStatistics faults = FilmFile.read(path).header().faults();
    assertThat(faults.firstRejected()).isEmpty();
    assertThat(faults.rejected()).isEqualTo(film.header().faults().rejected());
  }

  @Test
  void filmsOfAnyVersionAreKnownByTheirFirstBytes() throws IOException {
    assertThat(FilmFile.startsIn(FilmFixture.content(path))).isTrue();
    assertThat(FilmFile.startsIn(ascii("LUMBRE-FILM 99\n"))).isTrue();
    assertThat(FilmFile.startsIn(ascii("LUMBRE-FIL"))).isFalse();
    assertThat(FilmFile.startsIn(ascii("{\"camera\": {}}"))).isFalse();
    assertThat(FilmFile.startsIn(new byte[0])).isFalse();
  }

  @Test
  void noRejectedSamplesMayBeStated() throws IOException {
    String text = new String(FilmFixture.content(path), StandardCharsets.ISO_8859_1);
    String none = withRejected(text, "0").replaceFirst("first-rejected: [^\n]*\n", "");
    FilmFixture.writeSealed(path, ascii(none));
    assertThat(FilmFile.read(path).header().faults().rejected()).isZero();
  }
}
