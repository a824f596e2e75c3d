package io.github.lumbre.material;

/** A distribution of the microfacet normals of a rough surface. */
public enum MicrofacetDistribution {
  /** Slopes with a normal distribution (Beckmann &amp; Spizzichino 1963). */
  BECKMANN,
  /** Slopes with long tails (Walter et al. 2007). */
  GGX
}
