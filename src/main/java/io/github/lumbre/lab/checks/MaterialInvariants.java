package io.github.lumbre.lab.checks;

import static io.github.lumbre.material.MaterialParameter.ATTENUATION_DISTANCE;
import static io.github.lumbre.material.MaterialParameter.IOR;
import static io.github.lumbre.material.MaterialParameter.TRANSMISSION;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Bsdf;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.MetallicRoughness;
import io.github.lumbre.material.internal.Fresnel;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Elementary;
import io.github.lumbre.math.sampling.Sampler;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import java.util.ArrayList;
import java.util.List;

/**
 * Invariants of scattering: every material, from smooth to rough, from normal to grazing incidence.
 */
final class MaterialInvariants {
  private static final int SAMPLES = 1 << 12;
  private static final int MANY_SAMPLES = 1 << 18;
  private static final double MOST_EXCESS = 2e-3;
  private static final double MOST_LOSS = .01;
  private static final int PAIRS = 20_000;
  private static final int ROWS = 512;
  private static final int COLUMNS = 256;
  private static final double[] COSINES = {.01, .1, .3, .6, .95};

  /**
   * The smallest roughness that the quadrature resolves; narrower lobes fall between its points.
   */
  private static final double LEAST_WIDE = .3;

  private static final double MOST_WIDE_EXPONENT = 52;

  /** Index of refraction; reflectance at 0°, 60° and 80° by the exact Fresnel equations. */
  private static final double[][] FRESNEL = {
    {1.1, .0022675736961451, .0130699669001, .193562762457},
    {1.33, .020059312199525, .0591255992474, .346916096262},
    {1.5, .04, .0891867128022, .387704354691},
    {2.4, .16955017301038, .209351260771, .433236034108},
    {3.0504, .25626031614535, .276636121267, .432822279413},
    {1e6, .999996000008, .999995000017, .999988135295}
  };

  private MaterialInvariants() {}

  static List<Invariant> all() {
    String range =
        "matte, Phong with exponents 0 to 1e9, Cook-Torrance (Beckmann, GGX), glass,"
            + " metallic-roughness, anisotropy, thin films, clear coat, sheen, diffuse transmission"
            + " and thin glass of roughness 1e-3 to 1, dispersive glass, mirror; cosines 0.01 to"
            + " 0.95";
    return List.of(
        new Invariant(
            "furnace",
            "energy scattered in excess of the incident energy in a white furnace, relative",
            range,
            MOST_EXCESS,
            tries -> excess()),
        new Invariant(
            "rough-furnace",
            "light that white metal and glass lose in a white furnace, relative",
            "metal, thin and solid glass of roughness 0.1 to 1 and indices 1.33 to 2.4; cosines 0.1"
                + " to 0.95",
            MOST_LOSS,
            tries -> loss()),
        new Invariant(
            "weights",
            "relative difference of sample weights from f·cos/pdf",
            range,
            1e-12,
            MaterialInvariants::weights),
        new Invariant(
            "reciprocity",
            "relative difference of f(wo, wi) and f(wi, wo)",
            "matte, Phong, Cook-Torrance, metallic-roughness, anisotropy, thin films, clear coat,"
                + " sheen, diffuse transmission and thin glass; roughness from 0.05, exponents to"
                + " 1000",
            1e-12,
            MaterialInvariants::reciprocity),
        new Invariant(
            "pdf-integral",
            "excess over 1 of the integral of the pdf over all directions",
            "lobes wide enough for a quadrature: exponents to 52, roughness from 0.3",
            2e-3,
            tries -> integrals()),
        new Invariant(
            "fresnel",
            "relative difference from the Fresnel equations",
            "indices 1.1 to 1e6, at 0°, 60° and 80°",
            1e-11,
            tries -> fresnel()));
  }

  private static Vec3 viewer(double cosine) {
    return new Vec3(Elementary.safeSqrt(1 - cosine * cosine), 0, cosine);
  }

  private static double excess() {
    double worst = 0;
    for (Bsdf bsdf : MeasuredMaterials.everything()) {
      for (double cosine : COSINES) {
        double excess = excess(bsdf, viewer(cosine));
        // NaN must not pass as a small number.
        worst = excess >= -1 ? Math.max(worst, excess) : Double.NaN;
      }
    }
    return worst;
  }

  /** Returns the mean weight minus 1. Where few samples give too much, many more decide. */
  private static double excess(Bsdf bsdf, Vec3 wo) {
    double excess = mean(bsdf, wo, SAMPLES) - 1;
    return excess <= .5 * MOST_EXCESS ? excess : mean(bsdf, wo, MANY_SAMPLES) - 1;
  }

  private static double loss() {
    double worst = 0;
    for (double ior : new double[] {1.33, 1.5, 2.4}) {
      for (double roughness : new double[] {.1, .3, .6, 1}) {
        MetallicRoughness.Builder glass =
            MeasuredMaterials.metallic(0, roughness).set(IOR, ior).set(TRANSMISSION, 1);
        List<Material> white =
            new ArrayList<>(List.of(MeasuredMaterials.metallic(1, roughness).build()));
        white.add(glass.build());
        white.add(glass.set(ATTENUATION_DISTANCE, Double.POSITIVE_INFINITY).build());
        for (Bsdf bsdf : MeasuredMaterials.all(white)) {
          for (double cosine : new double[] {.1, .3, .6, .95}) {
            worst = Math.max(worst, 1 - mean(bsdf, viewer(cosine), SAMPLES));
          }
        }
      }
    }
    return worst;
  }

  /** Returns the largest component of the mean weight. */
  private static double mean(Bsdf bsdf, Vec3 wo, int samples) {
    Sampler sampler = new SobolSampler(21);
    Rgb sum = Rgb.BLACK;
    for (int i = 0; i < samples; i++) {
      sampler.startSample(0, 0, i);
      sum = sum.plus(bsdf.sample(wo, sampler.get1d(0), sampler.get2d(1)).weight());
    }
    return sum.max() / samples;
  }

  private static double weights(Tries tries) {
    Draws draws = tries.draws(22);
    double worst = 0;
    for (Bsdf bsdf : MeasuredMaterials.everything()) {
      for (double cosine : COSINES) {
        Vec3 wo = viewer(cosine);
        for (int i = 0; i < tries.times() * (SAMPLES / 8); i++) {
          BsdfSample drawn = bsdf.sample(wo, draws.unit(), draws.point());
          if (!drawn.isAbsorbed() && !drawn.isSpecular()) {
            double expected = bsdf.evaluate(wo, drawn.wi()).f().max() / bsdf.pdf(wo, drawn.wi());
            worst = Math.max(worst, Math.abs(drawn.weight().max() / expected - 1));
          }
        }
      }
    }
    return worst;
  }

  private static double reciprocity(Tries tries) {
    Draws draws = tries.draws(23);
    double worst = 0;
    List<Material> materials = new ArrayList<>(MeasuredMaterials.opaque(.05, 1e3));
    materials.addAll(MeasuredMaterials.layered(.05));
    for (Bsdf bsdf : MeasuredMaterials.all(materials)) {
      for (int i = 0; i < tries.times() * PAIRS; i++) {
        Vec3 wo = upward(draws.direction());
        Vec3 wi = draws.direction();
        double one = bsdf.evaluate(wo, wi).f().max() / Math.abs(wi.z());
        double other = bsdf.evaluate(wi, wo).f().max() / wo.z();
        double largest = Math.max(one, other);
        worst = largest <= 1e-100 ? worst : Math.max(worst, Math.abs(one - other) / largest);
      }
    }
    return worst;
  }

  private static Vec3 upward(Vec3 direction) {
    return new Vec3(direction.x(), direction.y(), Math.abs(direction.z()));
  }

  private static double integrals() {
    List<Material> materials =
        new ArrayList<>(MeasuredMaterials.opaque(LEAST_WIDE, MOST_WIDE_EXPONENT));
    materials.addAll(MeasuredMaterials.layered(LEAST_WIDE));
    materials.addAll(MeasuredMaterials.coatedGlass(LEAST_WIDE));
    materials.addAll(MeasuredMaterials.glasses(LEAST_WIDE));
    double worst = 0;
    for (Bsdf bsdf : MeasuredMaterials.all(materials)) {
      for (double cosine : new double[] {.1, .6}) {
        worst = Math.max(worst, integral(bsdf, viewer(cosine)) - 1);
      }
    }
    return worst;
  }

  /** Returns the integral of the pdf over the sphere, by the midpoint rule. */
  private static double integral(Bsdf bsdf, Vec3 wo) {
    double sum = 0;
    for (int row = 0; row < ROWS; row++) {
      double z = 2 * (row + .5) / ROWS - 1;
      double across = Elementary.safeSqrt(1 - z * z);
      for (int column = 0; column < COLUMNS; column++) {
        double turns = (column + .5) / COLUMNS;
        double x = across * Elementary.cosTurns(turns);
        double y = across * Elementary.sinTurns(turns);
        sum += bsdf.pdf(wo, new Vec3(x, y, z));
      }
    }
    return sum * 4 * Math.PI / (ROWS * COLUMNS);
  }

  private static double fresnel() {
    double worst = 0;
    double[] cosines = {1, .5, Elementary.cosDegrees(80)};
    for (double[] row : FRESNEL) {
      for (int i = 0; i < cosines.length; i++) {
        double found = Fresnel.dielectric(cosines[i], row[0]);
        worst = Math.max(worst, Math.abs(found / row[i + 1] - 1));
      }
    }
    return worst;
  }
}
