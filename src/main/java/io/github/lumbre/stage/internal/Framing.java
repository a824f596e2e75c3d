package io.github.lumbre.stage.internal;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.stage.Stage.View;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/** Where a camera must stand so that all vertices of a model are in the frame. Immutable. */
public final class Framing {
  /** The fraction of the frame that the model may fill. */
  static final double FILL = .92;

  /** The least distance of a vertex from the camera, relative to the diagonal of the box. */
  private static final double NEAR = 1e-3;

  /** How equal margins are, relative to what the model fills. */
  private static final double EVEN = 1e-4;

  /** The least height of a parallel camera's film, relative to the diagonal of the box. */
  private static final double LEAST_FILM = 1e-9;

  /** How far below its middle a film reaches with the pixel filter, relative to its height. */
  private static final double BELOW_FILM = .6;

  /** The largest distance of a parallel camera, relative to what it shows. */
  private static final double FAR = 1e6;

  /** The largest number of passes over the vertices. */
  private static final int MAX_PASSES = 20;

  private final List<Vertices> parts;
  private final Vec3 min;
  private final Vec3 max;

  /** Whether there is no vertex. */
  private final boolean isEmpty;

  /** What is in the frame instead of everything. */
  private final Optional<Framing> fitted;

  private Framing(
      List<Vertices> parts, Vec3 min, Vec3 max, boolean isEmpty, Optional<Framing> fitted) {
    this.parts = parts;
    this.min = min;
    this.max = max;
    this.isEmpty = isEmpty;
    this.fitted = fitted;
  }

  /**
   * The vertices of a part.
   *
   * @param positions of all vertices, in the space of the part
   * @param used the indices of those that belong to a triangle, or are points
   * @param radius of spheres around the points, in world space; 0 if they belong to triangles
   */
  private record Vertices(Transform toWorld, double[] positions, BitSet used, double radius) {
    static Vertices of(ModelPart part, double pointRadius) {
      BitSet used = new BitSet(part.geometry().positions().length / 3);
      for (int vertex : part.geometry().indices()) {
        used.set(vertex);
      }
      boolean isPoints = part.geometry().isPoints();
      if (isPoints) {
        used.set(0, part.geometry().vertexCount());
      }
      Transform toWorld = ModelScene.TO_LEFT_HANDED.times(part.toWorld());
      double[] positions = part.geometry().positions();
      return new Vertices(toWorld, positions, used, isPoints ? pointRadius : 0);
    }

    /** Returns whether the vertices are those of another part, perhaps at another place. */
    boolean isMoved(Vertices other) {
      return radius == other.radius
          && used.equals(other.used)
          && Arrays.equals(positions, other.positions);
    }

    /** Returns these vertices at the place of others. */
    Vertices at(Vertices other) {
      return new Vertices(other.toWorld, positions, used, radius);
    }

    /** Calls the visitor with each vertex in world space. */
    void forEach(Visitor visitor) {
      for (int v = used.nextSetBit(0); v >= 0; v = used.nextSetBit(v + 1)) {
        Vec3 local = new Vec3(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
        visitor.visit(toWorld.point(local), radius);
      }
    }
  }

  /** Visits vertices in world space. */
  private interface Visitor {
    /** Visits the sphere around a vertex; its radius is 0 for a vertex of triangles. */
    void visit(Vec3 vertex, double radius);
  }

  static Framing of(Model model) {
    List<Vertices> parts =
        model.parts().stream().map(part -> Vertices.of(part, model.pointRadius())).toList();
    double infinity = Double.POSITIVE_INFINITY;
    double[] box = {infinity, infinity, infinity, -infinity, -infinity, -infinity};
    forVertices(
        parts,
        (v, radius) -> {
          box[0] = Math.min(box[0], v.x() - radius);
          box[1] = Math.min(box[1], v.y() - radius);
          box[2] = Math.min(box[2], v.z() - radius);
          box[3] = Math.max(box[3], v.x() + radius);
          box[4] = Math.max(box[4], v.y() + radius);
          box[5] = Math.max(box[5], v.z() + radius);
        });
    boolean isEmpty = box[0] > box[3];
    return new Framing(
        parts,
        isEmpty ? Vec3.ZERO : new Vec3(box[0], box[1], box[2]),
        isEmpty ? Vec3.ZERO : new Vec3(box[3], box[4], box[5]),
        isEmpty,
        Optional.empty());
  }

  /** Returns where a camera must stand so that the corners of a box are in the frame. */
  static Framing of(Bounds3 box) {
    return new Framing(List.of(), box.min(), box.max(), false, Optional.empty());
  }

  /**
   * Returns where a camera must stand so that one part of this model is in the frame; all of it if
   * the part is empty.
   */
  Framing fittedTo(Optional<Framing> part) {
    return new Framing(parts, min, max, isEmpty, part);
  }

  /** Returns what is in the frame. */
  private Framing shown() {
    return fitted.filter(part -> !part.isEmpty).orElse(this);
  }

  /**
   * Returns where a camera must stand so that two models are in the frame. If the other one is this
   * one in another pose, they share the vertices of parts that keep their shape. One without
   * vertices does not count.
   */
  public Framing with(Framing other) {
    if (isEmpty || other.isEmpty) {
      return isEmpty ? other : this;
    }
    List<Vertices> all = new ArrayList<>(parts);
    for (int i = 0; i < other.parts.size(); i++) {
      Vertices part = other.parts.get(i);
      boolean isMoved = i < parts.size() && part.isMoved(parts.get(i));
      all.add(isMoved ? parts.get(i).at(part) : part);
    }
    Bounds3 box = new Bounds3(min, max).union(new Bounds3(other.min, other.max));
    Optional<Framing> both =
        fitted.isPresent() && other.fitted.isPresent()
            ? fitted.map(part -> part.with(other.fitted.get()))
            : Optional.empty();
    return new Framing(List.copyOf(all), box.min(), box.max(), false, both);
  }

  /** Visits all vertices, and the corners of the box if it is drawn. */
  private void visit(Visitor visitor, Set<String> labels) {
    forVertices(parts, visitor);
    if (ShownLabels.showBox(labels)) {
      corners().forEach(corner -> visitor.visit(corner, 0));
    }
  }

  private List<Vec3> corners() {
    List<Vec3> corners = new ArrayList<>();
    for (double x : List.of(min.x(), max.x())) {
      for (double y : List.of(min.y(), max.y())) {
        corners.add(new Vec3(x, y, min.z()));
        corners.add(new Vec3(x, y, max.z()));
      }
    }
    return corners;
  }

  private static void forVertices(List<Vertices> parts, Visitor visitor) {
    parts.forEach(part -> part.forEach(visitor));
  }

  /** Returns the box around the vertices; a point at the origin if there are none. */
  Bounds3 box() {
    return new Bounds3(min, max);
  }

  /** Returns the middle of the box around what is in the frame. */
  Vec3 middle() {
    return shown().center();
  }

  private Vec3 center() {
    return min.plus(max).times(.5);
  }

  private double diagonal() {
    return max.minus(min).length();
  }

  /**
   * Returns the nearest point for a pinhole camera that has all vertices in its frame, with equal
   * margins to the left and right, and above and below. A camera of a turntable has the smallest
   * distance and the height that suit every azimuth, and the middle of the model's box is on the
   * vertical line through the middle of its frame.
   *
   * @param fov vertical angle of view in degrees
   * @param aspect width of the frame over its height
   * @param labels on the picture, which need room
   */
  Vec3 eye(View from, double fov, double aspect, Set<String> labels) {
    Framing shown = shown();
    double tan = Elementary.tanDegrees(fov / 2);
    Bounds across = new Bounds(aspect * (ShownLabels.fillAcross(labels, FILL) * tan));
    Bounds upwards = new Bounds(ShownLabels.fillUpwards(labels, FILL) * tan);
    Measure measure = new Measure(from, shown.center(), across, upwards);
    shown.visit(measure, labels);
    double margin = NEAR * shown.diagonal();
    double distance =
        Math.max(measure.nearest + margin, Math.max(across.distance(), upwards.distance()));
    // One axis does not fill its part of the frame; it gets equal margins step by step.
    boolean isEven = distance == 0;
    for (int pass = 0; !isEven && pass < MAX_PASSES; pass++) {
      isEven = across.fitTo(distance) & upwards.fitTo(distance);
      shown.visit(measure, labels);
    }
    return measure.eye(distance > 0 ? distance : 1);
  }

  /**
   * A camera in parallel projection.
   *
   * @param eye the middle of its film, in world space
   * @param height of the film, in world space
   */
  record Parallel(Vec3 eye, double height) {}

  /**
   * Returns a parallel camera outside of the model that has all vertices in its frame, as large as
   * the margins of {@link #eye} allow. From above, its film is above the lowest point of the model,
   * so that a floor is seen. A camera of a turntable has one height and place for all azimuths.
   *
   * @param aspect width of the frame over its height
   * @param zoom factor by which everything is larger
   * @param labels on the picture, which need room
   */
  Parallel parallel(View from, double aspect, double zoom, Set<String> labels) {
    Framing shown = shown();
    Bounds across = new Bounds(0);
    Bounds upwards = new Bounds(0);
    Measure measure = new Measure(from, shown.center(), across, upwards);
    shown.visit(measure, labels);
    double height = height(across.extent(), upwards.extent(), aspect, labels) / zoom;
    double around = (.5 + NEAR) * diagonal() + center().minus(shown.center()).length();
    double above = Double.NEGATIVE_INFINITY;
    if (from.elevation() > 0) {
      double lowest = measure.eye(0).y() - BELOW_FILM * height * measure.cosE;
      above = Math.min((min.y() - lowest) / measure.sinE, FAR * Math.max(around, height));
    }
    double distance = Math.max(around, above);
    return new Parallel(measure.eye(distance > 0 ? distance : 1), height);
  }

  /**
   * Returns the height of the film of a parallel camera at an eye that has the box in its frame,
   * whose middle need not be that of the frame.
   *
   * @param axes of the camera
   */
  double heightAround(Vec3 eye, Frame axes, double aspect, Set<String> labels) {
    double[] half = {0, 0};
    for (Vec3 corner : shown().corners()) {
      Vec3 local = axes.toLocal(corner.minus(eye));
      half[0] = Math.max(half[0], Math.abs(local.x()));
      half[1] = Math.max(half[1], Math.abs(local.y()));
    }
    return height(2 * half[0], 2 * half[1], aspect, labels);
  }

  /** Returns the height of a film on which an extent has its place. */
  private double height(double across, double upwards, double aspect, Set<String> labels) {
    double height =
        Math.max(
            across / (aspect * ShownLabels.fillAcross(labels, FILL)),
            upwards / ShownLabels.fillUpwards(labels, FILL));
    double least = LEAST_FILM * diagonal();
    return Math.max(height, least > 0 ? least : 1);
  }

  /**
   * Returns the tangent of half the vertical angle of view of a camera at an eye that has the box
   * in its frame; empty if a corner is not in front of it.
   *
   * @param axes of the camera
   */
  OptionalDouble tanAround(Vec3 eye, Frame axes, double aspect, Set<String> labels) {
    double tan = 0;
    for (Vec3 corner : shown().corners()) {
      Vec3 local = axes.toLocal(corner.minus(eye));
      if (!(local.z() > 0)) {
        return OptionalDouble.empty();
      }
      double across = Math.abs(local.x()) / (aspect * ShownLabels.fillAcross(labels, FILL));
      double upwards = Math.abs(local.y()) / ShownLabels.fillUpwards(labels, FILL);
      tan = Math.max(tan, Math.max(across, upwards) / local.z());
    }
    return tan > 0 ? OptionalDouble.of(tan) : OptionalDouble.empty();
  }

  /** Measures vertices along the axes of a view. */
  private static final class Measure implements Visitor {
    private final View from;
    private final Vec3 center;
    private final double sinE;
    private final double cosE;
    private final Vec3 back;
    private final Vec3 right;
    private final Vec3 up;
    private final Bounds across;
    private final Bounds upwards;
    private double nearest;

    Measure(View from, Vec3 center, Bounds across, Bounds upwards) {
      double sinA = Elementary.sinDegrees(from.azimuth());
      double cosA = Elementary.cosDegrees(from.azimuth());
      sinE = Elementary.sinDegrees(from.elevation());
      cosE = Elementary.cosDegrees(from.elevation());
      back = new Vec3(sinA * cosE, sinE, -cosA * cosE);
      right = new Vec3(cosA, 0, sinA);
      up = new Vec3(-sinA * sinE, cosE, cosA * sinE);
      this.from = from;
      this.center = center;
      this.across = across;
      this.upwards = upwards;
    }

    @Override
    public void visit(Vec3 vertex, double size) {
      Vec3 v = vertex.minus(center);
      if (from.isTurntable()) {
        double radius = Math.sqrt(v.x() * v.x() + v.z() * v.z());
        across.addCircle(0, v.y() * sinE, radius, cosE, size);
        upwards.addCircle(v.y() * cosE, v.y() * sinE, radius, sinE, cosE, size);
        nearest = Math.max(nearest, v.y() * sinE + radius * cosE + size);
      } else {
        double depth = v.dot(back);
        across.add(v.dot(right), depth, size);
        upwards.add(v.dot(up), depth, size);
        nearest = Math.max(nearest, depth + size);
      }
    }

    /** Returns the point at a distance whose frame has equal margins. */
    Vec3 eye(double distance) {
      return center
          .plus(distance, back)
          .plus(across.middle(), right)
          .plus(upwards.middle(), up);
    }
  }

  /**
   * The bounds of points along one axis of the frame. A point at {@code x} and {@code depth}
   * towards the camera is in the frame of a camera at {@code e} and {@code distance} if |x − e| ≤
   * tan (distance − depth). A sphere around it of a radius is in the frame if that holds with |x −
   * e| greater by √(1 + tan²) times the radius.
   */
  private static final class Bounds {
    private double tan;
    private double high = Double.NEGATIVE_INFINITY;
    private double low = Double.POSITIVE_INFINITY;

    Bounds(double tan) {
      this.tan = tan;
    }

    /** Adds a sphere; a point if its radius is 0. */
    void add(double x, double depth, double radius) {
      double reach = radius == 0 ? 0 : radius * Math.sqrt(1 + tan * tan);
      high = Math.max(high, x + tan * depth + reach);
      low = Math.min(low, x - tan * depth - reach);
    }

    /** Adds the spheres around (x + r sin φ, depth + r cos φ cosE) for all φ. */
    void addCircle(double x, double depth, double r, double cosE, double radius) {
      double reach = r * Math.sqrt(1 + tan * tan * cosE * cosE) + radius * Math.sqrt(1 + tan * tan);
      high = Math.max(high, x + tan * depth + reach);
      low = Math.min(low, x - tan * depth - reach);
    }

    /** Adds the spheres around (x − r cos φ sinE, depth + r cos φ cosE) for all φ. */
    void addCircle(double x, double depth, double r, double sinE, double cosE, double radius) {
      double reach = radius * Math.sqrt(1 + tan * tan);
      high = Math.max(high, x + tan * depth + r * Math.abs(tan * cosE - sinE) + reach);
      low = Math.min(low, x - tan * depth - r * Math.abs(tan * cosE + sinE) - reach);
    }

    /**
     * Begins anew with the part of the frame that the points fill at a distance, by the former
     * bounds. Returns whether it is nearly the former part.
     */
    boolean fitTo(double distance) {
      double filled = high > low ? (high - low) / (2 * distance) : tan;
      boolean isSame = Math.abs(filled - tan) <= EVEN * tan;
      tan = filled;
      high = Double.NEGATIVE_INFINITY;
      low = Double.POSITIVE_INFINITY;
      return isSame;
    }

    /** Returns the extent of the points; 0 if there are none. */
    double extent() {
      return high > low ? high - low : 0;
    }

    /** Returns the smallest distance of a camera that has all points in its frame. */
    double distance() {
      return high > low ? (high - low) / (2 * tan) : 0;
    }

    /**
     * Returns the position along the axis where a camera at {@link #distance} has equal margins.
     */
    double middle() {
      return high > low ? (high + low) / 2 : 0;
    }
  }
}
