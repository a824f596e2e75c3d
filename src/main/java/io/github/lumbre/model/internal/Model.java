package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.model.ModelFormatException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The content of a model file, in its own world space: right-handed, +Y up, in the file's units.
 * The scene graph is flattened: each part has its own transform. Immutable.
 *
 * @param front what decides which side of a triangle is its front
 * @param parts surfaces to render, in the order of the file; parts that use one mesh share one
 *     {@link ModelGeometry} object
 * @param pointRadius the radius of the spheres that show points, in this space, in (0, 1e150]
 * @param cameras in the order of the file; empty if the file has none
 * @param lights in the order of the file; empty if the file has none
 * @param variants names of material variants that the file offers; empty if it offers none
 * @param animations animations that the file offers; empty if it has none
 * @param warnings problems that do not prevent rendering, each with its place in the file; empty if
 *     there are none
 */
public record Model(
    TriangleMesh.Front front,
    List<ModelPart> parts,
    double pointRadius,
    List<ModelCamera> cameras,
    List<ModelLight> lights,
    List<String> variants,
    List<ModelAnimation> animations,
    List<String> warnings) {
  /** The number of warnings in the error of a model without surfaces. */
  private static final int MAX_REASONS = 3;

  private static final double MAX_RADIUS = 1e150;

  public Model {
    Objects.requireNonNull(front, "front");
    parts = List.copyOf(parts);
    cameras = List.copyOf(cameras);
    lights = List.copyOf(lights);
    variants = List.copyOf(variants);
    animations = List.copyOf(animations);
    warnings = List.copyOf(warnings);
  }

  /** Returns this model with other parts. */
  public Model with(List<ModelPart> newParts) {
    return new Model(front, newParts, pointRadius, cameras, lights, variants, animations, warnings);
  }

  /** Returns this model with more warnings. */
  public Model warning(List<String> more) {
    List<String> all = new ArrayList<>(warnings);
    all.addAll(more);
    return new Model(front, parts, pointRadius, cameras, lights, variants, animations, all);
  }

  /**
   * Returns this model with another radius of points.
   *
   * @param radius more than 0; the nearest possible one is used
   */
  public Model withPointRadius(double radius) {
    double possible = Math.max(Double.MIN_NORMAL, Math.min(radius, MAX_RADIUS));
    return new Model(front, parts, possible, cameras, lights, variants, animations, warnings);
  }

  /**
   * Checks that the model has a surface to show.
   *
   * @throws ModelFormatException if there is no point, and no triangle has an area; it states what
   *     was left out
   */
  public void requireSurface() throws ModelFormatException {
    if (parts.stream().anyMatch(part -> part.geometry().isVisible())) {
      return;
    }
    int shown = Math.min(warnings.size(), MAX_REASONS);
    List<String> reasons = new ArrayList<>(warnings.subList(0, shown));
    if (warnings.size() > shown) {
      reasons.add("and " + (warnings.size() - shown) + " more");
    }
    throw new ModelFormatException(
        ModelFormatException.Kind.MALFORMED,
        "",
        "expected at least one triangle with an area, found none"
            + (reasons.isEmpty() ? "" : " (" + String.join("; ", reasons) + ")"));
  }
}
