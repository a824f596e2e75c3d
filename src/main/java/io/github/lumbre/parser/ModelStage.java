package io.github.lumbre.parser;

import static java.util.stream.Collectors.joining;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.Model;
import io.github.lumbre.model.ModelCamera;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelScene;
import io.github.lumbre.parser.ModelSetup.View;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.text.Spelling;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Writes the scene around a model: the model, a camera, the sky and the ground.
 *
 * @param setup what is around the model
 * @param framing of the model
 */
record ModelStage(ModelSetup setup, Model model, ModelFraming framing) {
  /** The path of the sky's texture in the scene. */
  static final String SKY_PICTURE = "$.assets[0]";

  /** The path of the sky's light in the scene. */
  private static final String SKY = "$.objects[1]";

  /** The name of the ground and of its material. */
  private static final String GROUND = "ground";

  private static final double GROUND_GRAY = .6;

  /**
   * Returns the place of a problem as users of a model know it: the argument {@code sky} or {@code
   * size}, or empty for the rest of the scene around the model. Places in the model stay.
   *
   * @param path in the scene that {@link #scene} makes
   */
  static String place(String path) {
    if (path.endsWith("overrides $.renderOptions")) {
      return "size";
    }
    if (!path.startsWith("$")) {
      return path;
    }
    return path.startsWith(SKY_PICTURE) || path.startsWith(SKY) ? "sky" : "";
  }

  /**
   * Returns the scene.
   *
   * @param name the path of the model from the folder
   * @param folder where asset paths start
   * @param aspect width of the frame over its height, to frame the model; empty for the default
   * @throws ModelFormatException if the model has no surface, or lacks the camera
   */
  JsonObject scene(Path name, Path folder, OptionalDouble aspect) throws ModelFormatException {
    model.requireSurface();
    JsonObject scene = new JsonObject();
    scene.addProperty("mainCameraId", 1);
    scene.add("renderOptions", renderOptions(ownCamera().flatMap(ModelStage::aspect)));
    JsonArray assets = new JsonArray();
    JsonArray objects = new JsonArray();
    objects.add(cameraObject(aspect));
    objects.add(dome(assets, folder));
    objects.add(modelObject(name));
    if (setup.ground()) {
      assets.add(groundMaterial());
      objects.add(floor(framing.min().y()));
    }
    scene.add("assets", assets);
    scene.add("objects", objects);
    return scene;
  }

  private static Optional<Double> aspect(ModelCamera camera) {
    OptionalDouble aspect = camera.aspect();
    return aspect.isPresent() ? Optional.of(aspect.getAsDouble()) : Optional.empty();
  }

  /**
   * Returns the settings. The longer side of the picture is {@link ModelSetup#DEFAULT_WIDTH}.
   *
   * @param aspect width over height of the camera's frame; empty for the default
   */
  private JsonObject renderOptions(Optional<Double> aspect) {
    JsonObject render = new JsonObject();
    double ratio = aspect.orElse((double) ModelSetup.DEFAULT_WIDTH / ModelSetup.DEFAULT_HEIGHT);
    double side = ModelSetup.DEFAULT_WIDTH;
    render.addProperty("width", Math.max(1, Math.round(side * Math.min(1, ratio))));
    render.addProperty("height", Math.max(1, Math.round(side / Math.max(1, ratio))));
    render.addProperty("maxTraceDepth", 12);
    ToneCurve curve = Setting.TONE_MAP.inModels().orElseThrow();
    render.addProperty(Setting.TONE_MAP.name(), Setting.TONE_MAP.type().format(curve));
    if (setup.transparent()) {
      render.addProperty("background", "transparent");
    }
    setup.background().ifPresent(color -> render.add("backplate", Written.color(color)));
    return render;
  }

  private JsonObject cameraObject(OptionalDouble aspect) throws ModelFormatException {
    Optional<ModelCamera> own = ownCamera();
    if (own.isPresent()) {
      return cameraObject(own.get());
    }
    View from = setup.view().orElse(View.DEFAULT);
    JsonObject object = object("Camera");
    object.addProperty("id", 1);
    object.addProperty("cameraType", "Pinhole");
    object.addProperty("fieldOfView", setup.fov());
    Vec3 eye = framing.eye(from, setup.fov(), aspect.orElse(4 / 3.));
    object.add("localPosition", Written.vector(eye));
    object.add("localRotation", Written.vector(new Vec3(from.elevation(), -from.azimuth(), 0)));
    return object;
  }

  private Optional<ModelCamera> ownCamera() throws ModelFormatException {
    if (setup.camera().isEmpty()) {
      return setup.view().isPresent() ? Optional.empty() : model.cameras().stream().findFirst();
    }
    List<String> names = ModelContents.cameraNames(model);
    int index = names.indexOf(setup.camera().get());
    if (index < 0) {
      String wanted = Problems.quoted(setup.camera().get());
      throw new ModelFormatException(
          ModelFormatException.Kind.MALFORMED,
          "cameras",
          names.isEmpty()
              ? "expected a camera " + wanted + ", found none in the model"
              : "expected "
                  + names.stream().limit(20).map(Problems::quoted).collect(joining(" or "))
                  + ", found "
                  + wanted
                  + Spelling.suggestion(setup.camera().get(), names));
    }
    return Optional.of(model.cameras().get(index));
  }

  private static JsonObject cameraObject(ModelCamera camera) {
    Transform toWorld = ModelScene.TO_LEFT_HANDED.times(camera.toWorld());
    JsonObject object = object("Camera");
    object.addProperty("id", 1);
    if (!camera.name().isEmpty()) {
      object.addProperty("name", camera.name());
    }
    if (camera.lens() instanceof ModelCamera.Parallel lens) {
      object.addProperty("cameraType", "Orthographic");
      object.addProperty("height", 2 * lens.halfHeight() * toWorld.vector(Vec3.Y).length());
    } else {
      double angle = ((ModelCamera.Perspective) camera.lens()).verticalFov();
      object.addProperty("cameraType", "Pinhole");
      object.addProperty("fieldOfView", Math.toDegrees(angle));
    }
    object.add("localPosition", Written.vector(toWorld.point(Vec3.ZERO)));
    object.add("localRotation", Written.vector(Rotations.degrees(ModelScene.axes(toWorld))));
    return object;
  }

  private JsonObject dome(JsonArray assets, Path folder) {
    JsonObject dome = object("Light");
    dome.addProperty("name", "sky");
    dome.addProperty("lightType", "Dome");
    dome.addProperty("intensity", setup.skyIntensity());
    dome.add("localRotation", Written.vector(new Vec3(0, setup.skyRotation(), 0)));
    String sky = setup.sky();
    if (sky.equals("studio")) {
      dome.addProperty("sky", "studio");
    } else if (!sky.equals("white")) {
      Path picture = Path.of(sky).toAbsolutePath().normalize();
      JsonObject texture = new JsonObject();
      texture.addProperty("assetType", "Texture");
      texture.addProperty("id", 1);
      texture.addProperty("file", slashed(folder.relativize(picture)));
      texture.addProperty("filter", "bilinear");
      assets.add(texture);
      dome.addProperty("textureId", 1);
    }
    return dome;
  }

  private JsonObject modelObject(Path name) {
    JsonObject object = object("Model");
    object.addProperty("file", slashed(name));
    Written.options(object, setup.options());
    return object;
  }

  private JsonObject groundMaterial() {
    JsonObject material = new JsonObject();
    material.addProperty("assetType", "Material");
    material.addProperty("id", 2);
    material.addProperty("name", GROUND);
    material.addProperty("materialType", setup.transparent() ? "ShadowCatcher" : "Diffuse");
    material.add("color", Written.color(Rgb.grey(GROUND_GRAY)));
    return material;
  }

  private static JsonObject floor(double y) {
    JsonObject floor = object("Shape");
    floor.addProperty("name", GROUND);
    floor.addProperty("shapeType", "Plane");
    floor.addProperty("materialID", 2);
    floor.add("localPosition", Written.vector(new Vec3(0, y, 0)));
    return floor;
  }

  private static JsonObject object(String type) {
    JsonObject object = new JsonObject();
    object.addProperty("type", type);
    return object;
  }

  private static String slashed(Path path) {
    return path.toString().replace('\\', '/');
  }
}
