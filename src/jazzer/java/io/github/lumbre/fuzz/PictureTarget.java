package io.github.lumbre.fuzz;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.LinearReader;

/** Any bytes as a picture: PNG, JPEG, portable float map, Radiance HDR or OpenEXR. */
public final class PictureTarget {
  private PictureTarget() {}

  /** Reads a picture; what else it throws is a defect. */
  public static void fuzzerTestOneInput(byte[] file) {
    try {
      LinearReader.decode(file);
    } catch (ImageFormatException e) {
      return;
    }
  }
}
