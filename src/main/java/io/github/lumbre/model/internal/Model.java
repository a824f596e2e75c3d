package io.github.lumbre.model.internal;

import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.math.Transform;
import io.github.lumbre.model.ModelFormatException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * The content of a model file, in its own world space: right-handed, +Y up, in the file's units.
 * The scene graph is flattened: each part has its own transform. Immutable.
 *
 * @param fromFile from the axes and the unit of the file to this space
 * @param unit of the file, such as {@code millimeter}, from which {@code fromFile} leads to meters;
 *     empty if the file states none
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
 * @param poses the model in each part of the time during which it moves for one picture; empty if
 *     it stands still. Parts that do not move are the same objects in all poses
 */
public record Model(
    Transform fromFile,
    String unit,
    TriangleMesh.Front front,
    List<ModelPart> parts,
    double pointRadius,
    List<ModelCamera> cameras,
    List<ModelLight> lights,
    List<String> variants,
    List<ModelAnimation> animations,
    List<String> warnings,
    List<Model> poses) {
  /** The number of warnings in the error of a model without surfaces. */
  private static final int MAX_REASONS = 3;

  private static final double MAX_RADIUS = 1e150;

  public Model {
    Objects.requireNonNull(fromFile, "fromFile");
    Objects.requireNonNull(front, "front");
    Objects.requireNonNull(unit, "unit");
    parts = List.copyOf(parts);
    cameras = List.copyOf(cameras);
    lights = List.copyOf(lights);
    variants = List.copyOf(variants);
    animations = List.copyOf(animations);
    warnings = List.copyOf(warnings);
    poses = List.copyOf(poses);
  }

  /**
   * Returns a model in motion: the middle one of some poses, with them all. Its parts and meshes
   * are shared by poses in which they are the same.
   *
   * @param poses in the order of time, at least one; a single one stands still
   */
  public static Model inMotion(List<Model> poses) {
    if (poses.size() == 1) {
      return poses.get(0);
    }
    SharedParts shared = new SharedParts();
    List<Model> all = poses.stream().map(pose -> pose.with(shared.of(pose.parts()))).toList();
    return all.get(all.size() / 2).moving(all);
  }

  private Model moving(List<Model> newPoses) {
    return with(fromFile, unit, parts, lights, pointRadius, warnings, newPoses);
  }

  private Model with(
      Transform file,
      String unitOfFile,
      List<ModelPart> newParts,
      List<ModelLight> newLights,
      double radius,
      List<String> newWarnings,
      List<Model> newPoses) {
    return new Model(
        file,
        unitOfFile,
        front,
        newParts,
        radius,
        cameras,
        newLights,
        variants,
        animations,
        newWarnings,
        newPoses);
  }

  /** Returns this model, standing still, with another {@link #fromFile} and {@link #unit}. */
  public Model from(Transform file, String unitOfFile) {
    return with(file, unitOfFile, parts, lights, pointRadius, warnings, List.of());
  }

  /** Returns this model, standing still, with other parts and without lights. */
  public Model unlit(List<ModelPart> newParts) {
    return with(fromFile, unit, newParts, List.of(), pointRadius, warnings, List.of());
  }

  /** Returns this model, standing still, with other parts. */
  public Model with(List<ModelPart> newParts) {
    return with(fromFile, unit, newParts, lights, pointRadius, warnings, List.of());
  }

  /** Returns this model, standing still, with other parts, cameras and lights. */
  Model with(List<ModelPart> newParts, List<ModelCamera> newCameras, List<ModelLight> newLights) {
    return new Model(
        fromFile,
        unit,
        front,
        newParts,
        pointRadius,
        newCameras,
        newLights,
        variants,
        animations,
        warnings,
        List.of());
  }

  public Model warning(List<String> more) {
    List<String> all = new ArrayList<>(warnings);
    all.addAll(more);
    return with(fromFile, unit, parts, lights, pointRadius, all, poses);
  }

  /**
   * Returns this model, standing still, with another radius of points.
   *
   * @param radius more than 0; the nearest possible one is used
   */
  public Model withPointRadius(double radius) {
    double possible = Math.max(Double.MIN_NORMAL, Math.min(radius, MAX_RADIUS));
    return with(fromFile, unit, parts, lights, possible, warnings, List.of());
  }

  /**
   * Returns whether the model has a surface to show, in motion in any pose: a point, or a triangle
   * with an area.
   */
  public boolean hasSurface() {
    return parts.stream().anyMatch(part -> part.geometry().isVisible())
        || poses.stream().anyMatch(Model::hasSurface);
  }

  /**
   * Checks that the model {@linkplain #hasSurface has a surface to show}.
   *
   * @throws ModelFormatException if it has none; it states what was left out
   */
  public void requireSurface() throws ModelFormatException {
    if (hasSurface()) {
      return;
    }
    int shown = Math.min(warnings.size(), MAX_REASONS);
    List<String> reasons = new ArrayList<>(warnings.subList(0, shown));
    if (warnings.size() > shown) {
      reasons.add("and " + (warnings.size() - shown) + " more");
    }
    throw ModelFormatException.Kind.MALFORMED.at(
        "",
        "expected at least one triangle with an area, found none"
            + (reasons.isEmpty() ? "" : " (" + String.join("; ", reasons) + ")"));
  }
}
