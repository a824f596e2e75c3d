package io.github.lumbre.scenefile;

import io.github.lumbre.scene.SettingType;
import io.github.lumbre.scenefile.internal.SceneOrigins;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/** The assets of a scene by type and id, not yet decoded. */
final class AssetTable {
  static final Map<String, Type> TYPES = Value.named(Value::capitalized, List.of(Type.values()));

  /** The id that names no asset. */
  static final int NONE = -1;

  private static final int MAX_IDS_SHOWN = 20;

  enum Type {
    MATERIAL,
    TEXTURE,
    MESH
  }

  private final boolean lenient;
  private final Map<Type, Map<Integer, JsonNode>> assets = new EnumMap<>(Type.class);
  private final Map<Type, Set<JsonNode>> used = new EnumMap<>(Type.class);

  /**
   * @param lenient whether a reference to a missing asset is a warning instead of an error
   */
  AssetTable(JsonNode root, boolean lenient) {
    this.lenient = lenient;
    for (Type type : Type.values()) {
      assets.put(type, new TreeMap<>());
      used.put(type, new HashSet<>());
    }
    Map<Integer, JsonNode> all = new HashMap<>();
    for (JsonNode asset : root.objects(RootKeys.ASSETS.name())) {
      add(asset, all);
    }
  }

  /** Returns whether a reference to a missing asset is a warning instead of an error. */
  boolean isLenient() {
    return lenient;
  }

  private void add(JsonNode asset, Map<Integer, JsonNode> all) {
    String idKey = ObjectKeys.ID.name();
    Optional<Type> type = ObjectKeys.ASSET_TYPE.stated(asset);
    if (!ObjectKeys.ASSET_TYPE.isIn(asset)) {
      ObjectKeys.ASSET_TYPE.error(
          asset, "expected one of " + String.join(", ", TYPES.keySet()) + ", found nothing");
    }
    if (!ObjectKeys.ID.isIn(asset)) {
      asset.error(idKey, "expected an integer, found nothing");
    }
    Optional<Integer> id = ObjectKeys.ID.stated(asset);
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

  /** Warns of keys that no asset of a type has. */
  void warnUnknown(Type type, Set<String> known) {
    assets.get(type).values().forEach(asset -> asset.warnUnknown(known));
  }

  /** Returns the number of assets of a type that have been found. */
  int used(Type type) {
    return used.get(type).size();
  }

  /** Returns the assets that have not been found. */
  List<SceneOrigins.Unused> unused() {
    List<SceneOrigins.Unused> unused = new ArrayList<>();
    assets.forEach(
        (type, ofType) ->
            ofType.values().stream()
                .filter(asset -> !used.get(type).contains(asset))
                .map(asset -> new SceneOrigins.Unused(SettingType.nameOf(type), asset.origin()))
                .forEach(unused::add));
    return unused;
  }

  /** Returns the asset that a key names; empty if there is none. Reports dangling ids. */
  Optional<JsonNode> find(JsonNode from, Key<Integer> key, Type type) {
    Optional<Integer> id = key.stated(from).filter(i -> i != NONE);
    Optional<JsonNode> asset = id.map(assets.get(type)::get);
    asset.ifPresent(used.get(type)::add);
    if (id.isPresent() && asset.isEmpty()) {
      reportDangling(from, key, id.get(), type);
    }
    return asset;
  }

  /** Returns the same as {@link #find}, without adding an error. */
  Optional<JsonNode> findSilently(JsonNode from, Key<Integer> key, Type type) {
    return from.idSilently(key.name()).filter(id -> id != NONE).map(assets.get(type)::get);
  }

  private void reportDangling(JsonNode from, Key<Integer> key, int id, Type type) {
    String message =
        "expected the id of a %s, found %s; %s"
            .formatted(Value.capitalized(type), id, shown(assets.get(type).keySet()));
    if (lenient) {
      key.warn(from, message);
    } else {
      key.error(from, message);
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
