package io.github.lumbre.model.format.dae;

import io.github.lumbre.math.Transform;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The meshes of controllers, in the pose in which skins were bound to their bones; morphs have the
 * shape of their base mesh.
 */
final class DaeSkins {
  /** The most controllers between an instance and its geometry. */
  private static final int MAX_LEVELS = 10;

  /** The most nodes that are searched for bones, for all skins. */
  private static final int MAX_SEARCHED = 10_000_000;

  private static final Pattern SPACE = Pattern.compile("\\s+");

  private final DaeDocument document;
  private final Map<DaeElement, Transform> places;

  /** The nodes of the scene by their names for joints. */
  private final Map<String, DaeElement> joints = new HashMap<>();

  private int searched;

  /**
   * @param places of all nodes of the scene, in its space, in the order of the file
   */
  DaeSkins(DaeDocument document, Map<DaeElement, Transform> places) {
    this.document = document;
    this.places = places;
    places.keySet().forEach(node -> joints.putIfAbsent(node.attribute("sid"), node));
  }

  /**
   * A mesh of a controller.
   *
   * @param inScene its place in the space of the scene; empty if it is that of the node
   */
  record Bound(DaeElement geometry, Optional<Transform> inScene) {}

  /** Returns the mesh of an instance of a controller; empty, with a warning, if it is missing. */
  Optional<Bound> bound(DaeElement instance) {
    Optional<Transform> inScene = Optional.empty();
    String reference = instance.attribute("url");
    for (int level = 0; level < MAX_LEVELS; level++) {
      Optional<DaeElement> controller = document.withId("controller", id(reference));
      if (controller.isEmpty()) {
        Optional<Transform> place = inScene;
        return document
            .find(level == 0 ? "controller" : "geometry", reference, instance.location())
            .map(geometry -> new Bound(geometry, place));
      }
      Optional<DaeElement> skin = controller.get().find("skin");
      Optional<DaeElement> source = skin.or(() -> controller.get().find("morph"));
      if (source.isEmpty()) {
        break;
      }
      if (skin.isPresent()) {
        inScene = Optional.of(place(skin.get(), instance));
      } else {
        document
            .file()
            .warnings()
            .once(" morphs", source.get().location(), "other shapes of morphs are left out");
      }
      reference = source.get().attribute("source");
    }
    document
        .file()
        .warnings()
        .add(instance.location(), "left out a controller without a skin or a morph");
    return Optional.empty();
  }

  private static String id(String reference) {
    String stated = reference.strip();
    return stated.startsWith("#") ? stated.substring(1) : stated;
  }

  /** Returns the place of a skin: where its first bone is now, as it was when it was bound. */
  private Transform place(DaeElement skin, DaeElement instance) {
    Transform shape =
        skin.find("bind_shape_matrix")
            .flatMap(e -> document.numbers(e, 16))
            .map(m -> DaeTransforms.matrix(m, 0))
            .orElse(Transform.IDENTITY);
    Optional<Transform> bone = bone(skin, instance);
    Optional<Transform> toBone = toBone(skin);
    return bone.isPresent() && toBone.isPresent()
        ? bone.get().times(toBone.get()).times(shape)
        : shape;
  }

  /** Returns the place of the first bone in the scene. */
  private Optional<Transform> bone(DaeElement skin, DaeElement instance) {
    Optional<DaeElement> names =
        source(skin, "JOINT")
            .flatMap(s -> s.find("Name_array").or(() -> s.find("IDREF_array")));
    String first = names.map(e -> SPACE.split(e.text(), 2)[0]).orElse("");
    if (first.isEmpty()) {
      return Optional.empty();
    }
    List<DaeElement> skeletons =
        instance.children("skeleton").stream()
            .flatMap(s -> document.withId("node", id(s.text())).stream())
            .toList();
    Optional<DaeElement> joint =
        skeletons.stream().flatMap(root -> joint(root, first).stream()).findFirst();
    return joint
        .or(() -> document.withId("node", first))
        .or(() -> Optional.ofNullable(joints.get(first)))
        .flatMap(node -> Optional.ofNullable(places.get(node)));
  }

  private Optional<DaeElement> joint(DaeElement node, String name) {
    if (node.attribute("sid").equals(name) || node.attribute("id").equals(name)) {
      return Optional.of(node);
    }
    searched++;
    for (DaeElement child : node.children()) {
      Optional<DaeElement> found =
          child.is("node") && searched < MAX_SEARCHED ? joint(child, name) : Optional.empty();
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  /** Returns the inverse of the place of the first bone when the skin was bound. */
  private Optional<Transform> toBone(DaeElement skin) {
    return source(skin, "INV_BIND_MATRIX")
        .flatMap(s -> s.find("float_array"))
        .map(DaeElement::numbers)
        .filter(numbers -> numbers.length >= 16)
        .map(numbers -> DaeTransforms.matrix(numbers, 0))
        .filter(Transform::isInvertible);
  }

  private Optional<DaeElement> source(DaeElement skin, String semantic) {
    return skin.find("joints").stream()
        .flatMap(joints -> joints.children("input").stream())
        .filter(input -> input.attribute("semantic").equals(semantic))
        .findFirst()
        .flatMap(
            i -> document.within(skin).find("source", i.attribute("source"), i.location()));
  }
}
