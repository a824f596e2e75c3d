package io.github.lumbre.image.animation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.file.ExternalProgram;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests how ffmpeg is called, with stand-ins, and with the real program where it is installed. */
@DisabledOnOs(OS.WINDOWS)
class VideoWriterTest {
  /** Lists encoders, or keeps its arguments and writes its input to the file of the last one. */
  private static final String COPY =
      """
      if [ "$2" = "-encoders" ]; then echo " V....D ENCODER      Some video"; exit 0; fi
      echo "$@" > "$(dirname "$0")/arguments.txt"
      for last in "$@"; do :; done
      cat > "$last"
      """;

  @TempDir private Path folder;

  private Map<String, String> program(String script) throws IOException {
    Path bin = Files.createDirectories(folder.resolve("bin"));
    Path file = Files.writeString(bin.resolve("ffmpeg"), "#!/bin/sh\n" + script);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    return Map.of("PATH", bin.toString());
  }

  private AnimationFrames frames(Pixels... pictures) throws IOException {
    Path frames = Files.createDirectories(folder.resolve("frames"));
    return AnimationFixture.frames(frames, "30000/1001", pictures);
  }

  private void write(AnimationFrames frames, Path target, Map<String, String> environment)
      throws IOException, InterruptedException {
    AnimationFormat format = AnimationFormat.of(target).orElseThrow();
    AnimationWriter writer = format.writer(Optional.empty(), environment);
    try (OutputFile output = OutputFile.open(target)) {
      writer.write(frames, Map.of(), output);
    }
  }

  private static Pixels plain(int width, int height, int argb) {
    return AnimationFixture.pixels(width, height, true, (x, y) -> argb);
  }

  /** With alpha 128 over black, 200 becomes 147: the linear values are 0.5776 and 0.2899. */
  @Test
  void theProgramGetsFramesOfAnEvenSizeOverBlack() throws Exception {
    Map<String, String> environment = program(COPY.replace("ENCODER", "libx264"));
    AnimationFrames frames = frames(plain(3, 1, 0xff010203), plain(3, 1, 0x80c8ff00));
    Path target = folder.resolve("-a b.mp4");
    write(frames, target, environment);
    byte[] written = Files.readAllBytes(target);
    assertThat(written).hasSize(2 * 4 * 2 * 3);
    for (int i = 0; i < 24; i += 3) {
      assertThat(new byte[] {written[i], written[i + 1], written[i + 2]}).containsExactly(1, 2, 3);
      assertThat(written[24 + i] & 0xff).isEqualTo(147);
      assertThat(written[25 + i] & 0xff).isEqualTo(188);
      assertThat(written[26 + i]).isZero();
    }
    String arguments = Files.readString(folder.resolve("bin/arguments.txt"));
    assertThat(arguments)
        .contains(" -xerror ")
        .contains("-video_size 4x2 -framerate 30000/1001 -i pipe:0 -c:v libx264")
        .containsPattern("-f mp4 -y " + folder + "/\\.lumbre-[0-9]+/video\\.mp4\n$");
    assertOnly(target);
  }

  /** Nothing is left behind but these files. */
  private void assertOnly(Path... targets) throws IOException {
    assertThat(Folders.files(folder))
        .filteredOn(Files::isRegularFile)
        .containsExactlyInAnyOrder(targets);
  }

  /** A program, or somebody else, may have left a link at a name that can be guessed. */
  @Test
  void onlyANewFileBecomesTheVideo() throws Exception {
    Path secret = Files.writeString(folder.resolve("bin.txt"), "secret");
    Path target = folder.resolve("a.mp4");
    AnimationFrames frames = frames(plain(2, 2, 0xff000000));
    Files.createSymbolicLink(folder.resolve(".a.mp4.video"), secret);
    String copy = COPY.replace("ENCODER", "libx264");
    write(frames, target, program(copy));
    assertThat(secret).hasContent("secret");
    assertThat(Files.size(target)).isEqualTo(12);
    Files.delete(target);
    for (String left : List.of("ln -s " + secret + " \"$last\"", "mkfifo \"$last\"")) {
      String linking = copy.replace("cat > \"$last\"", "cat > /dev/null; " + left);
      assertThatThrownBy(() -> write(frames, target, program(linking)))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("ffmpeg: left no video: a link or another special file");
      assertThat(target).doesNotExist();
    }
    assertThat(secret).hasContent("secret");
    Files.delete(folder.resolve(".a.mp4.video"));
    assertOnly(secret);
    assertThat(folder.toFile().list()).containsExactlyInAnyOrder("bin", "bin.txt", "frames");
  }

  @ParameterizedTest
  @CsvSource({
    "a.mp4, libx264, 16384",
    "a.mp4, mpeg4, 8190",
    "a.webm, libvpx-vp9, 16384",
    "a.webm, libvpx, 16382"
  })
  void tooLargeFramesAreRefusedBeforehand(Path name, String encoder, int most) throws Exception {
    AnimationWriter writer =
        AnimationFormat.of(name)
            .orElseThrow()
            .writer(Optional.empty(), program(COPY.replace("ENCODER", encoder)));
    writer.requireFits(most - 1, 1);
    for (int side : new int[] {most + 1, 65535}) {
      assertThatThrownBy(() -> writer.requireFits(side, 1))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("a video of the encoder %s has at most %d", encoder, most);
      assertThatThrownBy(() -> writer.requireFits(1, side))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }

  @Test
  void whatIsMissingIsNamed() throws Exception {
    Map<String, String> environment = program(COPY.replace("ENCODER", "libx264rgb"));
    String path = folder.resolve("bin/ffmpeg").toString();
    assertThatThrownBy(() -> AnimationFormat.MP4.writer(Optional.empty(), environment))
        .isInstanceOf(IOException.class)
        .hasMessage(
            path
                + ": cannot write .mp4: it lacks the encoders libx264 and mpeg4; install a build"
                + " that has one of them");
    assertThatThrownBy(() -> AnimationFormat.WEBM.writer(Optional.of(folder), environment))
        .hasMessage(folder + ": not a program; install it; or state its path in LUMBRE_FFMPEG");
    assertThatThrownBy(() -> AnimationFormat.WEBM.writer(Optional.empty(), Map.of()))
        .hasMessage(
            "ffmpeg: not found on the PATH; install it; or state its path in LUMBRE_FFMPEG");
  }

  @Test
  void aFailureKeepsThePreviousFile() throws Exception {
    Path target = Files.writeString(folder.resolve("a.webm"), "before");
    AnimationFrames frames = frames(plain(2, 2, 0xff000000));
    String copy = COPY.replace("ENCODER", "libvpx");
    assertThatThrownBy(
            () -> write(frames, target, program(copy + "echo No space left on device; exit 1\n")))
        .isInstanceOf(IOException.class)
        .hasMessageEndingWith("failed with code 1: No space left on device");
    String nothing = copy.replace("cat > \"$last\"", "cat > /dev/null");
    assertThatThrownBy(() -> write(frames, target, program(nothing)))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("ffmpeg: left no video");
    Files.writeString(frames.files().get(0), "damaged");
    assertThatThrownBy(() -> write(frames, target, program(copy)))
        .hasMessageContaining("frame-000.png: expected a PNG");
    assertThat(target).hasContent("before");
    assertOnly(target);
  }

  @Test
  void anInterruptEndsTheProgram() throws Exception {
    Path target = folder.resolve("a.mp4");
    AnimationFrames frames = frames(plain(2, 2, 0xff000000));
    Map<String, String> environment =
        program(COPY.replace("ENCODER", "mpeg4") + "touch \"$(dirname \"$0\")/begun\"; sleep 60\n");
    Thread thread = Thread.currentThread();
    Thread interrupter =
        new Thread(
            () -> {
              while (!Files.exists(folder.resolve("bin/begun"))) {
                Thread.onSpinWait();
              }
              thread.interrupt();
            });
    interrupter.start();
    assertThatThrownBy(() -> write(frames, target, environment))
        .isInstanceOf(InterruptedException.class);
    interrupter.join();
    assertOnly();
  }

  /**
   * Plain frames come back but for the rounding of two conversions between RGB and YCbCr, and the
   * loss of a good quality: 4 of 255.
   */
  @ParameterizedTest
  @CsvSource({"a.mp4, 48, 32", "a.webm, 47, 31", "a.mp4, 1, 1", "a.webm, 1, 1"})
  void theRealProgramWritesTheFrames(String name, int width, int height) throws Exception {
    Path target = folder.resolve(name);
    AnimationFrames frames = frames(plain(width, height, 0xffc08040), plain(width, height, ~0));
    ExternalProgram ffmpeg;
    try {
      ffmpeg =
          ExternalProgram.find("ffmpeg", Optional.empty(), "LUMBRE_FFMPEG", System.getenv(), "");
    } catch (IOException e) {
      Assumptions.abort("ffmpeg is not installed");
      return;
    }
    write(frames, target, System.getenv());
    Path decoded = folder.resolve("decoded.rgb");
    List<String> arguments =
        List.of("-v", "error", "-i", target.toString(), "-vf", "scale=in_color_matrix=bt709");
    ffmpeg.run(
        Stream.concat(
                arguments.stream(),
                Stream.of("-pix_fmt", "rgb24", "-f", "rawvideo", decoded.toString()))
            .toList(),
        ExternalProgram.Input.NONE);
    byte[] bytes = Files.readAllBytes(decoded);
    int size = 3 * (width + width % 2) * (height + height % 2);
    assertThat(bytes).hasSize(2 * size);
    int[] expected = {0xc0, 0x80, 0x40};
    for (int i = 0; i < size; i++) {
      assertThat(bytes[i] & 0xff).isCloseTo(expected[i % 3], within(4));
      assertThat(bytes[size + i] & 0xff).isCloseTo(0xff, within(4));
    }
  }
}
