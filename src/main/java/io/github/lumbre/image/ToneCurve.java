package io.github.lumbre.image;

/** How linear light becomes the values of a picture file with few bits. */
public enum ToneCurve {
  /** Clamp to [0,1], then the sRGB curve. */
  SRGB,
  /** The 2016 report's: clamp, then v^(1/2.2). */
  GAMMA22,
  /** c / (1 + Y), then sRGB (Reinhard et al. 2002, on luminance Y). */
  REINHARD,
  /** x(2.51x+.03) / (x(2.43x+.59)+.14) for each channel, clamped, then sRGB (Narkowicz 2015). */
  ACES;
}
