package io.github.lumbre.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Box;
import io.github.lumbre.geometry.MeshInstance;
import io.github.lumbre.geometry.Plane;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Sphere;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.DirectionalLight;
import io.github.lumbre.light.Emission;
import io.github.lumbre.light.EnvironmentLight;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.SpotLight;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

class SceneBuilderTest {
  private static final Vec3 EYE = new Vec3(0, 1, -5);
  private static final Transform SIDE = Transform.translation(Vec3.X);

  private static SceneBuilder empty() {
    return Scene.builder().lookingAt(EYE, Vec3.ZERO, Lens.pinhole(40));
  }

  private static TriangleMesh triangle() {
    return TriangleMesh.of(
        new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
        new double[0],
        new double[0],
        new int[] {0, 1, 2});
  }

  @Test
  void unfinishedScenesSayWhatIsMissing() {
    assertThatIllegalStateException()
        .isThrownBy(() -> Scene.builder().add(Plane.floor(0), Matte.GRAY).build())
        .withMessage("camera: expected lookingAt or seenBy, found neither");
  }

  private static void assertRefused(ThrowingCallable call, String message) {
    assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
  }

  @Test
  void wrongArgumentsAreNamedWithTheirRange() {
    assertRefused(() -> Glass.of(0), "ior: expected a number in (0, 1000000], found 0.0");
    assertRefused(
        () -> Matte.of(1.5, 0, 0),
        "albedo: expected components from 0 to 1, found Rgb[r=1.5, g=0.0, b=0.0]");
    assertRefused(
        () -> Mirror.of(new Rgb(0, Double.NaN, 0)),
        "reflectance: expected components from 0 to 1, found Rgb[r=0.0, g=NaN, b=0.0]");
    assertRefused(
        () -> Glass.of(1.5).withRoughness(2),
        "roughness: expected a number from 0 to 1, found 2.0");
    assertRefused(
        () -> Phong.of(Rgb.BLACK, Rgb.WHITE, -1),
        "exponent: expected a finite number >= 0, found -1.0");
    assertRefused(
        () -> CookTorrance.of(Rgb.BLACK, Rgb.WHITE, Double.NaN),
        "roughness: expected a number from 0 to 1, found NaN");
    assertRefused(
        () -> Emission.of(Rgb.gray(-1)),
        "radiance: expected finite components >= 0, found Rgb[r=-1.0, g=-1.0, b=-1.0]");
    assertRefused(
        () -> Lens.pinhole(180), "fovDegrees: expected a number in (0, 180), found 180.0");
    assertRefused(
        () -> Lens.thinLens(40, 0, 1), "focusDistance: expected a finite number > 0, found 0.0");
    assertRefused(
        () -> Lens.fishEye(361), "angleDegrees: expected a number in (0, 360], found 361.0");
    assertRefused(() -> Lens.orthographic(0), "height: expected a finite number > 0, found 0.0");
    assertRefused(
        () -> Sphere.of(Vec3.ZERO, -1), "radius: expected a finite number > 0, found -1.0");
    assertRefused(
        () -> Box.of(new Vec3(0, Double.NaN, 0), Vec3.X),
        "center: expected finite numbers, found Vec3[x=0.0, y=NaN, z=0.0]");
    assertRefused(
        () -> Rectangle.facing(Vec3.ZERO, Vec3.ZERO, 1, 1),
        "normal: expected a finite vector other than 0, found Vec3[x=0.0, y=0.0, z=0.0]");
    assertRefused(
        () -> empty().lookingAt(EYE, EYE, Lens.pinhole(40)),
        "target: expected a point other than the eye " + EYE + ", found " + EYE);
    assertRefused(
        () -> empty().lookingAt(Vec3.Y, Vec3.ZERO, Lens.pinhole(40)),
        "up: expected a direction other than that of the view, found " + Vec3.Y);
    assertRefused(
        () -> DirectionalLight.along(Vec3.ZERO, Rgb.WHITE),
        "direction: expected a finite vector other than 0, found " + Vec3.ZERO);
    assertRefused(
        () -> empty().add("", Plane.floor(0), Matte.GRAY),
        "name: expected 1 to 60 characters, found 0");
    assertRefused(
        () -> empty().group("a", Transform.scale(Vec3.X), group -> {}),
        "transform: expected an invertible transform, found a singular one");
  }

  @Test
  void groupsMoveWhatTheyHold() {
    Scene scene =
        empty()
            .group(
                "outer",
                SIDE,
                outer ->
                    outer
                        .add("ball", Sphere.of(Vec3.ZERO, 1), Matte.GRAY)
                        .add(PointLight.of(Vec3.Y, Rgb.WHITE))
                        .group(
                            "inner",
                            SIDE,
                            inner ->
                                inner.add(SpotLight.lookingAt(Vec3.ZERO, Vec3.Z, Rgb.WHITE, 20))))
            .build();
    Sphere ball = (Sphere) scene.primitives().get(0).shape();
    assertThat(ball.toWorld().point(Vec3.ZERO)).isEqualTo(Vec3.X);
    assertThat(((PointLight) scene.lights().get(0)).position()).isEqualTo(new Vec3(1, 1, 0));
    SpotLight spot = (SpotLight) scene.lights().get(1);
    assertThat(spot.source().position()).isEqualTo(new Vec3(2, 0, 0));
    assertThat(spot.axis()).isEqualTo(Vec3.Z);
    assertThat(scene.names().object(0)).isEqualTo("ball");
  }

  @Test
  void groupsHoldNoCameraAndNoSky() {
    assertThatIllegalStateException()
        .isThrownBy(() -> empty().group("a", SIDE, g -> g.add(EnvironmentLight.uniform(Rgb.WHITE))))
        .withMessageContaining("environment light");
    assertThatIllegalStateException()
        .isThrownBy(
            () -> empty().group("a", SIDE, g -> g.lookingAt(EYE, Vec3.ZERO, Lens.pinhole(9))))
        .withMessageContaining("camera");
    assertThatIllegalStateException()
        .isThrownBy(() -> empty().group("a", SIDE, g -> {}).group("a", SIDE, g -> {}).build())
        .withMessage("groups: expected each name once, found \"a\" again");
  }

  @Test
  void namesAreUniqueAndMaterialsHaveOneName() {
    Matte red = Matte.of(1, 0, 0);
    Scene scene =
        empty()
            .name(red, "red")
            .add("ball", Sphere.of(Vec3.ZERO, 1), red)
            .add("ball", Sphere.of(Vec3.X, 1), red)
            .add(Plane.floor(-1), Matte.GRAY)
            .addAreaLight("lamp", Sphere.of(Vec3.Y, .1), Rgb.WHITE)
            .build();
    assertThat(scene.names().objects()).containsExactly("ball", "ball 2", "object 2", "lamp");
    assertThat(scene.names().materials()).containsExactly("red", "red", "material 2", "material 3");
  }

  @Test
  void scenesThatContinueAnotherShareWhatDoesNotMove() {
    MeshInstance mesh = MeshInstance.of(triangle());
    Scene first =
        empty()
            .add("still", Sphere.of(Vec3.ZERO, 1), Matte.GRAY)
            .group("arm", SIDE, arm -> arm.add("mesh", mesh, Matte.GRAY))
            .group("base", SIDE, base -> base.add("foot", Sphere.of(Vec3.Y, 1), Matte.GRAY))
            .build();
    Transform up = Transform.translation(Vec3.Y);
    Scene moved = first.toBuilder().place("arm", up).build();
    assertThat(moved.primitives().get(0).shape()).isSameAs(first.primitives().get(0).shape());
    assertThat(moved.primitives().get(2).shape()).isSameAs(first.primitives().get(2).shape());
    MeshInstance arm = (MeshInstance) moved.primitives().get(1).shape();
    assertThat(arm.shared()).isSameAs(mesh.shared());
    assertThat(arm.toWorld().point(Vec3.ZERO)).isEqualTo(Vec3.Y);
    assertThat(first.toBuilder().build().hierarchy()).isSameAs(first.hierarchy());
    assertThat(moved.hierarchy()).isNotSameAs(first.hierarchy());
    assertRefused(
        () -> first.toBuilder().place("leg", up),
        "group: expected one of [arm, base], found \"leg\"");
  }
}
