package io.github.lumbre.lab.checks;

import static io.github.lumbre.material.MaterialParameter.ANISOTROPY;
import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT;
import static io.github.lumbre.material.MaterialParameter.CLEARCOAT_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.DIFFUSE_TRANSMISSION;
import static io.github.lumbre.material.MaterialParameter.DISPERSION;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE;
import static io.github.lumbre.material.MaterialParameter.IRIDESCENCE_IOR;
import static io.github.lumbre.material.MaterialParameter.METALLIC;
import static io.github.lumbre.material.MaterialParameter.ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.SHEEN_COLOR;
import static io.github.lumbre.material.MaterialParameter.SHEEN_ROUGHNESS;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.CookTorrance;
import io.github.lumbre.material.Glass;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.Matte;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.MicrofacetDistribution;
import io.github.lumbre.material.Mirror;
import io.github.lumbre.material.Phong;
import io.github.lumbre.material.internal.ColorChannel;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.texture.ScalarTexture;
import io.github.lumbre.texture.Texture;
import io.github.lumbre.texture.TexturePoint;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Materials of every kind, from smooth to rough, to measure. */
final class MeasuredMaterials {
  private static final double[] ROUGHNESSES = {1e-3, .01, .05, .1, .3, .5, 1};
  private static final double[] EXPONENTS = {0, 1, 10, 52, 1e3, 1e6, 1e9};

  private MeasuredMaterials() {}

  static List<Bsdf> all(List<Material> materials) {
    return materials.stream().map(material -> material.at(new TexturePoint(.5, .5))).toList();
  }

  static List<Material> opaque(double leastRoughness, double mostExponent) {
    Texture<Rgb> white = Texture.constant(Rgb.WHITE);
    Texture<Rgb> black = Texture.constant(Rgb.BLACK);
    Texture<Rgb> half = Texture.constant(Rgb.gray(.5));
    List<Material> materials = new ArrayList<>();
    materials.add(new Matte(white));
    for (double exponent : EXPONENTS) {
      if (exponent <= mostExponent) {
        materials.add(new Phong(black, white, ScalarTexture.constant(exponent)));
        materials.add(new Phong(half, half, ScalarTexture.constant(exponent)));
      }
    }
    for (MicrofacetDistribution kind : MicrofacetDistribution.values()) {
      for (double roughness : ROUGHNESSES) {
        if (roughness >= leastRoughness) {
          ScalarTexture alpha = ScalarTexture.constant(roughness);
          ScalarTexture ior = ScalarTexture.constant(CookTorrance.DEFAULT_IOR);
          materials.add(new CookTorrance(black, white, alpha, ior, kind));
          materials.add(new CookTorrance(half, half, alpha, ior, kind));
        }
      }
    }
    return materials;
  }

  static List<Material> glasses(double leastRoughness) {
    Texture<Rgb> white = Texture.constant(Rgb.WHITE);
    List<Material> materials = new ArrayList<>();
    for (double ior : new double[] {1.33, 1.5, 2.4}) {
      for (double roughness : ROUGHNESSES) {
        if (roughness >= leastRoughness) {
          materials.add(
              new Glass(
                  white, white, ScalarTexture.constant(ior), ScalarTexture.constant(roughness)));
        }
      }
    }
    return materials;
  }

  /** Metals, plastics, thin films, clear coats, sheen and thin glass, smooth and rough. */
  static List<Material> layered(double leastRoughness) {
    List<Material> materials = new ArrayList<>();
    for (double alpha : ROUGHNESSES) {
      if (alpha >= leastRoughness) {
        double roughness = Math.sqrt(alpha);
        ScalarChannel varied = ScalarChannel.of(roughness);
        ScalarChannel medium = ScalarChannel.of(.6);
        ColorChannel white = ColorChannel.of(Rgb.WHITE);
        materials.add(metallic(1, roughness).build());
        materials.add(metallic(0, roughness).build());
        materials.add(metallic(1, roughness).set(ANISOTROPY, .9).build());
        materials.add(filmed(1, roughness).build());
        materials.add(filmed(0, roughness).build());
        materials.add(metallic(.5, .6).set(CLEARCOAT, 1).set(CLEARCOAT_ROUGHNESS, varied).build());
        materials.add(
            metallic(0, roughness).set(CLEARCOAT, .5).set(CLEARCOAT_ROUGHNESS, medium).build());
        materials.add(metallic(0, .6).set(SHEEN_COLOR, white).set(SHEEN_ROUGHNESS, varied).build());
        materials.add(
            metallic(1, roughness)
                .set(SHEEN_COLOR, white)
                .set(SHEEN_ROUGHNESS, medium)
                .set(CLEARCOAT, 1)
                .set(CLEARCOAT_ROUGHNESS, varied)
                .build());
        materials.add(metallic(0, roughness).set(DIFFUSE_TRANSMISSION, .6).build());
        materials.add(metallic(0, roughness).set(TRANSMISSION, 1).build());
      }
    }
    return materials;
  }

  private static MetallicRoughness.Builder filmed(double metallic, double roughness) {
    return metallic(metallic, roughness).set(IRIDESCENCE, 1).set(IRIDESCENCE_IOR, 1.8);
  }

  private static Material dispersive(double roughness) {
    return filmed(0, roughness)
        .set(TRANSMISSION, 1)
        .set(ATTENUATION_DISTANCE, 1)
        .set(DISPERSION, 2)
        .build();
  }

  /** Clear coats above rough glass, which are not reciprocal. */
  static List<Material> coatedGlass(double leastRoughness) {
    return Arrays.stream(ROUGHNESSES)
        .filter(alpha -> alpha >= leastRoughness)
        .mapToObj(alpha -> metallic(.3, Math.sqrt(alpha)).set(TRANSMISSION, .5))
        .<Material>map(glass -> glass.set(CLEARCOAT, .5).build())
        .toList();
  }

  static MetallicRoughness.Builder metallic(double metallic, double roughness) {
    return MetallicRoughness.builder().set(METALLIC, metallic).set(ROUGHNESS, roughness);
  }

  /** Returns BSDFs with every lobe that materials have. */
  static List<Bsdf> everything() {
    List<Material> materials = new ArrayList<>(opaque(0, Double.MAX_VALUE));
    materials.addAll(layered(0));
    materials.addAll(coatedGlass(0));
    materials.addAll(glasses(0));
    materials.add(dispersive(0));
    materials.add(dispersive(.5));
    materials.add(new Mirror(Texture.constant(Rgb.WHITE)));
    Texture<Rgb> white = Texture.constant(Rgb.WHITE);
    ScalarTexture smooth = ScalarTexture.constant(0);
    ScalarTexture ior = ScalarTexture.constant(1.5);
    materials.add(new Glass(white, white, ior, smooth));
    materials.add(
        new CookTorrance(
            Texture.constant(Rgb.BLACK), white, smooth, ior, MicrofacetDistribution.GGX));
    return all(materials);
  }
}
