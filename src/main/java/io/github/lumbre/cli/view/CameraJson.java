package io.github.lumbre.cli.view;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.internal.CameraPose;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;

/** The JSON of a scene's camera at another place, to be copied into a scene file. */
final class CameraJson {
  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  private CameraJson() {}

  /**
   * Returns the main camera of a scene with a pose: an object without a parent.
   *
   * @param scene the text of a valid scene
   */
  static String of(byte[] scene, CameraPose pose) {
    JsonObject camera = main(scene);
    camera.remove("children");
    camera.remove("localScale");
    camera.addProperty("type", "Camera");
    camera.add("localPosition", vector(pose.position()));
    camera.add("localRotation", vector(pose.rotation()));
    return GSON.toJson(camera);
  }

  private static JsonObject main(byte[] text) {
    try {
      JsonObject scene =
          JsonParser.parseString(new String(text, StandardCharsets.UTF_8)).getAsJsonObject();
      JsonElement id = scene.get("mainCameraId");
      Deque<JsonElement> left = new ArrayDeque<>();
      left.push(scene.get("objects"));
      while (!left.isEmpty()) {
        for (JsonElement element : left.pop().getAsJsonArray()) {
          JsonObject object = element.getAsJsonObject();
          boolean isCamera =
              object.has("type") && object.get("type").getAsString().equals("Camera");
          if (isCamera && (id == null || id.equals(object.get("id")))) {
            return object.deepCopy();
          }
          if (object.has("children")) {
            left.push(object.get("children"));
          }
        }
      }
    } catch (JsonParseException | IllegalStateException | ClassCastException e) {
      // The file is being edited just now; the pose alone is right in any case.
      return new JsonObject();
    }
    return new JsonObject();
  }

  private static JsonObject vector(Vec3 v) {
    JsonObject object = new JsonObject();
    object.addProperty("x", v.x());
    object.addProperty("y", v.y());
    object.addProperty("z", v.z());
    return object;
  }
}
