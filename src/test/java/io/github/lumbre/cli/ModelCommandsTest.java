package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import io.github.lumbre.base.file.OutputFile;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.stage.Stage.View;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** All commands work on a model file as on a scene. */
class ModelCommandsTest extends CommandFixture {
  private static final String SMALL = " --size 24x18 -s 4 --quiet";

  @BeforeEach
  void writeModel() throws IOException {
    ModelSample.write(directory);
  }

  /** Checks that a part of a sheet is a picture, and that other pixels of it are a step brighter. */
  private static void assertDitheredByItsOwnPlace(BufferedImage part, BufferedImage picture) {
    int[] steps = new int[3];
    for (int i = 0; i < picture.getWidth() * picture.getHeight(); i++) {
      int x = i % picture.getWidth();
      int y = i / picture.getWidth();
      steps[1 + (part.getRGB(x, y) & 0xff) - (picture.getRGB(x, y) & 0xff)]++;
    }
    assertThat(steps).doesNotContain(0);
  }

  @Test
  void viewsAreThoseOfRender() throws IOException {
    String flags = " --ground --sky white --background #8080ff --size 24x18 -s 2";
    Outcome outcome = run("views T/sample.glb -o T/views/new" + flags).done();
    assertThat(outcome.err())
        .matches(
            ".*/views/new: 7 views and a contact sheet, views.png; 24x18 pixels, 2 samples per"
                + " pixel, denoised; [0-9.]+ s\n");
    for (String view : View.standard().keySet()) {
      runs("render T/sample.glb -o T/one.png --quiet --view " + view + flags);
      assertThat(pixels("views/new/" + view + ".png")).as(view).isEqualTo(pixels("one.png"));
      Map<String, String> texts = texts("one.png");
      texts.remove("Time");
      assertThat(texts("views/new/" + view + ".png")).as(view).containsAllEntriesOf(texts);
    }
    BufferedImage sheet = picture("views/new/views.png");
    assertThat(sheet.getWidth()).isEqualTo(4 * 24 + 3);
    assertThat(sheet.getHeight()).isEqualTo(2 * 18 + 1);
    assertDitheredByItsOwnPlace(sheet.getSubimage(50, 19, 24, 18), picture("views/new/iso.png"));
    int[] free = sheet.getRGB(75, 19, 24, 18, null, 0, 24);
    assertThat(free).containsOnly(free[0]);
    assertThat(free[0] & 255).as("a light background").isGreaterThan(200);
  }

  @Test
  void viewsReserveAllPicturesBeforeTheFirst() throws IOException {
    Path folder = Files.createDirectory(directory.resolve("v"));
    try (OutputFile other = OutputFile.open(folder.resolve("views.png"))) {
      run("views T/sample.glb --size 24x18 -s 1 -o T/v")
          .assertFailed(ExitCodes.OUTPUT, "views.png: another run is writing this file");
      assertThat(other.target()).doesNotExist();
    }
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void viewsRefusesWhatItCannotDo() throws IOException {
    for (String flag : new String[] {"--view top", "--camera a"}) {
      Outcome outcome = run("views T/sample.glb -o T/v " + flag);
      assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
      assertThat(outcome.err()).contains(flag.split(" ")[0] + ": cannot be used");
    }
    assertThat(run("views T/none.glb -o T/v").exitCode()).isEqualTo(ExitCodes.SCENE);
    assertThat(run("views T/a.json -o T/v").exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(run("views T/sample.glb -o T/v -s 0").exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(directory.resolve("v")).doesNotExist();
    Files.createDirectory(directory.resolve("v"));
    Files.writeString(directory.resolve("v/top.png"), "notes");
    Outcome kept = run("views T/sample.glb -o T/v");
    assertThat(kept.exitCode()).isEqualTo(ExitCodes.OUTPUT);
    assertThat(directory.resolve("v/top.png")).hasContent("notes");
    assertThat(directory.resolve("v/front.png")).doesNotExist();
  }

  /** With a transparent background, opaque pixels are those of the model. */
  @ParameterizedTest
  @ValueSource(
      strings = {"front", "back", "left", "right", "top", "bottom", "iso", "30,20", "-70,-10"})
  void theWholeModelIsInTheFrame(String view) throws IOException {
    for (String size : new String[] {"128x64", "64x128"}) {
      runs(
          "render T/sample.glb --background transparent -o T/a.png -s 4 --quiet --view "
              + view
              + " --size "
              + size);
      BufferedImage picture = picture("a.png");
      int last = picture.getWidth() - 1;
      int bottom = picture.getHeight() - 1;
      int covered = 0;
      for (int y = 0; y <= bottom; y++) {
        for (int x = 0; x <= last; x++) {
          boolean isBorder = x == 0 || y == 0 || x == last || y == bottom;
          int alpha = picture.getRGB(x, y) >>> 24;
          covered += alpha > 0 ? 1 : 0;
          assertThat(isBorder && alpha > 0).as(x + ", " + y).isFalse();
        }
      }
      assertThat(covered).isGreaterThan(60);
    }
  }

  @Test
  void theDefaultLightIsNeitherDarkNorGlaring() throws IOException {
    runs("render T/sample.glb --view front --background transparent -o T/a.png" + SMALL);
    BufferedImage picture = picture("a.png");
    int[] green =
        Arrays.stream(picture.getRGB(0, 0, 24, 18, null, 0, 24))
            .filter(pixel -> pixel >>> 24 == 255)
            .map(pixel -> pixel >> 8 & 255)
            .sorted()
            .toArray();
    double median = Math.pow(green[green.length / 2] / 255., 2.2);
    assertThat(median).isBetween(.1, .6);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " --camera close",
        " --camera 1",
        " --view iso --fov 60 --ground",
        " --variant red --view back",
        " --pose lift@0.5 --sky white --sky-intensity 0.5",
        " --sky sun --sun 20,40 --sky-rotation 30 --ground",
        " --sky sun --sun 48.1,11.6@2026-06-21T14:00+02:00",
        " --background #336699 --sky T/sky/sky.pfm --sky-rotation 40"
      })
  void theImportedSceneHasTheSamePicture(String flags) throws IOException {
    Files.createDirectory(directory.resolve("sky"));
    runs("render T/sample.glb --sky white -o T/sky/sky.pfm --size 4x2 -s 1 --quiet");
    runs("import T/sample.glb -o T/scene.json" + flags);
    runs("render T/scene.json -o T/a.pfm" + SMALL);
    runs("render T/sample.glb -o T/b.pfm" + SMALL + flags);
    assertSame("a.pfm", "b.pfm");
  }

  @ParameterizedTest
  @ValueSource(strings = {"14:00+0200", "14:00+02", "12:00:00z", "06:30:00.0-0530"})
  void zonesOfTimesHaveTheFormsOfIso(String time) throws IOException {
    String flags = " --sky sun --sun 48.1,11.6@2026-06-21T";
    runs("import T/sample.glb -o T/a.json" + flags + "14:00+02:00");
    runs("import T/sample.glb -o T/b.json" + flags + time);
    assertSame("a.json", "b.json");
  }

  @Test
  void flagsChangeThePicture() throws IOException {
    runs("render T/sample.glb -o T/a.pfm" + SMALL);
    for (String flags :
        new String[] {"--variant red", "--pose lift@1 --camera close", "--ground", "--view top"}) {
      runs("render T/sample.glb -o T/b.pfm " + flags + SMALL);
      assertThat(Files.mismatch(directory.resolve("a.pfm"), directory.resolve("b.pfm")))
          .as(flags)
          .isNotEqualTo(-1);
    }
  }

  @Test
  void aResumedRenderIsBitIdentical() throws IOException {
    runs("render T/sample.glb --view iso --ground -o T/a.pfm --size 24x18 -s 8 --quiet");
    runs("render T/sample.glb --view iso --ground -o T/b.pfm --checkpoint T/b.film" + SMALL);
    Files.createDirectory(directory.resolve("moved"));
    for (String file : new String[] {"sample.glb", "paint.png"}) {
      Files.move(directory.resolve(file), directory.resolve("moved/" + file));
    }
    Outcome lost = run("resume T/b.film -s 8 --quiet");
    assertThat(lost.exitCode()).isIn(ExitCodes.SCENE, ExitCodes.ASSET);
    assertThat(lost.err()).contains("sample.glb");
    runs("resume T/b.film -s 8 --quiet --scene T/moved/sample.glb");
    assertSame("a.pfm", "b.pfm");
  }

  /** A film knows its model, whose pixels decide; without the model, the whole picture does. */
  @Test
  void automaticExposureOfAFilmIsThatOfTheRender() throws IOException {
    String flags = " --background black --layers denoise --checkpoint T/a.film" + SMALL;
    runs("render T/sample.glb -o T/fixed.png --checkpoint T/b.film --background black" + SMALL);
    runs("render T/sample.glb -o T/a.png --exposure auto" + flags);
    runs("develop T/a.film -o T/developed.png");
    runs("develop T/b.film -o T/later.png --exposure auto");
    runs("denoise T/a.film -o T/denoised.png");
    assertSamePixels("developed.png", "a.png");
    assertSamePixels("later.png", "a.png");
    runs("develop T/a.film -o T/clean.png --denoise");
    assertSamePixels("denoised.png", "clean.png");
    assertThat(pixels("fixed.png")).isNotEqualTo(pixels("a.png"));

    Files.writeString(directory.resolve("sample.glb"), "now something else");
    Outcome changed = run("develop T/a.film -o T/whole.png");
    assertThat(changed.exitCode()).isEqualTo(ExitCodes.OK);
    assertThat(changed.err())
        .contains("warning: ", "sample.glb: ", "exposure is measured over the whole picture");
    assertThat(pixels("whole.png")).isNotEqualTo(pixels("a.png"));
    Files.delete(directory.resolve("sample.glb"));
    assertThat(run("denoise T/a.film -o T/b.png").err())
        .contains("found none", "without the film's model, ");
    assertThat(run("develop T/a.film -o T/a.exr").err()).doesNotContain("warning");
    assertThat(run("develop T/a.film -o T/c.png --exposure 2").err()).doesNotContain("warning");
  }

  private void assertSamePixels(String one, String other) throws IOException {
    assertThat(pixels(one)).as(one).isEqualTo(pixels(other));
  }

  /** The sky is beside the folder of the model, and both are moved. */
  @Test
  void aModelMayMoveWithItsSky() throws IOException {
    Files.createDirectories(directory.resolve("old/models"));
    ModelSample.write(directory.resolve("old/models"));
    runs("render T/sample.glb -o T/old/sky.pfm --size 4x2 -s 1 --quiet");
    runs(
        "render T/old/models/sample.glb --sky T/old/sky.pfm -o T/b.pfm --checkpoint T/b.film"
            + SMALL);
    Files.move(directory.resolve("old"), directory.resolve("new"));
    runs("resume T/b.film -s 6 --quiet --scene T/new/models/sample.glb");
  }

  @Test
  void aChangedModelIsNotResumed() throws IOException {
    runs("render T/sample.glb -o T/b.pfm --checkpoint T/b.film" + SMALL);
    ModelSample.writeWith(directory, "\"metallicFactor\": 0", "\"metallicFactor\": 1");
    assertThat(run("resume T/b.film -s 8 --quiet").exitCode()).isNotEqualTo(ExitCodes.OK);
  }

  @Test
  void mergedSharesAreBitIdentical() {
    runs("render T/sample.glb -o T/a.pfm" + SMALL);
    for (int i = 0; i < 2; i++) {
      runs(
          "render T/sample.glb --share %1$d/2 --checkpoint T/%1$d.film -o T/%1$d.pfm".formatted(i)
              + SMALL);
    }
    runs("merge T/0.film T/1.film -o T/b.pfm");
    assertSame("a.pfm", "b.pfm");
  }

  @Test
  void turntablesAreNumberedAndBeginWithTheView() throws IOException {
    runs("render T/sample.glb --turntable 3 --view 10,5 -o T/a.pfm" + SMALL);
    runs("render T/sample.glb --turntable 1 --view 10,5 -o T/first.pfm" + SMALL);
    runs("render T/sample.glb --turntable 1 --view 130,5 -o T/second.pfm" + SMALL);
    assertSame("a-000.pfm", "first-000.pfm");
    assertSame("a-001.pfm", "second-000.pfm");
    assertThat(directory.resolve("a-002.pfm")).exists();
    assertThat(directory.resolve("a.pfm")).doesNotExist();
  }

  @Test
  void framesShareTheTimeOfTheCommand() {
    Outcome outcome =
        run("render T/sample.glb --turntable 4 --size 24x18 --time 4s --json -o T/a.pfm").done();
    double[] seconds =
        outcome
            .out()
            .lines()
            .map(line -> JsonParser.parseString(line).getAsJsonObject())
            .mapToDouble(frame -> frame.get("seconds").getAsDouble())
            .toArray();
    assertThat(seconds).hasSize(4);
    assertThat(Arrays.stream(seconds).min().orElseThrow())
        .isGreaterThan(Arrays.stream(seconds).max().orElseThrow() / 10);
  }

  /** The timer interrupts reading as a signal does. */
  @Test
  void resumedReadingOfAModelEnds() {
    runs("render T/sample.glb --checkpoint T/a.film -o T/a.pfm" + SMALL);
    run("resume T/a.film -s 8 --timeout 0.000001s")
        .assertFailed(ExitCodes.LIMIT, "--timeout: the time ended before anything was rendered");
  }

  @Test
  void oneTimeoutEndsAllFrames() throws IOException {
    // Reading is quick once its classes are loaded.
    runs("render T/sample.glb -o T/first.pfm" + SMALL);
    Outcome outcome =
        run("render T/sample.glb --turntable 3 --size 24x18 -s 100000000 --timeout 2s -o T/a.pfm");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.LIMIT);
    assertThat(outcome.err().replace(directory + "/", ""))
        .endsWith(
            "lumbre: --timeout: the time ended after 0 of 3 pictures: a-000.pfm is partial,"
                + " 2 not rendered: a-001.pfm to a-002.pfm\n");
    assertThat(directory.resolve("a-000.pfm")).exists();
    assertThat(directory.resolve("a-001.pfm")).doesNotExist();
  }

  @Test
  void theMemoryOfATurntableIsEstimatedOnce() {
    Outcome outcome =
        run("render T/sample.glb --turntable 3 --dry-run --json -o T/a.pfm" + SMALL).done();
    assertThat(outcome.out().lines()).hasSize(1);
    assertThat(directory.resolve("a-000.pfm")).doesNotExist();
  }

  @Test
  void foreignFilesAmongTheFramesAreFoundFirst() throws IOException {
    Files.writeString(directory.resolve("a-002.pfm"), "a letter");
    run("render T/sample.glb --turntable 3 -o T/a.pfm" + SMALL)
        .assertFailed(ExitCodes.OUTPUT, "a-002.pfm: exists and is not a PNG");
    Files.delete(directory.resolve("a-002.pfm"));
    Files.createDirectory(directory.resolve("a-002.pfm"));
    run("render T/sample.glb --turntable 3 -o T/a.pfm" + SMALL)
        .assertFailed(ExitCodes.OUTPUT, "a-002.pfm: is a directory");
    assertThat(directory.resolve("a-000.pfm")).doesNotExist();
  }

  @Test
  void reportsNameNodesAndMaterials() {
    Outcome pixel = run("pixel T/sample.glb 12,9 --size 24x18 -s 4 --sample 0");
    assertThat(pixel.out()).contains("nodes[0]", "body", "materials[0]", "paint");
    Outcome around = run("pixel T/sample.glb 12,17 --ground --size 24x18 -s 4 --sample 0");
    assertThat(around.out())
        .containsPattern("hits .*\"ground\"")
        .containsPattern("material .*\"ground\"")
        .containsPattern("light .*\"sky\"");
    Outcome audit = run("audit T/sample.glb --view front --camera close");
    assertThat(audit.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(run("audit T/sample.glb --camera close").exitCode()).isEqualTo(ExitCodes.OK);
    assertThat(run("check T/sample.glb --plan").out()).contains("meshes");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--camera closer | cameras: expected \"close\" or \"1\", found \"closer\"; did you mean",
        "--variant rde | expected \"red\" or \"blue\", found \"rde\"",
        "--pose lfit@1 | \"lift\"",
        "--sky sky/none.hdr | sample.glb: --sky: expected a file, found none at \"sky/none.hdr\"",
        "--sky . | sample.glb: --sky: expected a file, found a folder at \".\""
      })
  void unknownNamesListWhatTheModelOffers(String flags, String message) {
    run("render T/sample.glb -o T/a.png " + flags).assertFailed(ExitCodes.ASSET, message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--view up | --view: expected front, back",
        "--view 0,91 | --view: expected an elevation",
        "--view front --camera close | --camera and --view",
        "--fov 180 | --fov",
        "--unit 0 | --unit",
        "--points 0 | --points: expected a number from 1e-100 to 1e100, found 0.0",
        "--up x | --up: expected y or z, found x",
        "--pose lift@-1 | --pose",
        "--pose lift | --pose: expected NAME@SECONDS, such as lift@0, found lift",
        "--pose lift@soon | --pose: expected a number, found soon",
        "--background redd | --background: expected sky, transparent, a color such as #ff8800",
        "--background redd | found 'redd'; did you mean red?",
        "--background #12345g | --background",
        "--background rgb(1,2,3) | --background",
        "--sky-intensity -1 | --sky-intensity: expected a number from 0 to 1e150, found -1.0",
        "--sky-intensity 1e308 | --sky-intensity: expected a number from 0 to 1e150, found 1.0E308",
        "--sky-rotation 1e400 | --sky-rotation: expected a finite number, found Infinity",
        "--sun 0,30 | --sun: requires --sky sun",
        "--sky sun --sun 0,-1 | --sun: expected an elevation from 0 to 90, found -1.0",
        "--sky sun --sun 0,91 | --sun: expected an elevation from -90 to 90, found 91",
        "--sky sun --sun 0,x | --sun: expected a number, found x",
        "--sky sun --sun 48@2026-06-21T12:00Z | --sun: expected LATITUDE,LONGITUDE@TIME, found 48@",
        "--sky sun --sun 48,x@2026-06-21T12:00Z | --sun: expected a number, found x",
        "--sky sun --sun 98,11@2026-06-21T12:00Z | --sun: expected a latitude from -90 to 90",
        "--sky sun --sun 48,11@noon | --sun: expected a time such as 2026-06-21T12:00Z, found noon",
        "--sky sun --sun 48,11@2026-06-21T12:00 | --sun: expected a time such as",
        "--sky sun --sun 48,11@1926-06-21T12:00Z | --sun: expected a time from 1950 to 2050",
        "--sky sun --sun 48,11@2026-06-21T23:00Z | --sun: expected a time when the sun is up",
        "--turntable 0 | --turntable",
        "--turntable 2 --camera close | --turntable: cannot be combined with --camera"
      })
  void wrongFlagsAreRefused(String flags, String message) {
    Outcome outcome = run("render T/sample.glb -o T/a.png " + flags);
    assertThat(outcome.err()).contains(message);
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--camera c",
        "--view top",
        "--fov 30",
        "--sky white",
        "--ground",
        "--pose a",
        "--variant a",
        "--up z",
        "--unit 2",
        "--points 2",
        "--turntable 2"
      })
  void scenesRefuseTheFlagsOfModels(String flag) {
    runs("import T/sample.glb -o T/scene.json");
    Outcome outcome = run("render T/scene.json -o T/a.png " + flag);
    assertThat(outcome.err()).contains(flag.split(" ")[0] + ": requires a model file");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.USAGE);
  }

  @Test
  void missingAndDamagedModelsAreLocated() throws IOException {
    run("render T/none.glb -o T/a.png")
        .assertFailed(
            ExitCodes.SCENE,
            "none.glb: ",
            "found none at \"",
            directory.resolve("none.glb") + "\"");
    ModelSample.writeWith(directory, "\"mesh\": 0", "\"mesh\": 7");
    for (String command : new String[] {"render", "check", "audit", "import"}) {
      run(command + " T/sample.glb")
          .assertFailed(ExitCodes.ASSET, "sample.glb: nodes[0].mesh: ", "found 7");
    }
    ModelSample.write(directory);
    Files.delete(directory.resolve("paint.png"));
    String missing = "images[0].uri: expected a file, found none at \"paint.png\"";
    run("import T/sample.glb").assertFailed(ExitCodes.ASSET, "sample.glb: " + missing);
    String scene = "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1,";
    Files.writeString(
        directory.resolve("s.json"),
        scene
            + " \"cameraType\": \"Pinhole\"},"
            + " {\"type\": \"Model\", \"file\": \"sample.glb\"}]}");
    run("check T/s.json").assertFailed(ExitCodes.ASSET, missing);
    assertThat(run("check T/s.json --lenient").err()).contains("; the picture is left out");
  }

  @ParameterizedTest
  @ValueSource(strings = {"paint.png", "http://localhost/paint.png", "../paint.png"})
  void missingPicturesOfGltfAreLeftOut(String uri) throws IOException {
    ModelSample.writeWith(directory, "\"paint.png\"", "\"" + uri + "\"");
    Files.delete(directory.resolve("paint.png"));
    assertThat(run("render T/sample.glb -o T/a.png --strict").exitCode())
        .isEqualTo(ExitCodes.WARNINGS);
    Outcome outcome = run("render T/sample.glb -o T/a.pfm --checkpoint T/a.film" + SMALL);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err().lines())
        .singleElement()
        .asString()
        .startsWith("warning: sample.glb: ")
        .contains("images[0].uri: expected a ")
        .endsWith("; the picture is left out");
    assertThat(directory.resolve("a.pfm")).isNotEmptyFile();
    runs("resume T/a.film -s 6 --quiet");
    runs("check T/sample.glb");
    runs("views T/sample.glb -s 1 -o T/views --size 24x18");
  }

  @Test
  void checkCountsWhatTheModelHas() throws IOException {
    assertThat(run("check T/sample.glb").out().lines())
        .contains(
            "shapes     1",
            "meshes     1",
            "triangles  4",
            "lights     1",
            "materials  1: \"paint\"",
            "textures   1");
    Files.writeString(directory.resolve("a.mtl"), "newmtl red\nKd 1 0 0\nnewmtl unused\n");
    Files.writeString(
        directory.resolve("a.obj"),
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 3 2 1\n");
    assertThat(run("check T/a.obj --json").out())
        .contains("\"shapes\":2", "\"meshes\":2", "\"materials\":1", "\"textures\":0");
  }

  @Test
  void checkNamesWhatFlagsCanChoose() throws IOException {
    assertThat(run("check T/sample.glb").out().lines())
        .contains(
            "cameras    \"close\", \"1\"",
            "animations \"lift\" (1 s)",
            "variants   \"red\", \"blue\"",
            "bounds     (5, 1, -2) to (6, 2, -1), size 1 x 1 x 1");
    assertThat(run("check T/sample.glb --json").out())
        .contains(
            "\"cameras\":[\"close\",\"1\"]",
            "\"animations\":[{\"name\":\"lift\",\"seconds\":1.0}]",
            "\"variants\":[\"red\",\"blue\"]",
            "\"material_names\":[\"paint\"]",
            "\"bounds\":[[5.0,1.0,-2.0],[6.0,2.0,-1.0]]");
    // Only what the file has is listed.
    Files.writeString(directory.resolve("a.obj"), "v 0 0 1\nv 2 0 1\nv 0 1.5 1\nf 1 2 3\n");
    assertThat(run("check T/a.obj").out())
        .contains("bounds     (0, 0, 1) to (2, 1.5, 1), size 2 x 1.5 x 0\n")
        .doesNotContain("cameras", "animations", "variants");
    assertThat(run("check T/a.obj --up z --unit 10").out()).contains("size 20 x 0 x 15");
    assertThat(run("check T/a.obj --up Z --section Y=-99 --unit 10").out())
        .contains("size 20 x 0 x 15");
  }

  @Test
  void manyNamesAreCounted() throws IOException {
    StringBuilder obj = new StringBuilder("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    StringBuilder mtl = new StringBuilder();
    for (int i = 0; i < 25; i++) {
      mtl.append("newmtl m").append(i).append('\n');
      obj.append("usemtl m").append(i).append("\nf 1 2 3\n");
    }
    Files.writeString(directory.resolve("a.mtl"), mtl);
    Files.writeString(directory.resolve("a.obj"), obj);
    assertThat(run("check T/a.obj").out()).contains("\"m0\", ", "\"m19\" and 5 more\n");
  }

  @Test
  void posesAfterTheEndAreReported() {
    assertThat(run("check T/sample.glb --pose lift@1").err()).isEmpty();
    assertThat(run("check T/sample.glb --pose lift@99.5").err())
        .contains("animations[0]: expected a time from 0 to 1 s, found 99.5 s; the last pose");
  }

  @Test
  void onlyGltfHasPosesAndVariants() throws IOException {
    Files.writeString(directory.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (String flag : new String[] {"--pose lift@0", "--variant lift"}) {
      run("check T/a.obj " + flag)
          .assertFailed(ExitCodes.ASSET, "\"lift\", found none in the model");
    }
  }

  /** The scene around a model is in no file, so that its paths would help nobody. */
  @Test
  void noProblemNamesThePathsOfTheSceneAroundAModel() throws IOException {
    Path sky = Files.writeString(directory.resolve("sky.png"), "no picture");
    Files.writeString(directory.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 1\n");
    for (String line :
        new String[] {
          "check T/none.obj",
          "check T/a.obj",
          "check T/a.obj --sky " + sky,
          "check T/a.obj --sky-intensity 0",
          "render T/a.obj -o T/a.png --size 30000x30000"
        }) {
      Outcome outcome = run(line);
      assertThat(outcome.err()).as(line).contains(".obj: ").doesNotContain("$", "a.obj: a.obj");
    }
    assertThat(run("check T/a.obj --sky " + sky).err()).startsWith("a.obj: --sky: expected");
    assertThat(run("check T/a.obj").err()).startsWith("warning: a.obj: ");
    assertThat(run("check T/a.obj --sky " + sky + " --json").out()).contains("a.obj: --sky: expec");
    String dark = " T/a.obj --sky-intensity 0 ";
    assertThat(run("check" + dark).err())
        .contains("warning: a.obj: --sky: the light emits nothing");
    assertThat(run("check" + dark + "--json").out())
        .contains("a.obj: --sky: the light emits nothing");
    assertThat(run("audit" + dark).out()).contains("warning  --sky: the light emits nothing");
    assertThat(run("audit" + dark + "--json").out()).contains("\"path\": \"--sky\"");
    assertThat(run("render T/a.obj -o T/a.png --size 30000x30000").err())
        .startsWith("a.obj: --size: expected width x height");
    assertThat(run("audit T/a.obj").out()).contains("warning  a.obj: ").doesNotContain("$:");
  }

  @Test
  void anObjFileMayLackItsMaterials() throws IOException {
    Files.writeString(
        directory.resolve("a.obj"),
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    Outcome outcome = run("render T/a.obj -o T/a.png" + SMALL);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err().lines())
        .hasSize(2)
        .allMatch(line -> line.contains("warning") && line.contains("a.obj: line "));
    assertThat(outcome.err()).contains("found none at \"a.mtl\"");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "none.png|expected a file, found none at \"none.png\"",
        "../no.png|expected a file inside the model's folder, found \"../no.png\"",
        "folder|expected a file, found a folder at \"folder\"",
        "a\0b|expected a file inside the model's folder, found \"a\\u0000b\"",
        "paint.png/b|expected a readable file, found \"paint.png/b\": not a directory",
      })
  void anObjFileMayLackItsPictures(String name, String warning) throws IOException {
    Path folder = Files.createDirectories(directory.resolve("obj/folder")).getParent();
    Files.writeString(
        folder.resolve("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    Files.writeString(folder.resolve("a.mtl"), "newmtl m\nKd 1 0 0\nmap_Kd " + name + "\n");
    Files.copy(directory.resolve("paint.png"), folder.resolve("paint.png"));
    Outcome outcome = run("render T/obj/a.obj -o T/a.png" + SMALL);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err().lines())
        .singleElement(InstanceOfAssertFactories.STRING)
        .contains("warning", "a.obj: a.mtl line 3: " + warning, "; the picture is left out");
  }

  @Test
  void aPictureOutsideTheFolderIsReplacedByThatInside() throws IOException {
    Path folder = Files.createDirectories(directory.resolve("obj/maps")).getParent();
    Files.writeString(
        folder.resolve("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    Files.writeString(folder.resolve("a.mtl"), "newmtl m\nmap_Kd ../PAINT.png\n");
    Files.copy(directory.resolve("paint.png"), folder.resolve("maps/paint.png"));
    Outcome outcome = run("render T/obj/a.obj -o T/a.png" + SMALL);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err()).contains("; \"maps/paint.png\" is used");
    run("render T/obj/a.obj -o T/obj/maps/paint.png --overwrite" + SMALL)
        .assertFailed(ExitCodes.OUTPUT, "paint.png");
  }

  @Test
  void inputsAndEditedScenesAreKept() throws IOException {
    Files.createDirectory(directory.resolve("sky"));
    runs("render T/sample.glb -o T/sky/sky.pfm --size 4x2 -s 1 --quiet");
    byte[] texture = Files.readAllBytes(directory.resolve("paint.png"));
    run("render T/sample.glb -o T/paint.png --overwrite")
        .assertFailed(ExitCodes.OUTPUT, "paint.png");
    run("render T/sample.glb --sky T/sky/sky.pfm -o T/sky/sky.pfm --overwrite")
        .assertFailed(ExitCodes.OUTPUT, "sky.pfm");
    assertThat(Files.readAllBytes(directory.resolve("paint.png"))).isEqualTo(texture);
    runs("import T/sample.glb");
    runs("import T/sample.glb");
    run("import T/sample.glb --ground").assertFailed(ExitCodes.OUTPUT, "--overwrite");
    runs("import T/sample.glb --ground --overwrite");
    assertThat(run("import T/sample.glb -o T/sky/scene.json").err()).contains("in a folder that");
    assertThat(run("import T/sample.glb -o T/new.gltf").err()).contains(".json");
  }

  @Test
  void plainFormatsHaveUnitsAndAxes() throws IOException {
    Files.writeString(
        directory.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 0 2\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
    runs("render T/a.obj --up z --unit 0.001 -o T/a.pfm" + SMALL);
    runs("render T/a.obj -o T/b.pfm" + SMALL);
    assertThat(Files.mismatch(directory.resolve("a.pfm"), directory.resolve("b.pfm")))
        .isNotEqualTo(-1);
  }
}
