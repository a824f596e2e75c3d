package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.render.PictureRenderer;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.testing.Folders;
import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code lumbre render}, its flags and its errors. */
class RenderCommandTest extends CommandFixture {
  private Outcome render(String json, String... flags) {
    return withScene(json, "render T/tiny.json -o T/tiny.png", flags);
  }

  private Path picture() {
    return directory.resolve("tiny.png");
  }

  private List<String> files() throws IOException {
    return Folders.names(directory);
  }

  private String bytes() throws IOException {
    return Files.readString(picture(), StandardCharsets.ISO_8859_1);
  }

  @Test
  void pictureIsWrittenAndTold() throws IOException {
    Outcome outcome = render(TinyScene.JSON).done();
    assertThat(outcome.out()).isEmpty();
    assertThat(outcome.err()).contains("tiny.png: 16x12 pixels, 2 samples per pixel", "samples/s");
    BufferedImage image = ImageIO.read(picture().toFile());
    assertThat(image.getWidth()).isEqualTo(16);
    assertThat(image.getHeight()).isEqualTo(12);
    assertThat(files()).containsExactly("tiny.json", "tiny.png");
  }

  @Test
  void quietRendersSayNothing() {
    Outcome outcome = render(TinyScene.JSON, "--quiet");
    assertThat(outcome).isEqualTo(new Outcome(ExitCodes.OK, "", ""));
  }

  @Test
  void flagsWinOverTheScene() throws IOException {
    Outcome outcome = render(TinyScene.JSON, "--size", "20x10", "-s", "3", "--seed", "7");
    assertThat(outcome.err()).contains("20x10 pixels, 3 samples per pixel");
    assertThat(bytes()).contains("Samples\0003", "Seed\0007", "Size\00020x10", "Mode\000path");
  }

  @Test
  void samplesAreSamplesPerPixelInRayModeToo() throws IOException {
    Outcome outcome = render(TinyScene.JSON, "--mode", "ray", "-s", "3", "--stats");
    assertThat(outcome.err()).contains("samples      " + 16 * 12 * 3);
    assertThat(bytes()).contains("Mode\000ray");
  }

  @Test
  void depthEndsPathsInBothModes() {
    for (String mode : List.of("path", "ray")) {
      String shallow = statistic(render(TinyScene.JSON, "--mode", mode, "--depth", "0", "--stats"));
      String deep = statistic(render(TinyScene.JSON, "--mode", mode, "--depth", "9", "--stats"));
      assertThat(shallow)
          .as(mode)
          .isEqualTo("rays         " + 16 * 12 * (mode.equals("ray") ? 4 : 2));
      assertThat(deep).as(mode).isNotEqualTo(shallow);
    }
  }

  private static String statistic(Outcome outcome) {
    return outcome.err().lines().filter(line -> line.startsWith("rays  ")).findFirst().orElse("");
  }

  @Test
  void cropKeepsThePixelsOfTheFullFrame() throws IOException {
    render(TinyScene.JSON);
    BufferedImage full = ImageIO.read(picture().toFile());
    render(TinyScene.JSON, "--crop", "3,5,8,4");
    BufferedImage part = ImageIO.read(picture().toFile());
    assertThat(part.getWidth()).isEqualTo(8);
    assertThat(part.getHeight()).isEqualTo(4);
    assertThat(part.getRGB(0, 0, 8, 4, null, 0, 8)).isEqualTo(full.getRGB(3, 5, 8, 4, null, 0, 8));
    assertThat(bytes()).contains("Size\00016x12", "Crop\0003,5,8,4");
  }

  @Test
  void cropOutsideTheScenesFrameIsAUsageError() throws IOException {
    render(TinyScene.JSON, "--crop", "10,0,7,1")
        .assertFailed(ExitCodes.USAGE, "--crop: expected a part of 16x12, found 10,0,7,1");
    assertThat(files()).containsExactly("tiny.json");
  }

  @Test
  void pictureTellsWhereItComesFrom() throws IOException {
    render(TinyScene.JSON);
    assertThat(bytes())
        .contains("Software\000Lumbre ", "Scene\000tiny.json", "SceneHash\000", "Time\000")
        .doesNotContain("Partial", "Crop");
  }

  @Test
  void bitsAreThePngs() throws IOException {
    render(TinyScene.JSON, "--bits", "16");
    assertThat(ImageIO.read(picture().toFile()).getColorModel().getComponentSize(0)).isEqualTo(16);
  }

  @Test
  void exposureIsSuggestedForDarkPicturesOnly() {
    String dark = TinyScene.with("\"intensity\": 3", "\"intensity\": 0.01");
    assertThat(render(dark).err()).contains("--exposure auto");
    assertThat(render(dark, "--exposure", "auto").err()).doesNotContain("hint");
    assertThat(render(dark, "--exposure", "9").err()).doesNotContain("hint");
    assertThat(render(TinyScene.JSON).err()).doesNotContain("hint");
  }

  /** A model's automatic exposure is that of its objects; a scene's is that of the format. */
  @Test
  void automaticExposureOfScenesIsThatOfTheirFormat() throws Exception {
    render(TinyScene.JSON, "--exposure", "auto");
    SceneFile file = new SceneParser().parse(directory.resolve("tiny.json"));
    Image image = new PictureRenderer(file.settings()).render(file.scene());
    Path expected = directory.resolve("expected.png");
    ImageWriter.write(
        image,
        expected,
        new ImageWriter.Options(Exposure.AUTO, file.settings().toneCurve(), 8, Map.of()));
    assertThat(Pictures.pixels(picture())).isEqualTo(Pictures.pixels(expected));
  }

  @Test
  void statisticsAreToldEvenByQuietRenders() {
    assertThat(render(TinyScene.JSON, "--stats", "--quiet").err())
        .startsWith("samples ")
        .contains("shadow rays", "rays/s", "rejected", "saturated", "threads", "peak heap");
  }

  @Test
  void texturePointsThatAreNotFiniteAreCounted() throws IOException {
    String marble = "{\"id\": 9, \"assetType\": \"Texture\", \"textureType\": \"Marble\"}";
    String endless =
        TinyScene.withAsset(marble)
            .replace("\"Diffuse\",", "\"Diffuse\", \"colorTextureId\": 9, \"colorScale\": SCALE,");
    String huge = "{\"x\": 1e308, \"y\": 1}";
    assertThat(render(endless.replace("SCALE", huge)).err())
        .containsPattern("warning: [1-9][0-9]* invalid texture coordinates");
    Outcome strict = render(endless.replace("SCALE", huge), "--strict");
    assertThat(strict.exitCode()).isEqualTo(ExitCodes.WARNINGS);
    assertThat(render(endless.replace("SCALE", "{\"x\": 1e3, \"y\": 1}")).err())
        .doesNotContain("not finite");
  }

  @Test
  void warningsAreToldAndStrictnessStopsBeforeRendering() throws IOException {
    String odd = TinyScene.with("\"radius\": 1", "\"radius\": 1, \"colour\": 2");
    Outcome told = render(odd, "--quiet").done();
    assertThat(told.err()).startsWith("warning: ").contains("colour");
    Files.delete(picture());
    Outcome strict = render(odd, "--strict");
    assertThat(strict.exitCode()).isEqualTo(ExitCodes.WARNINGS);
    assertThat(strict.err()).contains("1 warning; --strict treats warnings as errors");
    assertThat(files()).containsExactly("tiny.json");
  }

  @Test
  void lenientRendersTakeMissingAssetsAsWarnings() {
    String dangling = TinyScene.with("\"materialID\": 2", "\"materialID\": 77");
    render(dangling).assertFailed(ExitCodes.SCENE, "77", "$.objects[2].materialID");
    Outcome lenient = render(dangling, "--lenient", "--quiet").done();
    assertThat(lenient.err()).startsWith("warning: ").contains("77");
  }

  @Test
  void sceneIsNeverOverwritten() throws IOException {
    Path scene = directory.resolve("scene.png");
    Files.writeString(scene, TinyScene.JSON);
    Outcome.of("render", scene.toString(), "-o", directory + "/./scene.png")
        .assertFailed(ExitCodes.OUTPUT, "scene.png: is the scene", "-o");
    assertThat(scene).hasContent(TinyScene.JSON);
  }

  @Test
  void unwritableOutputIsFoundBeforeTheSceneIsRead() throws IOException {
    Outcome.of("render", "no-such-scene.json", "-o", directory + "/missing/too/p.png")
        .assertFailed(ExitCodes.SCENE, "no-such-scene.json");
    assertThat(directory.resolve("missing")).doesNotExist();
    Files.writeString(directory.resolve("file"), "");
    Outcome.of("render", "no-such-scene.json", "-o", directory + "/file/p.png")
        .assertFailed(ExitCodes.OUTPUT, "/file cannot be created");
  }

  private Path writable(String name) {
    return TinyScene.write(directory, TinyScene.JSON).resolveSibling(name);
  }

  @Test
  void failedRenderLeavesTheOldPicture() throws IOException {
    String precious = "PF 1 1 -1 precious";
    Files.writeString(picture(), precious);
    render("{").assertFailed(ExitCodes.SCENE, "tiny.json");
    assertThat(picture()).hasContent(precious);
    assertThat(files()).containsExactly("tiny.json", "tiny.png");
  }

  @ParameterizedTest
  @ValueSource(strings = {"16385x16384", "65535x65535"})
  void picturesBeyondTheLimitAreRefused(String size) {
    render(TinyScene.JSON, "--size", size)
        .assertFailed(
            ExitCodes.LIMIT,
            "the size that overrides $.renderOptions: expected width x height <= 268435456,"
                + " found "
                + size);
  }

  @Test
  void limitOfPixelsMayBeSet() throws IOException {
    render(TinyScene.JSON, "--max-pixels", "191")
        .assertFailed(ExitCodes.LIMIT, "width x height <= 191, found 16x12");
    assertThat(render(TinyScene.JSON, "--max-pixels", "192", "--quiet").exitCode()).isZero();
    render(TinyScene.JSON, "--max-pixels", "0")
        .assertFailed(ExitCodes.USAGE, "--max-pixels: expected 1 to 536870912, found 0");
  }

  @Test
  void timeoutEndsARenderWithAPartialPicture() throws IOException {
    Outcome outcome = render(TinyScene.JSON, "-s", "1000000000", "--timeout", "0.7s").done();
    assertThat(outcome.err()).contains("stopped early, partial picture of 16x12 pixels");
    assertThat(bytes()).contains("Partial\000");
  }

  @Test
  void timeoutBeforeTheFirstSampleLeavesNoPicture() throws IOException {
    render(TinyScene.JSON, "--timeout", "0.000000001s")
        .assertFailed(ExitCodes.LIMIT, "--timeout", "no picture is written");
    assertThat(files()).containsExactly("tiny.json");
  }

  @Test
  void timeoutThatIsNotReachedChangesNothing() throws IOException {
    assertThat(render(TinyScene.JSON, "--timeout", "2h", "--quiet").exitCode()).isZero();
    assertThat(bytes()).doesNotContain("Partial");
  }

  @ParameterizedTest
  @ValueSource(strings = {"0s", "5", "-1s", "1d", "s", "1e9s", "", "0.0000000001s"})
  void timesThatMakeNoSenseAreUsageErrors(String time) {
    render(TinyScene.JSON, "--timeout", time)
        .assertFailed(ExitCodes.USAGE, "expected a duration above 0");
  }

  @Test
  void dryRunTellsWhatARenderTakesAndWritesNothing() throws IOException {
    Outcome outcome = render(TinyScene.JSON, "--dry-run", "--threads", "3").done();
    assertThat(outcome.err()).isEmpty();
    assertThat(outcome.out())
        .contains("pixels   192: 16x12", "samples  384: 2 per pixel", "film     1 MiB", ": 3\n")
        .containsPattern("scene    \\d+ MiB\n")
        .containsPattern("heap     \\d+ MiB\n");
    assertThat(files()).containsExactly("tiny.json");
  }

  @Test
  void dryRunTellsThatARenderDoesNotFit() {
    Outcome outcome =
        render(TinyScene.JSON, "--dry-run", "--size", "65535x8192", "--max-pixels", "536870912");
    assertThat(outcome.out()).contains("pixels   536862720: 65535x8192", "film     40960 MiB");
    assertThat(outcome.err()).contains("the maximum heap size is");
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.LIMIT);
  }

  @Test
  void controlCharactersOfTheSceneDoNotReachTheTerminal() {
    String evil = TinyScene.with("\"radius\": 1", "\"radius\": 1, \"\\u001b[31m\\u0007\": 2");
    assertThat(render(evil).err()).doesNotContain("\u001b", "\u0007").contains("\\u001b[31m");
  }

  @Test
  void debugShowsTheStackTrace() {
    assertThat(render("{", "--debug").err()).contains("SceneFormatException", "\tat ");
  }
}
