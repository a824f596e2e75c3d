package io.github.lumbre.render.checkpoint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.fail;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.testing.Effort;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.zip.CRC32C;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests manipulated films with valid checksums. */
class HostileFilmTest {
  private static final int CHECKSUM_BYTES = 4;
  private static final Pattern WORD = Pattern.compile("[^\\s=,]+");
  private static final String[] WORDS = {
    "0", "1", "-1", "2", "65535", "65536", "2147483647", "2147483648", "-2147483648", "1e9", "NaN",
    "true", "false", "", "x", "1,2", "0,0,0,0", "1073741825", "\n", "\n\n", "\u0000", "\u001b[2J",
    "lumbre-film", "4294967296", "99999999999999999999"
  };

  @TempDir private Path directory;

  @Test
  void anyFilmIsReadOrRefusedForAReason() throws IOException {
    byte[] sound = sound();
    int read = 0;
    int count = Effort.count(2000, 200_000);
    for (int i = 0; i < count; i++) {
      long seed = Effort.seed(0) + i;
      byte[] film = changed(sound, new Random(seed));
      Path file = Files.write(directory.resolve(i + ".film"), film);
      try {
        FilmFile.read(file);
        read++;
      } catch (FilmFormatException e) {
        assertThat(e.getMessage()).as("seed %d", seed).isNotBlank().doesNotContain("Exception");
      } catch (RuntimeException | Error e) {
        fail("seed " + seed, e);
      }
      Files.delete(file);
    }
    // If all or no films were rejected, the test would be useless.
    assertThat(read).isBetween(count / 50, count * 49 / 50);
  }

  private byte[] sound() throws IOException {
    Path path = directory.resolve("sound.film");
    try (OutputFile output = OutputFile.open(path)) {
      FilmFixture.file(FilmFixture.FRAME, 0, (x, y) -> (x + y) % 5).write(output);
      output.commit();
    }
    byte[] file = Files.readAllBytes(path);
    return Arrays.copyOf(file, file.length - CHECKSUM_BYTES);
  }

  private static byte[] changed(byte[] sound, Random random) {
    String text = new String(sound, StandardCharsets.ISO_8859_1);
    for (int changes = 1 + random.nextInt(2); changes > 0; changes--) {
      int header = Math.max(1, text.indexOf("\n\n"));
      text = random.nextBoolean() ? word(text, header, random) : pixel(text, header, random);
    }
    byte[] content = text.getBytes(StandardCharsets.ISO_8859_1);
    CRC32C checksum = new CRC32C();
    checksum.update(content);
    ByteBuffer film = ByteBuffer.allocate(content.length + CHECKSUM_BYTES);
    film.order(ByteOrder.LITTLE_ENDIAN).put(content).putInt((int) checksum.getValue());
    return film.array();
  }

  private static String word(String text, int header, Random random) {
    List<MatchResult> words = WORD.matcher(text.substring(0, header)).results().toList();
    if (words.isEmpty()) {
      return text;
    }
    MatchResult old = words.get(random.nextInt(words.size()));
    String word = WORDS[random.nextInt(WORDS.length)];
    return text.substring(0, old.start()) + word + text.substring(old.end());
  }

  private static String pixel(String text, int header, Random random) {
    int at = header + random.nextInt(text.length() - header);
    int extremes = random.nextInt(3);
    char with = (char) (extremes == 0 ? 0xff : extremes == 1 ? 0x80 : random.nextInt(256));
    String rest = random.nextInt(8) == 0 ? "" : text.substring(at + 1);
    return text.substring(0, at) + with + rest;
  }
}
