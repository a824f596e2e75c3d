package io.github.lumbre.parser;

import io.github.lumbre.geometry.Kernel;
import io.github.lumbre.light.Light;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.Model;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelGeometry;
import io.github.lumbre.model.ModelMaterial;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Pose;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.ModelPart;
import io.github.lumbre.model.ModelReader;
import io.github.lumbre.model.ModelScene;
import io.github.lumbre.model.ModelSurface;
import io.github.lumbre.parser.ObjectTree.Placed;
import io.github.lumbre.parser.SceneFormatException.Kind;
import io.github.lumbre.scene.SceneAssembly;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;

/** Reads objects that are model files: glTF, OBJ, PLY and STL. */
final class ModelObjects {
  private static final Set<String> KEYS = new HashSet<>(ObjectTree.EMITTER_KEYS);
  private static final Map<String, Up> UPS = new LinkedHashMap<>();

  static {
    KEYS.addAll(
        Set.of(
            "file",
            "up",
            "unit",
            "pose",
            "seconds",
            "variant",
            "useLights",
            "materials",
            "shared"));
    UPS.put("y", Up.Y);
    UPS.put("z", Up.Z);
  }

  private final AssetData data;
  private final MaterialReader materials;
  private final Kernel kernel;
  private final String sceneName;
  private final boolean lenient;
  private final Set<ModelGeometry> meshes = identitySet();
  private final Set<ModelMaterial> ownMaterials = identitySet();
  private int count;
  private int pictures;
  private int lights;
  private long triangles;

  /**
   * @param sceneName name of the scene file; problems of a model with this name are located in the
   *     model alone
   * @param kernel traversal kernel of shared meshes
   * @param lenient whether a missing picture of a model is a warning instead of an error; it always
   *     is if the scene stands for the model
   */
  ModelObjects(
      AssetData data, MaterialReader materials, String sceneName, Kernel kernel, boolean lenient) {
    this.data = data;
    this.materials = materials;
    this.sceneName = sceneName;
    this.kernel = kernel;
    this.lenient = lenient;
  }

  private static <T> Set<T> identitySet() {
    return Collections.newSetFromMap(new IdentityHashMap<>());
  }

  /** A part of a model: one primitive or light. */
  record Part(Origin origin, Origin material, Consumer<SceneAssembly> action) {}

  /** Returns the number of parts read so far. */
  int count() {
    return count;
  }

  /** Returns the number of meshes read so far; instances share one. */
  int meshes() {
    return meshes.size();
  }

  /** Returns the number of materials of the models in use, without default materials. */
  int materials() {
    return ownMaterials.size();
  }

  /** Returns the number of pictures that the models' materials use. */
  int pictures() {
    return pictures;
  }

  /** Returns the number of the models' lights in use. */
  int lights() {
    return lights;
  }

  /** Returns the number of triangles read so far, counted for each instance. */
  long triangles() {
    return triangles;
  }

  /** Returns the parts of a model; empty, with an error added, if it cannot be used. */
  List<Part> read(Placed object) {
    JsonNode node = object.node();
    node.warnUnknown(KEYS);
    Optional<String> name = node.string("file");
    if (name.isEmpty()) {
      if (!node.has("file")) {
        node.error("file", "expected the name of a model file, found nothing");
      }
      return List.of();
    }
    Optional<AssetData.Content> content = data.file(node, name.get());
    return content.map(bytes -> parts(object, name.get(), bytes)).orElse(List.of());
  }

  private List<Part> parts(Placed object, String name, AssetData.Content content) {
    JsonNode node = object.node();
    try {
      ModelOptions options = options(node, name);
      Model model = ModelReader.read(name, content.bytes(), data.folderOf(name), options);
      model.warnings().forEach(warning -> warn(node, name, warning));
      Transform toWorld = object.toWorld().times(ModelScene.TO_LEFT_HANDED);
      long maxTexels = data.allowance().texelsLeft();
      boolean sharesAll = node.flag("shared", false);
      ModelScene scene = new ModelScene(model, toWorld, kernel, maxTexels, sharesAll);
      return parts(node, name, scene, overrides(node));
    } catch (ModelFormatException e) {
      report(node, name, e);
    } catch (IOException e) {
      CancellationException cancelled = new CancellationException(e.toString());
      cancelled.initCause(e);
      throw cancelled;
    }
    return List.of();
  }

  private List<Part> parts(
      JsonNode node, String name, ModelScene scene, Map<String, Surface> overrides)
      throws ModelFormatException {
    List<Part> parts = new ArrayList<>();
    List<ModelSurface> surfaces = scene.surfaces();
    scene.warnings().forEach(warning -> warn(node, name, warning));
    data.allowance().addTexels(scene.texels());
    pictures += scene.pictures();
    for (ModelSurface surface : surfaces) {
      ModelPart part = surface.part();
      count++;
      triangles += part.geometry().triangleCount();
      data.allowance().addTriangles(part.geometry().triangleCount());
      meshes.add(part.geometry());
      Optional<Surface> other = Optional.ofNullable(overrides.get(part.material().name()));
      if (other.isEmpty() && !part.material().location().isEmpty()) {
        ownMaterials.add(part.material());
      }
      if (ShapeReader.isMeasurable(node, surface.shape())) {
        parts.add(
            new Part(
                origin(node, name, part.location(), part.name()),
                origin(node, name, part.material().location(), part.material().name()),
                builder ->
                    other.ifPresentOrElse(
                        own -> own.add(surface.shape(), builder), () -> surface.addTo(builder))));
      }
    }
    if (node.flag("useLights", true)) {
      for (Light light : scene.lights()) {
        lights++;
        parts.add(new Part(origin(node, name, "lights", ""), Origin.NONE, b -> b.add(light)));
      }
    }
    return parts;
  }

  private Origin origin(JsonNode node, String name, String location, String itsName) {
    String path = isTheScene(name) ? location : node.path() + ": " + name + ": " + location;
    return new Origin(Problems.shownPath(Problems.escaped(path)), Problems.shortened(itsName));
  }

  /** Returns whether the scene stands for the model itself. */
  private boolean isTheScene(String name) {
    return name.substring(name.lastIndexOf('/') + 1).equals(sceneName);
  }

  private void warn(JsonNode node, String name, String warning) {
    if (isTheScene(name)) {
      node.problems().warn(() -> "", () -> warning);
    } else {
      node.warn("file", name + ": " + warning);
    }
  }

  private void report(JsonNode node, String name, ModelFormatException e) {
    Kind kind =
        switch (e.kind()) {
          case TOO_LARGE -> Kind.LIMIT;
          case MALFORMED, UNSUPPORTED, ASSET -> Kind.ASSET;
        };
    String message = Problems.escaped(e.getMessage());
    if (isTheScene(name)) {
      node.problems().error(kind, () -> Problems.escaped(e.location()), e.detail());
    } else {
      node.error(kind, "file", name + ": " + message);
    }
  }

  private ModelOptions options(JsonNode node, String file) {
    Optional<Pose> pose =
        node.has("pose")
            ? node.string("pose")
                .map(name -> new Pose(name, node.number("seconds", 0, Range.NOT_NEGATIVE)))
            : Optional.empty();
    Optional<String> variant = node.has("variant") ? node.string("variant") : Optional.empty();
    return new ModelOptions(
        pose,
        variant,
        node.choice("up", UPS, Up.Y),
        node.number("unit", 1, Range.POSITIVE),
        data.allowance().left(),
        lenient || isTheScene(file));
  }

  /** Returns the surfaces that replace materials of the model, by the names of these. */
  private Map<String, Surface> overrides(JsonNode node) {
    Map<String, Surface> all = new LinkedHashMap<>();
    node.object("materials")
        .ifPresent(
            named ->
                named
                    .keys()
                    .forEach(key -> materials.named(named, key).ifPresent(s -> all.put(key, s))));
    return all;
  }
}
