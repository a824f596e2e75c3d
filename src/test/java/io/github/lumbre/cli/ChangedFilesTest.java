package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.render.checkpoint.CheckpointFile;
import io.github.lumbre.render.checkpoint.FilmFile;
import io.github.lumbre.render.checkpoint.FilmHeader;
import io.github.lumbre.render.checkpoint.RecordedLayers;
import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code lumbre resume} after the scene or its files have changed. */
class ChangedFilesTest {
  private static final String ADVICE =
      " changed since the checkpoint file was created; to resume, restore the files, or name an"
          + " unchanged copy of the scene with --scene COPY";

  @TempDir private Path directory;
  private String film;

  @BeforeEach
  void begin() throws IOException {
    Files.createDirectory(directory.resolve("maps"));
    paint("maps/wood.png", 0x804020);
    paint("stone.png", 0x808080);
    film = directory.resolve("a.film").toString();
    String scene = TinyScene.write(directory, scene("0.6")).toString();
    String picture = directory.resolve("a.pfm").toString();
    Outcome begun = Outcome.of("render", scene, "-o", picture, "--checkpoint", film).done();
  }

  private void paint(String name, int rgb) throws IOException {
    Files.write(directory.resolve(name), Pictures.png(2, 2, 0, 0, 0, rgb));
  }

  private static String scene(String green) {
    String texture = "{\"id\": %d, \"assetType\": \"Texture\", \"file\": \"%s\"}";
    String textures =
        texture.formatted(8, "maps/wood.png") + ", " + texture.formatted(9, "stone.png");
    String material =
        ", {\"id\": 3, \"assetType\": \"Material\", \"materialType\": \"Diffuse\","
            + " \"colorTextureId\": 8}, {\"id\": 4, \"assetType\": \"Material\","
            + " \"materialType\": \"Diffuse\", \"colorTextureId\": 9}";
    return TinyScene.withAsset(textures + material)
        .replace(
            "\"shapeType\": \"Plane\", \"materialID\": 1",
            "\"shapeType\": \"Plane\", \"materialID\": 3")
        .replace(
            "\"shapeType\": \"Cube\", \"materialID\": 1",
            "\"shapeType\": \"Cube\", \"materialID\": 4")
        .replace("\"g\": 0.6", "\"g\": " + green);
  }

  private void assertRefused(String message) {
    Outcome refused = Outcome.of("resume", film, "-s", "4");
    refused.assertFailed(ExitCodes.SCENE, "a.film: " + message + ADVICE);
    assertThat(refused.err()).doesNotContainPattern("[0-9a-f]{64}");
  }

  @Test
  void changedTexturesAreNamed() throws IOException {
    paint("maps/wood.png", 0x804021);
    assertRefused("maps/wood.png has");
    paint("stone.png", 0x808081);
    assertRefused("maps/wood.png, stone.png have");
  }

  @Test
  void changedScenesAreNamed() throws IOException {
    TinyScene.write(directory, scene("0.5"));
    assertRefused("tiny.json has");
    paint("stone.png", 0x808081);
    assertRefused("tiny.json, stone.png have");
  }

  @Test
  void copiesOfTheSceneAsItWasAreResumed() throws IOException {
    Path copy = Files.createDirectories(directory.resolve("copy/maps")).getParent();
    for (String name : new String[] {"tiny.json", "stone.png", "maps/wood.png"}) {
      Files.copy(directory.resolve(name), copy.resolve(name));
    }
    paint("stone.png", 0x808081);
    assertRefused("stone.png has");
    Outcome resumed =
        Outcome.of("resume", film, "-s", "4", "--scene", copy.resolve("tiny.json").toString())
            .done();
  }

  /** Films of older versions have no hashes of files; they are read, and resumed, as before. */
  @Test
  void filmsWithoutHashesOfFilesAreResumedAndRefused() throws IOException {
    forgetFiles();
    Outcome resumed = Outcome.of("resume", film, "-s", "3").done();
    forgetFiles();
    paint("stone.png", 0x808081);
    assertRefused(directory.resolve("tiny.json") + " or a file that it uses has");
  }

  private void forgetFiles() throws IOException {
    FilmFile file = FilmFile.read(Path.of(film));
    FilmHeader old = file.header();
    Map<String, String> notes = new LinkedHashMap<>(old.notes());
    assertThat(notes.remove("files")).isNotNull();
    FilmHeader header =
        new FilmHeader(
            old.identity(),
            old.hasAlpha(),
            old.window(),
            RecordedLayers.NONE,
            old.parts(),
            old.faults(),
            notes);
    try (CheckpointFile target = CheckpointFile.reserve(Path.of(film))) {
      target.save(new FilmFile(header, file.film()));
    }
  }
}
