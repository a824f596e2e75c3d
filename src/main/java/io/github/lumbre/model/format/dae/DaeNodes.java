package io.github.lumbre.model.format.dae;

import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelLimits;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Counts what nodes show before it is placed, so that nodes that contain themselves, and instances
 * of instances in any number, are found without walking them. Mutable.
 */
final class DaeNodes {
  /** The most nodes within each other, instances included. */
  private static final int MAX_DEPTH = 1000;

  /** Stands for a node that is being counted. */
  private static final long OPEN = -1;

  private final DaeDocument document;
  private final DaeSources sources;
  private final PolygonDivision division;
  private final Map<DaeElement, List<DaeGeometry.Group>> geometries = new IdentityHashMap<>();
  private final Map<DaeElement, Long> counts = new IdentityHashMap<>();

  /** Instances of nodes that contain them. */
  private final Set<DaeElement> cyclic = Collections.newSetFromMap(new IdentityHashMap<>());

  DaeNodes(DaeDocument document) {
    this.document = document;
    sources = new DaeSources(document);
    division = new PolygonDivision(document.file().tally());
  }

  /** Returns a scene of one node with all geometries of the file. */
  static DaeElement sceneOfGeometries(DaeDocument document) {
    DaeElement scene = new DaeElement("visual_scene", Map.of(), "");
    DaeElement node = new DaeElement("node", Map.of(), "");
    for (DaeElement geometry : document.library("library_geometries", "geometry")) {
      Map<String, String> url = Map.of("url", "#" + geometry.attribute("id"));
      node.add(new DaeElement("instance_geometry", url, geometry.location()));
    }
    scene.add(node);
    return scene;
  }

  /** Returns the places of all nodes of a scene, in their order, without instances of nodes. */
  Map<DaeElement, Transform> places(DaeElement scene, DaeTransforms transforms) {
    // Elements are compared by identity.
    Map<DaeElement, Transform> places = new LinkedHashMap<>();
    scene.children("node").forEach(node -> place(node, Transform.IDENTITY, transforms, places));
    return places;
  }

  private static void place(
      DaeElement node,
      Transform parent,
      DaeTransforms transforms,
      Map<DaeElement, Transform> places) {
    Transform here = parent.times(transforms.of(node));
    places.put(node, here);
    node.children("node").forEach(child -> place(child, here, transforms, places));
  }

  /** Returns the number of surfaces in all nodes of a scene, each as often as it is shown. */
  long surfaces(DaeElement scene) throws ModelFormatException {
    long all = 0;
    for (DaeElement node : scene.children("node")) {
      all = sum(all, count(node, 1));
    }
    return all;
  }

  /** Adds counts that are perhaps too large for a file. */
  private static long sum(long a, long b) {
    return Math.min(a + b, Integer.MAX_VALUE);
  }

  private long count(DaeElement node, int depth) throws ModelFormatException {
    Long known = counts.get(node);
    if (known != null) {
      return Math.max(0, known);
    }
    ModelLimits.require(node.location(), "nodes within each other", MAX_DEPTH, depth);
    counts.put(node, OPEN);
    long all = 0;
    for (DaeElement child : node.children()) {
      switch (child.name()) {
        case "node" -> all = sum(all, count(child, depth + 1));
        case "instance_node" -> {
          Optional<DaeElement> target = found(child);
          if (target.isPresent()) {
            all = sum(all, count(target.get(), depth + 1));
          }
        }
        case "instance_geometry" -> all = sum(all, geometry(child).size());
        // Cameras and skins are counted as one; skins are counted again when they are placed.
        case "instance_controller", "instance_camera" -> all = sum(all, 1);
        default -> {
          // Nothing to show.
        }
      }
    }
    counts.put(node, all);
    return all;
  }

  private Optional<DaeElement> found(DaeElement instance) {
    Optional<DaeElement> target =
        document.find("node", instance.attribute("url"), instance.location());
    if (target.isPresent() && isOpen(target.get())) {
      document
          .file()
          .warnings()
          .add(
              "nodes within themselves",
              instance.location(),
              "expected nodes that do not contain themselves, found one; it is left out there");
      cyclic.add(instance);
      return Optional.empty();
    }
    return target;
  }

  private boolean isOpen(DaeElement node) {
    return counts.containsKey(node) && counts.get(node) == OPEN;
  }

  /** Returns whether a node, which has been counted, shows anything. */
  boolean isShown(DaeElement node) {
    return counts.getOrDefault(node, 0L) > 0;
  }

  /** Returns the node of an instance; empty if it shows nothing, or contains the instance. */
  Optional<DaeElement> target(DaeElement instance) {
    return cyclic.contains(instance)
        ? Optional.empty()
        : document
            .find("node", instance.attribute("url"), instance.location())
            .filter(this::isShown);
  }

  /**
   * Returns the surfaces of a geometry.
   *
   * @param element the geometry, or an instance of it
   */
  List<DaeGeometry.Group> geometry(DaeElement element) throws ModelFormatException {
    List<DaeGeometry.Group> known = geometries.get(element);
    if (known == null) {
      known = read(element);
      geometries.put(element, known);
    }
    return known;
  }

  private List<DaeGeometry.Group> read(DaeElement element) throws ModelFormatException {
    if (element.is("geometry")) {
      return DaeGeometry.of(element, document, sources, division).groups();
    }
    Optional<DaeElement> target =
        document.find("geometry", element.attribute("url"), element.location());
    return target.isPresent() ? geometry(target.get()) : List.of();
  }
}
