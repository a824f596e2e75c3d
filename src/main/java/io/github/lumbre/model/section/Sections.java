package io.github.lumbre.model.section;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelMaterial;
import io.github.lumbre.model.internal.ModelNode;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Warnings;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Cuts a model by planes: what is in front of all of them is removed, so that two planes remove a
 * quarter. Closed parts get a hatched surface where they are cut. The planes of a model in motion
 * stand still. Confined to one thread.
 */
public final class Sections {
  /** The parts of the diagonal of the model's box that are the distance of hatch lines. */
  private static final double LINES = 40;

  /** The parts of a cut surface that are the distance of its lines at most. */
  private static final double FEWEST_LINES = 6;

  /** Memory to find the shells of a mesh, per vertex and triangle. */
  private static final long BYTES_PER_ITEM = 200;

  private final List<CutPlane> planes;
  private final ModelOptions options;
  private final double distance;
  private final Warnings warnings;
  private final Map<ModelGeometry, Bounds3> boxes = new IdentityHashMap<>();

  /** What is left of each part of the model; nothing for a part that is removed. */
  private final Map<ModelPart, ModelPart> left = new IdentityHashMap<>();

  private final List<ModelPart> caps = new ArrayList<>();
  private int hatches;

  private Sections(List<CutPlane> planes, ModelOptions options, double distance) {
    this.planes = planes;
    this.options = options;
    this.distance = distance;
    warnings = new Warnings();
  }

  /** Creates the sections of another pose of the model. */
  private Sections(Sections other) {
    planes = other.planes;
    options = other.options;
    distance = other.distance;
    warnings = other.warnings;
  }

  /**
   * Returns a model without what its options cut off.
   *
   * @throws ModelFormatException if nothing is left
   */
  public static Model cut(Model model, ModelOptions options) throws ModelFormatException {
    return cut(model, options, false);
  }

  /**
   * Returns a model without what its options cut off.
   *
   * @param mayBeEmpty whether nothing needs to be left
   */
  public static Model cut(Model model, ModelOptions options, boolean mayBeEmpty)
      throws ModelFormatException {
    Bounds3 bounds = bounds(model);
    List<String> texts = options.get(ModelOption.SECTION);
    if (texts.isEmpty() || bounds.isEmpty()) {
      return model;
    }
    Bounds3 inFile = Bounds3.EMPTY;
    for (int corner = 0; corner < 8; corner++) {
      inFile = inFile.union(model.fromFile().inversePoint(bounds.corner(corner)));
    }
    List<CutPlane> planes = new ArrayList<>();
    for (String text : texts) {
      planes.add(Section.of(text).in(inFile, model.fromFile()));
    }
    Sections sections = new Sections(planes, options, 2 * bounds.radius() / LINES);
    Model result = sections.inMotion(model);
    String size = " the model, which is " + text(inFile) + " in the unit of the file";
    if (result.parts().isEmpty() && !mayBeEmpty) {
      String expected = "expected a plane that leaves something of" + size;
      throw Kind.MALFORMED.at("section", expected + ", found " + String.join(" ", texts));
    }
    boolean isWhole = result.parts().equals(model.parts());
    return isWhole
        ? model.warning(
            List.of("section " + String.join(" ", texts) + " cuts nothing of" + size))
        : result.warning(sections.warnings.all());
  }

  private static String text(Bounds3 box) {
    return "from x=%s to %s, y=%s to %s, z=%s to %s"
        .formatted(
            number(box.min().x()),
            number(box.max().x()),
            number(box.min().y()),
            number(box.max().y()),
            number(box.min().z()),
            number(box.max().z()));
  }

  private static String number(double value) {
    return new BigDecimal(value).round(new MathContext(4)).stripTrailingZeros().toPlainString();
  }

  /** Returns the box around all triangles and points, in the model's world space. */
  public static Bounds3 bounds(Model model) {
    double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (ModelPart part : model.parts()) {
      ModelGeometry geometry = part.geometry();
      double radius = geometry.isPoints() ? model.pointRadius() : 0;
      BitSet used = geometry.used();
      for (int v = used.nextSetBit(0); v >= 0; v = used.nextSetBit(v + 1)) {
        Vec3 p = part.position(v);
        for (int axis = 0; axis < 3; axis++) {
          low[axis] = Math.min(low[axis], p.get(axis) - radius);
          high[axis] = Math.max(high[axis], p.get(axis) + radius);
        }
      }
    }
    return new Bounds3(new Vec3(low[0], low[1], low[2]), new Vec3(high[0], high[1], high[2]));
  }

  private Model inMotion(Model model) throws ModelFormatException {
    List<Model> poses = new ArrayList<>();
    for (Model pose : model.poses()) {
      poses.add(new Sections(this).of(pose));
    }
    return poses.isEmpty() ? of(model) : Model.inMotion(poses);
  }

  private Model of(Model model) throws ModelFormatException {
    Map<ModelNode, List<ModelPart>> bodies =
        model.parts().stream()
            .collect(
                Collectors.groupingBy(
                    part -> part.node().whole(), LinkedHashMap::new, Collectors.toList()));
    for (List<ModelPart> body : bodies.values()) {
      body.stream().filter(part -> part.geometry().isPoints()).forEach(this::addPoints);
      addMeshes(body.stream().filter(part -> !part.geometry().isPoints()).toList());
    }
    List<ModelPart> parts =
        model.parts().stream()
            .filter(left::containsKey)
            .map(left::get)
            .collect(Collectors.toList());
    parts.addAll(caps);
    return model.with(parts);
  }

  /** Keeps the points whose centers are not in front of all planes. */
  private void addPoints(ModelPart part) {
    ModelGeometry points =
        part.geometry()
            .points(v -> planes.stream().anyMatch(plane -> plane.side(part.position(v)) < 0));
    put(part, points.vertexCount() == part.geometry().vertexCount() ? part.geometry() : points);
  }

  private void put(ModelPart part, ModelGeometry kept) {
    if (kept == part.geometry()) {
      left.put(part, part);
    } else if (kept.isVisible()) {
      left.put(part, part.with(part.node(), kept, part.material().fromBothSides()));
    }
  }

  private void addMeshes(List<ModelPart> body) throws ModelFormatException {
    Optional<BodyCut> cut = Optional.empty();
    if (body.stream().anyMatch(part -> !isBehind(part) && !isInFront(part))) {
      long items =
          body.stream().mapToLong(p -> p.geometry().vertexCount() + p.geometry().itemCount()).sum();
      ModelLimits.requireMemory(body.get(0).location(), BYTES_PER_ITEM * items, options.limits());
      cut = BodyCut.of(body, planes);
    }
    for (int i = 0; i < body.size(); i++) {
      ModelPart part = body.get(i);
      if (cut.isPresent()) {
        put(part, cut.get().kept(i));
      } else if (!isInFront(part)) {
        left.put(part, part);
      }
    }
    if (cut.isPresent()) {
      addCaps(body.get(0), cut.get());
    }
  }

  private void addCaps(ModelPart first, BodyCut cut) {
    Map<Integer, Integer> numbers = new HashMap<>();
    for (int plane = 0; plane < planes.size(); plane++) {
      for (BodyCut.Surface surface : cut.surfaces(plane)) {
        int number = numbers.computeIfAbsent(surface.number(), n -> hatches++);
        caps.add(cap(surface.part(), surface.shape(), number));
      }
    }
    String name = first.node().label().isEmpty() ? first.location() : first.node().label();
    if (cut.isOpen()) {
      warnings.add(
          "parts are open",
          name,
          "the part is not closed, or its triangles face different sides; its cut has no surface");
    }
    if (cut.isTangled()) {
      warnings.add(
          "outlines of parts cross",
          name,
          "the part crosses itself too often; its cut has no surface");
    }
    if (cut.isGuess()) {
      warnings.add(
          "shells contradict each other",
          name,
          "the part is inside out, but not all of it; shells in others are taken as cavities");
    }
  }

  private ModelPart cap(ModelPart part, ModelGeometry surface, int number) {
    Rgb color = part.material().input(MaterialParameter.BASE_COLOR).factor();
    double lines = Math.min(distance, extent(surface) / FEWEST_LINES);
    ModelMaterial material =
        PlainModel.matte("section", "").hatch(Hatch.of(number, color, lines)).build();
    return new ModelPart(part.node(), part.location(), surface, material, Transform.IDENTITY);
  }

  /** Returns the larger side of the box around texture coordinates. */
  private static double extent(ModelGeometry surface) {
    double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
    for (int i = 0; i < surface.uv0().length; i++) {
      low[i % 2] = Math.min(low[i % 2], surface.uv0()[i]);
      high[i % 2] = Math.max(high[i % 2], surface.uv0()[i]);
    }
    return Math.max(high[0] - low[0], high[1] - low[1]);
  }

  private boolean isBehind(ModelPart part) {
    return planes.stream().anyMatch(plane -> corners(part).allMatch(p -> plane.side(p) < 0));
  }

  private boolean isInFront(ModelPart part) {
    return planes.stream().allMatch(plane -> corners(part).allMatch(p -> plane.side(p) >= 0));
  }

  /** Returns the corners of a part's box in world space. */
  private Stream<Vec3> corners(ModelPart part) {
    Bounds3 box = boxes.computeIfAbsent(part.geometry(), ModelGeometry::bounds);
    return IntStream.range(0, 8).mapToObj(i -> part.toWorld().point(box.corner(i)));
  }
}
