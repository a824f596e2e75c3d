package io.github.lumbre.parser;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.camera.Lens;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Writes the scene around a model as a scene file.
 *
 * @param stage the camera, sky, ground and background of the model
 * @param camera of the scene
 * @param moving name of the model's camera that moves with the pose; empty if it stands still
 * @param floor height of the ground
 */
record WrittenStage(Stage stage, StageCamera camera, Optional<String> moving, double floor) {
  /**
   * Returns the scene.
   *
   * @param folder where asset paths start
   * @param model absolute path of the model, in the folder
   * @param settings of the scene
   */
  JsonObject scene(Path folder, Path model, RenderSettings settings) {
    JsonObject scene = new JsonObject();
    scene.addProperty("mainCameraId", 1);
    scene.add("renderOptions", renderOptions(settings));
    JsonArray assets = new JsonArray();
    JsonArray objects = new JsonArray();
    objects.add(cameraObject());
    if (stage.sky().hasSun()) {
      objects.add(ofSun(StagedModel.SKY, "clear"));
      objects.add(ofSun(StagedModel.SUN, "sun"));
    } else {
      objects.add(dome(assets, folder));
    }
    objects.add(modelObject(slashed(folder.relativize(model))));
    if (stage.ground()) {
      assets.add(groundMaterial());
      objects.add(groundPlane());
    }
    scene.add("assets", assets);
    scene.add("objects", objects);
    return scene;
  }

  private JsonObject renderOptions(RenderSettings settings) {
    JsonObject render = new JsonObject();
    render.addProperty("width", settings.width());
    render.addProperty("height", settings.height());
    render.addProperty("maxTraceDepth", settings.maxTraceDepth());
    render.addProperty(Setting.TONE_MAP.name(), settings.text(Setting.TONE_MAP));
    for (Setting<Double> setting : List.of(Setting.LINE_WIDTH, Setting.CREASE_ANGLE)) {
      if (settings.isSet(setting)) {
        render.addProperty(setting.name(), settings.get(setting));
      }
    }
    if (stage.transparent()) {
      render.addProperty("background", "transparent");
    }
    stage
        .background()
        .map(CssColor::text)
        .ifPresent(color -> render.addProperty(Setting.BACKPLATE.name(), color));
    return render;
  }

  private JsonObject cameraObject() {
    JsonObject object = WrittenObjects.object("Camera", "");
    object.addProperty("id", 1);
    if (!camera.name().isEmpty()) {
      object.addProperty("name", camera.name());
    }
    object.addProperty("cameraType", camera.type());
    if (camera.lens() instanceof Lens.Orthographic parallel) {
      object.addProperty("height", parallel.height());
    } else {
      object.addProperty("fieldOfView", ((Lens.Pinhole) camera.lens()).fovDegrees());
    }
    object.add("localPosition", Written.vector(camera.pose().position()));
    object.add("localRotation", Written.vector(camera.pose().rotation()));
    return object;
  }

  private JsonObject dome(String name) {
    JsonObject dome = WrittenObjects.object("Light", name);
    dome.addProperty("lightType", "Dome");
    dome.addProperty("intensity", stage.sky().intensity());
    dome.add("localRotation", Written.vector(new Vec3(0, stage.sky().rotation(), 0)));
    return dome;
  }

  private JsonObject ofSun(String name, String sky) {
    JsonObject dome = dome(name);
    dome.addProperty("sky", sky);
    dome.addProperty("sunAzimuth", stage.sky().sun().azimuth());
    dome.addProperty("sunElevation", stage.sky().sun().elevation());
    return dome;
  }

  private JsonObject dome(JsonArray assets, Path folder) {
    JsonObject dome = dome(StagedModel.SKY);
    if (stage.sky().name().equals("studio")) {
      dome.addProperty("sky", "studio");
    }
    stage
        .sky()
        .picture()
        .ifPresent(
            picture -> {
              JsonObject texture = new JsonObject();
              texture.addProperty("assetType", "Texture");
              texture.addProperty("id", 1);
              texture.addProperty(AssetData.FILE_KEY, slashed(folder.relativize(picture)));
              texture.addProperty("filter", "bilinear");
              assets.add(texture);
              dome.addProperty("textureId", 1);
            });
    return dome;
  }

  private JsonObject modelObject(String name) {
    JsonObject object = WrittenObjects.object("Model", "");
    object.addProperty(AssetData.FILE_KEY, name);
    Written.options(object, stage.options());
    moving.ifPresent(own -> object.addProperty("useCamera", own));
    return object;
  }

  private JsonObject groundMaterial() {
    JsonObject material = new JsonObject();
    material.addProperty("assetType", "Material");
    material.addProperty("id", 2);
    material.addProperty("name", StagedModel.GROUND);
    material.addProperty("materialType", stage.transparent() ? "ShadowCatcher" : "Diffuse");
    material.add("color", Written.color(Rgb.grey(StagedModel.GROUND_GRAY)));
    return material;
  }

  private JsonObject groundPlane() {
    JsonObject plane = WrittenObjects.object("Shape", StagedModel.GROUND);
    plane.addProperty("shapeType", "Plane");
    plane.addProperty("materialID", 2);
    plane.add("localPosition", Written.vector(new Vec3(0, floor, 0)));
    return plane;
  }

  /** Returns a path as scenes state it. */
  static String slashed(Path path) {
    return path.toString().replace('\\', '/');
  }
}
