package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.internal.PictureTexts;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.io.TempDir;

/** A folder for the files of a test, and command lines in which T stands for it. */
abstract class CommandFixture {
  @TempDir Path directory;

  final Outcome run(String line) {
    return Outcome.in(directory, line);
  }

  /** Writes the scene tiny.json, and runs a command line with further words. */
  final Outcome withScene(String json, String line, String... more) {
    TinyScene.write(directory, json);
    Stream<String> words = Stream.of(Outcome.words(directory, line));
    return Outcome.of(Stream.concat(words, Stream.of(more)).toArray(String[]::new));
  }

  /** Runs a command that succeeds. */
  final Outcome runs(String line) {
    Outcome outcome = run(line);
    assertThat(outcome.exitCode()).as(line + ": " + outcome.err()).isZero();
    return outcome;
  }

  /** Runs a command that succeeds, and returns its messages, without the name of the folder. */
  final String said(String line) {
    return runs(line).err().replace(directory + "/", "");
  }

  final String path(String name) {
    return directory.resolve(name).toString();
  }

  final byte[] bytes(String name) throws IOException {
    return Files.readAllBytes(directory.resolve(name));
  }

  final BufferedImage picture(String name) {
    try {
      return ImageIO.read(directory.resolve(name).toFile());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the colors of a picture's pixels, with alpha. */
  final int[] pixels(String name) {
    return Pictures.pixels(picture(name));
  }

  /** Returns the metadata of a picture. */
  final Map<String, String> texts(String name) throws IOException {
    return PictureTexts.read(directory.resolve(name));
  }

  /** Changes what a film says of its scene and settings. */
  final void changeIdentity(String name, Consumer<Map<String, String>> change) throws IOException {
    FilmFile film = FilmFile.read(directory.resolve(name));
    FilmHeader header = film.header();
    Map<String, String> identity = new LinkedHashMap<>(header.identity());
    change.accept(identity);
    try (CheckpointFile file = CheckpointFile.reserve(directory.resolve(name))) {
      file.save(
          FilmFile.of(identity, film.film(), header.layers(), header.notes(), header.faults()));
    }
  }

  final void assertSame(String one, String other) {
    assertThat(directory.resolve(one)).hasSameBinaryContentAs(directory.resolve(other));
  }
}
