package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.material.Material;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
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
    SceneKeys.MAIN_CAMERA.put(scene, 1);
    scene.add(SceneKeys.OPTIONS.name(), renderOptions(settings));
    JsonArray assets = new JsonArray();
    JsonArray objects = new JsonArray();
    objects.add(cameraObject());
    if (stage.sky().hasSun()) {
      objects.add(ofSun(StagedModel.SKY, LightKinds.Sky.CLEAR));
      objects.add(ofSun(StagedModel.SUN, LightKinds.Sky.SUN));
    } else {
      objects.add(dome(assets, folder));
    }
    objects.add(modelObject(slashed(folder.relativize(model))));
    if (stage.ground()) {
      assets.add(groundMaterial());
      objects.add(groundPlane());
    }
    scene.add(SceneKeys.ASSETS.name(), assets);
    scene.add(SceneKeys.OBJECTS.name(), objects);
    return scene;
  }

  private JsonObject renderOptions(RenderSettings settings) {
    JsonObject render = new JsonObject();
    render.addProperty(Setting.WIDTH.name(), settings.width());
    render.addProperty(Setting.HEIGHT.name(), settings.height());
    render.addProperty(Setting.MAX_TRACE_DEPTH.name(), settings.maxTraceDepth());
    render.addProperty(Setting.TONE_MAP.name(), settings.text(Setting.TONE_MAP));
    for (Setting<Double> setting : List.of(Setting.LINE_WIDTH, Setting.CREASE_ANGLE)) {
      if (settings.isSet(setting)) {
        render.addProperty(setting.name(), settings.get(setting));
      }
    }
    if (stage.transparent()) {
      render.addProperty(SceneKeys.BACKGROUND.name(), SettingsReader.TRANSPARENT);
    }
    stage
        .background()
        .map(CssColor::text)
        .ifPresent(color -> render.addProperty(Setting.BACKPLATE.name(), color));
    return render;
  }

  private JsonObject cameraObject() {
    JsonObject object = WrittenObjects.object("Camera", "");
    ObjectKeys.ID.put(object, 1);
    if (!camera.name().isEmpty()) {
      object.addProperty(ObjectKeys.NAME.name(), camera.name());
    }
    CameraKinds.FAMILY.write(camera.lens(), object, new WrittenTextures(new WrittenAssets()));
    ObjectKeys.POSITION.put(object, camera.pose().position());
    ObjectKeys.ROTATION.put(object, camera.pose().rotation());
    return object;
  }

  private JsonObject dome(String name) {
    JsonObject dome = WrittenObjects.object("Light", name);
    LightKinds.FAMILY.typeKey().put(dome, LightKinds.DOME);
    LightKinds.INTENSITY.put(dome, stage.sky().intensity());
    ObjectKeys.ROTATION.put(dome, new Vec3(0, stage.sky().rotation(), 0));
    return dome;
  }

  private JsonObject ofSun(String name, LightKinds.Sky sky) {
    JsonObject dome = dome(name);
    LightKinds.SKY.put(dome, sky);
    LightKinds.SUN_AZIMUTH.put(dome, stage.sky().sun().azimuth());
    LightKinds.SUN_ELEVATION.put(dome, stage.sky().sun().elevation());
    return dome;
  }

  private JsonObject dome(JsonArray assets, Path folder) {
    JsonObject dome = dome(StagedModel.SKY);
    if (stage.sky().name().equals("studio")) {
      LightKinds.SKY.put(dome, LightKinds.Sky.STUDIO);
    }
    stage
        .sky()
        .picture()
        .ifPresent(
            picture -> {
              JsonObject texture = new JsonObject();
              ObjectKeys.ASSET_TYPE.put(texture, AssetTable.Type.TEXTURE);
              ObjectKeys.ID.put(texture, 1);
              ObjectKeys.FILE.put(texture, slashed(folder.relativize(picture)));
              TextureKinds.FILTER.put(texture, Filter.BILINEAR);
              assets.add(texture);
              LightKinds.TEXTURE.put(dome, 1);
            });
    return dome;
  }

  private JsonObject modelObject(String name) {
    JsonObject object = WrittenObjects.object("Model", "");
    ObjectKeys.FILE.put(object, name);
    ModelKeys.write(stage.options(), object);
    moving.ifPresent(own -> ObjectKeys.USE_CAMERA.put(object, own));
    return object;
  }

  private JsonObject groundMaterial() {
    JsonObject material = new JsonObject();
    ObjectKeys.ASSET_TYPE.put(material, AssetTable.Type.MATERIAL);
    ObjectKeys.ID.put(material, 2);
    material.addProperty(ObjectKeys.NAME.name(), StagedModel.GROUND);
    Material ground = StagedModel.groundMaterial(stage);
    MaterialKinds.FAMILY.write(ground, material, new WrittenTextures(new WrittenAssets()));
    return material;
  }

  private JsonObject groundPlane() {
    JsonObject plane = WrittenObjects.object("Shape", StagedModel.GROUND);
    ShapeKinds.FAMILY.typeKey().put(plane, ShapeKinds.PLANE);
    ShapeKinds.MATERIAL.put(plane, 2);
    ObjectKeys.POSITION.put(plane, new Vec3(0, floor, 0));
    return plane;
  }

  /** Returns a path as scenes state it. */
  static String slashed(Path path) {
    return path.toString().replace('\\', '/');
  }
}
