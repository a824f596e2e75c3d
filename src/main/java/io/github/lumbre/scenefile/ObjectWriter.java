package io.github.lumbre.scenefile;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import io.github.lumbre.camera.Viewpoint;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.model.ModelFile;
import io.github.lumbre.scene.internal.SceneNode;
import io.github.lumbre.scene.internal.SurfaceNames;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** Writes the tree of objects. Not reusable: it counts the surfaces. */
final class ObjectWriter {
  private final AssetWriter assets;
  private final TextureWriter textures;
  private final SurfaceNames names;
  private int surfaces;

  /**
   * @param names of the objects and materials; surfaces come first and in the order of the nodes
   */
  ObjectWriter(AssetWriter assets, SurfaceNames names) {
    this.assets = assets;
    this.names = names;
    textures = new TextureWriter(assets);
  }

  /** Returns the objects of nodes; backgrounds are none. */
  JsonArray all(List<SceneNode> nodes) {
    JsonArray all = new JsonArray();
    for (SceneNode node : nodes) {
      if (node instanceof SceneNode.Group group) {
        all.add(group(group));
      } else if (node instanceof SceneNode.Surface surface) {
        all.add(surface(surface));
      } else if (node instanceof SceneNode.Lamp lamp) {
        all.add(light(lamp.lightGroup(), lamp.light()));
      } else if (node instanceof SceneNode.Ambient ambient) {
        all.add(light("", ambient));
      } else if (node instanceof SceneNode.Part part) {
        all.add(part(part));
      }
    }
    return all;
  }

  private JsonObject group(SceneNode.Group group) {
    JsonObject object = object("None", group.name());
    LocalTransform.place(object, group.transform());
    object.add(ObjectKeys.CHILDREN.name(), all(group.children()));
    return object;
  }

  static JsonObject object(String type, String name) {
    JsonObject object = new JsonObject();
    object.addProperty(ObjectKeys.TYPE.name(), type);
    if (!name.isEmpty()) {
      object.addProperty(ObjectKeys.NAME.name(), name);
    }
    return object;
  }

  private JsonObject surface(SceneNode.Surface surface) {
    String name = names.object(surfaces);
    String materialName = names.material(surfaces);
    surfaces++;
    try {
      JsonObject object = object("Shape", name);
      ObjectKeys.LIGHT_GROUP.put(object, surface.lightGroup());
      ShapeKinds.MATERIAL.put(object, material(surface, materialName));
      ShapeKinds.FAMILY.write(surface.shape(), object, textures);
      return object;
    } catch (Unwritable e) {
      throw e.at("\"" + name + '"');
    }
  }

  /** Writes the material of a surface and returns its id. */
  private int material(SceneNode.Surface surface, String name) {
    Optional<Emission> emission = surface.emission();
    if (emission.isEmpty()) {
      return asset(surface.material(), name, name, to -> material(to, surface.material()));
    }
    if (surface.material() != Unlit.INSTANCE) {
      throw new Unwritable(
          "a surface that scatters or emits light", "one that does both; use two surfaces");
    }
    boolean isDeclared = surface.isDeclared();
    return asset(
        emission.get(), isDeclared + name, name, to -> emission(to, emission.get(), isDeclared));
  }

  private int asset(Object source, String variant, String name, Consumer<JsonObject> keys) {
    return assets.id(
        source,
        variant,
        AssetTable.Type.MATERIAL,
        to -> {
          to.addProperty(ObjectKeys.NAME.name(), name);
          keys.accept(to);
        });
  }

  private void emission(JsonObject to, Emission emission, boolean isDeclared) {
    if (!isDeclared && !emission.twoSided()) {
      throw new Unwritable(
          "an emissive surface that emits on both sides",
          "one that emits outside; use addAreaLight");
    }
    if (emission.meanRadiance() != new Emission(emission.radiance(), true).meanRadiance()) {
      throw new Unwritable("the mean radiance of the texture", "another one");
    }
    Kind<?, ?> kind = isDeclared ? MaterialKinds.AREA_LIGHT : MaterialKinds.EMISSIVE;
    MaterialKinds.FAMILY.write(kind, emission, to, textures);
  }

  private void material(JsonObject to, Material material) {
    if (!(material instanceof NormalMapped mapped)) {
      MaterialKinds.FAMILY.write(material, to, textures);
      return;
    }
    if (mapped.uvSet() != 0 || mapped.material() instanceof NormalMapped) {
      throw new Unwritable("one normal map with the first texture coordinates", "another one");
    }
    Kind<?, ?> kind = MaterialKinds.FAMILY.write(mapped.material(), to, textures);
    if (!kind.keys().contains(MaterialKinds.NORMAL.texture())) {
      throw new Unwritable("a " + kind.name() + " without a normal map", "one with a normal map");
    }
    textures.normalMap(to, MaterialKinds.NORMAL, mapped.map());
  }

  private JsonObject light(String group, Object light) {
    JsonObject object = object("Light", "");
    ObjectKeys.LIGHT_GROUP.put(object, group);
    LightKinds.FAMILY.write(light, object, textures);
    return object;
  }

  private JsonObject part(SceneNode.Part part) {
    if (!(part.content() instanceof ModelFile model)) {
      throw new Unwritable("a model of Models.read", Unwritable.name(part.content()));
    }
    JsonObject object = object("Model", part.name());
    LocalTransform.place(object, part.transform());
    ObjectKeys.LIGHT_GROUP.put(object, part.lightGroup());
    ObjectKeys.FILE.put(object, file(model));
    ModelKeys.write(model.options(), object);
    ObjectKeys.USE_LIGHTS.put(object, model.usesLights());
    ObjectKeys.SHARED_MODEL.put(object, model.isMovable());
    return object;
  }

  /** Adds a model with the files that it names, in a folder of its own. */
  private String file(ModelFile model) {
    byte[] content = model.content();
    StringBuilder all = new StringBuilder(Sha256.of(content));
    Map<String, byte[]> others = model.files();
    others.forEach((name, bytes) -> all.append(name).append(Sha256.of(bytes)));
    byte[] key = all.toString().getBytes(StandardCharsets.UTF_8);
    String folder = AssetWriter.FOLDER + "model-" + AssetWriter.shortHash(key) + "/";
    assets.file(folder + model.name(), content);
    others.forEach((name, bytes) -> assets.file(folder + name, bytes));
    return folder + model.name();
  }

  JsonObject camera(Viewpoint from) {
    JsonObject object = object("Camera", "");
    ObjectKeys.ID.put(object, 1);
    ObjectKeys.POSITION.put(object, from.eye());
    ObjectKeys.LOOK_AT.put(object, from.target());
    ObjectKeys.LOOK_AT_UP.put(object, from.up());
    CameraKinds.FAMILY.write(from.lens(), object, textures);
    return object;
  }
}
