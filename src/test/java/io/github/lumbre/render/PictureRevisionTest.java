package io.github.lumbre.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Checks that a change of pictures comes with a new revision. */
class PictureRevisionTest {
  private static final Path HASHES = Path.of("scenes", "table-hashes.csv");
  private static final Path REVISIONS = Path.of("src/test/resources/picture-revisions.csv");

  /** New picture hashes require a decision here: can films of earlier versions still be resumed? */
  @Test
  void otherPicturesHaveAnotherRevision() throws IOException, NoSuchAlgorithmException {
    List<String> lines = Files.readAllLines(REVISIONS);
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(HASHES));
    assertThat(lines.get(lines.size() - 1))
        .as(
            "%s has changed. If the renderer takes other samples of the same scenes, raise"
                + " FilmRenderer.REVISION and add a line to %s; if other scenes are all that has"
                + " changed, exchange its last line's hash",
            HASHES, REVISIONS)
        .isEqualTo(FilmRenderer.REVISION + "," + HexFormat.of().formatHex(digest));
  }
}
