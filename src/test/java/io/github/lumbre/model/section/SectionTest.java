package io.github.lumbre.model.section;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.math.Bounds3;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.ModelOptions.Up;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Texts of sections become planes. */
class SectionTest {
  private static final Bounds3 BOUNDS = new Bounds3(new Vec3(-1, 0, 2), new Vec3(1, 10, 6));

  private static final Transform Z_UP =
      new ModelOptions(Optional.empty(), Optional.empty(), Up.Z, 2).toWorld();

  private static CutPlane plane(String text, Transform toWorld) {
    return Section.of(text).in(BOUNDS, toWorld);
  }

  @ParameterizedTest
  @CsvSource({
    "x=0.5, 0.5, 0, 0, 1, 0, 0",
    "+x=0.5, 0.5, 0, 0, 1, 0, 0",
    "-x=0.5, 0.5, 0, 0, -1, 0, 0",
    "y=25%, 0, 2.5, 0, 0, 1, 0",
    "z=-1e1, 0, 0, -10, 0, 0, 1",
    "-z=100%, 0, 0, 6, 0, 0, -1"
  })
  void axesArePlanes(String text, double x, double y, double z, double nx, double ny, double nz) {
    CutPlane plane = plane(text, Transform.IDENTITY);
    assertThat(plane.point()).isEqualTo(new Vec3(x, y, z));
    assertThat(plane.normal().minus(new Vec3(nx, ny, nz)).maxAbs()).isZero();
  }

  /** With z up, smaller y is in front. */
  @ParameterizedTest
  @CsvSource({"y=3, 0, 0, -6, 0, 0, 1", "+y=3, 0, 0, -6, 0, 0, -1", "z=1, 0, 2, 0, 0, 1, 0"})
  void axesAndUnitsAreThoseOfTheFile(
      String text, double x, double y, double z, double nx, double ny, double nz) {
    CutPlane plane = plane(text, Z_UP);
    assertThat(plane.point().minus(new Vec3(x, y, z)).maxAbs()).isZero();
    assertThat(plane.normal().minus(new Vec3(nx, ny, nz)).maxAbs()).isZero();
  }

  @Test
  void pointsAndNormalsArePlanes() {
    CutPlane plane = plane("50%,1,25%/0,-3e200,4e200", Transform.IDENTITY);
    assertThat(plane.point()).isEqualTo(new Vec3(0, 1, 3));
    assertThat(plane.normal().minus(new Vec3(0, -.6, .8)).maxAbs()).isLessThan(1e-15);
    assertThat(plane.side(new Vec3(0, 1, 4))).isPositive();
    assertThat(plane.side(new Vec3(0, 2, 3))).isNegative();
  }

  @ParameterizedTest
  @ValueSource(strings = {"x=0", "y=0", "z=0", "-y=0", "0,0,0/1,2,3", "0,0,0/-1,5,.1"})
  void axesInThePlaneAreRightHanded(String text) {
    CutPlane plane = plane(text, Transform.IDENTITY);
    assertThat(plane.right().cross(plane.up()).minus(plane.normal()).maxAbs()).isLessThan(1e-15);
    Vec3 point = plane.at(.25, -3);
    assertThat(plane.u(point)).isCloseTo(.25, org.assertj.core.api.Assertions.within(1e-14));
    assertThat(plane.v(point)).isCloseTo(-3, org.assertj.core.api.Assertions.within(1e-14));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "x",
        "x=",
        "w=1",
        "x=NaN",
        "x=1e999",
        "x=1 mm",
        "1,2/1,0,0",
        "1,2,3/0,0,0",
        "1,2,3",
        "1,2,3/1,0,0/1",
        "--x=1",
        "x=5%%",
        "x=1,2",
        "1,2,3/1%,0,0"
      })
  void otherTextsAreRefused(String text) {
    assertThatThrownBy(() -> Section.of(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "expected a plane such as x=0.5, y=50%, -z=2 or a point and a normal 0,0,1/1,1,0,"
                + " found "
                + text);
  }
}
