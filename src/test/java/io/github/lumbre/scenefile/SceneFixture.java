package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;

/** Small scenes in a folder, and the results of reading them. */
final class SceneFixture {
  static final String CAMERA = "{\"type\": \"Camera\", \"id\": 1}";
  static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

  private final Path folder;

  SceneFixture(Path folder) {
    this.folder = folder;
  }

  /** Returns a scene with a camera and the given array elements. */
  static String scene(String objects, String assets) {
    return "{\"mainCameraId\": 1, \"objects\": ["
        + CAMERA
        + (objects.isEmpty() ? "" : ", ")
        + objects
        + "], \"assets\": ["
        + assets
        + "]}";
  }

  /** Returns the JSON text of an object that is written with apostrophes instead of quotes. */
  static String json(String text) {
    return text.replace('\'', '"');
  }

  Path write(String text) {
    try {
      return Files.writeString(folder.resolve("scene.json"), text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  SceneFile parse(String text) {
    return parse(new SceneParser(), text);
  }

  SceneFile parse(SceneParser parser, String text) {
    try {
      return parser.parse(write(text));
    } catch (SceneFormatException | IOException e) {
      throw new AssertionError(e);
    }
  }

  SceneFormatException refusal(String text) {
    return refusal(new SceneParser(), text);
  }

  SceneFormatException refusal(SceneParser parser, String text) {
    Path file = write(text);
    return catchThrowableOfType(SceneFormatException.class, () -> parser.parse(file));
  }

  static String base64(String text) {
    return Base64.getEncoder().encodeToString(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** Returns a PNG of one row of pixels. */
  static byte[] png(int... pixels) {
    return Pictures.png(pixels.length, 1, pixels);
  }

  /** Returns a texture asset. */
  static String texture(int id, byte[] file, String more) {
    return json("{'id': " + id + ", 'assetType': 'Texture', 'base64PNG': '")
        + Base64.getEncoder().encodeToString(file)
        + json("'" + more + "}");
  }

  /** Returns a mesh asset. */
  static String mesh(int id, String obj) {
    return json("{'id': " + id + ", 'assetType': 'Mesh', 'base64OBJ': '" + base64(obj) + "'}");
  }
}
