package io.github.lumbre.texture;

import static io.github.lumbre.testing.Draws.direction;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the normals that a normal map perturbs. */
class NormalMapTest {
  private static final double EPS = 0x1p-52;
  private static final TexturePoint POINT = new TexturePoint(.3, .6);

  private final SplittableRandom random = new SplittableRandom(59);

  private static Vec3 perturbed(Rgb normal, UvMapping mapping, double strength) {
    NormalMap map = new NormalMap(Texture.constant(normal), mapping, strength);
    return perturbed(map, Frame.WORLD, Vec3.Z).normal();
  }

  /** Returns the shading frame of a surface after a normal map is applied. */
  private static Frame perturbed(NormalMap map, Frame shading, Vec3 geometricNormal) {
    SurfaceHit hit =
        new SurfaceHit().set(Vec3.ZERO, geometricNormal, shading, POINT, geometricNormal, 0);
    new NormalMapped(Matte.GRAY, map).perturb(hit);
    return hit.shading();
  }

  private static UvMapping scaled(double x, double y) {
    return new UvMapping(.1, .2, x, y);
  }

  @Test
  void flatMapOfEightBitsChangesNothingAtAll() {
    Pixels pixels = Pixels.of(1, 1, 3, new byte[] {(byte) 128, (byte) 128, (byte) 255});
    for (Filter filter : Filter.values()) {
      NormalMap map =
          new NormalMap(new ImageTexture(pixels, Role.NORMAL, filter), UvMapping.IDENTITY, 1);
      Frame frame = Frame.around(direction(random));
      assertThat(perturbed(map, frame, frame.normal())).isEqualTo(frame);
    }
  }

  @Test
  void componentsFollowTangentBitangentAndNormal() {
    Vec3 normal = perturbed(new Rgb(.48, -.36, .8), UvMapping.IDENTITY, 1);
    assertThat(normal.minus(new Vec3(.48, -.36, .8)).length()).isLessThan(4 * EPS);
    // The components need not form a unit vector.
    assertThat(perturbed(new Rgb(.12, -.09, .2), UvMapping.IDENTITY, 1).minus(normal).length())
        .isLessThan(4 * EPS);
  }

  @Test
  void negativeScalesMirrorTheBumps() {
    Rgb tilt = new Rgb(.48, .36, .8);
    assertThat(perturbed(tilt, scaled(3, 2), 1).x()).isCloseTo(.48, within(4 * EPS));
    assertThat(perturbed(tilt, scaled(-3, 2), 1).x()).isCloseTo(-.48, within(4 * EPS));
    assertThat(perturbed(tilt, scaled(-3, 2), 1).y()).isCloseTo(.36, within(4 * EPS));
    assertThat(perturbed(tilt, scaled(3, -2), 1).y()).isCloseTo(-.36, within(4 * EPS));
  }

  @Test
  void mapsStretchedWithoutEndHaveNoSlopeThatWay() {
    Rgb tilt = new Rgb(.48, .36, .8);
    Vec3 alongV = perturbed(tilt, scaled(0, 2), 1);
    assertThat(alongV.x()).isZero();
    assertThat(alongV.y() / alongV.z()).isCloseTo(.45, within(4 * EPS));
    Vec3 alongU = perturbed(tilt, scaled(3, 0), 1);
    assertThat(alongU.x() / alongU.z()).isCloseTo(.6, within(4 * EPS));
    assertThat(alongU.y()).isZero();
  }

  @Test
  void valueIsTheMapsOwnBeforeMappingAndStrength() {
    Texture<Rgb> coordinates = (u, v) -> new Rgb(u, v, 1);
    NormalMap map = new NormalMap(coordinates, scaled(-3, 2), 5);
    assertThat(map.value(POINT)).isEqualTo(new Rgb(POINT.u(), POINT.v(), 1));
  }

  @Test
  void strengthMultipliesTheSlopes() {
    Rgb tilt = new Rgb(.3, .4, .5);
    assertThat(perturbed(tilt, UvMapping.IDENTITY, 0)).isEqualTo(Vec3.Z);
    for (double strength : new double[] {-1, .5, 2, 10}) {
      Vec3 normal = perturbed(tilt, UvMapping.IDENTITY, strength);
      assertThat(normal.x() / normal.z()).isCloseTo(.6 * strength, within(1e-14));
      assertThat(normal.y() / normal.z()).isCloseTo(.8 * strength, within(1e-14));
    }
    assertThatThrownBy(() -> perturbed(tilt, UvMapping.IDENTITY, Double.NaN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("strength");
  }

  @Test
  void normalsBelowTheHorizonAreBentBackToJustAbove() {
    Vec3 normal = perturbed(new Rgb(.8, 0, -.6), UvMapping.IDENTITY, 1);
    assertThat(normal.z()).isBetween(5e-4, 2e-3);
    assertThat(normal.x()).isGreaterThan(.99);
    // Straight down, no side is nearer than another.
    assertThat(perturbed(new Rgb(0, 0, -1), UvMapping.IDENTITY, 1)).isEqualTo(Vec3.Z);
    assertThat(perturbed(Rgb.BLACK, UvMapping.IDENTITY, 1)).isEqualTo(Vec3.Z);
  }

  @Test
  void wildMapsGiveFramesThatRiseAboveTheSurface() {
    for (int i = 0; i < 20_000; i++) {
      Vec3 geometric = direction(random);
      Vec3 shading = geometric.plus(.9, direction(random)).normalized();
      Vec3 n = i % 2 == 0 ? direction(random) : new Vec3(i % 3 - 1, i % 5 - 2, i % 7 - 3);
      NormalMap map =
          new NormalMap(
              Texture.constant(new Rgb(n.x(), n.y(), n.z())),
              UvMapping.IDENTITY,
              Math.pow(10, random.nextDouble(-308, 308)));
      Vec3 u = direction(random);
      Vec3 v = direction(random);
      Frame frame = Frame.around(shading, u, v);
      Frame perturbed = perturbed(map, frame, geometric);
      assertThat(perturbed.normal().dot(geometric)).isGreaterThan(9e-4);
      assertThat(perturbed.normal().length()).isCloseTo(1, within(4 * EPS));
      assertThat(perturbed.tangent().length()).isCloseTo(1, within(4 * EPS));
      assertThat(perturbed.bitangent().length()).isCloseTo(1, within(8 * EPS));
      assertThat(perturbed.tangent().dot(perturbed.normal())).isCloseTo(0, within(4 * EPS));
      assertThat(perturbed.bitangent().dot(perturbed.normal())).isCloseTo(0, within(4 * EPS));
      assertThat(perturbed.bitangent().dot(perturbed.tangent())).isCloseTo(0, within(4 * EPS));
    }
  }

  @Test
  void gentleBumpsKeepTheTangents() {
    Frame mirrored = new Frame(Vec3.X, Vec3.Y.negated(), Vec3.Z);
    for (Frame frame : new Frame[] {Frame.WORLD, mirrored}) {
      NormalMap map = new NormalMap(Texture.constant(new Rgb(.3, .2, .9)), UvMapping.IDENTITY, 1);
      Frame perturbed = perturbed(map, frame, Vec3.Z);
      assertThat(perturbed.tangent().dot(frame.tangent())).isGreaterThan(.9);
      assertThat(perturbed.bitangent().dot(frame.bitangent())).isGreaterThan(.9);
    }
  }
}
