package io.github.lumbre.material;

import io.github.lumbre.geometry.SurfaceHit;
import io.github.lumbre.material.internal.ScalarChannel;
import io.github.lumbre.material.internal.ThinFilm;

/** The thin film of a {@link MetallicRoughness} material, which varies over the surface. */
final class Films {
  /** What the clear coat adds to the index of refraction of air. */
  private static final double COAT_EXCESS = .5;

  private final ScalarChannel strength;
  private final ScalarChannel thickness;
  private final ScalarChannel clearcoat;
  private final double ior;
  private final double thinnest;
  private final double thickest;
  private final boolean exists;

  Films(MetallicRoughness.Builder values) {
    exists = values.states(MaterialParameter.IRIDESCENCE);
    strength = values.number(MaterialParameter.IRIDESCENCE);
    thickness = values.number(MaterialParameter.IRIDESCENCE_THICKNESS);
    clearcoat = values.number(MaterialParameter.CLEARCOAT);
    ior = values.constant(MaterialParameter.IRIDESCENCE_IOR);
    thinnest = values.constant(MaterialParameter.IRIDESCENCE_THICKNESS_MINIMUM);
    thickest = values.constant(MaterialParameter.IRIDESCENCE_THICKNESS_MAXIMUM);
  }

  /** Returns the film at a hit; {@link ThinFilm#NONE} if its strength is 0. */
  ThinFilm at(SurfaceHit hit) {
    double part = exists ? strength.fractionAt(hit) : 0;
    if (part == 0) {
      return ThinFilm.NONE;
    }
    double nanometers = thinnest + (thickest - thinnest) * thickness.fractionAt(hit);
    return new ThinFilm(part, ior, nanometers, 1 + COAT_EXCESS * clearcoat.fractionAt(hit));
  }
}
