package io.github.lumbre.scenefile;

import com.google.gson.JsonObject;
import io.github.lumbre.math.internal.Sha256;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * The assets of a scene that is written, and their files. The names of the files contain the hashes
 * of their content, so that scenes in one folder share them. Mutable.
 */
final class AssetWriter {
  /** The folder of the files, beside the scene. */
  static final String FOLDER = "assets/";

  private static final int HASH_LETTERS = 16;

  private final List<JsonObject> assets = new ArrayList<>();
  private final Map<String, byte[]> files = new TreeMap<>();
  private final Map<Object, Map<String, Integer>> ids = new IdentityHashMap<>();

  /** Returns the assets in the order of their ids. */
  List<JsonObject> assets() {
    return assets;
  }

  /** Returns the bytes of the files by their names, relative to the scene's folder. */
  Map<String, byte[]> files() {
    return files;
  }

  /**
   * Returns the id of an asset; makes it at its first use.
   *
   * @param source the object that the asset is made from, by identity
   * @param variant distinguishes assets of one object
   * @param type its assetType
   * @param maker adds its other keys
   */
  int id(Object source, String variant, AssetTable.Type type, Consumer<JsonObject> maker) {
    Map<String, Integer> ofSource = ids.computeIfAbsent(source, key -> new TreeMap<>());
    Integer known = ofSource.get(variant);
    if (known != null) {
      return known;
    }
    JsonObject asset = new JsonObject();
    // Textures of a material are made before it: the id states the place in the list.
    JsonObject keys = new JsonObject();
    maker.accept(keys);
    int id = assets.size() + 1;
    ObjectKeys.ID.put(asset, id);
    ObjectKeys.ASSET_TYPE.put(asset, type);
    keys.entrySet().forEach(key -> asset.add(key.getKey(), key.getValue()));
    assets.add(asset);
    ofSource.put(variant, id);
    return id;
  }

  /** Adds a file and returns its name. */
  String file(String kind, byte[] content, String ending) {
    String name = FOLDER + kind + "-" + shortHash(content) + "." + ending;
    files.put(name, content);
    return name;
  }

  /** Adds a file under a name. */
  void file(String name, byte[] content) {
    files.put(name, content);
  }

  static String shortHash(byte[] content) {
    return Sha256.of(content).substring(0, HASH_LETTERS);
  }
}
