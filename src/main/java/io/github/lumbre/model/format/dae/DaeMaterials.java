package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.internal.ModelMaterial;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The materials of a file, and how instances bind them. Mutable: effects are read once. */
final class DaeMaterials {
  private static final String WHOLLY_TRANSPARENT =
      "all materials are wholly transparent, as some programs write opaque ones; they are shown"
          + " opaque";

  /** What a surface looks like: a material and the sets of texture coordinates of its pictures. */
  static final class Look {
    private final DaeConversion material;
    private final Map<String, Integer> sets;

    private Look(DaeConversion material, Map<String, Integer> sets) {
      this.material = material;
      this.sets = sets;
    }
  }

  /** A material whose pictures use the first or the second set of a surface. */
  private record Key(DaeConversion material, List<Integer> slots, boolean isOneSided) {}

  private final DaeDocument document;
  private final FormatFile file;
  private final Map<DaeElement, Optional<DaeConversion>> known = new IdentityHashMap<>();
  private final Map<Key, ModelMaterial> made = new HashMap<>();
  private boolean isOpaque;

  DaeMaterials(DaeDocument document) {
    this.document = document;
    file = document.file();
  }

  /**
   * Returns the look that an instance of a geometry gives to a symbol of it; empty if it has none.
   *
   * @param bound what the {@code <bind_material>} of the instance has, by {@link #bound}
   */
  Optional<Look> look(DaeElement instance, Map<String, DaeElement> bound, String symbol) {
    DaeElement stated = bound.get(symbol);
    if (stated != null) {
      Optional<DaeElement> material =
          document.find("material", stated.attribute("target"), stated.location());
      Map<String, Integer> sets = new HashMap<>();
      for (DaeElement input : stated.children("bind_vertex_input")) {
        sets.put(input.attribute("semantic"), input.integer("input_set", 0));
      }
      return material.flatMap(m -> look(m, sets));
    }
    if (symbol.isEmpty()) {
      return Optional.empty();
    }
    Optional<DaeElement> named = document.withId("material", symbol);
    file.warnings()
        .once(
            " unbound " + symbol,
            instance.location(),
            "expected a material bound to %s, found none; %s"
                .formatted(
                    PrintableText.quoted(symbol),
                    named.isPresent() ? "that of this id is used" : "light gray is used"));
    return named.flatMap(material -> look(material, Map.of()));
  }

  /** Returns the instances of materials that an instance of a geometry has, by their symbols. */
  static Map<String, DaeElement> bound(DaeElement instance) {
    Map<String, DaeElement> all = new HashMap<>();
    for (DaeElement bind : instance.children("bind_material")) {
      for (DaeElement technique : bind.children("technique_common")) {
        for (DaeElement material : technique.children("instance_material")) {
          all.putIfAbsent(material.attribute("symbol"), material);
        }
      }
    }
    return all;
  }

  private Optional<Look> look(DaeElement material, Map<String, Integer> sets) {
    return known
        .computeIfAbsent(
            material,
            m -> DaeEffect.of(m, document).map(effect -> new DaeConversion(effect, m, file)))
        .map(conversion -> new Look(conversion, sets));
  }

  /** Shows all materials as opaque, with a warning. */
  void showOpaque() {
    isOpaque = true;
    file.warnings().add("", WHOLLY_TRANSPARENT);
  }

  /** Returns whether a look is wholly transparent. */
  boolean isInvisible(Look look) {
    return look.material.isInvisible();
  }

  /**
   * Returns the sets of texture coordinates that a look needs, at most two.
   *
   * @param available sets of the surface, in ascending order
   */
  List<Integer> sets(Look look, List<Integer> available) {
    List<Integer> used = new ArrayList<>();
    for (String semantic : look.material.semantics()) {
      int set = set(look, semantic, available);
      if (set >= 0 && !used.contains(set)) {
        used.add(set);
      }
    }
    if (used.size() > 2) {
      file.warnings()
          .add(
              look.material.location(),
              "expected pictures with two sets of texture coordinates, found more; the first set"
                  + " is used for the others");
    }
    return List.copyOf(used.subList(0, Math.min(2, used.size())));
  }

  /** Returns the set that a name means; the first one if it is not bound; -1 without any. */
  private int set(Look look, String semantic, List<Integer> available) {
    if (available.isEmpty()) {
      return -1;
    }
    Integer bound = look.sets.get(semantic);
    if (bound != null && available.contains(bound)) {
      return bound;
    }
    if (bound != null || available.size() > 1) {
      file.warnings()
          .once(
              " set " + semantic,
              look.material.location(),
              "expected texture coordinates bound to %s, found none; the set %d is used"
                  .formatted(PrintableText.quoted(semantic), available.get(0)));
    }
    return available.get(0);
  }

  /**
   * Returns the material of a look.
   *
   * @param used the sets of the surface: the first and the second one
   * @param available all sets of the surface
   */
  ModelMaterial material(
      Look look, List<Integer> used, List<Integer> available, boolean isOneSided)
      throws ModelFormatException, IOException {
    List<Integer> slots = new ArrayList<>();
    for (String semantic : look.material.semantics()) {
      slots.add(Math.max(0, used.indexOf(set(look, semantic, available))));
    }
    Key key = new Key(look.material, slots, isOneSided);
    ModelMaterial converted = made.get(key);
    if (converted == null) {
      converted = look.material.material(slots, isOpaque, isOneSided);
      made.put(key, converted);
    }
    return converted;
  }
}
