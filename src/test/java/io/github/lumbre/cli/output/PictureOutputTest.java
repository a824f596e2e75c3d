package io.github.lumbre.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.internal.ImageFormat;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the default name of a picture and its fallback. */
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
    assertThat(PictureOutput.defaultFor(scene, ImageFormat.PNG)).isEqualTo(picture);
  }

  @Test
  void missingFallbacksAreNamedWhenTheyAreNeeded(@TempDir Path directory) throws Exception {
    Path folder = Files.createDirectory(directory.resolve("folder"));
    Path none = directory.resolve("none");
    Image image = Image.black(2, 1);
    String advice = none + ": no such directory; choose another one with --fallback-dir";
    try (PictureOutput output =
        PictureOutput.reserve(folder.resolve("a.png"), new Fallback(none))) {
      output.write(image, ImageWriter.Options.DEFAULT);
    }
    try (PictureOutput output =
        PictureOutput.reserve(folder.resolve("b.png"), new Fallback(none))) {
      Files.move(folder, directory.resolve("moved"));
      assertThatThrownBy(() -> output.write(image, ImageWriter.Options.DEFAULT))
          .hasMessageContaining("b.png: cannot be written")
          .hasMessageEndingWith("nor could it be saved in " + advice);
    }
    assertThatThrownBy(() -> PictureOutput.toStandardOutput(ImageFormat.PNG, new Fallback(none)))
        .hasMessage(advice.replace("none:", "none: cannot be written:"));
  }
}
