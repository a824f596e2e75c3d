package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.Rectangle;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.integrator.PathTracer;
import io.github.lumbre.integrator.RenderContext;
import io.github.lumbre.light.Emission;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.Unlit;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.IndependentSampler;
import io.github.lumbre.model.internal.ModelSurface.Emitter;
import io.github.lumbre.scene.SceneAssembly;
import io.github.lumbre.texture.Texture;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Emissive meshes that are divided give the same light with less noise. */
class EmissiveTrianglesTest {
  private static final int SIDE = 24;
  private static final int SAMPLES = 20_000;

  /** One of 64 squares of the texture is bright, one is dim, the others are black. */
  private static final Texture<Rgb> SPOTS =
      (u, v) -> Rgb.gray(u < .125 && v < .125 ? 64 : u > .875 && v > .875 ? 2 : 0);

  private static final Transform ABOVE =
      Transform.translation(new Vec3(0, 1, 0)).times(Transform.scale(new Vec3(4, 1, 6)));

  /** Returns a horizontal square from (-1/2, 0, -1/2), whose texture coordinates are x and z. */
  private static TriangleMesh ceiling() {
    double[] positions = new double[3 * (SIDE + 1) * (SIDE + 1)];
    double[] uvs = new double[2 * (SIDE + 1) * (SIDE + 1)];
    int[] indices = new int[6 * SIDE * SIDE];
    for (int i = 0; i < (SIDE + 1) * (SIDE + 1); i++) {
      uvs[2 * i] = i % (SIDE + 1) / (double) SIDE;
      uvs[2 * i + 1] = Math.floorDiv(i, SIDE + 1) / (double) SIDE;
      positions[3 * i] = uvs[2 * i] - .5;
      positions[3 * i + 2] = uvs[2 * i + 1] - .5;
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
      int corner = i + Math.floorDiv(i, SIDE);
      int[] two = {corner, corner + 1, corner + SIDE + 1, corner + 1, corner + SIDE + 2};
      System.arraycopy(two, 0, indices, 6 * i, 5);
      indices[6 * i + 5] = corner + SIDE + 1;
    }
    return TriangleMesh.of(positions, new double[0], uvs, indices);
  }

  private static List<Emitter> emitters(Texture<Rgb> radiance) {
    TriangleMesh mesh = ceiling();
    Emission emission = new Emission(radiance, true);
    return EmissiveTriangles.of(mesh, Mesh.baked(mesh, ABOVE), ABOVE, emission);
  }

  private static double power(Emitter emitter) {
    return emitter.shape().area() * emitter.emission().meanRadiance();
  }

  @Test
  void emittersHaveAllOfTheSurfaceAndItsPower() {
    List<Emitter> spots = emitters(SPOTS);
    assertThat(spots.stream().mapToDouble(e -> e.shape().area()).sum()).isCloseTo(24, within(1e-9));
    // Black triangles have 1/1000 of the mean radiance.
    assertThat(spots.stream().mapToDouble(EmissiveTrianglesTest::power).sum())
        .isCloseTo(24 * 66 / 64., within(.03));
  }

  @Test
  void bothSpotsAreEmittersOfTheirOwn() {
    List<Emitter> spots = emitters(SPOTS);
    assertThat(spots).hasSize(3);
    assertThat(spots.get(0).shape().bounds().max().x()).isCloseTo(-1.5, within(1e-9));
    assertThat(spots.get(0).emission().meanRadiance()).isCloseTo(64, within(1e-9));
    assertThat(spots.get(1).shape().bounds().min().z()).isCloseTo(2.25, within(1e-9));
    assertThat(spots.get(1).emission().meanRadiance()).isCloseTo(2, within(1e-9));
  }

  @Test
  void uniformMeshesAreDividedByPlace() {
    List<Emitter> all = emitters(Texture.constant(Rgb.WHITE));
    assertThat(all).hasSizeBetween(SIDE * SIDE / 16, SIDE * SIDE / 8);
    for (Emitter emitter : all) {
      assertThat(emitter.emission().meanRadiance()).isEqualTo(1);
      assertThat(emitter.shape().bounds().max().minus(emitter.shape().bounds().min()).maxAbs())
          .isLessThan(1.3);
    }
  }

  @Test
  void meshesThatSeemBlackStayWhole() {
    Texture<Rgb> fine = (u, v) -> u == .123 ? Rgb.WHITE : Rgb.BLACK;
    assertThat(emitters(fine)).hasSize(1);
    assertThat(emitters(Texture.constant(Rgb.BLACK))).hasSize(1);
  }

  @Test
  void textureBrighterThanNumbersIsNotDivided() {
    Texture<Rgb> infinite = (u, v) -> Rgb.gray(u < .5 ? Double.POSITIVE_INFINITY : 1);
    assertThat(emitters(infinite)).hasSize(1);
  }

  /** Returns mean and variance of the light that a floor below the ceiling reflects. */
  private static double[] light(List<Emitter> emitters) {
    SceneAssembly builder = new SceneAssembly(Lens.pinhole(60).camera(Vec3.ZERO, Frame.WORLD, 1));
    Shape floor = new Rectangle(Transform.IDENTITY, 100, 100, false);
    builder.add(floor, new Matte(Texture.constant(Rgb.gray(.5))));
    emitters.forEach(e -> builder.add(e.shape(), Unlit.INSTANCE, e.emission()));
    PathTracer tracer = new PathTracer(builder.build(), 1);
    IndependentSampler sampler = new IndependentSampler(7);
    RenderContext context = new RenderContext();
    Ray ray = new Ray(new Vec3(-1.5, .5, -2), Vec3.Y.negated());
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < SAMPLES; i++) {
      sampler.startSample(0, 0, i);
      context.startSample();
      double value = tracer.radiance(ray, sampler, context).g();
      sum += value;
      squares += value * value;
    }
    double mean = sum / SAMPLES;
    return new double[] {mean, squares / SAMPLES - mean * mean};
  }

  /**
   * The means differ by at most 4 standard errors; without the division they have a standard error
   * of about 2 %.
   */
  @Test
  void divisionKeepsTheLightAndReducesItsVariance() {
    TriangleMesh mesh = ceiling();
    Emitter whole = new Emitter(Mesh.baked(mesh, ABOVE), new Emission(SPOTS, true));
    double[] before = light(List.of(whole));
    double[] after = light(emitters(SPOTS));
    double error = Math.sqrt((before[1] + after[1]) / SAMPLES);
    assertThat(error).isLessThan(.03 * after[0]);
    assertThat(before[0]).isCloseTo(after[0], within(4 * error));
    assertThat(after[1]).isLessThan(before[1] / 10);
  }
}
