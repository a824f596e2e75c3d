package io.github.lumbre.model.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MaterialParameter;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.format.gltf.GltfFile;
import io.github.lumbre.texture.TexturePoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares KHR_materials_pbrSpecularGlossiness with its text: diffuse · (1 - max(specular)), F0 =
 * specular and α = (1 - glossiness)².
 */
class SpecularGlossinessTest {
  private static final Rgb DIFFUSE = new Rgb(.9, .5, .2);
  private static final Rgb SPECULAR = new Rgb(.3, .6, .15);

  private static Material material(String json, boolean isTextured) throws Exception {
    GltfFile file = new GltfFile();
    file.add("nodes", "{'mesh': " + file.triangle(", 'material': 0") + "}");
    if (isTextured) {
      Pixels diffuse = Pixels.of(1, 1, 4, new byte[] {51, 102, (byte) 153, (byte) 204});
      Pixels specular = Pixels.of(1, 1, 4, new byte[] {(byte) 204, 51, 102, (byte) 178});
      for (Pixels each : new Pixels[] {diffuse, specular}) {
        int view = file.view(each.toPng(), "");
        file.add("images", "{'mimeType': 'image/png', 'bufferView': " + view + "}");
      }
      file.add("textures", "{'source': 0}");
      file.add("textures", "{'source': 1}");
    }
    String extension = "'KHR_materials_pbrSpecularGlossiness'";
    file.set("extensionsRequired", "[" + extension + "]");
    file.add("materials", "{'doubleSided': true, 'extensions': {" + extension + ": " + json + "}}");
    Model model = file.read();
    assertThat(model.warnings()).isEmpty();
    return new ModelMaterials(Transform.IDENTITY, Limits.NONE, new DecodedPictures())
        .of(model.parts().get(0).material(), true);
  }

  private static Bsdf plain(double glossiness) throws Exception {
    return material(
            "{'diffuseFactor': [%s, %s, %s, 1], 'specularFactor': [%s, %s, %s], 'glossinessFactor': %s}"
                .formatted(
                    DIFFUSE.r(),
                    DIFFUSE.g(),
                    DIFFUSE.b(),
                    SPECULAR.r(),
                    SPECULAR.g(),
                    SPECULAR.b(),
                    glossiness),
            false)
        .at(hit());
  }

  private static double linear(double encoded) {
    return Math.pow((encoded + .055) / 1.055, 2.4);
  }

  private static SurfaceHit hit() {
    return new SurfaceHit()
        .set(Vec3.ZERO, Vec3.Z, Frame.WORLD, new TexturePoint(.5, .5), Vec3.Z, 0);
  }

  private static Vec3 direction(double cosine, double phi) {
    double sine = Math.sqrt(1 - cosine * cosine);
    return new Vec3(sine * Math.cos(phi), sine * Math.sin(phi), cosine);
  }

  /** Returns the green reflection of glTF 2.0, Appendix B, times the cosine of wi. */
  private static double byTheText(Vec3 wo, Vec3 wi, double glossiness) {
    double alpha = (1 - glossiness) * (1 - glossiness);
    double square = alpha * alpha;
    Vec3 h = wo.plus(wi).normalized();
    double t = h.z() * h.z() * (square - 1) + 1;
    double density = square / (Math.PI * t * t);
    double visibility =
        .5
            / (wi.z() * Math.sqrt(wo.z() * wo.z() * (1 - square) + square)
                + wo.z() * Math.sqrt(wi.z() * wi.z() * (1 - square) + square));
    double grazing = Math.pow(1 - wo.dot(h), 5);
    double fresnel = SPECULAR.g() + (1 - SPECULAR.g()) * grazing;
    double largest = SPECULAR.max() + (1 - SPECULAR.max()) * grazing;
    double diffuse = DIFFUSE.g() * (1 - SPECULAR.max()) / Math.PI;
    return (fresnel * density * visibility + (1 - largest) * diffuse) * wi.z();
  }

  @Test
  void texturesScaleTheFactors() throws Exception {
    Bsdf found =
        material(
                """
                {'diffuseFactor': [1, 0.5, 0.25, 1], 'specularFactor': [0.5, 0.75, 1],
                 'glossinessFactor': 0.9, 'diffuseTexture': {'index': 0},
                 'specularGlossinessTexture': {'index': 1}}
                """,
                true)
            .at(hit());
    Rgb specular = new Rgb(linear(.8), linear(.2), linear(.4)).times(new Rgb(.5, .75, 1));
    Rgb diffuse = new Rgb(linear(.2), linear(.4), linear(.6)).times(new Rgb(1, .5, .25));
    Bsdf expected =
        MetallicRoughness.builder()
            .set(MaterialParameter.METALLIC, 0)
            .set(MaterialParameter.IOR, 0)
            .set(MaterialParameter.BASE_COLOR, diffuse.times(1 - specular.max()))
            .set(MaterialParameter.SPECULAR_COLOR, specular)
            .set(MaterialParameter.ROUGHNESS, 1 - .9 * 178 / 255)
            .build()
            .at(hit());
    Vec3 wo = direction(.7, 1);
    for (double cosine : new double[] {.9, .4, .1}) {
      Rgb value = found.evaluate(wo, direction(cosine, 3)).f();
      Rgb same = expected.evaluate(wo, direction(cosine, 3)).f();
      assertThat(value.r()).isCloseTo(same.r(), within(1e-6 * same.r()));
      assertThat(value.g()).isCloseTo(same.g(), within(1e-6 * same.g()));
      assertThat(value.b()).isCloseTo(same.b(), within(1e-6 * same.b()));
    }
  }

  /**
   * Head-on, smooth facets reflect F0 · D / 4. Nothing that the material adds to the text, for
   * light between rough facets, is above 1 % at this roughness.
   */
  @Test
  void specularIsTheReflectanceHeadOn() throws Exception {
    Bsdf mirror =
        material(
                "{'diffuseFactor': [0, 0, 0, 1], 'specularFactor': [0.3, 0.6, 0.15],"
                    + " 'glossinessFactor': 0.8}",
                false)
            .at(hit());
    double density = 1 / (Math.PI * Math.pow(.2, 4));
    Rgb found = mirror.evaluate(Vec3.Z, Vec3.Z).f().times(4 / density);
    assertThat(found.r()).isCloseTo(.3, within(.003));
    assertThat(found.g()).isCloseTo(.6, within(.006));
    assertThat(found.b()).isCloseTo(.15, within(.0015));
  }

  /**
   * The light that the surface reflects in all directions is that of the text, by quadrature. The
   * text has no law for the diffuse light that leaves through the reflection: here, it is dimmed by
   * the albedo of the reflection, not by its Fresnel term, so that a small difference is allowed.
   * Rougher facets differ more, since the text loses the light between them.
   */
  @ParameterizedTest
  @ValueSource(doubles = {.6, .8, .9})
  void allLightIsThatOfTheText(double glossiness) throws Exception {
    Bsdf bsdf = plain(glossiness);
    for (double cosine : new double[] {1, .8, .5}) {
      Vec3 wo = direction(cosine, .3);
      double found = 0;
      double text = 0;
      int steps = 400;
      for (int i = 0; i < steps; i++) {
        for (int j = 0; j < steps; j++) {
          Vec3 wi = direction((i + .5) / steps, 2 * Math.PI * (j + .5) / steps);
          double weight = 2 * Math.PI / steps / steps;
          found += weight * bsdf.evaluate(wo, wi).f().g();
          text += weight * byTheText(wo, wi, glossiness);
        }
      }
      assertThat(found).as("cosine %s", cosine).isCloseTo(text, within(.03));
    }
  }

  /** A material that states nothing but a diffuse color is a perfect mirror, as the text has it. */
  @Test
  void withoutSpecularFactorNothingIsDiffuse() throws Exception {
    Bsdf bsdf = material("{'diffuseFactor': [1, 1, 1, 1]}", false).at(hit());
    assertThat(bsdf.diffuseAlbedo().isBlack()).isTrue();
    assertThat(bsdf.albedo()).isEqualTo(Rgb.WHITE);
  }
}
