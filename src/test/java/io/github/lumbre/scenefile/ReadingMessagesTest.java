package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.scenefile.SceneFixture.scene;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import io.github.lumbre.scenefile.SceneFormatException.Kind;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the error messages for invalid values and unusable files. */
class ReadingMessagesTest {
  @TempDir private Path folder;
  private SceneFixture fixture;

  @BeforeEach
  void makeFixture() {
    fixture = new SceneFixture(folder);
  }

  private void assertRefused(String text, Kind kind, String message) {
    SceneFormatException refusal = fixture.refusal(text);
    assertThat(refusal).hasMessage(message);
    assertThat(refusal.kind()).isEqualTo(kind);
  }

  private static String sceneWithMeshFile(String name) {
    return scene(
        json("{'type': 'Shape', 'shapeType': 'Mesh', 'meshId': 2}"),
        json("{'id': 2, 'assetType': 'Mesh', 'file': '" + name + "'}"));
  }

  @ParameterizedTest
  @CsvSource({"null, null", "true, true", "7, 7", "[], an array"})
  void scenesThatAreNoObjects(String text, String found) {
    assertRefused(text, Kind.INVALID, "scene.json: expected an object, found " + found);
  }

  @Test
  void nothingWithinAnArrayIsCalledNull() {
    assertRefused(
        "{\"mainCameraId\": 1, \"objects\": [{\"type\": \"Camera\", \"id\": 1}, null]}",
        Kind.INVALID,
        "scene.json: $.objects[1]: expected an object, found null");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"4294967297", "-2147483649", "2147483648", "1e20", "99999999999999999999"})
  void integersBeyondTheRangeAreToldTheRange(String id) {
    assertRefused(
        "{\"mainCameraId\": " + id + ", \"objects\": []}",
        Kind.INVALID,
        "scene.json: $.mainCameraId: expected an integer from -2147483648 to 2147483647, found "
            + id);
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.5", "true", "[]"})
  void whatIsNoIntegerIsToldSo(String id) {
    SceneFormatException refusal =
        fixture.refusal("{\"mainCameraId\": " + id + ", \"objects\": []}");
    assertThat(refusal)
        .hasMessageStartingWith("scene.json: $.mainCameraId: expected an integer, found ");
  }

  @ParameterizedTest
  @ValueSource(ints = {30, 300, 1900})
  void pathsOfDeepScenesAreShort(int levels) {
    String text =
        scene(
            json("{'children': [").repeat(levels)
                + json("{'type': 'Shape', 'shapeType': 'Sphere', 'radius': -1}")
                + "]}".repeat(levels),
            "");
    String problem = fixture.refusal(text).problems().get(0).toString();
    String path = problem.substring("scene.json: ".length(), problem.indexOf(": expected"));
    assertThat(path).startsWith("$.objects[1].children[0]").endsWith(".children[0].radius");
    assertThat(path).contains("…").hasSizeBetween(150, 201);
  }

  @Test
  void linksOutOfTheFolderAreCalledLinks() throws IOException {
    Path inside = Files.createDirectory(folder.resolve("inside"));
    Files.writeString(folder.resolve("a.obj"), SceneFixture.TRIANGLE);
    Files.createSymbolicLink(inside.resolve("out"), folder);
    Files.createSymbolicLink(inside.resolve("b.obj"), folder.resolve("a.obj"));
    for (String name : new String[] {"out/a.obj", "b.obj"}) {
      SceneFormatException refusal = new SceneFixture(inside).refusal(sceneWithMeshFile(name));
      assertThat(refusal.kind()).isEqualTo(Kind.INVALID);
      assertThat(refusal)
          .hasMessage(
              "scene.json: $.assets[0].file: expected a file inside the scene's folder, found the"
                  + " link \""
                  + name
                  + "\", which points outside it; copy the file into the folder");
    }
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void unreadableAssetsAreToldWithTheReason() throws IOException {
    String prefix = "scene.json: $.assets[0].file: expected a ";
    Files.createDirectory(folder.resolve("sub"));
    assertRefused(sceneWithMeshFile("sub"), Kind.ASSET, prefix + "file, found a folder at \"sub\"");
    Files.writeString(folder.resolve("a.obj"), SceneFixture.TRIANGLE);
    assertRefused(
        sceneWithMeshFile("a.obj/b.obj"),
        Kind.ASSET,
        prefix + "readable file, found \"a.obj/b.obj\": not a directory");
    Files.createSymbolicLink(folder.resolve("round"), Path.of("round"));
    assertRefused(
        sceneWithMeshFile("round"),
        Kind.ASSET,
        prefix
            + "readable file, found \"round\": too many levels of symbolic links or unable to"
            + " access attributes of symbolic link");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void assetsThatMayNotBeReadAreToldSo() throws IOException {
    Path file = Files.writeString(folder.resolve("a.obj"), SceneFixture.TRIANGLE);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
    assumeFalse(Files.isReadable(file), "this user may read every file");
    assertRefused(
        sceneWithMeshFile("a.obj"),
        Kind.ASSET,
        "scene.json: $.assets[0].file: expected a readable file, found \"a.obj\": permission"
            + " denied");
  }
}
