package io.github.lumbre.parser;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.parser.ObjectTree.Placed;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneAssembly;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** Reads the objects of a scene, the assets they use, and the main camera. Not reusable. */
final class SceneReader {
  private static final String MAIN_CAMERA = "mainCameraId";

  private final JsonNode root;
  private final Kernel kernel;
  private final AssetTable assets;
  private final ObjectTree tree;
  private final TextureReader textures;
  private final MeshReader meshes;
  private final MaterialReader materials;
  private final ShapeReader shapes;
  private final CameraReader cameras;
  private final ModelObjects models;
  private final List<Addition> additions = new ArrayList<>();
  private final List<Origin> primitives = new ArrayList<>();
  private final List<Origin> materialsOfPrimitives = new ArrayList<>();
  private final List<Origin> emitters = new ArrayList<>();
  private Optional<Camera> camera = Optional.empty();
  private Optional<Rgb> backplate = Optional.empty();
  private String cameraType = "";
  private int lightCount;

  /** An action that adds a part of the file to the scene. */
  private record Addition(
      Origin origin, Origin material, String lightGroup, Consumer<SceneAssembly> action) {}

  /**
   * @param seed seed of the procedural textures
   * @param change overrides for all textures
   * @param kernel traversal kernel of the bounding volume hierarchies
   * @param sceneName name of the scene file
   */
  SceneReader(
      JsonNode root,
      AssetTable assets,
      AssetData data,
      long seed,
      TextureChange change,
      Kernel kernel,
      String sceneName) {
    this.root = root;
    this.kernel = kernel;
    this.assets = assets;
    tree = ObjectTree.of(root);
    textures = new TextureReader(assets, data, seed, change);
    meshes = new MeshReader(assets, data);
    materials = new MaterialReader(assets, textures);
    shapes = new ShapeReader(meshes, objects(ObjectTree.Type.SHAPE), kernel);
    cameras = new CameraReader(textures);
    models = new ModelObjects(data, materials, sceneName, kernel, assets.isLenient());
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
    textures.checkAll();
    meshes.checkAll();
    materials.checkAll();
    objects(ObjectTree.Type.NONE).forEach(o -> o.node().warnUnknown(ObjectTree.COMMON_KEYS));
    readCamera(aspect);
    objects(ObjectTree.Type.SHAPE).forEach(this::readShape);
    objects(ObjectTree.Type.MODEL).forEach(this::readModel);
    readLights(background);
    backplate =
        root.find("renderOptions").filter(JsonNode::isObject).flatMap(SettingsReader::backplate);
  }

  private void readCamera(double aspect) {
    List<Placed> all = objects(ObjectTree.Type.CAMERA);
    all.forEach(cameras::check);
    Optional<Integer> wanted = root.id(MAIN_CAMERA);
    Optional<Placed> main =
        all.stream()
            .filter(c -> wanted.isPresent() && wanted.equals(c.node().idSilently("id")))
            .findFirst();
    if (main.isEmpty()) {
      reportNoCamera(all);
      return;
    }
    tree.repetition(wanted.get())
        .ifPresent(
            second ->
                second.error(
                    "id", "expected the main camera's id once, found " + wanted.get() + " again"));
    camera = cameras.read(main.get(), aspect);
    cameraType = main.get().node().string("cameraType").orElse(CameraReader.DEFAULT_TYPE);
  }

  private void reportNoCamera(List<Placed> cameras) {
    if (root.has(MAIN_CAMERA) && root.idSilently(MAIN_CAMERA).isEmpty()) {
      return;
    }
    TreeSet<Integer> ids = new TreeSet<>();
    cameras.forEach(c -> c.node().idSilently("id").ifPresent(ids::add));
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
            additions.add(
                new Addition(
                    Origin.of(object.node()),
                    materials.asset(object.node()).map(Origin::of).orElse(Origin.NONE),
                    object.lightGroup(),
                    scene -> surface.add(made, scene))));
  }

  private void readModel(Placed object) {
    Interrupts.check();
    for (ModelObjects.Part part : models.read(object)) {
      additions.add(
          new Addition(part.origin(), part.material(), object.lightGroup(), part.action()));
    }
  }

  private void readLights(Optional<Rgb> background) {
    LightReader lights = new LightReader(textures, materials.hasGlass());
    for (Placed light : objects(ObjectTree.Type.LIGHT)) {
      Origin origin = Origin.of(light.node());
      lights
          .read(light)
          .ifPresent(
              made -> additions.add(new Addition(origin, Origin.NONE, light.lightGroup(), made)));
    }
    lightCount = lights.count();
    if (background.isPresent() && lights.hasDome()) {
      root.object("renderOptions")
          .ifPresent(o -> o.warn("background", "is ignored, because the scene has a Dome"));
    } else {
      background.ifPresent(
          radiance ->
              additions.add(
                  new Addition(
                      Origin.of(backgroundNode()),
                      Origin.NONE,
                      "",
                      b -> b.addBackground(radiance))));
    }
  }

  private JsonNode backgroundNode() {
    return root.object("renderOptions").flatMap(o -> o.find("background")).orElse(root);
  }

  /**
   * Returns the scene; there must be no errors.
   *
   * @param known the same scene, if code has built it: it gets the names of the file
   */
  Scene scene(Optional<Scene> known) {
    SceneAssembly scene = new SceneAssembly(camera.orElseThrow()).searchedBy(kernel);
    backplate.ifPresent(scene::backplate);
    OriginNames objects = new OriginNames("object");
    OriginNames materialNames = new OriginNames("default");
    for (Addition addition : additions) {
      Interrupts.check();
      scene.lightGroup(addition.lightGroup);
      scene.named(objects.of(addition.origin), materialNames.of(addition.material));
      addition.action.accept(scene);
      note(addition, scene);
    }
    return known.map(same -> same.named(scene)).orElseGet(scene::build);
  }

  /** Records the origin of the primitives or lights that were just added. */
  private void note(Addition addition, SceneAssembly scene) {
    while (scene.primitiveCount() > primitives.size()) {
      primitives.add(addition.origin);
      materialsOfPrimitives.add(addition.material);
    }
    while (scene.emitterCount() > emitters.size()) {
      emitters.add(addition.origin);
    }
  }

  /** Returns the places of objects and assets; requires an earlier call of {@link #scene}. */
  SceneOrigins origins() {
    List<SceneOrigins.Unused> unused = new ArrayList<>();
    addUnused(AssetTable.Type.MATERIAL, "material", materials::uses, unused);
    addUnused(AssetTable.Type.TEXTURE, "texture", textures::uses, unused);
    addUnused(AssetTable.Type.MESH, "mesh", meshes::uses, unused);
    return new SceneOrigins(primitives, materialsOfPrimitives, emitters, textures.uses(), unused);
  }

  private void addUnused(
      AssetTable.Type type,
      String name,
      Predicate<JsonNode> isUsed,
      List<SceneOrigins.Unused> unused) {
    assets.all(type).stream()
        .filter(isUsed.negate())
        .forEach(asset -> unused.add(new SceneOrigins.Unused(name, Origin.of(asset))));
  }

  /** Returns the numbers of objects and assets. */
  SceneContents contents() {
    return new SceneContents(
        cameraType,
        shapes.count() + models.count(),
        meshes.count() + models.meshes(),
        shapes.triangles() + models.triangles(),
        lightCount + models.lights(),
        materials.count() + models.materials(),
        textures.count() + models.pictures());
  }
}
