package io.github.lumbre.scenefile;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/** The assets of a scene by type and id, not yet decoded. */
final class AssetTable {
  static final Map<String, Type> TYPES = ordered(Type.values());

  /** The id that names no asset. */
  static final int NONE = -1;

  private static final int MAX_IDS_SHOWN = 20;

  enum Type {
    MATERIAL("Material"),
    TEXTURE("Texture"),
    MESH("Mesh");

    private final String label;

    Type(String label) {
      this.label = label;
    }
  }

  private final boolean lenient;
  private final Map<Type, Map<Integer, JsonNode>> assets = new EnumMap<>(Type.class);

  /**
   * @param lenient whether a reference to a missing asset is a warning instead of an error
   */
  AssetTable(JsonNode root, boolean lenient) {
    this.lenient = lenient;
    for (Type type : Type.values()) {
      assets.put(type, new TreeMap<>());
    }
    Map<Integer, JsonNode> all = new HashMap<>();
    for (JsonNode asset : root.objects(SceneKeys.ASSETS.name())) {
      add(asset, all);
    }
  }

  /** Returns whether a reference to a missing asset is a warning instead of an error. */
  boolean isLenient() {
    return lenient;
  }

  private static Map<String, Type> ordered(Type... types) {
    Map<String, Type> map = new LinkedHashMap<>();
    for (Type type : types) {
      map.put(type.label, type);
    }
    return map;
  }

  private void add(JsonNode asset, Map<Integer, JsonNode> all) {
    String typeKey = ObjectKeys.ASSET_TYPE.name();
    String idKey = ObjectKeys.ID.name();
    Optional<Type> type = asset.choice(typeKey, TYPES);
    if (!asset.has(typeKey)) {
      asset.error(
          typeKey, "expected one of " + String.join(", ", TYPES.keySet()) + ", found nothing");
    }
    if (!asset.has(idKey)) {
      asset.error(idKey, "expected an integer, found nothing");
    }
    Optional<Integer> id = asset.id(idKey);
    if (id.isEmpty() || type.isEmpty()) {
      return;
    }
    JsonNode first = all.putIfAbsent(id.get(), asset);
    if (first != null) {
      String place = first.path() + "." + idKey;
      asset.error(idKey, "expected each id once, found " + id.get() + ", also at " + place);
      return;
    }
    assets.get(type.get()).put(id.get(), asset);
  }

  /** Returns all assets of a type, used or not. */
  List<JsonNode> all(Type type) {
    return List.copyOf(assets.get(type).values());
  }

  /** Returns the asset that a key names; empty if there is none. Reports dangling ids. */
  Optional<JsonNode> find(JsonNode from, Key<Integer> key, Type type) {
    return find(from, key.name(), type);
  }

  /** Returns the same as the other method, for a key that scenes name. */
  Optional<JsonNode> find(JsonNode from, String key, Type type) {
    Optional<Integer> id = from.id(key).filter(i -> i != NONE);
    Optional<JsonNode> asset = id.map(assets.get(type)::get);
    if (id.isPresent() && asset.isEmpty()) {
      reportDangling(from, key, id.get(), type);
    }
    return asset;
  }

  /** Returns whether a key names an existing asset of a type; never reports an error. */
  boolean has(JsonNode from, Key<Integer> key, Type type) {
    return from.idSilently(key.name())
        .filter(id -> id != NONE && assets.get(type).containsKey(id))
        .isPresent();
  }

  private void reportDangling(JsonNode from, String key, int id, Type type) {
    String message =
        "expected the id of a %s, found %s; %s"
            .formatted(type.label, id, shown(assets.get(type).keySet()));
    if (lenient) {
      from.warn(key, message);
    } else {
      from.error(key, message);
    }
  }

  /** Returns a short list of existing ids for an error message, in ascending order. */
  static String shown(Set<Integer> ids) {
    if (ids.isEmpty()) {
      return "none exists";
    }
    List<String> first = ids.stream().sorted().limit(MAX_IDS_SHOWN).map(String::valueOf).toList();
    return (ids.size() == 1 ? "existing id: " : "existing ids: ")
        + String.join(", ", first)
        + (ids.size() > MAX_IDS_SHOWN ? ", …" : "");
  }
}
