package io.github.lumbre.scenefile;

import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.DecodedPictures;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.program.ImportProgram.Imported;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import io.github.lumbre.scenefile.internal.PlacedCamera;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Reads objects that are model files: glTF, OBJ, PLY, STL, OFF, 3MF, COLLADA and ZIP.
 *
 * @param parts receives the models
 * @param settings of the scene: they have the time of the shutter
 * @param sceneName name of the scene file; places of a model with this name are in the model alone:
 *     the scene stands for the model
 * @param mayLackFiles whether a missing picture of a model is a warning instead of an error; it
 *     always is if the scene stands for the model
 * @param known the model that the scene is made around, if it has been read
 */
record ModelObjects(
    AssetData data,
    MaterialReader materials,
    ModelParts parts,
    RenderSettings settings,
    String sceneName,
    boolean mayLackFiles,
    Optional<Known> known) {
  /** A model that has been read: the only one of its scene, and the place of its problems. */
  record Known(Model model, ModelPlace place, DecodedPictures decoded) {}

  private static final String NOTHING = "nothing of the model is visible in this frame";

  private static final Set<String> KEYS =
      Key.names(ObjectKeys.OF_EMITTERS, ModelKeys.ALL, ObjectKeys.OF_MODELS);

  /** Adds the model of an object; adds an error if it cannot be used. */
  void read(Placed object) {
    JsonNode node = object.node();
    node.warnUnknown(KEYS);
    Optional<String> name = object.stated(ObjectKeys.FILE);
    if (name.isEmpty()) {
      if (!ObjectKeys.FILE.isIn(node)) {
        ObjectKeys.FILE.error(node, "expected the name of a model file, found nothing");
      }
      return;
    }
    if (known.isPresent()) {
      add(object, known.get().model, known.get().place);
      return;
    }
    Optional<Imported> imported = data.imported().filter(model -> isTheScene(name.get()));
    if (imported.isPresent()) {
      data.note(name.get(), imported.get().identity());
      // The ending chooses the format.
      read(object, name.get(), name.get() + ".glb", imported.get().glb());
      return;
    }
    data.file(node.problemPlace(ObjectKeys.FILE.name()), name.get())
        .ifPresent(content -> read(object, name.get(), name.get(), content.bytes()));
  }

  private boolean isTheScene(String name) {
    return name.substring(name.lastIndexOf('/') + 1).equals(sceneName);
  }

  private void read(Placed object, String name, String nameOfContent, byte[] content) {
    JsonNode node = object.node();
    boolean isTheScene = isTheScene(name);
    ModelPlace place =
        isTheScene
            ? new ModelPlace.OfFile(node.problems())
            : new ModelPlace.OfObject(node, ObjectKeys.FILE.name(), name);
    ModelOptions options = options(node, mayLackFiles || isTheScene);
    ModelFolder files =
        isTheScene
            ? data.ownFolderOf(name, options.with(ModelOption.ASSETS, data.modelAssets()))
            : data.folderOf(name);
    try {
      add(object, ModelReader.read(nameOfContent, content, files, options), place);
    } catch (ModelFormatException e) {
      place.error(e);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void add(Placed object, Model model, ModelPlace place) {
    JsonNode node = object.node();
    try {
      Optional<String> camera = object.stated(ObjectKeys.USE_CAMERA);
      if (camera.isPresent()) {
        parts.seenBy(PlacedCamera.inPoses(model, camera.get(), object.toWorld()));
      }
      parts.add(
          model,
          new ModelParts.Placement(
              place,
              object.toWorld(),
              object.get(ObjectKeys.SHARED_MODEL),
              overrides(node),
              object.get(ObjectKeys.USE_LIGHTS),
              object.lightGroup()));
      if (known.isPresent() && !model.hasSurface()) {
        place.warn(NOTHING);
      }
    } catch (ModelFormatException e) {
      place.error(e);
    }
  }

  private ModelOptions options(JsonNode node, boolean mayLack) {
    return ModelKeys.read(node)
        .limitedTo(data.allowance().left())
        .mayLackFiles(mayLack)
        .during(settings);
  }

  /** Returns the surfaces that replace materials of the model, by the names of these. */
  private Map<String, Surface> overrides(JsonNode node) {
    Map<String, Surface> all = new LinkedHashMap<>();
    for (JsonNode named : node.object(ObjectKeys.MATERIALS.name()).stream().toList()) {
      for (String key : named.keys()) {
        materials.named(named, Key.id(key)).ifPresent(surface -> all.put(key, surface));
      }
    }
    return all;
  }
}
