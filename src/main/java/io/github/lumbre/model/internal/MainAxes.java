package io.github.lumbre.model.internal;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Finds three perpendicular directions in which most flat faces of a model look, where these are
 * not the axes of its file: a tilted assembly. Confined to one thread.
 */
final class MainAxes {
  /** How many directions per unit are told apart. */
  private static final double GRID = 200;

  /** The directions of the largest area that are tried as axes. */
  private static final int TRIED = 24;

  /** The least cosine of faces that look along an axis. */
  private static final double ALONG = .9998;

  /** The largest cosine of perpendicular directions. */
  private static final double PERPENDICULAR = .01;

  /** The least part of the area that looks along other axes than those of the file. */
  private static final double LEAST = .15;

  /** By how much more area must look along other axes. */
  private static final double CLEARLY = 3;

  private final Map<List<Long>, Faces> faces = new LinkedHashMap<>();

  /** Faces that look in one direction, or against it. */
  private static final class Faces {
    private final Vec3 normal;
    private double area;

    Faces(Vec3 normal) {
      this.normal = normal;
    }
  }

  private MainAxes() {}

  /** Returns the axes of a model, in the order of those of the file; empty if they are the same. */
  static Optional<Frame> of(List<ModelPart> parts) {
    MainAxes axes = new MainAxes();
    parts.stream().filter(part -> !part.geometry().isPoints()).forEach(axes::add);
    double known = axes.area(Frame.WORLD);
    double all = axes.faces.values().stream().mapToDouble(f -> f.area).sum();
    List<Faces> largest =
        axes.faces.values().stream()
            .sorted(Comparator.comparingDouble(f -> -f.area))
            .limit(TRIED)
            .toList();
    return axes.frames(largest).stream()
        .max(Comparator.comparingDouble(axes::area))
        .filter(frame -> axes.area(frame) > Math.max(LEAST * all, CLEARLY * known))
        .map(MainAxes::inOrder);
  }

  private void add(ModelPart part) {
    int[] corners = part.geometry().indices();
    for (int i = 0; i < corners.length; i += 3) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      Vec3 from = part.position(corners[i]);
      Vec3 side = part.position(corners[i + 1]).minus(from);
      Vec3 cross = side.cross(part.position(corners[i + 2]).minus(from));
      double area = cross.length();
      if (area > 0 && area < Double.POSITIVE_INFINITY) {
        Vec3 normal = upwards(cross.times(1 / area));
        faces.computeIfAbsent(cell(normal), key -> new Faces(normal)).area += area;
      }
    }
  }

  /** Returns a direction or its opposite: the one that looks up. */
  private static Vec3 upwards(Vec3 v) {
    double level = Math.abs(v.x()) > .5 / GRID ? v.x() : v.z();
    double first = Math.abs(v.y()) > .5 / GRID ? v.y() : level;
    return first < 0 ? v.negated() : v;
  }

  private static List<Long> cell(Vec3 v) {
    return List.of(Math.round(GRID * v.x()), Math.round(GRID * v.y()), Math.round(GRID * v.z()));
  }

  private List<Frame> frames(List<Faces> largest) {
    List<Frame> frames = new ArrayList<>();
    for (Faces one : largest) {
      largest.stream()
          .filter(other -> Math.abs(one.normal.dot(other.normal)) < PERPENDICULAR)
          .findFirst()
          .ifPresent(
              other -> {
                Vec3 third = one.normal.cross(other.normal).normalized();
                frames.add(new Frame(one.normal, third.cross(one.normal), third));
              });
    }
    return frames;
  }

  /** Returns the area of the faces that look along an axis. */
  private double area(Frame frame) {
    return faces.values().stream()
        .filter(f -> frame.toLocal(f.normal).maxAbs() > ALONG)
        .mapToDouble(f -> f.area)
        .sum();
  }

  /** Returns the same axes, each as near as possible to that of the file: upwards first. */
  private static Frame inOrder(Frame frame) {
    List<Vec3> left = new ArrayList<>(List.of(frame.tangent(), frame.bitangent(), frame.normal()));
    Vec3 up = taken(left, Vec3.Y);
    Vec3 right = taken(left, Vec3.X);
    return new Frame(right, up, taken(left, Vec3.Z));
  }

  private static Vec3 taken(List<Vec3> left, Vec3 axis) {
    Vec3 nearest =
        left.stream().max(Comparator.comparingDouble(v -> Math.abs(v.dot(axis)))).orElseThrow();
    left.remove(nearest);
    return nearest.dot(axis) < 0 ? nearest.negated() : nearest;
  }
}
