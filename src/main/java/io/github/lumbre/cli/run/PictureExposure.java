package io.github.lumbre.cli.run;

import io.github.lumbre.cli.output.Visible;
import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.scenefile.SceneFile;
import java.util.Optional;

/**
 * Chooses the exposure of pictures. One for several pictures chooses an automatic exposure once, so
 * that a sequence does not flicker. Mutable.
 */
public final class PictureExposure {
  private final boolean isShared;
  private Optional<Exposure> chosen;

  private PictureExposure(boolean isShared, Optional<Exposure> chosen) {
    this.isShared = isShared;
    this.chosen = chosen;
  }

  /** Returns a choice for each picture by itself. */
  public static PictureExposure ofEach() {
    return new PictureExposure(false, Optional.empty());
  }

  /**
   * Returns a choice for all pictures of a sequence.
   *
   * @param chosen the exposure that earlier pictures have; empty to choose it from the first
   *     complete picture
   */
  public static PictureExposure ofAll(Optional<Exposure> chosen) {
    return new PictureExposure(true, chosen);
  }

  /**
   * Returns the exposure of a picture.
   *
   * @param image of the window of the file's settings
   */
  Exposure of(SceneFile file, Image image) {
    Exposure wanted = file.settings().exposure();
    if (wanted.stops().isPresent() || !isShared) {
      return Visible.exposure(wanted, file, image);
    }
    if (chosen.isEmpty()) {
      Exposure automatic = Visible.exposure(wanted, file, image);
      chosen = Optional.of(automatic.stops().isPresent() ? automatic : fixed(automatic, image));
    }
    return chosen.get();
  }

  /** Returns the number of stops that an automatic exposure has for a picture. */
  private static Exposure fixed(Exposure automatic, Image image) {
    return Exposure.of(StrictMath.log(automatic.factor(image)) / StrictMath.log(2));
  }
}
