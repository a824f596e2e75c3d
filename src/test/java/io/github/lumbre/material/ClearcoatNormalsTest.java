package io.github.lumbre.material;

import static io.github.lumbre.material.MaterialParameter.BASE_COLOR;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_NORMAL;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SPECULAR;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.internal.NormalChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A clear coat has the normals of the vertices or of its own map, not those of the base. */
class ClearcoatNormalsTest {
  private static final Vec3 SLOPE = new Vec3(.4, -.2, 1).normalized();
  private static final NormalMap BUMPS =
      new NormalMap(Texture.constant(new Rgb(SLOPE.x(), SLOPE.y(), SLOPE.z())), 1);
  private static final Vec3 WO = new Vec3(-.3, .1, 1).normalized();

  private final SplittableRandom random = new SplittableRandom(29);

  private static MetallicRoughness.Builder layered(Rgb color, double coat) {
    return MetallicRoughness.builder()
        .set(BASE_COLOR, color)
        .set(METALLIC, 0)
        .set(SPECULAR, ScalarChannel.of(0))
        .set(CLEARCOAT, coat)
        .set(CLEARCOAT_ROUGHNESS, ScalarChannel.of(.4));
  }

  private static SurfaceHit hit(Material material) {
    SurfaceHit hit =
        new SurfaceHit().set(Vec3.ZERO, Vec3.Z, Frame.WORLD, new TexturePoint(0, 0), WO, 0);
    material.perturb(hit);
    return hit;
  }

  /** Returns f·|cos| between two directions in world space. */
  private static Rgb value(Material material, Vec3 wi) {
    SurfaceHit hit = hit(material);
    return material.at(hit).evaluate(hit.toLocal(WO), hit.toLocal(wi)).f();
  }

  /** Returns a direction above the plane and above the slope. */
  private Vec3 above() {
    Vec3 wi = BsdfLaws.direction(random);
    return wi.z() > 0 && wi.dot(SLOPE) > 0 ? wi : above();
  }

  private void assertAlike(Material found, Material expected) {
    for (int i = 0; i < 100; i++) {
      Vec3 wi = above();
      assertThat(value(found, wi).r()).isCloseTo(value(expected, wi).r(), within(1e-9));
    }
  }

  @Test
  void bumpsOfTheBaseLeaveTheCoatSmooth() {
    Material smooth = layered(Rgb.BLACK, 1).build();
    assertAlike(new NormalMapped(smooth, BUMPS), smooth);
    assertAlike(new NormalMapped(smooth, BUMPS).simplified(), smooth);
    assertThat(hit(new NormalMapped(smooth, BUMPS)).shadingNormal()).isEqualTo(Vec3.Z);
  }

  @Test
  void bumpsOfTheBaseAreThoseOfASurfaceWithoutACoat() {
    Material bare = new NormalMapped(layered(Rgb.gray(.6), 0).build(), BUMPS);
    assertAlike(new NormalMapped(layered(Rgb.gray(.6), 1e-10).build(), BUMPS), bare);
    assertThat(hit(bare).shadingNormal().dot(SLOPE)).isCloseTo(1, within(1e-12));
  }

  @Test
  void bumpsOfTheCoatAreThoseOfASurfaceThatIsOnlyACoat() {
    Material reflection =
        MetallicRoughness.builder()
            .set(BASE_COLOR, Rgb.BLACK)
            .set(METALLIC, 0)
            .set(ROUGHNESS, .4)
            .build();
    Material coat =
        layered(Rgb.BLACK, 1).set(CLEARCOAT_NORMAL, new NormalChannel(BUMPS, 0)).build();
    assertAlike(coat, new NormalMapped(reflection, BUMPS));
    assertThat(coat.simplified()).isSameAs(coat);
  }

  @Test
  void bumpsOfTheCoatLeaveTheBaseSmooth() {
    Material bare = layered(Rgb.gray(.6), 0).build();
    assertAlike(
        layered(Rgb.gray(.6), 1e-10).set(CLEARCOAT_NORMAL, new NormalChannel(BUMPS, 0)).build(),
        bare);
  }

  @Test
  void samplesHaveTheWeightOfTheirDensity() {
    Material coat =
        layered(Rgb.gray(.6), 1).set(CLEARCOAT_NORMAL, new NormalChannel(BUMPS, 0)).build();
    for (Material material : new Material[] {coat, new NormalMapped(coat, BUMPS)}) {
      Bsdf bsdf = material.at(hit(material));
      BsdfLaws.assertWeightIsEvalOverPdf(bsdf, WO, 200, random, 1e-12);
      BsdfLaws.assertExtremesAreHarmless(bsdf);
      assertThat(BsdfLaws.sampledAlbedo(bsdf, WO, 20_000)).isBetween(.3, 1.);
    }
  }
}
