package io.github.lumbre.material.internal;

import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.BsdfSample;
import io.github.lumbre.material.Material;
import io.github.lumbre.material.NormalMapped;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.internal.Range;
import java.util.Optional;

/**
 * The BSDF of smooth glass: reflects by the exact Fresnel equations and refracts by Snell's law
 * (PBRT 4e, sec. 9.5). The inside of the glass is at negative z.
 *
 * @param reflectance tints the reflected light, each component in [0,1]
 * @param transmittance tints the refracted light, each component in [0,1]
 * @param ior index of refraction of the inside relative to the outside, in [1e-150, 1e150]
 */
public record Dielectric(Rgb reflectance, Rgb transmittance, double ior) implements SpecularBsdf {
  /** The indices of refraction that materials may state. */
  public static final Range IOR = Range.above(0, 1e6);

  /** Returns the BSDF of a material if it is known to be the same clear glass everywhere. */
  public static Optional<Dielectric> of(Material material) {
    // Perturbed normals refract to other places than the surface's own.
    return material.isUniform()
            && !(material instanceof NormalMapped)
            && material.at(0, 0) instanceof Dielectric glass
        ? Optional.of(glass)
        : Optional.empty();
  }

  @Override
  public boolean choosesLobe() {
    return true;
  }

  @Override
  public boolean transmits() {
    return true;
  }

  @Override
  public void sample(
      double woX, double woY, double woZ, double uLobe, double u, double v, BsdfSample result) {
    Vec3 wo = new Vec3(woX, woY, woZ);
    double fresnel = reflected(wo);
    double probability = reflectProbability(fresnel);
    if (!(probability >= 0)) {
      result.absorb();
      return;
    }
    if (uLobe < probability) {
      result.setSpecular(SpecularReflection.reflect(wo), reflectance.times(fresnel / probability));
    } else {
      result.setSpecular(refract(wo), transmittance.times((1 - fresnel) / (1 - probability)));
    }
  }

  /** Returns the probability of sampling the reflection; NaN if the surface is black. */
  private double reflectProbability(double fresnel) {
    double reflect = fresnel * reflectance.max();
    double pass = (1 - fresnel) * transmittance.max();
    return reflect / (reflect + pass);
  }

  /**
   * Returns the probability with which {@link #sample} refracts, in [0,1]; NaN if the surface is
   * black.
   *
   * @param wo unit direction to the viewer in the local frame
   */
  public double passProbability(Vec3 wo) {
    return 1 - reflectProbability(reflected(wo));
  }

  /**
   * Returns the fraction of light, per color in [0,1], that is refracted to a viewer.
   *
   * @param wo unit direction to the viewer in the local frame
   */
  public Rgb passed(Vec3 wo) {
    return transmittance.times(1 - reflected(wo));
  }

  /** Returns the Fresnel reflectance in [0,1] for a viewer at wo, without the tint. */
  public double reflected(Vec3 wo) {
    return Fresnel.dielectric(Math.abs(wo.z()), eta(wo));
  }

  /** Returns the unit direction refracted from wo; undefined beyond the critical angle. */
  public Vec3 refract(Vec3 wo) {
    double eta = eta(wo);
    double sin2I = wo.x() * wo.x() + wo.y() * wo.y();
    double cosT = Fresnel.cosTransmitted(Math.abs(wo.z()), sin2I, eta);
    return eta == 1
        ? wo.negated()
        : new Vec3(-wo.x() / eta, -wo.y() / eta, -Math.copySign(cosT, wo.z())).normalized();
  }

  /**
   * Returns the index of refraction on the other side of the surface, relative to the side of wo.
   *
   * @param wo local direction of any length
   */
  public double eta(Vec3 wo) {
    return wo.z() > 0 ? ior : 1 / ior;
  }

  @Override
  public Rgb albedo() {
    return transmittance;
  }
}
