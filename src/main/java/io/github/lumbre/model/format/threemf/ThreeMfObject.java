package io.github.lumbre.model.format.threemf;

import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import java.util.List;
import java.util.Optional;

/**
 * An object of a model: surfaces of its own, or other objects as components. Components are defined
 * before the object, so that there are no cycles.
 *
 * @param name empty if it has none
 * @param type as in the file, such as {@code model} or {@code support}
 * @param parts the number of surfaces in it and in its components, each as often as it is shown
 * @param depth the number of levels of components
 */
record ThreeMfObject(
    String name,
    String type,
    String location,
    List<Surface> surfaces,
    List<Component> components,
    long parts,
    int depth) {
  /** The most levels of components. */
  static final int MAX_DEPTH = 100;

  /** The triangles of one material. */
  record Surface(ModelGeometry geometry, ModelMaterial material) {}

  /**
   * An object within another one, or in the world.
   *
   * @param toParent invertible
   */
  record Component(ThreeMfObject object, Transform toParent) {}

  /**
   * Returns an object.
   *
   * @throws ModelFormatException if it has too many parts or levels
   */
  static ThreeMfObject of(
      String name, String type, String location, List<Surface> surfaces, List<Component> components)
      throws ModelFormatException {
    long parts = surfaces.size();
    int depth = 0;
    for (Component component : components) {
      parts += component.object.parts;
      depth = Math.max(depth, component.object.depth + 1);
      ModelLimits.require(location, "parts", ModelLimits.MAX_PARTS, parts);
    }
    ModelLimits.require(location, "levels of components", MAX_DEPTH, depth);
    return new ThreeMfObject(name, type, location, surfaces, components, parts, depth);
  }

  /**
   * Adds the surfaces in the object.
   *
   * @param parent the object that this one is a component of; an object without a name has its name
   */
  void addTo(List<ModelPart> all, Transform toWorld, Optional<ModelNode> parent) {
    String shown = name.isEmpty() ? parent.map(ModelNode::name).orElse("") : name;
    ModelNode node = ModelNode.of(shown, "object", parent);
    for (Surface surface : surfaces) {
      all.add(new ModelPart(node, location, surface.geometry, surface.material, toWorld));
    }
    for (Component component : components) {
      if (component.object.parts > 0) {
        component.object.addTo(all, toWorld.times(component.toParent), Optional.of(node));
      }
    }
  }
}
