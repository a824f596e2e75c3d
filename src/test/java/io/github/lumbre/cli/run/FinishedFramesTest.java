package io.github.lumbre.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.TaskException;
import io.github.lumbre.cli.output.PictureMetadata;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which frames are kept, by the metadata in their files. */
class FinishedFramesTest {
  @TempDir private Path directory;

  private final FinishedFrames finished = new FinishedFrames(Set.of(PictureMetadata.SCENE_HASH));

  private Path frame(String name, Map<String, String> texts) throws IOException {
    Path file = directory.resolve(name);
    Image image = Image.black(1, 1);
    ImageWriter.write(image, file, ImageWriter.Options.DEFAULT.withMetadata(texts));
    return file;
  }

  @Test
  void framesOfAnotherAutomaticExposureAreRefused() throws IOException, TaskException {
    Map<String, String> none = Map.of();
    finished.add(frame("a.png", Map.of(PictureMetadata.CHOSEN_EXPOSURE, "1.5")), none);
    finished.add(frame("b.exr", Map.of(PictureMetadata.CHOSEN_EXPOSURE, "1.5")), none);
    assertThat(finished.exposure()).contains(Exposure.of(1.5));
    Path other = frame("c.png", Map.of(PictureMetadata.CHOSEN_EXPOSURE, "1.25"));
    assertThatThrownBy(() -> finished.add(other, none))
        .isInstanceOf(TaskException.class)
        .hasMessageContaining("ChosenExposure 1.25, expected 1.5");
    Path without = frame("d.png", none);
    assertThatThrownBy(() -> finished.add(without, none))
        .hasMessageContaining("ChosenExposure nothing, expected 1.5");
    assertThat(finished.size()).isEqualTo(2);
  }

  @Test
  void partialAndMissingFramesAreNotComplete() throws IOException, TaskException {
    Path partial = frame("a.png", Map.of(PictureMetadata.PARTIAL, "1 of 2 samples"));
    Path missing = directory.resolve("b.png");
    finished.add(partial, Map.of(PictureMetadata.SCENE_HASH, "1"));
    finished.add(missing, Map.of());
    assertThat(finished.size()).isZero();
    assertThat(finished.contains(partial)).isFalse();
  }

  @Test
  void damagedFilesAreRefused() throws IOException {
    Path frame = frame("a.png", Map.of(PictureMetadata.SCENE_HASH, "1"));
    byte[] bytes = Files.readAllBytes(frame);
    bytes[bytes.length - 20]++;
    Files.write(frame, bytes);
    assertThatThrownBy(() -> finished.add(frame, Map.of(PictureMetadata.SCENE_HASH, "1")))
        .isInstanceOf(TaskException.class)
        .hasMessageContaining("a.png: cannot be continued: PNG is damaged");
  }
}
