package io.github.lumbre.model.threemf;

import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelPart;
import java.util.List;

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
   * @param otherwise the name of objects that have none
   */
  void addTo(List<ModelPart> all, Transform toWorld, String otherwise) {
    String shown = name.isEmpty() ? otherwise : name;
    for (Surface surface : surfaces) {
      all.add(new ModelPart(shown, location, surface.geometry, surface.material, toWorld));
    }
    for (Component component : components) {
      if (component.object.parts > 0) {
        component.object.addTo(all, toWorld.times(component.toParent), shown);
      }
    }
  }
}
