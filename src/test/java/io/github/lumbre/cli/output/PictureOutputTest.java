package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the default name of a picture. */
class PictureOutputTest {
  @ParameterizedTest
  @CsvSource({
    "scenes/cornell-box.json, cornell-box.png",
    "a.b.json, a.b.png",
    "plain, plain.png",
    ".hidden, .hidden.png",
    "/, picture.png"
  })
  void defaultIsTheScenesNameInTheWorkingDirectory(Path scene, Path picture) {
    assertThat(PictureOutput.defaultFor(scene)).isEqualTo(picture);
  }
}
