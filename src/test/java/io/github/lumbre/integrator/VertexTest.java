package io.github.lumbre.integrator;

import static io.github.lumbre.testing.TestScenes.empty;
import static io.github.lumbre.testing.TestScenes.glass;
import static io.github.lumbre.testing.TestScenes.matte;
import static io.github.lumbre.testing.TestScenes.point;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.light.Falloff;
import io.github.lumbre.light.LightSample;
import io.github.lumbre.light.PointLight;
import io.github.lumbre.light.internal.LightChoice;
import io.github.lumbre.light.internal.LightSampler;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.BsdfValue;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.UvMapping;
import io.github.lumbre.texture.internal.ImageTexture;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import io.github.lumbre.texture.internal.ImageTexture.Role;
import org.junit.jupiter.api.Test;

/**
 * Tests the directions of a vertex whose shading plane is tilted against its true surface: nothing
 * is scattered between different sides of the two.
 */
class VertexTest {
  /** Tilted by 45° from +y towards +x. */
  private static final Vec3 TILTED = new Vec3(1, 1, 0).normalized();

  private static final Glass ROUGH_GLASS =
      new Glass(
          Texture.constant(Rgb.WHITE),
          Texture.constant(Rgb.WHITE),
          ScalarTexture.constant(1.5),
          ScalarTexture.constant(.3));

  private static final double ABOVE = 1e-9;

  private final Vertex vertex = new Vertex();
  private final NearestHit hit = new NearestHit();
  private final BsdfValue value = new BsdfValue();

  /** Moves the vertex to the origin of the plane y = 0, seen from a direction. */
  private void lookFrom(Vec3 from, Material material) {
    double[] positions = {-9, 0, -9, 0, 0, 9, 9, 0, -9};
    double[] normals = new double[9];
    for (int i = 0; i < 9; i++) {
      normals[i] = TILTED.get(i % 3);
    }
    Mesh floor =
        Mesh.baked(
            TriangleMesh.of(positions, normals, new double[0], new int[] {0, 1, 2}),
            Transform.IDENTITY);
    Scene scene = empty().add(floor, material).build();
    assertThat(scene.intersect(new Ray(from.times(2), from.negated()), hit)).isTrue();
    vertex.moveTo(scene.surfaceAt(hit), material);
    assertThat(vertex.surface().position().length()).isLessThan(ABOVE);
  }

  private BsdfValue valueOf(Vec3 wi) {
    LightSample light = new LightSample();
    Vec3 lamp = wi.times(3);
    new PointLight(lamp, Rgb.WHITE, Falloff.INVERSE_SQUARE).sample(0, 0, 0, .5, .5, light);
    vertex.evaluate(light, value);
    return value;
  }

  private static Vec3 direction(double degrees) {
    double angle = Math.toRadians(degrees);
    return new Vec3(Math.sin(angle), Math.cos(angle), .01).normalized();
  }

  /** Angles are from +y towards +x: the true side is ±90°, the shading side is −45° to 135°. */
  @Test
  void lightMustBeOnOneSideOfBothPlanes() {
    for (double from : new double[] {-40, 0, 60, 85}) {
      lookFrom(direction(from), matte(.5));
      assertThat(vertex.surface().shadingNormal().minus(TILTED).length()).isLessThan(1e-12);
      assertThat(vertex.wo().z()).isCloseTo(direction(from).dot(TILTED), within(1e-12));
      for (double to = -178; to < 180; to += 4) {
        Vec3 wi = direction(to);
        double cosine = wi.dot(TILTED);
        boolean scatters = wi.y() > 0 && cosine > 0;
        assertThat(valueOf(wi).r()).isCloseTo(scatters ? .5 / Math.PI * cosine : 0, within(1e-9));
      }
      assertThat(valueOf(Vec3.X).r()).isZero();
    }
  }

  /** From behind the tilted plane, but in front of the true one, the true plane is shaded. */
  @Test
  void viewersBehindTheTiltedPlaneSeeTheTrueOne() {
    for (double from : new double[] {-50, -70, -85}) {
      lookFrom(direction(from), matte(.5));
      assertThat(vertex.surface().shadingNormal()).isEqualTo(Vec3.Y);
      assertThat(vertex.wo().z()).isCloseTo(direction(from).y(), within(1e-12));
      assertThat(valueOf(direction(-80)).r())
          .isCloseTo(.5 / Math.PI * direction(-80).y(), within(1e-12));
    }
  }

  @Test
  void sampledDirectionsAreOnOneSideOfBothPlanes() {
    BsdfSample sample = new BsdfSample();
    lookFrom(direction(20), matte(.5));
    int absorbed = 0;
    for (int i = 0; i < 400; i++) {
      vertex.sample(.5, (i / 20 + .5) / 20, (i % 20 + .5) / 20, sample);
      if (sample.isAbsorbed()) {
        absorbed++;
        continue;
      }
      Vec3 wi = sample.wi();
      assertThat(wi.y()).isPositive();
      assertThat(wi.dot(TILTED)).isCloseTo(sample.pdf() * Math.PI, within(1e-12));
    }
    // Of a cosine distribution around 45°, (1 − cos 45°) / 2 is below the horizon.
    assertThat(absorbed / 400.0).isCloseTo((1 - Math.sqrt(.5)) / 2, within(.02));
  }

  /** Glass passes light from one side of both planes to the other side of both. */
  @Test
  void glassScattersFromOneSideOfBothPlanesToEither() {
    BsdfSample sample = new BsdfSample();
    lookFrom(direction(20), glass(1.5));
    int below = 0;
    for (int i = 0; i < 100; i++) {
      vertex.sample((i + .5) / 100, .5, .5, sample);
      if (!sample.isAbsorbed()) {
        assertThat(sample.wi().y() * sample.wi().dot(TILTED)).isPositive();
        below += sample.wi().y() < 0 ? 1 : 0;
      }
    }
    assertThat(below).isBetween(90, 99);
  }

  /** A normal map of one texel tilts the shading plane by the angle of the texel. */
  @Test
  void normalMapsTiltTheShadingPlane() {
    Pixels texel = Pixels.of(1, 1, 3, new byte[] {(byte) 218, (byte) 128, (byte) 218});
    NormalMap map =
        new NormalMap(
            new ImageTexture(texel, Role.NORMAL, Filter.NEAREST), new UvMapping(0, 0, 1, 1), 1);
    lookFrom(direction(20), matte(.5));
    Vec3 before = vertex.surface().shadingNormal();
    lookFrom(direction(20), new NormalMapped(matte(.5), map));
    double cosine = vertex.surface().shadingNormal().dot(before);
    assertThat(Math.toDegrees(Math.acos(cosine))).isCloseTo(45, within(1.0));
  }

  /** Of two equal lights, opaque surfaces sample mostly the one on the viewer's side. */
  @Test
  void lightsAreSelectedForTheSidesThatScatter() {
    Scene lights = empty().add(point(TILTED.times(2), 1)).add(point(TILTED.times(-2), 1)).build();
    LightSampler sampler = LightSampler.over(lights.emitters());
    LightChoice choice = new LightChoice();
    for (boolean isFront : new boolean[] {true, false}) {
      lookFrom(direction(isFront ? 20 : 200), matte(.5));
      vertex.receiveFrom(choice);
      assertThat(choice.point().length()).isLessThan(ABOVE);
      sampler.choose(.5, choice);
      assertThat(sampler.probability(choice, isFront ? 0 : 1)).isGreaterThan(.9);
    }
    lookFrom(direction(20), ROUGH_GLASS);
    vertex.receiveFrom(choice);
    sampler.choose(.3, choice);
    assertThat(sampler.probability(choice, 0)).isCloseTo(.5, within(1e-6));
  }
}
