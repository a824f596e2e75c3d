package io.github.lumbre.integrator.guiding;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Tests the connections of vertices to bright places, and the mean light of these places. */
class ConnectionsTest {
  private static final Sight CLEAR = (x, y, z, dx, dy, dz) -> true;
  private static final double ALBEDO = .6;
  private static final double SIDE = .2;
  private static final double LIGHT = 10;

  static RecordValues values(GuideRecords records) {
    return new RecordValues(records, RecordOrder.ofAxes(records));
  }

  /**
   * Paths that leave a point of a floor, diffusely. Some meet a bright square one unit above, which
   * other paths find as well.
   */
  private static GuideRecords underCeiling(int count) {
    Random random = new Random(1);
    GuideRecords records = new GuideRecords();
    for (int i = 0; i < count; i++) {
      double sine = Math.sqrt(random.nextDouble());
      double phi = 2 * Math.PI * random.nextDouble();
      double x = sine * Math.cos(phi);
      double y = sine * Math.sin(phi);
      double z = Math.sqrt(1 - sine * sine);
      records.add(0, 0, 0, 0, 0, 1, 0, ALBEDO);
      boolean isMet = Math.max(Math.abs(x / z), Math.abs(y / z)) < SIDE / 2;
      records.leave(x, y, z, z / Math.PI, z / Math.PI, 0, isMet ? ALBEDO : 0, isMet);
      if (isMet) {
        records.add(x / z, y / z, 1, 0, 0, -1, LIGHT, ALBEDO);
      }
    }
    for (int i = 0; i < 1000; i++) {
      double x = SIDE * (random.nextDouble() - .5);
      double y = SIDE * (random.nextDouble() - .5);
      records.add(x, y, 1, 0, 0, -1, LIGHT, ALBEDO);
    }
    return records;
  }

  /** Returns the mean value of the floor's records and connections. */
  private static double meanOfFloor(GuideRecords records, Sight sight) {
    int size = records.size();
    RecordOrder[] orders = RecordOrder.ofAxes(records);
    RecordValues values = new RecordValues(records, orders);
    Connections connections = new Connections(records, values, Guide.NONE);
    RecordOrder floor = orders[Guide.axis(0, 0, 1)];
    int count = floor.size();
    int[] rays = new int[1];
    Sight counted =
        (x, y, z, dx, dy, dz) -> {
          rays[0]++;
          return sight.isClear(x, y, z, dx, dy, dz);
        };
    RecordOrder all = connections.connected(new RecordRange(floor, 0, count), counted);
    assertThat(rays[0]).isEqualTo(count);
    double sum = 0;
    for (int i = 0; i < all.size(); i++) {
      sum += values.value(all.record(i));
      int offset = i < count ? 0 : size;
      assertThat(all.record(i)).isEqualTo(floor.record(i % count) + offset);
    }
    return sum / (2 * count);
  }

  /**
   * Both kinds of directions together have the light that the floor scatters: albedo · L · F, with
   * the form factor F of a parallel square above a point. The areas of places are estimated, which
   * the tolerance allows.
   */
  @Test
  void directionsOfBothKindsAddUpToTheLight() {
    double a = SIDE / 2;
    double b = a / Math.sqrt(1 + a * a);
    double factor = 4 / Math.PI * b * Math.atan(b);
    double expected = ALBEDO * LIGHT * factor;
    double mean = meanOfFloor(underCeiling(100_000), CLEAR);
    assertThat(mean).isCloseTo(expected, within(.05 * expected));
  }

  /** Directions to a place that is hidden are not added; those that paths took are kept. */
  @Test
  void hiddenPlacesAreNotConnected() {
    GuideRecords records = underCeiling(2000);
    RecordOrder[] orders = RecordOrder.ofAxes(records);
    RecordValues values = new RecordValues(records, orders);
    Connections connections = new Connections(records, values, Guide.NONE);
    RecordOrder floor = orders[Guide.axis(0, 0, 1)];
    RecordRange range = new RecordRange(floor, 0, floor.size());
    RecordOrder all = connections.connected(range, (x, y, z, dx, dy, dz) -> false);
    assertThat(all.size()).isEqualTo(floor.size());
    for (int i = 0; i < range.size(); i++) {
      assertThat(records.isConnected(records.size() + range.record(i))).isFalse();
    }
  }

  /** Records of a floor below a small bright place that none of the paths met. */
  private static GuideRecords unmet(double albedo) {
    Random random = new Random(2);
    GuideRecords records = new GuideRecords();
    for (int i = 0; i < 1000; i++) {
      records.add(random.nextDouble(), random.nextDouble(), 0, 0, 0, 1, .01, albedo);
      records.leave(.6, 0, .8, .8 / Math.PI, .8 / Math.PI, .001, 0, false);
    }
    for (int i = 0; i < 100; i++) {
      double x = 3 + .1 * random.nextDouble();
      records.add(x, 4 + .1 * random.nextDouble(), 2, 0, 0, -1, 50, albedo);
    }
    return records;
  }

  /** Without connections, the part of the hemisphere where the place lies has little density. */
  @Test
  void guidesFindBrightPlacesThatNoPathMet() {
    GuideSample sample = new GuideSample();
    double[] densities = new double[2];
    for (int kind = 0; kind < 2; kind++) {
      Guide guide = GuideBuilder.build(unmet(kind * ALBEDO), Guide.NONE, () -> CLEAR);
      int cell = guide.cell(.5, .5, 0, 0, 0, 1);
      Octahedron.direction(Octahedron.u(2.55, 3.55, 2), Octahedron.v(2.55, 3.55, 2), sample);
      densities[kind] = guide.pdf(cell, sample.x(), sample.y(), sample.z());
    }
    assertThat(densities[0]).isPositive().isLessThan(.1);
    assertThat(densities[1]).isGreaterThan(2);
  }

  /**
   * A few bright vertices lie 5 units aside of many dark ones that face the same axis. The dark
   * ones are not exactly in one plane, as rounded hits are.
   */
  @Test
  void aSmallBrightPlaceDoesNotShareItsLight() {
    Random random = new Random(3);
    GuideRecords records = new GuideRecords();
    for (int i = 0; i < 20_000; i++) {
      boolean isBright = i % 1000 == 0;
      double x = random.nextDouble();
      double y = random.nextDouble();
      double z = isBright ? 5 + .1 * random.nextDouble() : 1e-7 * random.nextDouble();
      records.add(x, y, z, 0, 0, 1, isBright ? 1 : 0, 0);
    }
    RecordValues values = values(records);
    assertThat(values.mean(0)).isEqualTo(1);
    assertThat(values.mean(1)).isZero();
    assertThat(20 * values.area(0)).isCloseTo(1, within(.2));
  }

  /** Three of four guided paths arrive at a bright vertex, with a ninth of the others' weight. */
  @Test
  void verticesCountByTheWeightOfArrival() {
    GuideRecords records = new GuideRecords();
    for (int i = 0; i < 8; i++) {
      boolean isGuided = i % 4 > 0;
      records.add(0, 0, 0, 0, 0, 1, 0, 0);
      records.leave(1, 0, 0, 1, 1, 0, isGuided ? .25 : 2.25, true);
      records.add(1, 0, 0, -1, 0, 0, isGuided ? 6 : 2, 0);
    }
    assertThat(values(records).mean(1)).isEqualTo((3 * .25 * 6 + 2.25 * 2) / 3);
  }
}
