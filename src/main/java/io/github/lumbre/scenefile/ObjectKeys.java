package io.github.lumbre.scenefile;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.internal.CameraKeys;
import java.util.List;
import java.util.stream.Stream;

/** The keys of all objects and assets. */
final class ObjectKeys {
  /** Lists of objects. */
  static final Value<JsonNode> LIST =
      Value.other("{'type': ['array', 'null'], 'items': {'$ref': '#/$defs/object'}}");

  static final Key<JsonNode> NAME = Key.of("name", Value.other("{}"), "");
  static final Key<Integer> ID = Key.of(CameraKeys.ID, Value.ID, "");
  static final Key<ObjectTree.Type> TYPE =
      Key.choice(CameraKeys.TYPE, Value::capitalized, ObjectTree.Type.NONE, "");
  static final Key<JsonNode> CHILDREN = Key.of(CameraKeys.CHILDREN, LIST, "");
  static final Key<Vec3> POSITION = Key.vector(CameraKeys.POSITION, Vec3.ZERO, "");
  static final Key<Vec3> ROTATION =
      Key.vector(CameraKeys.ROTATION, Vec3.ZERO, "Degrees, about z first, then x, then y.");
  static final Key<Vec3> SCALE =
      Key.vector(CameraKeys.SCALE, new Vec3(1, 1, 1), "1 where missing.");
  static final Key<Vec3> LOOK_AT =
      Key.vector(
          CameraKeys.LOOK_AT,
          Vec3.Z,
          "The point, in the parent's space, that local +z points to.");
  static final Key<Vec3> LOOK_AT_UP =
      Key.vector(
          CameraKeys.LOOK_AT_UP,
          Vec3.Y,
          "The direction nearest to local +y; the parent's +y where missing.");
  static final Key<double[]> MATRIX =
      Key.of(
          CameraKeys.MATRIX,
          Value.list(LocalTransform.NUMBERS, Transform.VALUES),
          new double[0],
          "Three rows of four numbers, instead of position, rotation and scale.");
  static final Key<String> LIGHT_GROUP =
      Key.of(
              "lightGroup",
              Value.text("{'type': ['string', 'null'], 'pattern': '^[A-Za-z0-9_]*$'}"),
              "",
              "The light group of the light that this object emits.")
          .omitted();

  /** The keys of every object. */
  static final List<Key<?>> ALL =
      List.of(
          TYPE, NAME, ID, CHILDREN, POSITION, ROTATION, SCALE, LOOK_AT, LOOK_AT_UP, MATRIX);

  /** The keys of every object that can emit light. */
  static final List<Key<?>> OF_EMITTERS =
      Stream.<Key<?>>concat(ALL.stream(), Stream.of(LIGHT_GROUP)).toList();

  static final Key<AssetTable.Type> ASSET_TYPE =
      Key.of("assetType", Value.choice(AssetTable.TYPES), "");
  static final Key<String> FILE = content("file");

  /** The keys of every asset. */
  static final List<Key<?>> OF_ASSETS = List.of(ID, ASSET_TYPE, NAME);

  static final Key<String> BASE64_MESH = content("base64OBJ");

  /** The keys of meshes besides those of every asset. */
  static final List<Key<?>> OF_MESHES = List.of(BASE64_MESH, FILE);

  static final Key<Boolean> SHARED_MODEL =
      Key.flag("shared", false, "Whether all meshes keep hierarchies in their own space.");
  static final Key<Boolean> USE_LIGHTS =
      Key.flag("useLights", true, "Whether the lights of the file shine.");
  static final Key<String> USE_CAMERA =
      Key.of(
          "useCamera",
          Value.TEXT,
          "",
          "Name of a camera of the file that replaces the main camera, and moves with the pose.");
  static final Key<JsonNode> MATERIALS =
      Key.of(
          "materials",
          Value.other(
              "{'type': ['object', 'null'], 'additionalProperties': {'$ref': '#/$defs/id'}}"),
          "Ids of materials of the scene, by the names of the model's materials.");

  /** The keys of models besides their options and those of every emitter. */
  static final List<Key<?>> OF_MODELS =
      List.of(FILE, USE_CAMERA, USE_LIGHTS, MATERIALS, SHARED_MODEL);

  private ObjectKeys() {}

  /** Returns a key of the content of an asset, or of its file. */
  static Key<String> content(String name) {
    return Key.of(name, Value.TEXT, "");
  }
}
