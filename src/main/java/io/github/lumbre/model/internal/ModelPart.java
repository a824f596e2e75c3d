package io.github.lumbre.model.internal;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import java.util.Objects;

/**
 * A triangle mesh, or points, with one material, placed in the model's world space.
 *
 * @param node the part of the file that the surface belongs to
 * @param location of the part in the file, such as {@code nodes[3].mesh.primitives[0]}
 * @param geometry in local space; instances share one object
 * @param toWorld from local space to the model's world space, invertible
 */
public record ModelPart(
    ModelNode node,
    String location,
    ModelGeometry geometry,
    ModelMaterial material,
    Transform toWorld) {
  public ModelPart {
    Objects.requireNonNull(node, "node");
    Objects.requireNonNull(location, "location");
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(material, "material");
    Objects.requireNonNull(toWorld, "toWorld");
  }

  /** Returns a vertex in the model's world space. */
  public Vec3 position(int vertex) {
    double[] p = geometry.positions();
    return toWorld.point(new Vec3(p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]));
  }

  /** Returns the name of the node or object in the file; empty if it has none. */
  public String name() {
    return node.name();
  }

  /** Returns whether the surface emits light. */
  public boolean isLight() {
    return material.unlit() || !material.emission().factor().isBlack();
  }

  /** Returns whether the surface is not divided into connected pieces: points, and lights. */
  public boolean isOnePiece() {
    return geometry.isPoints() || !material.emission().factor().isBlack();
  }

  /** Returns this surface as another part of the file, or in another shape or material. */
  public ModelPart with(ModelNode newNode, ModelGeometry newGeometry, ModelMaterial newMaterial) {
    return new ModelPart(newNode, location, newGeometry, newMaterial, toWorld);
  }
}
