package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code render} of several scenes onto one contact sheet. */
class RenderSheetTest extends CommandFixture {
  private static final String SMALL = " --size 64x48 -s 1 --no-denoise";

  /** The width and height of the cells of {@link #SMALL}, with gaps. */
  private static final int RIGHT = 64 + 2;

  private static final int DOWN = 48 + 16 + 2;

  @BeforeEach
  void writeScenes() throws IOException {
    ModelSample.write(directory);
    Files.writeString(directory.resolve("tiny.json"), TinyScene.JSON);
    Files.writeString(directory.resolve("broken.glb"), "glTF and no more");
  }

  private Pixels decoded(String name) throws IOException {
    return ImageReader.decode(bytes(name));
  }

  /** Checks that a part of a picture with 16 bits is another one. */
  private void assertShows(String sheet, int left, int top, String picture) throws IOException {
    Pixels all = decoded(sheet);
    Pixels one = decoded(picture);
    for (int i = 0; i < one.width() * one.height(); i++) {
      int x = i % one.width();
      int y = i / one.width();
      for (int channel = 0; channel < 3; channel++) {
        assertThat(all.raw(left + x, top + y, channel))
            .as(picture + " at " + x + "," + y)
            .isBetween(one.raw(x, y, channel) - 1, one.raw(x, y, channel) + 1);
      }
    }
  }

  /** Five scenes have three columns; each cell has the picture of a render by itself. */
  @ParameterizedTest
  @ValueSource(strings = {"", " --tonemap gamma22", " --exposure auto"})
  void cellsAreThePicturesInTheOrderOfTheArguments(String flags) throws IOException {
    String more = flags + " --bits 16" + SMALL;
    String scenes = "T/tiny.json T/sample.glb T/tiny.json T/tiny.json T/sample.glb";
    runs("render " + scenes + " --sheet T/s.png" + more);
    Pixels sheet = decoded("s.png");
    assertThat(List.of(sheet.width(), sheet.height())).containsExactly(3 * RIGHT - 2, 2 * DOWN - 2);
    runs("render T/tiny.json -o T/a.png" + more);
    runs("render T/sample.glb -o T/b.png" + more);
    assertShows("s.png", 0, 0, "a.png");
    assertShows("s.png", RIGHT, 0, "b.png");
    assertShows("s.png", 2 * RIGHT, 0, "a.png");
    assertShows("s.png", 0, DOWN, "a.png");
    assertShows("s.png", RIGHT, DOWN, "b.png");
    assertThat(sheet.raw(2 * RIGHT + 30, DOWN + 20, 0)).as("a free cell").isEqualTo(65535);
  }

  /** A picture of 8 bits that is quantized twice would keep the dithering of its own place. */
  @Test
  void sheetsAreDitheredOnceByTheirOwnPlace() throws IOException {
    String line = "render T/sample.glb T/sample.glb --view front" + SMALL;
    runs(line + " --sheet T/fine.png --bits 16");
    runs(line + " --sheet T/s.png");
    Pixels fine = decoded("fine.png");
    Pixels sheet = decoded("s.png");
    int different = 0;
    for (int i = 0; i < 64 * 48; i++) {
      int x = i % 64;
      int y = i / 64;
      double exact = fine.raw(RIGHT + x, y, 1) / 257.0;
      assertThat((double) sheet.raw(RIGHT + x, y, 1)).isBetween(exact - 1.01, exact + 1.01);
      different += sheet.raw(RIGHT + x, y, 1) == sheet.raw(x, y, 1) ? 0 : 1;
    }
    assertThat(different).isGreaterThan(200);
  }

  /** Returns the number of pixels that are darker than half in a part of a picture. */
  private static int ink(BufferedImage picture, int left, int top, int width, int height) {
    int[] pixels = picture.getRGB(left, top, width, height, null, 0, width);
    return (int) Arrays.stream(pixels).filter(color -> (color & 0xff) < 128).count();
  }

  @Test
  void failedScenesAreEmptyCellsWithTheirNames() {
    Outcome outcome =
        run(
            "render T/broken.glb T/sample.glb T/none.glb --background black --sheet T/s.png"
                + SMALL);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.ASSET);
    String said = outcome.err().replace(directory.toString(), "T");
    assertThat(said)
        .contains("broken.glb: ", "none.glb: expected a model file, found none")
        .containsPattern(
            "\nT/s.png: 130x130 pixels, 2 columns; 1 of 3 pictures written, 2 failed:"
                + " T/broken.glb, T/none.glb; [0-9.]+ s\n$");
    BufferedImage sheet = picture("s.png");
    assertThat(ink(sheet, 0, 0, 64, 48)).isZero();
    assertThat(ink(sheet, 0, DOWN, 64, 48)).isZero();
    assertThat(ink(sheet, RIGHT, 0, 64, 48)).isPositive();
    for (int cell = 0; cell < 3; cell++) {
      int left = cell % 2 * RIGHT;
      int top = cell / 2 * DOWN + 48;
      assertThat(ink(sheet, left, top, 64, 16)).as("a name").isBetween(20, 64 * 16 / 2);
    }
    assertThat(ink(sheet, RIGHT, DOWN, 64, 64)).as("a free cell").isZero();
  }

  @Test
  void nothingIsWrittenIfAllScenesFail() {
    Outcome outcome = run("render T/broken.glb T/none.glb --sheet T/new/s.png" + SMALL);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.ASSET);
    assertThat(outcome.err()).contains("s.png: not written; 0 of 2 pictures written, 2 failed: ");
    assertThat(directory.resolve("new")).doesNotExist();
  }

  /** Models have the aspect ratios of their cameras; the cells that of the largest picture. */
  @Test
  void picturesWithoutASizeAreSmallAndInTheMiddle() throws IOException {
    runs("render T/sample.glb T/tiny.json --no-denoise -s 1 --crop 0,0,60,40 --sheet T/s.png");
    assertThat(picture("s.png").getWidth()).isEqualTo(2 * 60 + 1);
    runs("render T/sample.glb --no-denoise -s 1 --sheet T/s.jpg");
    assertThat(picture("s.jpg").getWidth()).isEqualTo(256);
    Files.writeString(
        directory.resolve("tall.json"), TinyScene.with("\"height\": 12", "\"height\": 32"));
    runs("render T/tall.json T/tiny.json --size 64 -s 1 --sheet T/s.png");
    BufferedImage sheet = picture("s.png");
    assertThat(sheet.getWidth()).isEqualTo(2 * 64 + 2);
    assertThat(sheet.getRGB(2, 30) & 0xffffff).as("beside a tall picture").isEqualTo(0xffffff);
    assertThat(sheet.getRGB(64 + 2 + 30, 2) & 0xffffff).as("above a wide one").isEqualTo(0xffffff);
    assertThat(sheet.getRGB(64 + 2 + 30, 30) & 0xffffff).isNotEqualTo(0xffffff);
  }

  @Test
  void sheetsOfTransparentPicturesAreTransparent() throws IOException {
    String clear = " --background transparent" + SMALL;
    runs("render T/sample.glb T/sample.glb --sheet T/s.png" + clear);
    Pixels sheet = decoded("s.png");
    runs("render T/sample.glb -o T/a.png" + clear);
    Pixels one = decoded("a.png");
    for (int i = 0; i < 64 * 48; i++) {
      assertThat(sheet.alpha(RIGHT + i % 64, i / 64)).isEqualTo(one.alpha(i % 64, i / 64));
    }
    assertThat(sheet.alpha(64, 10)).as("the gap").isZero();
  }

  @Test
  void theSummaryStatesThePlaceOfEachScene() {
    Outcome outcome =
        run("render T/sample.glb T/broken.glb --sheet T/s.png --json --quiet" + SMALL);
    List<JsonObject> lines =
        outcome.out().lines().map(line -> JsonParser.parseString(line).getAsJsonObject()).toList();
    assertThat(lines).hasSize(3);
    assertThat(lines.get(0).get("output").getAsString()).isEqualTo(path("s.png"));
    JsonObject last = lines.get(2);
    assertThat(last.get("sheet").getAsString()).isEqualTo(path("s.png"));
    assertThat(last.get("exit_code").getAsInt()).isEqualTo(ExitCodes.ASSET);
    assertThat(last.get("complete").getAsBoolean()).isTrue();
    JsonArray cells = last.getAsJsonArray("cells");
    assertThat(cells.get(0).getAsJsonObject().get("empty").getAsBoolean()).isFalse();
    assertThat(cells.get(1).getAsJsonObject().get("empty").getAsBoolean()).isTrue();
    assertThat(cells.get(1).getAsJsonObject().get("scene").getAsString())
        .isEqualTo(path("broken.glb"));
    assertThat(cells.get(1).getAsJsonObject().get("box").toString()).isEqualTo("[66,0,64,64]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--sheet T/s.exr                  | --sheet: expected a name that ends in .png or .jpg",
        "--sheet T/s                      | --sheet: expected a name that ends in .png or .jpg",
        "--sheet T/s.png -o T/out         | --output: cannot be combined with --sheet",
        "--sheet T/s.png --format png     | --format: cannot be combined with --sheet",
        "--sheet T/s.png --checkpoint T/f | --checkpoint: cannot be combined with --sheet",
        "--sheet T/s.png --turntable 3    | --turntable: cannot be combined with --sheet",
        "--sheet T/s.png --animation lift | --animation: cannot be combined with --sheet",
        "--sheet T/s.png --dry-run        | --dry-run: cannot be combined with --sheet",
        "--sheet T/s.png --layers depth   | --layers: cannot be combined with --sheet",
        "--sheet T/s.png --frames 0       | --frames: requires --turntable, --animation or --explode",
        "--sheet T/s.png --view iso -     | -: standard input cannot be one of several scenes",
        "--sheet T/s.png --size 0         | --size: expected 1 to"
      })
  void flagsThatDoNotSuitAreRefused(String flags, String message) {
    run("render T/sample.glb " + flags).assertFailed(ExitCodes.USAGE, message);
    assertThat(directory.resolve("s.png")).doesNotExist();
  }

  private String many(int count) {
    return "render" + String.join("", Collections.nCopies(count, " T/tiny.json"));
  }

  @Test
  void sheetsThatAreTooLargeAreRefusedBeforeRendering() {
    run(many(401) + " --sheet T/s.png -s 1")
        .assertFailed(ExitCodes.USAGE, "--sheet: expected at most 400 scenes, found 401");
    Outcome large = run(many(400) + " --size 1000x1000 --sheet T/s.png -s 1");
    assertThat(large.exitCode()).isEqualTo(ExitCodes.LIMIT);
    assertThat(large.err().lines()).as(large.err()).hasSize(1);
    assertThat(large.err())
        .contains("s.png: would have 20", "pixels, but a sheet has at most 2^28 pixels; choose");
    run(many(300) + " --size 12x4000 --sheet T/s.jpg -s 1")
        .assertFailed(ExitCodes.LIMIT, "a JPEG has at most 65500 pixels on a side");
    assertThat(directory.resolve("s.png")).doesNotExist();
  }

  @Test
  void theTimeLimitLeavesAPartialSheet() throws IOException {
    Outcome outcome =
        run(
            "render T/tiny.json T/tiny.json --sheet T/s.png -s 100000000 --size 16x12"
                + " --timeout 2s");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.LIMIT);
    assertThat(outcome.err()).contains("s.png: ", " 2 columns, partial; ", "1 not rendered");
    assertThat(texts("s.png")).containsEntry("Partial", "0 of 2 pictures are complete");
    runs("render T/tiny.json T/tiny.json --sheet T/s.png -s 1 --size 16x12");
    assertThat(texts("s.png")).doesNotContainKey("Partial");
  }

  /** Names of 14 pixels cannot be read; that is said, and the pictures are written. */
  @Test
  void namesWithoutRoomAreReported() {
    assertThat(runs("render T/sample.glb T/tiny.json --sheet T/s.png --size 16x12 -s 1").err())
        .contains("s.png: 2 names have no room below the picture; choose a larger --size");
    assertThat(runs("render T/sample.glb T/tiny.json --sheet T/s.png" + SMALL).err())
        .doesNotContain("no room");
  }

  @Test
  void equalNamesHaveTheirFolders() {
    List<Path> scenes = List.of(Path.of("a/x.glb"), Path.of("b/x.glb"), Path.of("b/y.glb"));
    assertThat(RenderSheet.names(scenes)).containsExactly("a/x.glb", "b/x.glb", "y.glb");
    assertThat(RenderSheet.names(List.of(Path.of("/x.glb"), Path.of("/x.glb"))))
        .containsExactly("x.glb", "x.glb");
  }
}
