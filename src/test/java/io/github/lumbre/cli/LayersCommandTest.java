package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.testing.Folders;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code lumbre layers}, and {@code compare --layer}. */
class LayersCommandTest extends CommandFixture {
  private Path scene;
  private Path picture;
  private Path film;

  @BeforeEach
  void render() {
    scene =
        TinyScene.write(
            directory,
            TinyScene.with(
                "\"shapeType\": \"Sphere\"", "\"name\": \"../ball\", \"shapeType\": \"Sphere\""));
    picture = directory.resolve("all.exr");
    film = directory.resolve("all.film");
    runs("render " + scene + " --layers all -o T/all.exr --checkpoint T/all.film");
  }

  private Outcome layers(Path file, String... more) {
    return Outcome.of(
        Stream.concat(Stream.of("layers", file.toString()), Stream.of(more))
            .toArray(String[]::new));
  }

  @Test
  void layersAreListedWithTheirRanges() {
    Outcome outcome = layers(picture).done();
    assertThat(outcome.out().lines().map(line -> line.split(" +")[0]))
        .contains("(picture)", "albedo", "depth", "normal", "CryptoObject:", "CryptoMaterial:");
    assertThat(outcome.out())
        .containsPattern("samples +N +float +2.00000 to 2.00000")
        .contains("../ball");
  }

  @Test
  void picturesAndFilmsHaveTheSameLayers() {
    JsonObject ofPicture = layers(picture, "--json").json();
    JsonObject ofFilm = layers(film, "--json").json();
    assertThat(ofFilm.get("mattes")).isEqualTo(ofPicture.get("mattes"));
    assertThat(ofFilm.get("layers").getAsJsonArray())
        .hasSameSizeAs(ofPicture.get("layers").getAsJsonArray());
    JsonObject shares = ofPicture.getAsJsonObject("mattes").getAsJsonObject("CryptoObject");
    assertThat(shares.get("../ball").getAsDouble()).isBetween(.05, .5);
  }

  @Test
  void masksAndRangesBecomePngInsideTheFolder() throws IOException {
    Path folder = directory.resolve("png");
    Outcome outcome = layers(picture, "--png", folder.toString()).done();
    assertThat(Folders.names(folder))
        .contains("picture.png", "albedo.png", "normal.png", "depth.png", "object-.._ball.png");
    assertThat(directory.resolve("ball.png")).doesNotExist();
    BufferedImage depth = ImageIO.read(folder.resolve("depth.png").toFile());
    assertThat(depth.getColorModel().getPixelSize()).isEqualTo(16);
    assertThat(depth.getWidth()).isEqualTo(16);
    BufferedImage ball = ImageIO.read(folder.resolve("object-.._ball.png").toFile());
    JsonObject shares =
        layers(picture, "--json").json().getAsJsonObject("mattes").getAsJsonObject("CryptoObject");
    double sum = 0;
    for (int i = 0; i < 16 * 12; i++) {
      sum += ball.getRaster().getSample(i % 16, i / 16, 0) / 255.0;
    }
    assertThat(sum / (16 * 12)).isCloseTo(shares.get("../ball").getAsDouble(), within(.002));
    // Straight ahead is the ball: the normal faces the camera, which looks along +z.
    BufferedImage normal = ImageIO.read(folder.resolve("normal.png").toFile());
    assertThat(normal.getRaster().getSample(8, 6, 2)).isLessThan(20);
  }

  @Test
  void onlyTheWantedLayerIsWritten() {
    Path folder = directory.resolve("one");
    Outcome outcome = layers(film, "--layer", "depth", "--png", folder.toString()).done();
    assertThat(folder.toFile().list()).containsExactly("depth.png");
    assertThat(outcome.out().strip()).isEqualTo(folder.resolve("depth.png").toString());
  }

  @Test
  void foreignFilesInTheFolderAreKept() throws IOException {
    Path own = Files.writeString(directory.resolve("depth.png"), "# notes");
    layers(film, "--layer", "depth", "--png", directory.toString())
        .assertFailed(ExitCodes.OUTPUT, "depth.png", "--overwrite");
    assertThat(own).hasContent("# notes");
  }

  @Test
  void aFolderThatIsAFileIsAnError() throws IOException {
    Path own = Files.writeString(directory.resolve("notes"), "# notes");
    layers(film, "--png", own.toString())
        .assertFailed(ExitCodes.OUTPUT, "notes: cannot be created: a file");
  }

  @Test
  void unknownLayersAreAnErrorWithASuggestion() {
    layers(picture, "--layer", "dept")
        .assertFailed(ExitCodes.USAGE, "dept", "did you mean depth", picture.toString());
    layers(picture, "--layer", "CryptoObjec")
        .assertFailed(ExitCodes.USAGE, "did you mean CryptoObject?", ", CryptoObject, ");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "v/1\u0001\u0002", "not a picture"})
  void otherFilesAreAnError(String content) throws IOException {
    Path file = Files.writeString(directory.resolve("other.exr"), content);
    layers(file).assertFailed(ExitCodes.ASSET, "other.exr");
  }

  @Test
  void aMissingFileIsAnError() {
    layers(directory.resolve("none.exr")).assertFailed(ExitCodes.USAGE, "none.exr");
  }

  @Test
  void layersAreCompared() {
    Outcome same =
        Outcome.of("compare", picture.toString(), film.toString(), "--layer", "normal", "--json")
            .done();
    double rmse = same.json().get("rmse").getAsDouble();
    // The picture stores normals as half floats.
    assertThat(rmse).isLessThan(1e-3);
    Outcome.of("compare", picture.toString(), film.toString(), "--layer", "norma")
        .assertFailed(ExitCodes.USAGE, "norma", "did you mean normal");
  }

  @Test
  void layersNeedAFileThatHoldsThem() {
    String png = directory.resolve("x.png").toString();
    Outcome.of("render", scene.toString(), "--layers", "depth", "-o", png)
        .assertFailed(ExitCodes.USAGE, "--layers", ".exr", "--checkpoint");
    Outcome.of("develop", film.toString(), "--layers", "depth", "-o", png)
        .assertFailed(ExitCodes.USAGE, "--layers", ".exr");
    Outcome.of("render", scene.toString(), "--layers", "albdo", "-o", png)
        .assertFailed(ExitCodes.USAGE, "albdo", "did you mean albedo");
  }
}
