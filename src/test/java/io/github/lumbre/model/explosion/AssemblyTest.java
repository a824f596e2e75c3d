package io.github.lumbre.model.explosion;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Bodies of an exploded view do not overlap, keep their order, and stay near each other. */
class AssemblyTest {
  private static final double LEAST = 1e-9;

  private final List<Bounds3> boxes = new ArrayList<>();
  private final Assembly assembly = new Assembly(Frame.WORLD);

  private void body(int group, double... corners) {
    Bounds3 box =
        new Bounds3(
            new Vec3(corners[0], corners[1], corners[2]),
            new Vec3(corners[3], corners[4], corners[5]));
    boxes.add(box);
    assembly.addBody(group, box, box);
  }

  private List<Bounds3> exploded() {
    List<Vec3> moves = assembly.exploded().moves();
    List<Bounds3> moved = new ArrayList<>();
    for (int i = 0; i < moves.size(); i++) {
      moved.add(
          new Bounds3(
              boxes.get(i).min().plus(moves.get(i)), boxes.get(i).max().plus(moves.get(i))));
    }
    return moved;
  }

  private static Bounds3 around(List<Bounds3> all) {
    return all.stream().reduce(Bounds3.EMPTY, Bounds3::union);
  }

  private static double longest(Bounds3 box) {
    return box.max().minus(box.min()).maxAbs();
  }

  private static int overlaps(List<Bounds3> all) {
    int count = 0;
    for (int i = 0; i < all.size(); i++) {
      for (int j = 0; j < i; j++) {
        Vec3 low = all.get(i).min();
        Vec3 high = all.get(i).max();
        Vec3 otherLow = all.get(j).min();
        Vec3 otherHigh = all.get(j).max();
        boolean isApart = false;
        for (int axis = 0; axis < 3; axis++) {
          isApart |= low.get(axis) > otherHigh.get(axis) - LEAST;
          isApart |= otherLow.get(axis) > high.get(axis) - LEAST;
        }
        count += isApart ? 0 : 1;
      }
    }
    return count;
  }

  private void assertApart() {
    List<Bounds3> all = exploded();
    assertThat(overlaps(all)).isZero();
    assertThat(longest(around(all))).isLessThanOrEqualTo(3 * longest(around(boxes)));
  }

  @Test
  void nestedRingsMoveAlongTheirAxis() {
    body(Assembly.ROOT, -10, -10, -3, 10, 10, 3);
    body(Assembly.ROOT, -7, -7, -3, 7, 7, 3);
    body(Assembly.ROOT, -4, -4, -3, 4, 4, 3);
    assertApart();
    List<Vec3> moves = assembly.exploded().moves();
    assertThat(moves).allMatch(move -> move.x() == 0 && move.y() == 0);
    assertThat(moves.get(1).z()).isGreaterThan(moves.get(0).z() + 6);
    assertThat(moves.get(2).z()).isGreaterThan(moves.get(1).z() + 6);
  }

  @Test
  void boltInTheCornerOfAPlateLeavesItsHole() {
    body(Assembly.ROOT, -30, -20, 0, 30, 20, 8);
    body(Assembly.ROOT, 22, 12, -2, 26, 16, 14);
    body(Assembly.ROOT, 20, 10, -6, 28, 18, 0); // a nut below it
    assertApart();
    List<Vec3> moves = assembly.exploded().moves();
    assertThat(moves).allMatch(move -> move.x() == 0 && move.y() == 0);
    assertThat(moves.get(1).z()).isGreaterThan(moves.get(0).z());
    assertThat(moves.get(2).z()).isLessThan(moves.get(0).z());
  }

  @Test
  void boltThatIsNoLongerThanItsHoleLeavesItAlongItsLength() {
    body(Assembly.ROOT, -30, -20, 0, 30, 20, 8);
    body(Assembly.ROOT, 22, 12, 0, 26, 16, 8);
    assertApart();
    assertThat(assembly.exploded().moves()).allMatch(m -> m.x() == 0 && m.y() == 0 && m.z() != 0);
  }

  @Test
  void partsThatTouchInACornerMoveAcrossTheirThinnestOverlap() {
    body(Assembly.ROOT, 0, 0, 0, 10, 10, 10);
    body(Assembly.ROOT, 9, 4, 5, 19, 14, 15);
    assertApart();
    List<Vec3> moves = assembly.exploded().moves();
    assertThat(moves).allMatch(move -> move.y() == 0 && move.z() == 0);
    assertThat(moves.get(1).x()).isPositive();
  }

  @Test
  void whatIsInTheWayMovesOn() {
    body(Assembly.ROOT, -10, -10, -1, 10, 10, 1);
    body(Assembly.ROOT, -2, -2, -3, 2, 2, 5);
    body(Assembly.ROOT, -2, -2, 6, 2, 2, 7); // a lid above the bolt
    assertApart();
    List<Bounds3> all = exploded();
    assertThat(all.get(2).min().z()).isGreaterThan(all.get(1).max().z());
  }

  @Test
  void farPartsStayWhereTheyAre() {
    body(Assembly.ROOT, 0, 0, 0, 1, 1, 1);
    body(Assembly.ROOT, 5, 0, 0, 6, 1, 1);
    assertThat(assembly.exploded().moves()).containsExactly(Vec3.ZERO, Vec3.ZERO);
  }

  @Test
  void groupsStayTogether() {
    int left = assembly.addGroup(Assembly.ROOT);
    int right = assembly.addGroup(Assembly.ROOT);
    int inner = assembly.addGroup(right);
    body(left, 0, 0, 0, 4, 4, 4);
    body(left, 1, 1, 1, 3, 3, 3);
    body(right, 3, 0, 0, 8, 4, 4);
    body(inner, 4, 1, 1, 6, 3, 3);
    body(inner, 5, 1, 1, 7, 3, 3);
    assertApart();
    List<Bounds3> all = exploded();
    List<Bounds3> groups = List.of(around(all.subList(0, 2)), around(all.subList(2, 5)));
    assertThat(overlaps(groups)).isZero();
    assertThat(overlaps(List.of(all.get(2), around(all.subList(3, 5))))).isZero();
  }

  @Test
  void gridsMoveApartInOrder() {
    for (int i = 0; i < 60; i++) {
      double x = 10 * (i % 5);
      double y = 10 * (i / 5 % 4);
      double z = 10 * (i / 20);
      body(Assembly.ROOT, x, y, z, x + 10, y + 10, z + 10);
    }
    assertApart();
    List<Bounds3> all = exploded();
    for (int i = 0; i < 60; i++) {
      if (i % 5 > 0) {
        assertThat(all.get(i).min().x()).isGreaterThan(all.get(i - 1).max().x());
      }
      if (i >= 20) {
        assertThat(all.get(i).min().z()).isGreaterThan(all.get(i - 20).max().z());
      }
    }
  }

  /** Boxes that are beside each other do not pass through each other on their ways. */
  @Test
  void randomBoxesMoveApartWithoutMeeting() {
    Random random = new Random(7);
    for (int round = 0; round < 20; round++) {
      AssemblyTest test = new AssemblyTest();
      for (int i = 0; i < 30; i++) {
        double x = 2 * random.nextDouble();
        double y = 2 * random.nextDouble();
        double z = 2 * random.nextDouble();
        double side = .1 + .5 * random.nextDouble();
        test.body(Assembly.ROOT, x, y, z, x + side, y + .5, z + .3);
      }
      test.assertApart();
      List<Bounds3> end = test.exploded();
      List<Bounds3> start = test.boxes;
      for (int i = 0; i < start.size(); i++) {
        for (int j = 0; j < i; j++) {
          if (overlaps(List.of(start.get(i), start.get(j))) == 0) {
            for (double t = .1; t < 1; t += .1) {
              assertThat(
                      overlaps(
                          List.of(
                              between(start.get(i), end.get(i), t),
                              between(start.get(j), end.get(j), t))))
                  .isZero();
            }
          }
        }
      }
    }
  }

  private static Bounds3 between(Bounds3 from, Bounds3 to, double t) {
    Vec3 move = to.min().minus(from.min()).times(t);
    return new Bounds3(from.min().plus(move), from.max().plus(move));
  }

  @Test
  void whatDoesNotFitIsNamed() {
    for (int i = 0; i < 30; i++) {
      body(Assembly.ROOT, -10, -10, -10 - i, 10, 10, 10 + i);
    }
    Assembly.Moves found = assembly.exploded();
    List<Bounds3> all = exploded();
    assertThat(found.overlaps()).isEqualTo(overlaps(all)).isPositive();
    assertThat(found.overlapping()).isNotEmpty();
    assertThat(longest(around(all))).isLessThanOrEqualTo(3 * longest(around(boxes)));
  }

  @Test
  void ofManyBodiesOneLevelMoves() {
    int all = assembly.addGroup(Assembly.ROOT);
    for (int group = 0; group < 3; group++) {
      int number = assembly.addGroup(all);
      for (int i = 0; i < 200; i++) {
        double x = .9 * group + i / 200.;
        body(number, x, 0, 0, x + .01, 1, 1);
      }
    }
    Assembly.Moves found = assembly.exploded();
    assertThat(found.level()).isEqualTo(3);
    assertThat(found.overlaps()).isZero();
    assertThat(found.moves().stream().distinct()).hasSize(3);
    List<Bounds3> moved = exploded();
    assertThat(
            overlaps(
                List.of(
                    around(moved.subList(0, 200)),
                    around(moved.subList(200, 400)),
                    around(moved.subList(400, 600)))))
        .isZero();
  }

  @Test
  void flatAndSingleBodiesAreNoProblem() {
    assertThat(assembly.exploded().moves()).isEmpty();
    body(Assembly.ROOT, 0, 0, 0, 1, 1, 0);
    assertThat(assembly.exploded().moves()).containsExactly(Vec3.ZERO);
    body(Assembly.ROOT, 0, 0, 0, 1, 1, 0);
    body(Assembly.ROOT, 2, 2, 2, 2, 2, 2);
    body(Assembly.ROOT, 2, 2, 2, 2, 2, 2);
    assertApart();
  }
}
