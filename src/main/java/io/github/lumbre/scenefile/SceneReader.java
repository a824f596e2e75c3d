package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.scene.Backplate;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.Setting;
import io.github.lumbre.scenefile.AssetTable.Type;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import io.github.lumbre.scenefile.internal.Origin;
import io.github.lumbre.scenefile.internal.PartSurface;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import io.github.lumbre.scenefile.internal.SceneContents;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/** Reads the objects of a scene, the assets they use, and the main camera. Not reusable. */
final class SceneReader {
  private static final String MAIN_CAMERA = RootKeys.MAIN_CAMERA.name();

  private final JsonNode root;
  private final RenderSettings settings;
  private final Kernel kernel;
  private final AssetTable assets;
  private final ObjectTree tree;
  private final TextureReader textures;
  private final MaterialReader materials;
  private final ShapeReader shapes;
  private final ModelObjects models;
  private final PlacedParts parts = new PlacedParts();
  private final ModelParts modelParts;
  private final LightProfiles profiles;
  private Optional<Camera> camera = Optional.empty();
  private Optional<Backplate> backplate = Optional.empty();
  private String cameraType = "";
  private int lightCount;

  /**
   * @param settings of the scene
   * @param change overrides for all textures
   * @param kernel traversal kernel of the bounding volume hierarchies
   * @param sceneName name of the scene file
   * @param known the model that the scene is made around, if it has been read
   */
  SceneReader(
      JsonNode root,
      AssetTable assets,
      AssetData data,
      RenderSettings settings,
      TextureChange change,
      Kernel kernel,
      String sceneName,
      Optional<ModelObjects.Known> known) {
    this.root = root;
    this.settings = settings;
    this.kernel = kernel;
    this.assets = assets;
    tree = ObjectTree.of(root);
    textures = new TextureReader(assets, data, settings.seed(), change);
    materials = new MaterialReader(assets, textures);
    shapes = new ShapeReader(assets, data, objects(ObjectTree.Type.SHAPE), kernel);
    profiles = new LightProfiles(data);
    DecodedPictures decoded =
        known.map(ModelObjects.Known::decoded).orElseGet(DecodedPictures::new);
    modelParts = new ModelParts(parts, data.allowance(), kernel, decoded);
    models =
        new ModelObjects(
            data, materials, modelParts, settings, sceneName, assets.isLenient(), known);
  }

  private List<Placed> objects(ObjectTree.Type type) {
    return tree.objects().stream().filter(object -> object.type() == type).toList();
  }

  /**
   * Reads camera, shapes and lights, and adds errors and warnings to the problems.
   *
   * @param aspect width of the film over its height
   * @param background radiance from the settings; empty if they name none
   */
  void read(double aspect, Optional<Rgb> background) {
    assets.warnUnknown(Type.TEXTURE, TextureKinds.FAMILY.keys());
    assets.warnUnknown(Type.MESH, Key.names(ObjectKeys.OF_ASSETS, ObjectKeys.OF_MESHES));
    assets.warnUnknown(Type.MATERIAL, MaterialKinds.FAMILY.keys());
    Set<String> keys = Key.names(ObjectKeys.ALL);
    objects(ObjectTree.Type.NONE).forEach(o -> o.node().warnUnknown(keys));
    readCamera(aspect);
    objects(ObjectTree.Type.SHAPE).forEach(this::readShape);
    objects(ObjectTree.Type.MODEL).forEach(this::readModel);
    readLights(background);
    backplate =
        RootKeys.OPTIONS.find(root).filter(JsonNode::isObject).flatMap(SettingsReader::backplate);
  }

  private void readCamera(double aspect) {
    List<Placed> all = objects(ObjectTree.Type.CAMERA);
    all.forEach(each -> each.node().warnUnknown(CameraKinds.FAMILY.keys()));
    Optional<Integer> wanted = RootKeys.MAIN_CAMERA.stated(root);
    Optional<Placed> main =
        all.stream()
            .filter(c -> wanted.isPresent() && wanted.equals(idOf(c)))
            .findFirst();
    if (main.isEmpty()) {
      reportNoCamera(all);
      return;
    }
    tree.repetition(wanted.get())
        .ifPresent(
            second ->
                second.error(
                    ObjectKeys.ID.name(),
                    "expected the main camera's id once, found " + wanted.get() + " again"));
    camera = CameraKinds.read(main.get(), aspect, textures);
    cameraType = CameraKinds.FAMILY.typeKey().in(main.get().node());
  }

  private static Optional<Integer> idOf(Placed object) {
    return object.node().idSilently(ObjectKeys.ID.name());
  }

  private void reportNoCamera(List<Placed> cameras) {
    if (root.has(MAIN_CAMERA) && root.idSilently(MAIN_CAMERA).isEmpty()) {
      return;
    }
    TreeSet<Integer> ids = new TreeSet<>();
    cameras.forEach(c -> idOf(c).ifPresent(ids::add));
    root.error(
        MAIN_CAMERA,
        "expected the id of a camera, found "
            + root.find(MAIN_CAMERA).map(JsonNode::found).orElse("nothing")
            + "; "
            + AssetTable.shown(ids));
  }

  private void readShape(Placed object) {
    Interrupts.check();
    Surface surface = materials.of(object.node());
    Optional<Shape> shape = shapes.read(object);
    shape.ifPresent(
        made ->
            parts.add(
                object.node().origin(),
                assets
                    .findSilently(object.node(), ShapeKinds.MATERIAL, Type.MATERIAL)
                    .map(JsonNode::origin)
                    .orElse(Origin.NONE),
                object.lightGroup(),
                scene -> surface.add(made, scene)));
  }

  private void readModel(Placed object) {
    Interrupts.check();
    models.read(object);
  }

  private void readLights(Optional<Rgb> background) {
    LightReader lights = new LightReader(textures, profiles, materials.hasGlass());
    for (Placed light : objects(ObjectTree.Type.LIGHT)) {
      Origin origin = light.node().origin();
      lights
          .read(light)
          .ifPresent(made -> parts.add(origin, Origin.NONE, light.lightGroup(), made));
    }
    lightCount = lights.count();
    if (background.isPresent() && lights.hasDome()) {
      root.object(RootKeys.OPTIONS.name())
          .ifPresent(
              o -> RootKeys.BACKGROUND.warn(o, "is ignored, because the scene has a Dome"));
    } else {
      background.ifPresent(
          radiance ->
              parts.add(
                  backgroundNode().origin(),
                  Origin.NONE,
                  "",
                  scene -> scene.addBackground(radiance)));
    }
  }

  private JsonNode backgroundNode() {
    return root.object(RootKeys.OPTIONS.name())
        .flatMap(RootKeys.BACKGROUND::find)
        .orElse(root);
  }

  /** Delays building the hierarchy of the scene until the first ray is traced. */
  void searchLater() {
    parts.searchLater();
  }

  /**
   * Returns the scene; there must be no errors.
   *
   * @param known the same scene, if code has built it: it gets the names of the file
   */
  Scene scene(Optional<Scene> known) {
    List<PlacedCamera> ofModel = modelParts.cameras();
    List<Camera> cameras =
        ofModel.isEmpty()
            ? List.of(camera.orElseThrow())
            : PlacedCamera.placed(ofModel, settings.aspect());
    if (settings.poses() > 1
        && !parts.areMoving()
        && cameras.size() == 1
        && models.known().isEmpty()) {
      root.object(RootKeys.OPTIONS.name())
          .ifPresent(
              o -> o.warn(Setting.SHUTTER.name(), "changes nothing, because no model has a pose"));
    }
    return parts.scene(cameras, settings.poses(), backplate, kernel, known);
  }

  /** Returns the surfaces of models, by the numbers of their primitives, after {@link #scene}. */
  Map<Integer, PartSurface> surfaces() {
    return modelParts.surfaces();
  }

  /** Returns the places of objects and assets; requires an earlier call of {@link #scene}. */
  SceneOrigins origins() {
    return parts.origins(textures.uses(), assets.unused());
  }

  /** Returns the numbers of objects and assets. */
  SceneContents contents() {
    return new SceneContents(
        cameraType,
        shapes.count() + modelParts.count(),
        assets.used(Type.MESH) + modelParts.meshes(),
        shapes.triangles() + modelParts.triangles(),
        modelParts.points(),
        lightCount + modelParts.lights(),
        assets.used(Type.MATERIAL) + modelParts.materials(),
        assets.used(Type.TEXTURE) + modelParts.pictures());
  }
}
