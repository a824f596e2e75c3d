package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.file.Disk;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.render.checkpoint.FilmFixture.FailingDisk;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests how checkpoint files are saved, replaced and loaded after failures and kills. */
class CheckpointFileTest {
  /** The chunk size in bytes; a save then takes about 100 steps. */
  private static final int CHUNK_BYTES = 24;

  @TempDir private Path directory;
  private Path path;

  @BeforeEach
  void name() {
    path = directory.resolve("a.film");
  }

  private static FilmFile film(int samples) {
    return FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> samples);
  }

  private static int samples(FilmFile file) {
    assertThat(FilmFixture.pixels(file.film()))
        .isEqualTo(FilmFixture.pixels(film(file.film().mostSamples()).film()));
    return file.film().mostSamples();
  }

  private void save(int... samples) throws IOException {
    try (CheckpointFile file = CheckpointFile.reserve(path, FailingDisk.never())) {
      for (int n : samples) {
        file.save(film(n));
      }
    }
  }

  @Test
  void lastFilmAndTheOneBeforeAreKept() throws IOException {
    save(1, 2, 3);
    assertThat(samples(FilmFile.read(path))).isEqualTo(3);
    assertThat(samples(FilmFile.read(OutputFile.previous(path)))).isEqualTo(2);
    assertThat(Folders.files(directory)).hasSize(2);
  }

  /** The last film has just lost its hidden name, and the next film does not have it yet. */
  @Test
  void isReservedWhileFilmsAreGivenTheirNames() throws IOException {
    AtomicInteger refused = new AtomicInteger();
    Disk whileOthersTry =
        new Disk() {
          @Override
          public void forceDirectory(Path parent) {
            assertThatThrownBy(() -> CheckpointFile.reserve(path))
                .hasMessage(path + ": another run is writing this file");
            refused.incrementAndGet();
            Disk.super.forceDirectory(parent);
          }
        };
    try (CheckpointFile file = CheckpointFile.reserve(path, whileOthersTry)) {
      file.save(film(1));
      file.save(film(2));
    }
    assertThat(refused).hasValue(2);
    save(3);
    assertThat(samples(FilmFile.read(path))).isEqualTo(3);
  }

  /**
   * The program is killed at each step of the second and third save: the previous or the new film
   * is readable, and the next run can save.
   */
  @Test
  void killedSaveLeavesOneFilmOrTheOther() throws IOException {
    int points = 0;
    for (boolean done = false; !done; points++) {
      for (Path file : new Path[] {path, OutputFile.previous(path)}) {
        Files.deleteIfExists(file);
      }
      save(1);
      FailingDisk disk = new FailingDisk(points, true, CHUNK_BYTES);
      int saved = saveUntilKilled(disk);
      int read = samples(CheckpointFile.load(path).file());
      assertThat(read).as("killed at step %d", points).isBetween(saved, saved + 1);
      done = !disk.hasFailed();
      save(7);
      assertThat(samples(FilmFile.read(path))).isEqualTo(7);
    }
    assertThat(points).isGreaterThan(100);
  }

  private int saveUntilKilled(FailingDisk disk) throws IOException {
    int saved = 1;
    try (CheckpointFile file = CheckpointFile.reserve(path, disk)) {
      for (int n = 2; n <= 3; n++) {
        file.save(film(n));
        saved = n;
      }
    } catch (FailingDisk.Killed e) {
      assertThat(disk.hasFailed()).isTrue();
    }
    return saved;
  }

  /** The disk is full for one step: the previous film is kept, and the next save succeeds. */
  @Test
  void failedSaveKeepsTheFilmBefore() throws IOException {
    boolean failed = true;
    for (int step = 0; failed; step++) {
      Files.deleteIfExists(path);
      Files.deleteIfExists(OutputFile.previous(path));
      save(1);
      FailingDisk disk = new FailingDisk(step, false, CHUNK_BYTES);
      try (CheckpointFile file = CheckpointFile.reserve(path, disk)) {
        try {
          file.save(film(2));
        } catch (IOException e) {
          assertThat(e).hasMessage("No space left on device");
          assertThat(samples(CheckpointFile.load(path).file())).isEqualTo(1);
          file.save(film(2));
        }
        assertThat(samples(FilmFile.read(path))).isEqualTo(2);
      }
      failed = disk.hasFailed();
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void damagedFilmIsReplacedByTheOneBefore(boolean exists) throws IOException {
    save(1, 2);
    byte[] bytes = Files.readAllBytes(path);
    bytes[bytes.length / 2]++;
    if (exists) {
      Files.write(path, bytes);
    } else {
      Files.delete(path);
    }
    CheckpointFile.Loaded loaded = CheckpointFile.load(path);
    assertThat(samples(loaded.file())).isEqualTo(1);
    assertThat(loaded.from()).isEqualTo(OutputFile.previous(path));
    assertThat(loaded.problem().orElseThrow()).contains(exists ? "damaged" : "does not exist");
    if (exists) {
      assertThat(Files.readAllBytes(path)).isEqualTo(bytes);
    }
  }

  @Test
  void twoDamagedFilmsAreBothTold() throws IOException {
    save(1, 2);
    Files.write(path, new byte[100]);
    Files.write(OutputFile.previous(path), new byte[100]);
    assertThatThrownBy(() -> CheckpointFile.load(path))
        .isInstanceOf(FilmFormatException.class)
        .hasMessage(
            "is not a film, or is damaged; %s cannot be used either: is not a film, or is damaged",
            OutputFile.previous(path));
    Files.delete(path);
    Files.delete(OutputFile.previous(path));
    assertThatThrownBy(() -> CheckpointFile.load(path)).isInstanceOf(NoSuchFileException.class);
  }

  @Test
  void oneRenderAtATimeKeepsItsFilmInAFile() throws IOException {
    try (CheckpointFile first = CheckpointFile.reserve(path)) {
      first.save(film(1));
      assertThatThrownBy(() -> CheckpointFile.reserve(path))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("another run");
    }
    save(2);
  }

  /**
   * The file with the hidden name is deleted at the end, so the name is free for the next render.
   */
  @Test
  void placeThatCannotBeOpenedIsNotKept() throws IOException {
    Path hidden = directory.resolve(".a.film.tmp");
    Files.createDirectory(hidden);
    assertThatThrownBy(() -> CheckpointFile.reserve(path)).isInstanceOf(IOException.class);
    Files.delete(hidden);
    save(1);
    assertThat(samples(FilmFile.read(path))).isEqualTo(1);
  }

  @Test
  void nothingIsLeftOfAFileThatNothingWasSavedIn() throws IOException {
    try (CheckpointFile file = CheckpointFile.reserve(path)) {
      assertThat(file.path()).isEqualTo(path);
    }
    assertThat(Folders.files(directory)).isEmpty();
  }

  @Test
  void soundFilmIsLoadedFromWhereItWasAskedFor() throws IOException {
    save(1, 2);
    CheckpointFile.Loaded loaded = CheckpointFile.load(path);
    assertThat(samples(loaded.file())).isEqualTo(2);
    assertThat(loaded.from()).isEqualTo(path);
    assertThat(loaded.problem()).isEmpty();
  }

  /** The system's own words differ; they begin in lower case, as the rest of a sentence. */
  @Test
  void reasonWhyTheFilmBeforeCannotBeReadIsReported() throws IOException {
    Files.createDirectory(OutputFile.previous(path));
    assertThatThrownBy(() -> CheckpointFile.load(path))
        .isInstanceOf(FilmFormatException.class)
        .hasMessageMatching("does not exist; .*a\\.film\\.bak cannot be used either: [a-z].+");
  }
}
