package io.github.lumbre.image.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests the choice of formats, their limits, and that a file appears complete or not at all. */
class AnimationFormatTest {
  @TempDir private Path folder;

  private AnimationFrames frames(String rate) throws IOException {
    Pixels red = AnimationFixture.pixels(5, 3, false, (x, y) -> 0xff0000);
    Pixels blue = AnimationFixture.pixels(5, 3, false, (x, y) -> 0xff);
    Path frames = Files.createDirectories(folder.resolve("frames"));
    return AnimationFixture.frames(frames, rate, red, blue);
  }

  private Path write(AnimationFormat format, AnimationFrames frames) throws Exception {
    Path target = folder.resolve("out" + format.ending());
    try (OutputFile output = OutputFile.open(target)) {
      format.writer(Optional.empty(), Map.of()).write(frames, Map.of(), output);
    }
    return target;
  }

  @Test
  void endingsChooseTheFormat() {
    assertThat(AnimationFormat.of(Path.of("a/Wave.GIF"))).contains(AnimationFormat.GIF);
    assertThat(AnimationFormat.of(Path.of("a.apng"))).contains(AnimationFormat.APNG);
    assertThat(AnimationFormat.of(Path.of("a.mp4"))).contains(AnimationFormat.MP4);
    assertThat(AnimationFormat.of(Path.of("a.webm"))).contains(AnimationFormat.WEBM);
    assertThat(AnimationFormat.of(Path.of("a.png"))).isEmpty();
    assertThat(AnimationFormat.of(Path.of("gif"))).isEmpty();
    assertThat(AnimationFormat.of(Path.of("/"))).isEmpty();
    assertThat(AnimationFormat.endings()).isEqualTo(".gif, .apng, .mp4, .webm");
    assertThat(Arrays.stream(AnimationFormat.values()).filter(AnimationFormat::isVideo))
        .containsExactly(AnimationFormat.MP4, AnimationFormat.WEBM);
  }

  @Test
  void aGifHasALargestRate() throws IOException {
    AnimationFormat.GIF.requireFits(FrameRate.parse("50"));
    AnimationFormat.APNG.requireFits(FrameRate.parse("120"));
    assertThatIllegalArgumentException()
        .isThrownBy(() -> AnimationFormat.GIF.requireFits(FrameRate.parse("50.01")))
        .withMessageContaining("at most 50 frames per second, found 5001/100,")
        .withMessageContaining("choose .apng");
    AnimationFrames fast = frames("60");
    assertThatIllegalArgumentException().isThrownBy(() -> write(AnimationFormat.GIF, fast));
  }

  @ParameterizedTest
  @EnumSource(
      value = AnimationFormat.class,
      names = {"GIF", "APNG"})
  void aFileAppearsCompleteOrNotAtAll(AnimationFormat format) throws Exception {
    AnimationFrames frames = frames("25");
    Path target = write(format, frames);
    byte[] before = Files.readAllBytes(target);
    Files.writeString(frames.files().get(1), "damaged");
    assertThatThrownBy(() -> write(format, frames)).isInstanceOf(IOException.class);
    assertThat(target).hasBinaryContent(before);
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> write(format, frames("25"))).isInstanceOf(InterruptedException.class);
    assertThat(Thread.currentThread().isInterrupted()).isFalse();
    assertThat(target).hasBinaryContent(before);
    assertThat(Folders.files(folder)).containsExactlyInAnyOrder(target, folder.resolve("frames"));
  }
}
