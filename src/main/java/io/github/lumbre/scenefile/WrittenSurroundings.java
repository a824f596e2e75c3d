package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.CssColor;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.ShadowCatcher;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.scenefile.internal.Surroundings;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the scene around a model as a scene file.
 *
 * @param folder where asset paths start
 */
record WrittenSurroundings(Surroundings around, Path folder) {
  /** The name of the sky. */
  static final String SKY = "sky";

  private static final String SUN = "sun";
  private static final String GROUND = "ground";
  private static final double GROUND_GRAY = .6;

  /**
   * Returns the scene.
   *
   * @param model absolute path of the model, in the folder
   */
  JsonObject scene(Path model) {
    JsonObject scene = new JsonObject();
    RootKeys.MAIN_CAMERA.put(scene, 1);
    scene.add(RootKeys.OPTIONS.name(), renderOptions(around.settings()));
    JsonArray assets = new JsonArray();
    JsonArray objects = new JsonArray();
    objects.add(cameraObject());
    if (around.sky().hasSun()) {
      objects.add(ofSun(SKY, LightKinds.Sky.CLEAR));
      objects.add(ofSun(SUN, LightKinds.Sky.SUN));
    } else {
      objects.add(dome(assets));
    }
    objects.add(modelObject(AssetData.slashed(folder.relativize(model))));
    if (around.hasGround()) {
      assets.add(groundMaterial());
      objects.add(groundPlane());
    }
    scene.add(RootKeys.ASSETS.name(), assets);
    scene.add(RootKeys.OBJECTS.name(), objects);
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
    if (settings.transparent()) {
      render.addProperty(RootKeys.BACKGROUND.name(), SettingsReader.TRANSPARENT);
    }
    settings
        .get(Setting.BACKPLATE)
        .map(CssColor::text)
        .ifPresent(color -> render.addProperty(Setting.BACKPLATE.name(), color));
    around
        .backplate()
        .map(SettingsReader::written)
        .ifPresent(seen -> render.add(Setting.BACKPLATE.name(), seen));
    return render;
  }

  private JsonObject cameraObject() {
    JsonObject object = ObjectWriter.object("Camera", "");
    ObjectKeys.ID.put(object, 1);
    PlacedCamera camera = around.camera();
    if (!camera.name().isEmpty()) {
      object.addProperty(ObjectKeys.NAME.name(), camera.name());
    }
    CameraKinds.FAMILY.write(camera.lens(), object, new TextureWriter(new AssetWriter()));
    ObjectKeys.POSITION.put(object, camera.pose().position());
    ObjectKeys.ROTATION.put(object, camera.pose().rotation());
    return object;
  }

  private JsonObject dome(String name) {
    JsonObject dome = ObjectWriter.object("Light", name);
    LightKinds.FAMILY.typeKey().put(dome, LightKinds.DOME);
    LightKinds.INTENSITY.put(dome, around.sky().intensity());
    ObjectKeys.ROTATION.put(dome, new Vec3(0, around.sky().rotation(), 0));
    return dome;
  }

  private JsonObject ofSun(String name, LightKinds.Sky sky) {
    JsonObject dome = dome(name);
    LightKinds.SKY.put(dome, sky);
    LightKinds.SUN_AZIMUTH.put(dome, around.sky().azimuth());
    LightKinds.SUN_ELEVATION.put(dome, around.sky().elevation());
    return dome;
  }

  private JsonObject dome(JsonArray assets) {
    JsonObject dome = dome(SKY);
    if (around.sky().name().equals("studio")) {
      LightKinds.SKY.put(dome, LightKinds.Sky.STUDIO);
    } else if (around.sky().name().equals("relief")) {
      LightKinds.SKY.put(dome, LightKinds.Sky.RELIEF);
    }
    around
        .sky()
        .picture()
        .ifPresent(
            picture -> {
              JsonObject texture = new JsonObject();
              ObjectKeys.ASSET_TYPE.put(texture, AssetTable.Type.TEXTURE);
              ObjectKeys.ID.put(texture, 1);
              ObjectKeys.FILE.put(texture, AssetData.slashed(folder.relativize(picture)));
              TextureKinds.FILTER.put(texture, Filter.BILINEAR);
              assets.add(texture);
              LightKinds.TEXTURE.put(dome, 1);
            });
    return dome;
  }

  private JsonObject modelObject(String name) {
    JsonObject object = ObjectWriter.object("Model", "");
    ObjectKeys.FILE.put(object, name);
    ModelKeys.write(around.options(), object);
    around.moving().ifPresent(own -> ObjectKeys.USE_CAMERA.put(object, own));
    return object;
  }

  private JsonObject groundMaterial() {
    JsonObject material = new JsonObject();
    ObjectKeys.ASSET_TYPE.put(material, AssetTable.Type.MATERIAL);
    ObjectKeys.ID.put(material, 2);
    material.addProperty(ObjectKeys.NAME.name(), GROUND);
    Texture<Rgb> gray = Texture.constant(Rgb.gray(GROUND_GRAY));
    Material ground = around.settings().transparent() ? new ShadowCatcher(gray) : new Matte(gray);
    MaterialKinds.FAMILY.write(ground, material, new TextureWriter(new AssetWriter()));
    return material;
  }

  private JsonObject groundPlane() {
    JsonObject plane = ObjectWriter.object("Shape", GROUND);
    ShapeKinds.FAMILY.typeKey().put(plane, ShapeKinds.PLANE);
    ShapeKinds.MATERIAL.put(plane, 2);
    ObjectKeys.POSITION.put(plane, new Vec3(0, around.box().min().y(), 0));
    return plane;
  }
}
