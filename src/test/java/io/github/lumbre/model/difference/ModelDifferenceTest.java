package io.github.lumbre.model.difference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.difference.PartChange.Kind;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ModelDifferenceTest {
  private static final double TOLERANCE = 1e-5;

  /** Triangles of a bolt: a shaft and a hexagonal head, with a cut in one side. */
  private static List<Vec3[]> bolt() {
    List<Vec3[]> triangles = new ArrayList<>();
    addPrism(triangles, 24, 1, 0, 5);
    addPrism(triangles, 6, 2, 5, 6.5);
    triangles.add(new Vec3[] {new Vec3(2, 0, 5), new Vec3(2.2, 0.1, 5.2), new Vec3(2, 0, 6)});
    return triangles;
  }

  private static void addPrism(
      List<Vec3[]> triangles, int sides, double radius, double low, double high) {
    for (int i = 0; i < sides; i++) {
      Vec3 a = onCircle(i, sides, radius, low);
      Vec3 b = onCircle(i + 1, sides, radius, low);
      Vec3 c = onCircle(i + 1, sides, radius, high);
      Vec3 d = onCircle(i, sides, radius, high);
      triangles.add(new Vec3[] {a, b, c});
      triangles.add(new Vec3[] {a, c, d});
      triangles.add(new Vec3[] {new Vec3(0, 0, low), b, a});
      triangles.add(new Vec3[] {new Vec3(0, 0, high), d, c});
    }
  }

  private static Vec3 onCircle(int i, int sides, double radius, double z) {
    double angle = 2 * Math.PI * (i % sides) / sides;
    return new Vec3(radius * Math.cos(angle), radius * Math.sin(angle), z);
  }

  private static PartShape part(String name, List<Vec3[]> triangles, UnaryOperator<Vec3> place) {
    return part(name, !name.startsWith("piece"), triangles, place, "steel");
  }

  private static PartShape part(
      String name,
      boolean isNamed,
      List<Vec3[]> triangles,
      UnaryOperator<Vec3> place,
      String material) {
    PartShape.Builder builder = new PartShape.Builder(place.apply(Vec3.ZERO));
    for (Vec3[] t : triangles) {
      builder.triangle(place.apply(t[0]), place.apply(t[1]), place.apply(t[2]));
    }
    return builder.build(name, isNamed ? name : "", Set.of(material));
  }

  private static UnaryOperator<Vec3> at(double x, double y, double z) {
    return p -> p.plus(new Vec3(x, y, z));
  }

  private static List<Vec3[]> shuffled(List<Vec3[]> triangles) {
    Random random = new Random(3);
    List<Vec3[]> other = new ArrayList<>();
    for (Vec3[] t : triangles) {
      int first = random.nextInt(3);
      other.add(new Vec3[] {t[first], t[(first + 1) % 3], t[(first + 2) % 3]});
    }
    Collections.shuffle(other, random);
    return other;
  }

  private static ModelDifference.Result between(List<PartShape> old, List<PartShape> now) {
    return ModelDifference.between(old, now, TOLERANCE);
  }

  private static PartChange only(List<PartShape> old, List<PartShape> now) {
    ModelDifference.Result result = between(old, now);
    assertThat(result.changes()).hasSize(1);
    return result.changes().get(0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"bolt", "piece "})
  void theOrderOfTrianglesAndPartsDoesNotMatter(String name) {
    List<PartShape> old =
        List.of(part(name + "1", bolt(), at(0, 0, 0)), part(name + "2", bolt(), at(9, 0, 0)));
    boolean isNamed = name.equals("bolt");
    List<PartShape> now =
        List.of(
            part(name + (isNamed ? "2" : "1"), shuffled(bolt()), at(9, 0, 0)),
            part(name + (isNamed ? "1" : "2"), shuffled(bolt()), at(0, 0, 0)));
    ModelDifference.Result result = between(old, now);
    assertThat(result.changes()).isEmpty();
    assertThat(result.same()).isEqualTo(2);
  }

  /** The scale of exporters that write 7 digits. */
  @Test
  void theRoundingOfAnExporterDoesNotMatter() {
    Random random = new Random(5);
    UnaryOperator<Vec3> rounded =
        p ->
            new Vec3(
                p.x() + 1e-6 * (random.nextDouble() - .5),
                p.y() + 1e-6 * (random.nextDouble() - .5),
                p.z() + 1e-6 * (random.nextDouble() - .5));
    assertThat(
            between(
                    List.of(part("bolt", bolt(), UnaryOperator.identity())),
                    List.of(part("bolt", bolt(), rounded)))
                .changes())
        .isEmpty();
  }

  @ParameterizedTest
  @ValueSource(doubles = {2e-4, 1e-3, 1, 1000})
  void aMovedBoltIsNamedWithItsDistance(double distance) {
    List<PartShape> old =
        List.of(
            part("bolt 1", bolt(), at(0, 0, 0)),
            part("bolt 2", bolt(), at(9, 0, 0)),
            part("bolt 3", bolt(), at(0, 9, 0)));
    List<PartShape> now =
        List.of(
            part("bolt 1", bolt(), at(0, 0, 0)),
            part("bolt 2", bolt(), at(9, 0, 0)),
            part("bolt 3", bolt(), at(0, 9, distance)));
    PartChange change = only(old, now);
    assertThat(change.kind()).isEqualTo(Kind.MOVED);
    assertThat(change.name()).isEqualTo("bolt 3");
    assertThat(change.distance()).isCloseTo(distance, within(1e-9 * Math.max(1, distance)));
    assertThat(change.degrees()).isZero();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 30, 90, 179})
  void aTurnedBoltIsNamedWithItsAngle(double degrees) {
    Transform turn = Transform.rotationDegrees(new Vec3(0, 0, degrees));
    Transform tilt = Transform.rotationDegrees(new Vec3(20, 0, 0));
    UnaryOperator<Vec3> place = p -> tilt.point(turn.point(tilt.inversePoint(p)));
    PartChange change =
        only(List.of(part("bolt", bolt(), at(0, 0, 0))), List.of(part("bolt", bolt(), place)));
    assertThat(change.kind()).isEqualTo(Kind.MOVED);
    assertThat(change.degrees()).isCloseTo(degrees, within(1e-2));
  }

  /** A prism of six sides is the same after 10° as after 70°, 130° and so on. */
  @Test
  void theSmallestAngleOfARegularPartIsNamed() {
    List<Vec3[]> prism = new ArrayList<>();
    addPrism(prism, 6, 1, 0, 2);
    Transform turn = Transform.rotationDegrees(new Vec3(0, 0, 10));
    PartChange change =
        only(List.of(part("nut", prism, at(0, 0, 0))), List.of(part("nut", prism, turn::point)));
    assertThat(change.kind()).isEqualTo(Kind.MOVED);
    assertThat(change.degrees()).isCloseTo(10, within(1e-2));
  }

  @Test
  void aMirroredBoltIsAnotherShape() {
    PartChange change =
        only(
            List.of(part("bolt", bolt(), at(0, 0, 0))),
            List.of(part("bolt", bolt(), p -> new Vec3(p.x(), -p.y(), p.z()))));
    assertThat(change.kind()).isEqualTo(Kind.CHANGED);
  }

  @Test
  void aDentIsAChange() {
    List<Vec3[]> dented = new ArrayList<>(bolt());
    dented.replaceAll(
        t ->
            new Vec3[] {
              t[0].equals(dented.get(9)[0]) ? t[0].times(.999) : t[0],
              t[1].equals(dented.get(9)[0]) ? t[1].times(.999) : t[1],
              t[2].equals(dented.get(9)[0]) ? t[2].times(.999) : t[2]
            });
    PartChange change =
        only(
            List.of(part("bolt", bolt(), at(0, 0, 0))), List.of(part("bolt", dented, at(0, 0, 0))));
    assertThat(change.kind()).isEqualTo(Kind.CHANGED);
    assertThat(change.details())
        .as("its size and area have the same five digits")
        .containsExactly("another shape");
  }

  @Test
  void aLongerBoltIsAChangeOfItsNumbers() {
    PartChange change =
        only(
            List.of(part("bolt", bolt(), at(0, 0, 0))),
            List.of(part("bolt", bolt(), p -> new Vec3(p.x(), p.y(), 2 * p.z()))));
    assertThat(change.details())
        .hasSize(2)
        .first()
        .asString()
        .matches("size 4.2 x 3.464 x 6.5 to 4.2 x 3.464 x 13");
    assertThat(change.details().get(1)).matches("area [0-9.]+ to [0-9.]+");
  }

  /** An open box without its lid has the vertices and the area of one without its floor. */
  @Test
  void aBoxThatIsOpenElsewhereIsAnotherShape() {
    List<Vec3[]> box = new ArrayList<>();
    addPrism(box, 4, 1, 0, Math.sqrt(2));
    List<Vec3[]> noLid = new ArrayList<>();
    List<Vec3[]> noFloor = new ArrayList<>();
    for (int i = 0; i < box.size(); i++) {
      if (i % 4 != 3) {
        noLid.add(box.get(i));
      }
      if (i % 4 != 2) {
        noFloor.add(box.get(i));
      }
    }
    noLid.add(new Vec3[] {new Vec3(0, 0, Math.sqrt(2)), Vec3.ZERO, new Vec3(0, 0, .1)});
    noFloor.add(new Vec3[] {new Vec3(0, 0, Math.sqrt(2)), Vec3.ZERO, new Vec3(0, 0, .1)});
    PartChange change =
        only(List.of(part("box", noLid, at(0, 0, 0))), List.of(part("box", noFloor, at(0, 0, 0))));
    assertThat(change.kind()).isNotEqualTo(Kind.RENAMED);
  }

  @Test
  void anotherDivisionIntoTrianglesIsTheSameSurface() {
    Vec3 a = new Vec3(0, 0, 0);
    Vec3 b = new Vec3(3, 0, 0);
    Vec3 c = new Vec3(3, 2, 0);
    Vec3 d = new Vec3(0, 2, 0);
    List<Vec3[]> one = List.of(new Vec3[] {a, b, c}, new Vec3[] {a, c, d});
    List<Vec3[]> other = List.of(new Vec3[] {a, b, d}, new Vec3[] {b, c, d});
    assertThat(
            between(
                    List.of(part("plate", one, at(0, 0, 0))),
                    List.of(part("plate", other, at(0, 0, 0))))
                .changes())
        .isEmpty();
  }

  @Test
  void addedRemovedRenamedAndRecoloredPartsAreTold() {
    List<Vec3[]> box = new ArrayList<>();
    addPrism(box, 4, 1, 0, 1);
    List<Vec3[]> rod = new ArrayList<>();
    addPrism(rod, 12, .1, 0, 9);
    List<PartShape> old =
        List.of(
            part("bolt", bolt(), at(0, 0, 0)),
            part("lid", box, at(20, 0, 0)),
            part("handle", rod, at(30, 0, 0)),
            part("gone", box, at(40, 0, 5)));
    List<PartShape> now =
        List.of(
            part("bolt", true, bolt(), at(0, 0, 0), "brass"),
            part("cover", box, at(20, 0, 0)),
            part("handle", rod, at(30, 0, 0)),
            part("new", bolt(), at(50, 0, 0)));
    List<String> told =
        between(old, now).changes().stream().map(c -> c.kind() + " " + c.name()).toList();
    assertThat(told).containsExactly("ADDED new", "REMOVED gone", "CHANGED bolt", "RENAMED cover");
  }

  /** More pairs than are kept at once: each part is still paired with the nearest one. */
  @ParameterizedTest
  @ValueSource(strings = {"bolt", "piece"})
  void manyEqualPartsAreAllPaired(String name) {
    List<Vec3[]> bolt = bolt().subList(0, 2);
    List<PartShape> old = new ArrayList<>();
    List<PartShape> now = new ArrayList<>();
    for (int i = 0; i < 1500; i++) {
      old.add(part(name, bolt, at(9 * (i % 40), 9 * (i / 40), 0)));
      now.add(0, part(name, bolt, at(9 * (i % 40), 9 * (i / 40), i == 5 ? 0 : 1)));
    }
    ModelDifference.Result result = between(old, now);
    assertThat(result.same()).isEqualTo(1);
    assertThat(result.changes())
        .hasSize(1499)
        .allMatch(change -> change.kind() == Kind.MOVED && Math.abs(change.distance() - 1) < 1e-9);
  }

  @Test
  void piecesWithoutNamesArePairedByShapeAndPlace() {
    List<Vec3[]> box = new ArrayList<>();
    addPrism(box, 4, 1, 0, 1);
    List<PartShape> old =
        List.of(part("piece 1", bolt(), at(0, 0, 0)), part("piece 2", box, at(20, 0, 0)));
    List<PartShape> now =
        List.of(part("piece 1", box, at(20, 0, 1)), part("piece 2", bolt(), at(0, 0, 0)));
    PartChange change = only(old, now);
    assertThat(change.kind()).isEqualTo(Kind.MOVED);
    assertThat(change.distance()).isCloseTo(1, within(1e-9));
  }

  @Test
  void filesWithoutMaterialsChangeNone() {
    PartShape.Builder builder = new PartShape.Builder(Vec3.ZERO);
    bolt().forEach(t -> builder.triangle(t[0], t[1], t[2]));
    List<PartShape> plain = List.of(builder.build("bolt", "bolt", Set.of()));
    List<PartShape> steel = List.of(part("bolt", bolt(), at(0, 0, 0)));
    assertThat(between(plain, steel).changes()).isEmpty();
    assertThat(between(steel, plain).changes()).isEmpty();
  }

  /** A rib within a part adds vertices, and takes a face of the same area and centroid away. */
  @Test
  void verticesThatAreNewAreAChange() {
    Vec3 a = new Vec3(-1, 0, 0);
    Vec3 b = new Vec3(1, 0, 0);
    Vec3 up = new Vec3(0, 1, 0);
    Vec3 down = new Vec3(0, -1, 0);
    Vec3 front = new Vec3(0, 0, 1);
    Vec3 back = new Vec3(0, 0, -1);
    Vec3[] upper = {a, b, up};
    Vec3[] lower = {a, b, down};
    Vec3[] far = {front, back, a};
    Vec3[] near = {front, back, b};
    List<PartShape> old = List.of(part("cross", List.of(upper, lower, upper, lower), at(0, 0, 0)));
    List<PartShape> now = List.of(part("cross", List.of(upper, lower, far, near), at(0, 0, 0)));
    assertThat(only(old, now).kind()).isEqualTo(Kind.CHANGED);
    assertThat(only(now, old).kind()).isEqualTo(Kind.CHANGED);
  }
}
