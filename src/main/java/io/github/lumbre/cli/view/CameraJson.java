package io.github.lumbre.cli.view;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.internal.CameraKeys;
import io.github.lumbre.scenefile.internal.CameraPose;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** The JSON of a scene's camera at another place, to be copied into a scene file. */
final class CameraJson {
  private static final Gson GSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  private CameraJson() {}

  /**
   * Returns the main camera of a scene with a pose: an object without a parent.
   *
   * @param scene the text of a valid scene
   * @param lens of the camera; empty if it is that of the scene
   */
  static String of(byte[] scene, CameraPose pose, Optional<Lens> lens) {
    JsonObject camera = main(scene);
    if (lens.isPresent() && lens.get() instanceof Lens.Orthographic parallel) {
      camera.addProperty(CameraKeys.HEIGHT, parallel.height());
    }
    if (lens.isPresent() && lens.get() instanceof Lens.Pinhole pinhole) {
      camera.addProperty(CameraKeys.FIELD_OF_VIEW, pinhole.fovDegrees());
    }
    camera.remove(CameraKeys.CHILDREN);
    CameraKeys.OTHER_PLACES.forEach(camera::remove);
    camera.addProperty(CameraKeys.TYPE, "Camera");
    camera.add(CameraKeys.POSITION, vector(pose.position()));
    camera.add(CameraKeys.ROTATION, vector(pose.rotation()));
    return GSON.toJson(camera);
  }

  private static JsonObject main(byte[] text) {
    try {
      JsonObject scene =
          JsonParser.parseString(new String(text, StandardCharsets.UTF_8)).getAsJsonObject();
      JsonElement id = scene.get(CameraKeys.MAIN_CAMERA);
      Deque<JsonElement> left = new ArrayDeque<>();
      left.push(scene.get(CameraKeys.OBJECTS));
      while (!left.isEmpty()) {
        for (JsonElement element : left.pop().getAsJsonArray()) {
          JsonObject object = element.getAsJsonObject();
          boolean isCamera =
              object.has(CameraKeys.TYPE)
                  && object.get(CameraKeys.TYPE).getAsString().equals("Camera");
          if (isCamera && (id == null || id.equals(object.get(CameraKeys.ID)))) {
            return object.deepCopy();
          }
          if (object.has(CameraKeys.CHILDREN)) {
            left.push(object.get(CameraKeys.CHILDREN));
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
