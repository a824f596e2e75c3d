package io.github.lumbre.math;

import static io.github.lumbre.testing.Draws.inCube;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.testing.Effort;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests transforms, their inverses and their error bounds. */
class TransformTest {
  private static final double EPS = 0x1p-52;

  private final SplittableRandom random = new SplittableRandom(5);

  private double decades(double n) {
    return StrictMath.pow(10, random.nextDouble(-n, n));
  }

  private Transform rigid() {
    return Transform.translation(inCube(random, 10))
        .times(Transform.rotationDegrees(inCube(random, 360)));
  }

  private static Transform rotation(double x, double y, double z) {
    return Transform.rotationDegrees(new Vec3(x, y, z));
  }

  @Test
  void axesOfAMapAreItsColumns() {
    Transform map = rigid().times(Transform.scale(new Vec3(2, -3, .5)));
    Transform copy =
        Transform.ofAxes(
            map.vector(Vec3.X), map.vector(Vec3.Y), map.vector(Vec3.Z), map.point(Vec3.ZERO));
    Vec3 p = inCube(random, 5);
    assertThat(copy.point(p).minus(map.point(p)).length()).isLessThan(1e-13);
    assertThat(copy.inversePoint(p).minus(map.inversePoint(p)).length()).isLessThan(1e-13);
    assertThat(copy.determinant()).isEqualTo(-3, within(1e-14));
    assertThat(copy.isInvertible()).isTrue();
  }

  @Test
  void axesInAPlaneMakeNoInvertibleMap() {
    Vec3 sum = new Vec3(1, 2, 0);
    assertThat(Transform.ofAxes(Vec3.X, Vec3.Y, sum, Vec3.ZERO).isInvertible()).isFalse();
    assertThat(Transform.ofAxes(Vec3.X, Vec3.Y, Vec3.ZERO, Vec3.ZERO).isInvertible()).isFalse();
  }

  @Test
  void inverseUndoesRotationsAndScales() {
    for (int i = 0; i < 100_000; i++) {
      Vec3 scale = new Vec3(decades(4), -decades(4), decades(4));
      Transform t = rigid().times(Transform.scale(scale));
      Vec3 magnitudes = new Vec3(scale.x(), -scale.y(), scale.z());
      double smallest = Math.min(magnitudes.x(), Math.min(magnitudes.y(), magnitudes.z()));
      double bound = 64 * EPS * magnitudes.maxAbs() / smallest;
      for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
        Vec3 there = t.vector(t.inverseVector(axis));
        Vec3 back = t.inverseVector(t.vector(axis));
        assertThat(there.minus(axis).maxAbs()).isLessThanOrEqualTo(bound);
        assertThat(back.minus(axis).maxAbs()).isLessThanOrEqualTo(bound);
      }
    }
  }

  @Test
  void inverseOfShearsIsAsGoodAsTheirCondition() {
    for (int i = 0; i < 10_000; i++) {
      Vec3 outer = new Vec3(1, decades(4), decades(4));
      Vec3 inner = new Vec3(decades(4), decades(4), 1);
      Transform t =
          rigid().times(Transform.scale(outer)).times(rigid()).times(Transform.scale(inner));
      double norm = 0;
      double inverseNorm = 0;
      Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
      for (Vec3 axis : axes) {
        norm += t.vector(axis).lengthSquared();
        inverseNorm += t.inverseVector(axis).lengthSquared();
      }
      double bound = 64 * EPS * Math.sqrt(norm * inverseNorm);
      for (Vec3 axis : axes) {
        assertThat(t.inverseVector(t.vector(axis)).minus(axis).maxAbs()).isLessThan(bound);
        assertThat(t.vector(t.inverseVector(axis)).minus(axis).maxAbs()).isLessThan(bound);
      }
    }
  }

  /** Rays rely on a transform and its inverse to agree in hierarchies of any depth. */
  @Test
  void deepHierarchiesHaveMatchingInverses() {
    Transform t = Transform.IDENTITY;
    for (int level = 0; level < 2000; level++) {
      t = t.times(rigid());
      Vec3 v = inCube(random, 1);
      assertThat(t.inverseVector(t.vector(v)).minus(v).maxAbs()).isLessThan(16 * EPS);
    }
  }

  @Test
  void quarterTurnsFollowTheConventionExactly() {
    assertThat(exact(rotation(90, 0, 0).vector(Vec3.Z))).isEqualTo(new Vec3(0, -1, 0));
    assertThat(exact(rotation(90, 0, 0).vector(Vec3.Y))).isEqualTo(new Vec3(0, 0, 1));
    assertThat(exact(rotation(0, 90, 0).vector(Vec3.Z))).isEqualTo(new Vec3(1, 0, 0));
    assertThat(exact(rotation(0, 90, 0).vector(Vec3.X))).isEqualTo(new Vec3(0, 0, -1));
    assertThat(exact(rotation(0, 0, 90).vector(Vec3.X))).isEqualTo(new Vec3(0, 1, 0));
    assertThat(exact(rotation(0, 0, 90).vector(Vec3.Y))).isEqualTo(new Vec3(-1, 0, 0));
    assertThat(exact(rotation(-270, 720, 360).vector(Vec3.Z))).isEqualTo(new Vec3(0, -1, 0));
  }

  /** Makes negative zeros positive. */
  private static Vec3 exact(Vec3 v) {
    return v.plus(Vec3.ZERO);
  }

  @Test
  void rotationTurnsAboutZThenXThenY() {
    // About z: x goes to y. About x: y goes to z. About y: z goes to x.
    assertThat(exact(rotation(90, 90, 90).vector(Vec3.X))).isEqualTo(Vec3.X);
    // In the other order, the rotation about y would first take x to -z.
    assertThat(exact(rotation(90, 90, 90).vector(Vec3.Y))).isEqualTo(new Vec3(0, 0, 1));
    for (int i = 0; i < 1000; i++) {
      Vec3 a = inCube(random, 360);
      Transform all = Transform.rotationDegrees(a);
      Transform steps = rotation(0, a.y(), 0).times(rotation(a.x(), 0, 0));
      steps = steps.times(rotation(0, 0, a.z()));
      Vec3 v = inCube(random, 1);
      assertThat(all.vector(v).minus(steps.vector(v)).maxAbs()).isLessThan(8 * EPS);
    }
  }

  @Test
  void rotationsFollowTheirMatrices() {
    double c = .5;
    double s = Math.sqrt(.75);
    Vec3 v = new Vec3(2, 3, 5);
    assertClose(rotation(60, 0, 0).vector(v), new Vec3(2, 3 * c - 5 * s, 3 * s + 5 * c));
    assertClose(rotation(0, 60, 0).vector(v), new Vec3(2 * c + 5 * s, 3, -2 * s + 5 * c));
    assertClose(rotation(0, 0, 60).vector(v), new Vec3(2 * c - 3 * s, 2 * s + 3 * c, 5));
  }

  private static void assertClose(Vec3 actual, Vec3 expected) {
    assertThat(actual.minus(expected).maxAbs()).isLessThan(16 * EPS);
  }

  @Test
  void productAppliesTheInnerMapFirst() {
    Transform t = Transform.translation(Vec3.X).times(Transform.scale(new Vec3(2, 3, 4)));
    assertThat(t.point(new Vec3(1, 1, 1))).isEqualTo(new Vec3(3, 3, 4));
    assertThat(t.vector(new Vec3(1, 1, 1))).isEqualTo(new Vec3(2, 3, 4));
    assertThat(t.inversePoint(new Vec3(3, 3, 4))).isEqualTo(new Vec3(1, 1, 1));
  }

  @ParameterizedTest
  @ValueSource(ints = {4, 40, 1000, 10_000, 100_000})
  void longChainThatUndoesItselfIsTheIdentity(int depth) {
    Transform chain = Transform.IDENTITY;
    for (int i = 0; i < depth / 4; i++) {
      Vec3 offset = inCube(random, 1);
      double angle = random.nextDouble(-180, 180);
      chain = chain.times(Transform.translation(offset)).times(rotation(0, angle, 0));
      chain = chain.times(rotation(0, -angle, 0)).times(Transform.translation(offset.negated()));
    }
    double bound = depth * 8 * EPS;
    for (int i = 0; i < 100; i++) {
      Vec3 p = inCube(random, 1);
      assertThat(chain.point(p).minus(p).maxAbs()).isLessThan(bound);
      assertThat(chain.inversePoint(p).minus(p).maxAbs()).isLessThan(bound);
    }
  }

  /** Quarter turns are exact, and so is a chain of any number of them. */
  @ParameterizedTest
  @ValueSource(ints = {1, 10, 1000, 10_000})
  void chainsOfQuarterTurnsAreExact(int depth) {
    for (int quarters = 1; quarters < 4; quarters++) {
      Transform chain = Transform.IDENTITY;
      for (int i = 0; i < depth; i++) {
        chain = chain.times(rotation(0, 90 * quarters, 0));
      }
      Transform once = rotation(0, 90.0 * (depth * quarters % 4), 0);
      for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
        assertThat(exact(chain.vector(axis))).isEqualTo(exact(once.vector(axis)));
        assertThat(exact(chain.inverseVector(axis))).isEqualTo(exact(once.inverseVector(axis)));
      }
    }
  }

  /**
   * A rotation divided into 1,000 or 10,000 levels equals the whole rotation, to a few ulp per
   * level.
   */
  @ParameterizedTest
  @ValueSource(ints = {10, 1000, 10_000})
  void chainsOfSmallTurnsAreTheWholeTurn(int depth) {
    for (double whole : new double[] {90, 180, 270, 77}) {
      Transform chain = Transform.IDENTITY;
      for (int i = 0; i < depth; i++) {
        chain = chain.times(rotation(0, whole / depth, 0));
      }
      for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
        Vec3 off = chain.vector(axis).minus(rotation(0, whole, 0).vector(axis));
        assertThat(off.maxAbs()).isLessThan(depth * 8 * EPS);
      }
    }
  }

  @Test
  void shearsOfScalesAndTurnsAreThoseOfFiftyDigits() {
    for (int i = 0; i < Effort.count(60, 10_000); i++) {
      Vec3 outer = new Vec3(decades(3), decades(3), decades(3));
      Vec3 angles = inCube(random, 360);
      Vec3 inner = new Vec3(decades(3), decades(3), decades(3));
      Transform t =
          Transform.scale(outer)
              .times(Transform.rotationDegrees(angles))
              .times(Transform.scale(inner));
      BigDecimal[][] exactly = Exactly.sheared(outer, angles, inner);
      double condition = condition(t);
      Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
      BigDecimal[][] inverse = Exactly.inverse(exactly);
      double size = outer.maxAbs() * inner.maxAbs();
      double inverseSize = Exactly.largest(inverse);
      for (int column = 0; column < 3; column++) {
        for (int row = 0; row < 3; row++) {
          double there = Exactly.difference(t.vector(axes[column]).get(row), exactly[row][column]);
          double back =
              Exactly.difference(t.inverseVector(axes[column]).get(row), inverse[row][column]);
          assertThat(there).isLessThanOrEqualTo(64 * EPS * size);
          assertThat(back).isLessThanOrEqualTo(64 * EPS * inverseSize * condition);
        }
      }
    }
  }

  private static double condition(Transform t) {
    double norm = 0;
    double inverseNorm = 0;
    for (Vec3 axis : new Vec3[] {Vec3.X, Vec3.Y, Vec3.Z}) {
      norm += t.vector(axis).lengthSquared();
      inverseNorm += t.inverseVector(axis).lengthSquared();
    }
    return Math.sqrt(norm * inverseNorm);
  }

  /** Matrices with 50 digits of precision. */
  private static final class Exactly {
    private static final MathContext DIGITS = new MathContext(50);
    private static final BigDecimal PI =
        new BigDecimal("3.14159265358979323846264338327950288419716939937510582097494");

    static BigDecimal[][] sheared(Vec3 outer, Vec3 degrees, Vec3 inner) {
      BigDecimal[][] turned =
          product(product(turn(1, degrees.y()), turn(0, degrees.x())), turn(2, degrees.z()));
      return product(product(diagonal(outer), turned), diagonal(inner));
    }

    /** Returns the rotation about an axis that takes the next axis to the one after it. */
    private static BigDecimal[][] turn(int axis, double degrees) {
      BigDecimal angle =
          new BigDecimal(degrees).multiply(PI).divide(BigDecimal.valueOf(180), DIGITS);
      BigDecimal cos = series(angle, 0);
      BigDecimal sin = series(angle, 1);
      int next = (axis + 1) % 3;
      int last = (axis + 2) % 3;
      BigDecimal[][] m = diagonal(new Vec3(1, 1, 1));
      m[next][next] = cos;
      m[last][last] = cos;
      m[last][next] = sin;
      m[next][last] = sin.negate();
      return m;
    }

    /** Returns the sum of (-1)^k x^(2k+first) / (2k+first)!, which is the cosine or the sine. */
    private static BigDecimal series(BigDecimal x, int first) {
      BigDecimal term = first == 0 ? BigDecimal.ONE : x;
      BigDecimal sum = BigDecimal.ZERO;
      for (int n = first; n < 100; n += 2) {
        sum = sum.add(term, DIGITS);
        BigDecimal divisor = BigDecimal.valueOf(-(n + 1L) * (n + 2L));
        term = term.multiply(x, DIGITS).multiply(x, DIGITS).divide(divisor, DIGITS);
      }
      return sum;
    }

    private static BigDecimal[][] diagonal(Vec3 v) {
      BigDecimal[][] m = new BigDecimal[3][3];
      for (int i = 0; i < 9; i++) {
        m[i / 3][i % 3] = i % 4 == 0 ? new BigDecimal(v.get(i / 3)) : BigDecimal.ZERO;
      }
      return m;
    }

    private static BigDecimal[][] product(BigDecimal[][] a, BigDecimal[][] b) {
      BigDecimal[][] m = new BigDecimal[3][3];
      for (int i = 0; i < 9; i++) {
        m[i / 3][i % 3] = BigDecimal.ZERO;
        for (int k = 0; k < 3; k++) {
          m[i / 3][i % 3] = m[i / 3][i % 3].add(a[i / 3][k].multiply(b[k][i % 3]), DIGITS);
        }
      }
      return m;
    }

    /** Returns the cofactors divided by the determinant. */
    static BigDecimal[][] inverse(BigDecimal[][] a) {
      BigDecimal[][] m = new BigDecimal[3][3];
      for (int i = 0; i < 9; i++) {
        int r = (i % 3 + 1) % 3;
        int s = (i % 3 + 2) % 3;
        int c = (i / 3 + 1) % 3;
        int d = (i / 3 + 2) % 3;
        m[i / 3][i % 3] = a[r][c].multiply(a[s][d]).subtract(a[r][d].multiply(a[s][c]));
      }
      BigDecimal determinant = BigDecimal.ZERO;
      for (int k = 0; k < 3; k++) {
        determinant = determinant.add(a[0][k].multiply(m[k][0]));
      }
      for (int i = 0; i < 9; i++) {
        m[i / 3][i % 3] = m[i / 3][i % 3].divide(determinant, DIGITS);
      }
      return m;
    }

    static double largest(BigDecimal[][] m) {
      double largest = 0;
      for (int i = 0; i < 9; i++) {
        largest = Math.max(largest, Math.abs(m[i / 3][i % 3].doubleValue()));
      }
      return largest;
    }

    static double difference(double found, BigDecimal expected) {
      return new BigDecimal(found).subtract(expected).abs().doubleValue();
    }
  }

  @Test
  void normalsStayAtRightAnglesToTheSurface() {
    for (int i = 0; i < 10_000; i++) {
      Vec3 scale = new Vec3(decades(3), decades(3), decades(3));
      Transform t = rigid().times(Transform.scale(scale));
      Frame frame = Frame.around(inCube(random, 1).normalized());
      Vec3 normal = t.normal(frame.normal());
      Vec3 tangent = t.vector(frame.tangent());
      assertThat(normal.length()).isCloseTo(1, within(4 * EPS));
      // Their sum is the tangent's length times the error of each factor.
      double error = 64 * EPS * scale.maxAbs();
      assertThat(normal.dot(tangent)).isCloseTo(0, within(error));
    }
  }

  @Test
  void normalOfAnEllipsoidIsItsGradient() {
    Vec3 scale = new Vec3(1e-3, 1, 1e3);
    Transform t = Transform.scale(scale);
    for (int i = 0; i < 1000; i++) {
      Vec3 onSphere = inCube(random, 1).normalized();
      Vec3 gradient =
          new Vec3(onSphere.x() / scale.x(), onSphere.y() / scale.y(), onSphere.z() / scale.z());
      assertThat(t.normal(onSphere).minus(gradient.normalized()).maxAbs()).isLessThan(8 * EPS);
    }
  }

  @Test
  void outsideStaysOutsideInMirrors() {
    Transform mirror = Transform.scale(new Vec3(-1, 1, 1));
    assertThat(mirror.isMirroring()).isTrue();
    assertThat(exact(mirror.normal(Vec3.X))).isEqualTo(new Vec3(-1, 0, 0));
    assertThat(exact(mirror.normal(Vec3.Y))).isEqualTo(Vec3.Y);
    assertThat(Transform.scale(new Vec3(-1, -1, 1)).isMirroring()).isFalse();
    for (int i = 0; i < 1000; i++) {
      Transform t = rigid().times(Transform.scale(new Vec3(-decades(1), decades(1), decades(1))));
      Vec3 outward = inCube(random, 1).normalized();
      assertThat(t.normal(outward).dot(t.vector(outward))).isPositive();
    }
  }

  @Test
  void powersOfTwoScaleExactly() {
    for (int exponent = -30; exponent <= 30; exponent++) {
      double s = Math.scalb(1.0, exponent);
      Transform inner = rigid().times(Transform.scale(new Vec3(decades(2), decades(2), 1)));
      Transform outer = Transform.scale(new Vec3(s, s, s)).times(inner);
      Vec3 p = inCube(random, 5);
      assertThat(outer.point(p)).isEqualTo(inner.point(p).times(s));
      assertThat(outer.inversePoint(p.times(s))).isEqualTo(inner.inversePoint(p));
      assertThat(outer.normal(p)).isEqualTo(inner.normal(p));
    }
  }

  @Test
  void mapsThatCannotBeUndoneAreKnown() {
    assertThat(Transform.IDENTITY.isInvertible()).isTrue();
    assertThat(scale(1e-90, 1e-90, 1e-90).isInvertible()).isTrue();
    assertThat(scale(1e90, 1e90, 1e90).isInvertible()).isTrue();
    assertThat(scale(0, 1, 1).isInvertible()).isFalse();
    assertThat(scale(0, 0, 0).isInvertible()).isFalse();
    assertThat(scale(1e200, 1e200, 1).isInvertible()).isFalse();
    assertThat(scale(1e-200, 1e-200, 1).isInvertible()).isFalse();
    assertThat(scale(1e-320, 1, 1).isInvertible()).isFalse();
    assertThat(scale(Double.NaN, 1, 1).isInvertible()).isFalse();
    assertThat(Transform.translation(new Vec3(0, 1 / 0.0, 0)).isInvertible()).isFalse();
    for (int i = 0; i < 1000; i++) {
      Transform inner = rigid().times(scale(decades(3), decades(3), decades(3)));
      assertThat(rigid().times(scale(1, 0, 1)).times(inner).isInvertible()).isFalse();
      assertThat(rigid().times(scale(1, 1e-8, 1e4)).times(inner).isInvertible()).isTrue();
    }
  }

  private static Transform scale(double x, double y, double z) {
    return Transform.scale(new Vec3(x, y, z));
  }

  @Test
  void boxAroundTheImageHoldsTheImageAndTouchesIt() {
    for (int i = 0; i < 1000; i++) {
      Transform t = rigid().times(Transform.scale(inCube(random, 3)));
      Bounds3 local = Bounds3.of(inCube(random, 1), inCube(random, 1));
      Bounds3 world = t.bounds(local);
      Bounds3 corners = Bounds3.EMPTY;
      for (int corner = 0; corner < 8; corner++) {
        corners = corners.union(t.point(local.corner(corner)));
      }
      assertThat(world).isEqualTo(corners);
      Vec3 inside = t.point(local.center());
      assertThat(world.union(inside)).isEqualTo(world);
    }
  }

  /**
   * A transform whose nine numbers and translation differ by orders of magnitude, so that each
   * matters at some points.
   */
  private Transform uneven() {
    Transform turned = rigid().times(Transform.scale(new Vec3(decades(3), decades(3), decades(3))));
    return Transform.translation(inCube(random, decades(4))).times(turned).times(rigid());
  }

  private Vec3 unevenPoint() {
    return new Vec3(decades(4) * sign(), decades(4) * sign(), decades(4) * sign());
  }

  private double sign() {
    return random.nextBoolean() ? 1 : -1;
  }

  @Test
  void coordinatesOneByOneAreThoseOfTheVectors() {
    for (int i = 0; i < 200; i++) {
      Transform t = uneven();
      Vec3 p = unevenPoint();
      Vec3 local = t.inversePoint(p);
      assertThat(t.inversePointX(p.x(), p.y(), p.z())).isEqualTo(local.x());
      assertThat(t.inversePointY(p.x(), p.y(), p.z())).isEqualTo(local.y());
      assertThat(t.inversePointZ(p.x(), p.y(), p.z())).isEqualTo(local.z());
      Vec3 direction = t.inverseVector(p);
      assertThat(t.inverseVectorX(p.x(), p.y(), p.z())).isEqualTo(direction.x());
      assertThat(t.inverseVectorY(p.x(), p.y(), p.z())).isEqualTo(direction.y());
      assertThat(t.inverseVectorZ(p.x(), p.y(), p.z())).isEqualTo(direction.z());
      assertThat(t.pointInPlane(p.x(), p.z())).isEqualTo(t.point(new Vec3(p.x(), 0, p.z())));
    }
  }

  @Test
  void inversePointUndoesPoint() {
    for (int i = 0; i < 200; i++) {
      Transform t = rigid();
      Vec3 p = inCube(random, 10);
      assertThat(t.inversePoint(t.point(p)).minus(p).maxAbs()).isLessThan(1e-13);
    }
  }

  /** Returns the sum of the absolute terms of a point's coordinate along a normal. */
  private static double termsOfPoint(Transform t, Vec3 p, Vec3 normal) {
    Vec3 translation = t.point(Vec3.ZERO);
    double sum = 0;
    for (int row = 0; row < 3; row++) {
      double terms =
          Math.abs(t.vector(Vec3.X).get(row) * p.x())
              + Math.abs(t.vector(Vec3.Y).get(row) * p.y())
              + Math.abs(t.vector(Vec3.Z).get(row) * p.z())
              + Math.abs(translation.get(row));
      sum += Math.abs(normal.get(row)) * terms;
    }
    return sum;
  }

  /** The bound is a few ulp of the terms, which covers their rounding with a small margin. */
  @Test
  void pointErrorIsAFewUlpOfItsTerms() {
    for (int i = 0; i < 2000; i++) {
      Transform t = uneven();
      Vec3 p = unevenPoint();
      Vec3 normal = unevenPoint().normalized();
      double terms = termsOfPoint(t, p, normal);
      assertThat(t.pointError(p, normal)).isBetween(31.9 * EPS * terms, 32.1 * EPS * terms);
    }
  }

  /** The bound of mapping to local space and back is a few ulp of its terms. */
  @Test
  void mappingErrorIsAFewUlpOfItsTerms() {
    Vec3[] axes = {Vec3.X, Vec3.Y, Vec3.Z};
    for (int i = 0; i < 2000; i++) {
      Transform t = uneven();
      Vec3 p = unevenPoint();
      Vec3 normal = unevenPoint().normalized();
      Vec3 offset = p.minus(t.point(Vec3.ZERO));
      double terms = 0;
      for (int row = 0; row < 3; row++) {
        for (int middle = 0; middle < 3; middle++) {
          double into = 0;
          for (int column = 0; column < 3; column++) {
            into += Math.abs(t.inverseVector(axes[column]).get(middle) * offset.get(column));
          }
          terms += Math.abs(normal.get(row) * t.vector(axes[middle]).get(row)) * into;
        }
      }
      assertThat(t.mappingError(p, normal)).isBetween(31.9 * EPS * terms, 32.1 * EPS * terms);
    }
  }

  @Test
  void eachPairOfAxesCanBeSkewed() {
    assertThat(Transform.scale(new Vec3(2, 1, 1)).times(rotation(0, 0, 45)).isSkewed()).isTrue();
    assertThat(Transform.scale(new Vec3(1, 2, 1)).times(rotation(45, 0, 0)).isSkewed()).isTrue();
    assertThat(Transform.scale(new Vec3(1, 1, 2)).times(rotation(0, 45, 0)).isSkewed()).isTrue();
    for (int i = 0; i < 1000; i++) {
      Vec3 scale = new Vec3(decades(5), decades(5), -decades(5));
      assertThat(rigid().times(Transform.scale(scale)).isSkewed()).isFalse();
    }
  }

  /** Skew depends on angles only, not on the lengths of the axes. */
  @Test
  void skewOfShortAndLongAxesIsSeen() {
    for (double size : new double[] {1e-6, 1, 1e6}) {
      Transform small = Transform.scale(new Vec3(size, size, size));
      Transform skew = Transform.scale(new Vec3(1 + 1e-9, 1, 1)).times(rotation(0, 0, 45));
      assertThat(small.times(skew).isSkewed()).isTrue();
      assertThat(small.times(rotation(20, 30, 45)).isSkewed()).isFalse();
    }
  }

  /** A transform with any number that is not finite is not invertible. */
  @Test
  void everyNumberMustBeFinite() {
    for (int axis = 0; axis < 3; axis++) {
      Vec3 far = new Vec3(axis == 0 ? NAN : 1, axis == 1 ? NAN : 1, axis == 2 ? NAN : 1);
      assertThat(Transform.translation(far).isInvertible()).isFalse();
      assertThat(Transform.scale(far).isInvertible()).isFalse();
    }
    assertThat(Transform.scale(new Vec3(1e-200, 1e200, 1)).isInvertible()).isTrue();
    assertThat(Transform.scale(new Vec3(1e-320, 1, 1)).isInvertible()).isFalse();
    assertThat(rigid().isInvertible()).isTrue();
  }

  private static final double NAN = Double.NaN;

  @Test
  void determinantIsTheFactorOfVolumesWithItsSign() {
    for (int i = 0; i < 200; i++) {
      Transform t = rigid().times(Transform.scale(inCube(random, 3))).times(rigid());
      double volume = t.vector(Vec3.X).cross(t.vector(Vec3.Y)).dot(t.vector(Vec3.Z));
      assertThat(t.determinant()).isCloseTo(volume, within(1e-12 * (1 + Math.abs(volume))));
      assertThat(t.isMirroring()).isEqualTo(volume < 0);
    }
    assertThat(Transform.scale(new Vec3(0, 1, 1)).isMirroring()).isFalse();
  }
}
