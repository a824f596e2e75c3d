package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.internal.PictureTexts;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.testing.Folders;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Animations and turntables: their frames, parts of them, and those that are continued. */
class AnimationCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 16x12 -s 2";
  private static final String LIFT = "render T/sample.glb --animation lift --fps 4";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  private List<String> files(String start) throws IOException {
    return Folders.names(directory).stream().filter(name -> name.startsWith(start)).toList();
  }

  /** The animation lasts 1 s: the frame at its end is the first one of the next loop. */
  @Test
  void framesAreThePosesFromTheStartToBeforeTheEnd() throws IOException {
    String printed = said(LIFT + " -o T/a.pfm" + SMALL);
    assertThat(printed)
        .containsPattern("4 of 4 pictures written: a-000.pfm to a-003.pfm; [0-9.]+ s\n");
    assertThat(files("a-")).containsExactly("a-000.pfm", "a-001.pfm", "a-002.pfm", "a-003.pfm");
    for (String pose : List.of("000@0", "001@0.25", "003@0.75")) {
      runs("render T/sample.glb --pose lift" + pose.substring(3) + " -o T/b.pfm" + SMALL);
      assertSame("a-" + pose.substring(0, 3) + ".pfm", "b.pfm");
    }
  }

  @Test
  void oneCameraHasAllPosesInItsFrame() throws IOException {
    String view = " --view front --no-denoise --background #000000";
    runs(LIFT + view + " -o T/a.pfm" + SMALL);
    runs(LIFT + view + " --frames 2 -o T/b.pfm" + SMALL);
    assertSame("a-002.pfm", "b-002.pfm");
    assertThat(files("b-")).containsExactly("b-002.pfm");
    // Twice the frames, the same poses at every second one.
    runs(LIFT.replace("4", "8") + view + " --frames 4 -o T/c.pfm" + SMALL);
    assertSame("a-002.pfm", "c-004.pfm");
    runs("render T/sample.glb --pose lift@0.5 -o T/d.pfm" + view + SMALL);
    assertThat(Files.mismatch(directory.resolve("a-002.pfm"), directory.resolve("d.pfm")))
        .isNotNegative();
  }

  @Test
  void framesStateTheHashesOfSinglePictures() throws IOException {
    runs("render T/sample.glb --turntable 3 --labels view --ground -o T/a.png" + SMALL);
    runs(
        "render T/sample.glb --turntable 1 --view 150,20 --labels view --ground -o T/b.png"
            + SMALL);
    assertThat(texts("a-001.png")).containsEntry("SceneHash", texts("b-000.png").get("SceneHash"));
    assertThat(texts("a-001.png").get("SceneHash"))
        .isNotEqualTo(texts("a-002.png").get("SceneHash"));
    assertThat(texts("a-001.png")).containsEntry("Labels", "view");
    runs(LIFT + " -o T/c.png" + SMALL);
    runs("render T/sample.glb --pose lift@0.25 -o T/d.png" + SMALL);
    assertThat(texts("c-001.png")).containsEntry("SceneHash", texts("d.png").get("SceneHash"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--turntable 3", "--animation lift --fps 3 --view front"})
  void missingFramesAreContinued(String what) throws IOException {
    String line = "render T/sample.glb " + what + " --continue -o T/a.png" + SMALL;
    assertThat(said(line)).contains("3 of 3 pictures written, denoised: a-000.png");
    int[] pixels = pixels("a-001.png");
    byte[] second = Files.readAllBytes(directory.resolve("a-001.png"));
    Files.delete(directory.resolve("a-001.png"));
    Object before = Files.getLastModifiedTime(directory.resolve("a-000.png"));
    assertThat(said(line))
        .contains(
            "1 of 3 pictures written, denoised, 2 neighbors rendered again, 2 were complete: a-");
    assertThat(pixels("a-001.png")).isEqualTo(pixels);
    assertThat(Files.getLastModifiedTime(directory.resolve("a-000.png"))).isEqualTo(before);
    assertThat(PictureTexts.read(directory.resolve("a-001.png"))).containsKey("SceneHash");
    assertThat(Files.size(directory.resolve("a-001.png")))
        .isBetween(second.length - 9L, second.length + 9L);
    assertThat(said(line)).contains("0 of 3 pictures written, denoised, 3 were complete");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "-s 3                   | its metadata have Samples 2, expected 3",
        "--seed 5               | its metadata have Seed 0, expected 5",
        "--depth 3              | its metadata have MaxTraceDepth 12, expected 3",
        "--exposure 1           | its metadata have Exposure nothing, expected 1.0",
        "--labels view          | its metadata have Labels nothing, expected view",
        "--size 12x16           | its metadata have Size 16x12, expected 12x16",
        "--no-denoise           | it is denoised",
        "--target-error 50%     | its metadata have TargetError nothing, expected 50 %",
        "--view top             | its scene is another one: the model, one of its files or a flag",
        "--ground               | its scene is another one"
      })
  void framesOfAnotherRenderAreRefused(String flags, String message) throws IOException {
    String line = "render T/sample.glb --turntable 2 --continue -o T/a.png --size 16x12 ";
    runs(line + "-s 2");
    Files.delete(directory.resolve("a-000.png"));
    byte[] before = Files.readAllBytes(directory.resolve("a-001.png"));
    String other = flags.startsWith("-s") ? flags : "-s 2 " + flags;
    run(line.replace("--size 16x12 ", flags.startsWith("--size") ? "" : "--size 16x12 ") + other)
        .assertFailed(
            ExitCodes.USAGE, "a-001.png: cannot be continued: " + message, "choose another path");
    assertThat(directory.resolve("a-000.png")).doesNotExist();
    assertThat(Files.readAllBytes(directory.resolve("a-001.png"))).isEqualTo(before);
  }

  @Test
  void partialFramesAreRenderedAnew() throws IOException {
    String line = "render T/sample.glb --turntable 2 --size 16x12 --no-denoise -o T/a.png";
    run(line + " -s 100000000 --timeout 3s");
    assertThat(texts("a-000.png")).containsKey("Partial");
    assertThat(said(line + " -s 2 --continue")).contains("2 of 2 pictures written");
    assertThat(texts("a-000.png")).doesNotContainKey("Partial");
  }

  @Test
  void partsOfASequenceMakeTheWhole() throws IOException {
    runs(LIFT + " -o T/a.pfm" + SMALL);
    for (String part : List.of("0..1", "2", "3/4")) {
      runs(LIFT + " -o T/b.pfm --frames " + part + SMALL);
    }
    assertThat(files("b-")).hasSize(4);
    for (int i = 0; i < 4; i++) {
      assertSame("a-00" + i + ".pfm", "b-00" + i + ".pfm");
    }
  }

  @Test
  void automaticExposureIsThatOfTheFirstFrame() throws IOException {
    String line = "render T/sample.glb --turntable 3 --exposure auto --sky sun -o T/a.png" + SMALL;
    runs(line);
    String chosen = texts("a-000.png").get("ChosenExposure");
    assertThat(chosen).isNotNull();
    assertThat(texts("a-002.png")).containsEntry("ChosenExposure", chosen);
    Files.delete(directory.resolve("a-000.png"));
    Files.delete(directory.resolve("a-002.png"));
    runs(line + " --continue --frames 2");
    assertThat(texts("a-002.png")).containsEntry("ChosenExposure", chosen);
    run(line.replace("a.png", "b.png") + " --frames 1..2")
        .assertFailed(ExitCodes.USAGE, "--exposure auto: is chosen from the first frame");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--animation wave            | 4 | expected \"lift\", found \"wave\"",
        "--animation lift --fps 0    | 2 | expected 1/600 to 65535 frames",
        "--fps 5                     | 2 | --fps: requires --animation",
        "--animation lift --pose lift@1 | 2 | --animation: cannot be combined with --pose",
        "--animation lift --turntable 3 | 2 | --turntable and --animation: expected only one",
        "--animation lift --checkpoint T/a.film | 2 | --animation: requires a model file",
        "--animation lift --frames 20..30 | 2 | --frames: expected frames from 0 to 24",
        "--animation lift --frames 3..2 | 2 | --frames: expected frames from 0 to 24",
        "--animation lift --frames x | 2 | --frames: expected I/N",
        "--animation lift --frames 1..x | 2 | --frames: expected A..B, A, I/N or auto",
        "--animation lift --frames 0/99 | 2 | --frames: expected at least one frame for each",
        "--turntable 2 --continue -o T/a.jpg | 2 | --continue: expected PNG or OpenEXR",
        "--frames 1                  | 2 | --frames: requires --turntable, --animation or --explode A..B",
        "--continue                  | 2 | --continue: requires --turntable, --animation or --explode A..B"
      })
  void wrongRequestsAreRefused(String flags, int code, String message) {
    String output = flags.contains(" -o ") ? "" : " -o T/a.png";
    Outcome outcome = run("render T/sample.glb " + flags + output + SMALL);
    assertThat(outcome.err()).contains(message);
    assertThat(outcome.exitCode()).isEqualTo(code);
  }

  @Test
  void animationsThatAreTooLongOrMissingAreRefused() throws IOException {
    ModelSample.writeWith(directory, "\"max\": [1]}", "\"max\": [1e30]}");
    run(LIFT + " -o T/a.png" + SMALL).assertFailed(ExitCodes.LIMIT, "frames of the animation");
    ModelSample.writeWith(directory, "\"min\": [0], \"max\": [1]", "\"min\": [0]");
    run(LIFT + " -o T/a.png" + SMALL).assertFailed(ExitCodes.ASSET, "lift", "states no length");
    Files.writeString(directory.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Outcome outcome = run("render T/a.obj --animation lift -o T/a.png" + SMALL);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.ASSET);
    assertThat(outcome.err()).contains("lift", "none");
    assertThat(Arrays.asList(directory.toFile().list())).noneMatch(name -> name.endsWith("a.png"));
  }

  @Test
  void otherFilesAmongTheFramesAreRefused() throws IOException {
    Files.writeString(directory.resolve("a-001.png"), "a letter");
    String line = "render T/sample.glb --turntable 2 -o T/a.png" + SMALL;
    run(line).assertFailed(ExitCodes.OUTPUT, "a-001.png: exists and is not a PNG");
    run(line + " --continue").assertFailed(ExitCodes.USAGE, "a-001.png: cannot be continued");
    assertThat(directory.resolve("a-001.png")).hasContent("a letter");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void framesThatTheFileCannotHaveAreNotRendered() throws IOException {
    Path program =
        Files.writeString(
            directory.resolve("ffmpeg"), "#!/bin/sh\necho ' V....D libvpx-vp9 VP9'\n");
    assertThat(program.toFile().setExecutable(true)).isTrue();
    run("render T/sample.glb --turntable 2 --size 65535x1 -s 1 --ffmpeg T/ffmpeg -o T/a.webm")
        .assertFailed(ExitCodes.LIMIT, "a.webm: a video of the encoder libvpx-vp9 has at most");
    assertThat(files("a.webm")).isEmpty();
    Files.writeString(directory.resolve("b.json"), TinyScene.JSON);
    Files.writeString(
        directory.resolve("c.json"), TinyScene.with("\"width\": 16", "\"width\": 18"));
    Outcome outcome = run("render T/b.json T/c.json -s 1 -o T/c.gif");
    assertThat(outcome.err()).contains("c.json: has 18x12 pixels, expected 16x12");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
  }

  /** Reading a pipe to which nobody writes would take for ever. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
  void pipesAmongTheFramesAreRefused() throws Exception {
    String line = "render T/sample.glb --turntable 2 -o T/a.png" + SMALL;
    for (String name : List.of("a-001.png", ".a-000.png.tmp", ".lumbre.lock")) {
      String pipe = directory.resolve(name).toString();
      assertThat(new ProcessBuilder("mkfifo", pipe).start().waitFor()).isZero();
      Outcome plain = run(line);
      assertThat(plain.exitCode()).as(plain.err()).isEqualTo(ExitCodes.OUTPUT);
      assertThat(plain.err()).contains(name);
      Outcome continued = run(line + " --continue");
      assertThat(continued.err()).contains(name);
      assertThat(continued.exitCode())
          .as(continued.err())
          .isEqualTo(name.startsWith(".") ? ExitCodes.OUTPUT : ExitCodes.USAGE);
      Files.delete(Path.of(pipe));
    }
  }

  /** The pixels of the file are tested with its writer; here are its frames. */
  @Test
  void framesAreJoinedIntoOneFile() throws IOException {
    String line = "render T/sample.glb --turntable 3 --fps 10 -o T/a.";
    String printed = said(line + "gif" + SMALL);
    assertThat(printed)
        .containsPattern("a.gif: 3 frames, denoised, 10 frames per second; [0-9.]+ s\n");
    assertThat(files("a.")).containsExactly("a.gif");
    ImageReader gif = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream in =
        ImageIO.createImageInputStream(directory.resolve("a.gif").toFile())) {
      gif.setInput(in);
      assertThat(gif.getNumImages(true)).isEqualTo(3);
      assertThat(gif.read(0).getWidth()).isEqualTo(16);
    } finally {
      gif.dispose();
    }
    JsonObject json =
        JsonParser.parseString(lastLine(run(line + "apng --json" + SMALL).out())).getAsJsonObject();
    assertThat(json.get("output").getAsString()).endsWith("a.apng");
    assertThat(json.get("frames").getAsInt()).isEqualTo(3);
    assertThat(texts("a.apng")).containsEntry("Samples", "2").doesNotContainKey("SceneHash");
  }

  /** The delays of a GIF's frames are in hundredths of a second. */
  @ParameterizedTest
  @CsvSource({"--seed 0, 4, 500", "--fps 10, 4, 40", "--seed 0, 3, 500"})
  void aTurntableTurnsOnceInFiveSeconds(String flags, int frames, int hundredths)
      throws IOException {
    String line = "render T/sample.glb --turntable " + frames + " --size 4x3 -s 1 " + flags;
    runs(line + " --no-denoise -o T/a.gif");
    byte[] gif = Files.readAllBytes(directory.resolve("a.gif"));
    int time = 0;
    for (int i = 0; i + 7 < gif.length; i++) {
      // A graphic control extension: its length, flags, and the delay.
      if (gif[i] == 0x21 && (gif[i + 1] & 0xff) == 0xf9 && gif[i + 2] == 4 && gif[i + 7] == 0) {
        time += gif[i + 4] & 0xff | (gif[i + 5] & 0xff) << Byte.SIZE;
      }
    }
    assertThat(time).isEqualTo(hundredths);
  }

  private static String lastLine(String text) {
    return text.strip().substring(text.strip().lastIndexOf('\n') + 1);
  }

  @Test
  void severalScenesAreFrames() throws IOException {
    Files.writeString(directory.resolve("b.json"), TinyScene.JSON);
    Files.writeString(
        directory.resolve("c.json"), TinyScene.JSON.replace("\"name\": \"", "\"name\": \"x"));
    String line = "render T/b.json T/c.json T/b.json -o T/a.gif -s 1 --size 8x6 ";
    assertThat(said(line + "--frames 0..1"))
        .contains("2 of 2 pictures written: a.gif.frames/a-000.png");
    assertThat(files("a.gif")).containsExactly("a.gif.frames");
    assertThat(said(line + "--continue"))
        .contains("a.gif: 3 frames, 25 frames per second; 2 were complete");
    assertThat(files("a.gif")).containsExactly("a.gif");
    runs(line + "--frames 0..1");
    // Another file stays, and its folder.
    Path notes = Files.writeString(directory.resolve("a.gif.frames/notes.txt"), "from me");
    runs(line + "--continue");
    assertThat(directory.resolve("a.gif.frames").toFile().list()).containsExactly("notes.txt");
    Files.delete(notes);
    runs(line + "--frames 0..1");
    run(line.replace("-s 1", "-s 2") + "--continue")
        .assertFailed(ExitCodes.USAGE, "a-000.png: cannot be continued: its metadata have Samples");
    run(line).assertFailed(ExitCodes.OUTPUT, "a.gif.frames: exists, with frames of an earlier run");
  }

  @Test
  void stoppedSequencesKeepTheirFrames() throws IOException {
    String line = "render T/sample.glb --turntable 2 --size 16x12 --no-denoise -o T/a.gif";
    Outcome outcome = run(line + " -s 100000000 --timeout 3s");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.LIMIT);
    assertThat(outcome.err()).contains("a-000.png is partial", "the same command with --continue");
    assertThat(files("a.gif")).containsExactly("a.gif.frames");
    Outcome last = run(line + " -s 100000000 --timeout 3s --continue");
    assertThat(last.exitCode()).isEqualTo(ExitCodes.LIMIT);
    runs(line + " -s 2 --continue");
    assertThat(files("a.gif")).containsExactly("a.gif");
  }

  /** A deadline in the last frame leaves it partial: there is nothing to join. */
  @Test
  void partialLastFramesAreNotJoined() throws IOException {
    String line = "render T/sample.glb --turntable 1 --size 16x12 -o T/a.gif";
    run(line + " --quiet -s 100000000 --timeout 3s")
        .assertFailed(
            ExitCodes.LIMIT,
            "--timeout: the time ended before " + directory.resolve("a.gif") + " was written",
            "with --continue");
    assertThat(texts("a.gif.frames/a-000.png")).containsKey("Partial");
  }

  @Test
  void failingProgramsKeepTheFrames() throws IOException {
    String line = "render T/sample.glb --turntable 2 -o T/a.mp4 --quiet" + SMALL;
    run(line + " --ffmpeg T/none").assertFailed(ExitCodes.OUTPUT, "a.mp4: ", "ffmpeg");
    assertThat(files("a.mp4")).isEmpty();
    Path program = directory.resolve("ffmpeg");
    Files.writeString(
        program,
        "#!/bin/sh\ncase \"$*\" in *-encoders*) echo ' V..... libx264 H.264';; *) exit 3;; esac\n");
    assertThat(program.toFile().setExecutable(true)).isTrue();
    run(line + " --ffmpeg T/ffmpeg")
        .assertFailed(
            ExitCodes.OUTPUT,
            "a.mp4: cannot be written: ",
            "its complete frames are in",
            "--continue");
    assertThat(files("a.mp4")).containsExactly("a.mp4.frames");
    assertThat(directory.resolve("a.mp4.frames").toFile().list()).hasSize(2);
  }

  @Test
  void eachKindOfWarningIsPrintedOnce() {
    String line = "render T/sample.glb --turntable 3 --denoise --size 16x12 -s 1 -o T/a.png";
    String printed = said(line);
    assertThat(printed.lines().filter(text -> text.contains("lacks its noise"))).hasSize(1);
    assertThat(printed).contains("warning: ", "a-000.png: lacks its noise");
    assertThat(printed.lines().filter(text -> !text.startsWith("warning: "))).hasSize(1);
    String stats = said(line + " --stats --progress json");
    assertThat(stats.lines().filter(text -> text.contains("peak heap"))).hasSize(3);
    assertThat(stats.lines())
        .anyMatch(text -> text.startsWith("{\"frame\":3,\"frames\":3,\"seconds_left_in_all\":"));
  }

  @Test
  void transparencyThatTheFileLacksIsSaid() {
    String line = "render T/sample.glb --turntable 1 --background transparent -o T/";
    assertThat(said(line + "a.gif" + SMALL)).contains("warning: a.gif: a GIF has no partial");
    assertThat(said(line + "a.apng" + SMALL)).doesNotContain("warning: a.apng");
    assertThat(said("render T/sample.glb --turntable 1 -o T/b.gif" + SMALL))
        .doesNotContain("warning: b.gif");
  }

  /** Returns how many values of a picture are not those of linear light, rounded. */
  private int notRounded(String name, String light) throws IOException {
    BufferedImage picture = picture(name);
    Image image = io.github.lumbre.image.ImageReader.readLinear(directory.resolve(light));
    int different = 0;
    for (int i = 0; i < image.rgb().length / 3; i++) {
      int x = i % image.width();
      int y = i / image.width();
      int green = (int) Math.round(255 * Srgb.encode(image.pixel(x, y).g()));
      different += (picture.getRGB(x, y) >> 8 & 0xff) == green ? 0 : 1;
    }
    return different;
  }

  @Test
  void joinedFramesAreRoundedAndOthersAreDithered() throws IOException {
    String line =
        "render T/sample.glb --turntable 2 --no-denoise --size 48x40 -s 1 --tonemap srgb -o T/";
    runs(line + "light.pfm");
    runs(line + "a.png");
    // Of values spread evenly between two steps, a quarter gets the farther one.
    assertThat(notRounded("a-000.png", "light-000.pfm")).isGreaterThan(48 * 40 / 5);
    assertThat(notRounded("a-001.png", "light-001.pfm")).isGreaterThan(48 * 40 / 5);
    runs(line + "b.apng");
    assertThat(notRounded("b.apng", "light-000.pfm")).isZero();
    runs(line + "c.gif --frames 1");
    assertThat(notRounded("c.gif.frames/c-001.png", "light-001.pfm")).isZero();
  }
}
