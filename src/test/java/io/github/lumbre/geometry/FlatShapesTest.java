package io.github.lumbre.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.testing.Effort;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests hits, borders and sides of planes and rectangles. */
class FlatShapesTest {
  private static final Rectangle RECTANGLE = new Rectangle(Transform.IDENTITY, 2, 4, false);
  private static final Rectangle TWO_SIDED = new Rectangle(Transform.IDENTITY, 2, 4, true);
  private static final Plane PLANE = new Plane(Transform.IDENTITY, false);
  private static final Plane SOLID_PLANE = new Plane(Transform.IDENTITY, true);
  private static final Vec3 DOWN = Vec3.Y.negated();

  @Test
  void oneWaySurfacesLetRaysFromBehindPass() {
    Ray fromFront = new Ray(new Vec3(.5, 2, 1), DOWN);
    Ray fromBehind = new Ray(new Vec3(.5, -2, 1), Vec3.Y);
    for (Shape shape : new Shape[] {RECTANGLE, PLANE}) {
      assertThat(Shapes.distance(shape, fromFront)).isEqualTo(2);
      assertThat(Shapes.distance(shape, fromBehind)).isNaN();
    }
    for (Shape shape : new Shape[] {TWO_SIDED, SOLID_PLANE}) {
      assertThat(Shapes.distance(shape, fromFront)).isEqualTo(2);
      assertThat(Shapes.distance(shape, fromBehind)).isEqualTo(2);
      assertThat(Shapes.hit(shape, fromBehind).orElseThrow().geometricNormal()).isEqualTo(Vec3.Y);
    }
  }

  @Test
  void mirroredPlanesKeepTheirFront() {
    Random random = new Random(1);
    for (int i = 0; i < 1000; i++) {
      Transform place = Shapes.placement(random, 1, 3).times(Transform.scale(new Vec3(-1, 1, 1)));
      Rectangle rectangle = new Rectangle(place, 1, 1, false);
      Vec3 front = place.point(Vec3.Y);
      Vec3 back = place.point(DOWN);
      Vec3 center = place.point(Vec3.ZERO);
      SurfaceHit hit = Shapes.hit(rectangle, new Ray(front, center.minus(front))).orElseThrow();
      assertThat(hit.geometricNormal().dot(front.minus(center))).isPositive();
      assertThat(Shapes.distance(rectangle, new Ray(back, center.minus(back)))).isNaN();
    }
  }

  @Test
  void bordersAreInclusive() {
    assertThat(Shapes.distance(RECTANGLE, new Ray(new Vec3(1, 1, 2), DOWN))).isEqualTo(1);
    assertThat(Shapes.distance(RECTANGLE, new Ray(new Vec3(-1, 1, -2), DOWN))).isEqualTo(1);
    assertThat(Shapes.distance(RECTANGLE, new Ray(new Vec3(Math.nextUp(1.0), 1, 0), DOWN))).isNaN();
    assertThat(Shapes.distance(RECTANGLE, new Ray(new Vec3(0, 1, Math.nextUp(2.0)), DOWN))).isNaN();
  }

  @Test
  void raysInTheSurfaceMissIt() {
    for (Shape shape : new Shape[] {RECTANGLE, TWO_SIDED, PLANE, SOLID_PLANE}) {
      assertThat(Shapes.distance(shape, new Ray(new Vec3(-5, 0, 0), Vec3.X))).isNaN();
      assertThat(Shapes.distance(shape, new Ray(new Vec3(-5, 0, 0), new Vec3(1, -0.0, 0)))).isNaN();
      assertThat(Shapes.distance(shape, new Ray(Vec3.ZERO, DOWN))).isNaN();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-1, 1e-5, 1e-10, 1e-15})
  void grazingRaysHitAtHeightOverCosine(double cos) {
    double sin = Math.sqrt((1 - cos) * (1 + cos));
    Ray ray = new Ray(Vec3.Y, new Vec3(sin, -cos, 0));
    SurfaceHit hit = Shapes.hit(PLANE, ray).orElseThrow();
    assertThat(Shapes.distance(PLANE, ray) * cos).isCloseTo(1, within(8 * 0x1p-52));
    assertThat(hit.position().y()).isEqualTo(0);
    assertThat(hit.texture().u()).isCloseTo(.1 * sin / cos, within(1e-14 / cos));
  }

  /** Grazing rays hit rotated surfaces to within a few ulp of the distance. */
  @ParameterizedTest
  @ValueSource(doubles = {1e-1, 1e-5, 1e-10, 1e-13, 1e-15})
  void grazingRaysHitOnTheSurface(double cos) {
    Random random = new Random(Effort.seed(3));
    double sin = Math.sqrt((1 - cos) * (1 + cos));
    double worstDistance = 0;
    double worstPosition = 0;
    for (int i = 0; i < Effort.brief(Effort.count(2000, 200_000)); i++) {
      Transform place = Shapes.rotation(random);
      Vec3 normal = place.normal(Vec3.Y);
      Vec3 along = place.vector(Vec3.X);
      Vec3 direction = along.times(sin).plus(-cos, normal);
      // Computed from the rounded coordinates of the ray, not from the intended ones.
      double height = normal.dot(normal);
      double slope = -direction.dot(normal);
      Ray ray = new Ray(normal, direction);
      if (slope < .1 * cos) {
        continue;
      }
      for (Shape shape :
          new Shape[] {new Plane(place, false), new Rectangle(place, 1e17, 1e17, false)}) {
        double t = Shapes.distance(shape, ray);
        worstDistance = Math.max(worstDistance, Math.abs(t * slope / height - 1) * cos);
        double off = Shapes.hit(shape, ray).orElseThrow().position().dot(normal);
        worstPosition = Math.max(worstPosition, Math.abs(off) / (1 + t));
      }
    }
    assertThat(worstDistance).isBetween(1e-18, 8 * 0x1p-52);
    assertThat(worstPosition).isBetween(1e-18, 8 * 0x1p-52);
  }

  @Test
  void planesAreHitAndMappedFarAway() {
    for (double height : new double[] {1e12, 1e15, 1e100, 1e150}) {
      Vec3 origin = new Vec3(.25 * height, height, 0);
      SurfaceHit hit = Shapes.hit(PLANE, new Ray(origin, DOWN)).orElseThrow();
      assertThat(Shapes.distance(PLANE, new Ray(origin, DOWN))).isEqualTo(height);
      assertThat(hit.position()).isEqualTo(new Vec3(.25 * height, 0, 0));
      assertThat(hit.texture().u()).isEqualTo(.25 * height / 10);
      assertThat(hit.texture().v()).isZero();
    }
  }

  @Test
  void texturesAndFramesRunAsTheFormatSays() {
    SurfaceHit finite = Shapes.hit(RECTANGLE, new Ray(new Vec3(.5, 1, -1), DOWN)).orElseThrow();
    assertThat(finite.texture().u()).isEqualTo(.25);
    assertThat(finite.texture().v()).isEqualTo(.75);
    assertThat(finite.shading().tangent().x()).isEqualTo(-1);
    assertThat(finite.shading().bitangent().z()).isEqualTo(-1);
    SurfaceHit infinite = Shapes.hit(PLANE, new Ray(new Vec3(5, 1, -20), DOWN)).orElseThrow();
    assertThat(infinite.texture().u()).isEqualTo(.5);
    assertThat(infinite.texture().v()).isEqualTo(-2);
    assertThat(infinite.shading().tangent().x()).isEqualTo(1);
    assertThat(infinite.shading().bitangent().z()).isEqualTo(1);
  }

  @Test
  void infinitePlanesCannotBeSampled() {
    assertThatThrownBy(() -> PLANE.sample(Vec3.Y, new Point2(.5, .5)))
        .isInstanceOf(UnsupportedOperationException.class);
    assertThat(PLANE.bounds().isFinite()).isFalse();
  }

  @Test
  void impossibleSizesAreRejected() {
    for (double size : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 1e151}) {
      assertThatThrownBy(() -> new Rectangle(Transform.IDENTITY, size, 1, false))
          .isInstanceOf(IllegalArgumentException.class);
      assertThatThrownBy(() -> new Rectangle(Transform.IDENTITY, 1, size, false))
          .isInstanceOf(IllegalArgumentException.class);
      assertThatThrownBy(() -> new Box(Transform.IDENTITY, 1, size, 1))
          .isInstanceOf(IllegalArgumentException.class);
    }
  }
}
