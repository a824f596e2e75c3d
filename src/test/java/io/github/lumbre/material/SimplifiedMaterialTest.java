package io.github.lumbre.material;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.texture.NormalMap;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import io.github.lumbre.texture.UvMapping;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests that simplified materials scatter as the original ones do. */
class SimplifiedMaterialTest {
  private static final Texture<Rgb> HALF = Texture.constant(Rgb.gray(.5));
  private static final Texture<Rgb> VARYING = (u, v) -> new Rgb(u, v, .1);
  private static final ScalarTexture ROUGH = ScalarTexture.constant(.3);
  private static final ScalarTexture INDEX = ScalarTexture.constant(1.5);
  private static final TexturePoint SOMEWHERE = new TexturePoint(.3, .7);

  private static List<Material> materials(Texture<Rgb> color, ScalarTexture number) {
    return List.of(
        new Matte(color),
        new Mirror(color),
        new Phong(color, HALF, number),
        new CookTorrance(color, HALF, number, INDEX, MicrofacetDistribution.BECKMANN),
        new Glass(color, HALF, INDEX, number));
  }

  @Test
  void whatIsUniformScattersByOneBsdfAsItDidBefore() {
    for (Material material : materials(HALF, ROUGH)) {
      Material simple = material.simplified();
      assertThat(simple.at(SOMEWHERE)).isEqualTo(material.at(SOMEWHERE));
      assertThat(simple.at(SOMEWHERE)).isSameAs(simple.at(new TexturePoint(.9, .1)));
    }
  }

  @Test
  void onlyEvenMirrorsHaveAReflectance() {
    Material mirror = new Mirror(HALF);
    assertThat(mirror.mirrorReflectance()).contains(Rgb.gray(.5));
    assertThat(mirror.simplified().mirrorReflectance()).contains(Rgb.gray(.5));
    assertThat(new Mirror(Texture.constant(Rgb.gray(2))).mirrorReflectance()).contains(Rgb.WHITE);
    assertThat(new Mirror(VARYING).mirrorReflectance()).isEmpty();
    NormalMap flat = new NormalMap(Texture.constant(new Rgb(.5, .5, 1)), UvMapping.IDENTITY, 1);
    assertThat(new NormalMapped(mirror, flat).mirrorReflectance()).isEmpty();
    assertThat(new NormalMapped(mirror, flat).simplified().mirrorReflectance()).isEmpty();
    for (Material other : materials(HALF, ROUGH)) {
      assertThat(other.mirrorReflectance().isPresent()).isEqualTo(other instanceof Mirror);
    }
  }

  @Test
  void whatVariesStaysAsItIs() {
    for (Material material : materials(VARYING, ROUGH)) {
      assertThat(material.simplified()).isSameAs(material);
    }
    for (Material material : materials(HALF, (u, v) -> u).subList(2, 5)) {
      assertThat(material.simplified()).isSameAs(material);
    }
  }

  /** Each color and number of a material varies in turn, while all others are constant. */
  @Test
  void oneTextureThatVariesMakesAMaterialVary() {
    ScalarTexture number = (u, v) -> u;
    MicrofacetDistribution kind = MicrofacetDistribution.GGX;
    for (Material material :
        List.of(
            new Phong(HALF, VARYING, ROUGH),
            new CookTorrance(HALF, VARYING, ROUGH, INDEX, kind),
            new CookTorrance(HALF, HALF, ROUGH, number, kind),
            new Glass(HALF, VARYING, INDEX, ROUGH),
            new Glass(HALF, HALF, number, ROUGH))) {
      assertThat(material.isUniform()).isFalse();
      assertThat(material.simplified()).isSameAs(material);
    }
  }

  @Test
  void materialUnderANormalMapIsSimplifiedAndKeepsItsMap() {
    NormalMap map = new NormalMap(VARYING, UvMapping.IDENTITY, 1);
    NormalMapped uniform = new NormalMapped(new Matte(HALF), map);
    assertThat(uniform.isUniform()).isTrue();
    assertThat(uniform.simplified()).isEqualTo(new NormalMapped(new Matte(HALF).simplified(), map));
    assertThat(uniform.simplified().at(SOMEWHERE)).isEqualTo(uniform.at(SOMEWHERE));
    NormalMapped varying = new NormalMapped(new Matte(VARYING), map);
    assertThat(varying.isUniform()).isFalse();
    assertThat(varying.at(SOMEWHERE)).isEqualTo(new Matte(VARYING).at(SOMEWHERE));
    assertThat(varying.simplified()).isEqualTo(varying);
  }

  @Test
  void simplifiedMaterialsStayAsTheyAre() {
    Material simple = new Matte(HALF).simplified();
    assertThat(simple.isUniform()).isTrue();
    assertThat(simple.simplified()).isSameAs(simple);
  }

  @Test
  void bsdfsThatSayTheyChooseNoLobeDoNot() {
    Point2 u = new Point2(.3, .6);
    for (Material material : materials(HALF, ROUGH)) {
      Bsdf bsdf = material.at(SOMEWHERE);
      Vec3 wo = new Vec3(.6, 0, .8);
      Vec3 low = bsdf.sample(wo, 0, u).wi();
      Vec3 high = bsdf.sample(wo, BsdfLaws.LAST, u).wi();
      assertThat(low.equals(high)).isEqualTo(!bsdf.choosesLobe());
    }
  }
}
