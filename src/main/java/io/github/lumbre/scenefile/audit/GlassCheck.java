package io.github.lumbre.scenefile.audit;

import io.github.lumbre.geometry.Bvh;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.Hash;
import io.github.lumbre.math.sampling.internal.Warp;
import io.github.lumbre.scene.Primitive;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Reports glass on surfaces that are not closed, and glass objects that overlap. */
final class GlassCheck implements Check {
  private static final String LAW = "glass";

  private static final TexturePoint ORIGIN = new TexturePoint(0, 0);

  /** The largest number of pairs of glass objects to compare; it limits the time. */
  private static final int MOST_PAIRS = 500;

  private static final int POINTS = 200;

  /** The largest number of surfaces to count along one ray. */
  private static final int MOST_CROSSINGS = 1000;

  /** A glass object with a closed surface, and a hierarchy over this object only. */
  private record Pane(int primitive, Shape shape, Bvh alone) {}

  @Override
  public List<Finding> of(ParsedScene file, Pilot pilot) {
    // Copies of a part have one place in the file.
    Set<Finding> findings = new LinkedHashSet<>();
    List<Pane> closed = new ArrayList<>();
    for (int i = 0; i < file.scene().primitives().size(); i++) {
      Primitive primitive = file.scene().primitives().get(i);
      if (!refracts(primitive.material())) {
        continue;
      }
      if (primitive.shape().isClosed()) {
        closed.add(new Pane(i, primitive.shape(), Bvh.over(List.of(primitive.shape()))));
      } else {
        findings.add(
            Finding.warning(
                LAW,
                file.origins().primitives().get(i),
                "glass on a surface that is not closed",
                "light that enters never leaves: all space behind the surface counts as glass",
                Surfaces.flat(primitive.material()) instanceof Glass
                    ? "close the mesh, model the pane as a thin Cube, or set its ior to 1"
                    : "close the mesh, or make it thin: a thicknessFactor of 0 in glTF, no"
                        + " attenuationDistance in a scene"));
      }
    }
    int pairs = 0;
    for (Pane a : closed) {
      for (Pane b : closed) {
        if (a != b && overlap(a.shape.bounds(), b.shape.bounds()) && pairs++ < MOST_PAIRS) {
          compare(a, b, file, findings);
        }
      }
    }
    return List.copyOf(findings);
  }

  /** Returns whether a surface is the boundary of a volume that refracts or absorbs. */
  private static boolean refracts(Material material) {
    Material flat = Surfaces.flat(material);
    if (flat instanceof Glass glass) {
      return !(glass.ior().isConstant() && glass.ior().at(0, 0) == 1);
    }
    if (!(flat instanceof MetallicRoughness physical)
        || physical.stated(MaterialParameter.ATTENUATION_DISTANCE).isEmpty()) {
      return false;
    }
    boolean isClear =
        isAlways(physical, MaterialParameter.IOR, 1) && physical.absorption().isBlack();
    return !isClear
        && (passes(physical, MaterialParameter.TRANSMISSION)
            || passes(physical, MaterialParameter.DIFFUSE_TRANSMISSION));
  }

  private static boolean passes(MetallicRoughness material, MaterialParameter transmission) {
    return material.stated(transmission).isPresent() && !isAlways(material, transmission, 0);
  }

  /** Returns whether a number has a value that is stated and the same everywhere. */
  private static boolean isAlways(
      MetallicRoughness material, MaterialParameter parameter, double value) {
    return material
        .stated(parameter)
        .filter(c -> c instanceof ScalarChannel n && n.isConstant() && n.at(ORIGIN) == value)
        .isPresent();
  }

  private static boolean overlap(Bounds3 a, Bounds3 b) {
    return a.min().x() <= b.max().x()
        && b.min().x() <= a.max().x()
        && a.min().y() <= b.max().y()
        && b.min().y() <= a.max().y()
        && a.min().z() <= b.max().z()
        && b.min().z() <= a.max().z();
  }

  /** Adds a finding if the surface of one object lies partly or wholly inside the other. */
  private static void compare(Pane surface, Pane volume, ParsedScene file, Set<Finding> findings) {
    int inside = 0;
    int points = 0;
    NearestHit hit = new NearestHit();
    Bounds3 bounds = surface.shape.bounds();
    for (int i = 0; i < POINTS; i++) {
      Vec3 out = direction(i);
      Vec3 from = bounds.center().plus(3 * bounds.radius(), out);
      Ray ray =
          new Ray(
              from,
              bounds
                  .center()
                  .plus(bounds.radius() * .5, direction(i + POINTS))
                  .minus(from)
                  .normalized());
      if (surface.alone.intersect(ray, hit)) {
        Vec3 point = surface.shape.surfaceAt(hit).position();
        points++;
        inside += isInside(volume, point, hit) ? 1 : 0;
      }
    }
    // Rounding puts points of a common face on either side: tolerate 5 %.
    int few = points / 20;
    String other = file.origins().primitives().get(volume.primitive).toString();
    if (inside > few && inside < points - few) {
      findings.add(
          Finding.warning(
              LAW,
              file.origins().primitives().get(surface.primitive),
              "the glass overlaps the glass of " + other,
              "each surface refracts as if its other side were air; in the overlap, this matches"
                  + " neither glass",
              "leave a gap between the two, or model their common boundary as one surface"));
    } else if (points > 0 && inside >= points - few) {
      findings.add(
          Finding.note(
              LAW,
              file.origins().primitives().get(surface.primitive),
              "the glass lies entirely inside the glass of " + other,
              "its ior is relative to the surrounding glass, not to air",
              "use 1.33 / 1.5 for water in glass, or 1 / 1.5 for an air bubble"));
    }
  }

  private static Vec3 direction(int number) {
    return Warp.uniformSphere(
        new Point2(Hash.unit(Hash.of(1, number)), Hash.unit(Hash.of(2, number))));
  }

  /** Returns whether a point is inside: a ray from it crosses an odd number of surfaces. */
  private static boolean isInside(Pane volume, Vec3 point, NearestHit hit) {
    Ray ray = new Ray(point, direction(-1));
    int crossings = 0;
    while (crossings < MOST_CROSSINGS && volume.alone.intersect(ray, hit)) {
      SurfaceHit surface = volume.shape.surfaceAt(hit);
      ray = surface.spawn(ray.direction());
      crossings++;
    }
    return crossings % 2 == 1;
  }
}
