package io.github.lumbre.model.format;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedFormat;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelFiles;
import io.github.lumbre.model.internal.ModelImage;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelTexture;
import io.github.lumbre.model.internal.Warnings;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;

/** Reads each picture that a model names at its first use. Mutable. */
public final class ObjTextures {
  /** The number of points per side at which a picture is checked for color. */
  private static final int CHECKED = 64;

  private final ModelFiles folder;
  private final Limits limits;
  private final Map<String, ModelImage> images = new HashMap<>();
  private long bytes;

  public ObjTextures(ModelFiles folder, Limits limits) {
    this.folder = folder;
    this.limits = limits;
  }

  public ModelTexture texture(MtlMap map) throws ModelFormatException, IOException {
    return new ModelTexture(image(map), 0, map.wrap(), map.wrap(), false, map.uvTransform());
  }

  /** Returns the picture of a map. */
  public ModelImage image(MtlMap map) throws ModelFormatException, IOException {
    ModelImage known = images.get(map.file());
    if (known != null) {
      return known;
    }
    byte[] encoded = folder.read(map.file(), map.location());
    bytes += encoded.length;
    ModelLimits.requireMemory(map.location(), bytes, limits);
    try {
      EncodedFormat.open(encoded, limits);
    } catch (ImageFormatException e) {
      throw new ModelFormatException(
          e.kind() == ImageFormatException.Kind.TOO_LARGE ? Kind.TOO_LARGE : Kind.ASSET,
          map.location(),
          PrintableText.quoted(map.file()) + ": " + e.getMessage());
    }
    ModelImage image = new ModelImage(PrintableText.escaped(map.file()), encoded);
    images.put(map.file(), image);
    return image;
  }

  /** Returns whether there is a picture that may be read; adds a warning if not. */
  public boolean isReadable(MtlMap map, Warnings warnings)
      throws ModelFormatException, IOException {
    try {
      image(map);
      return true;
    } catch (ModelFormatException e) {
      if (e.kind() != Kind.ASSET) {
        throw e;
      }
      warnings.once(
          " picture " + map.file(), map.location(), e.detail() + "; the picture is left out");
      return false;
    }
  }

  /**
   * Returns whether a bump map holds heights: it is gray. A picture that cannot be decoded is taken
   * for a normal map, so that its error is found where it is used.
   */
  public boolean isHeightMap(MtlMap map) throws ModelFormatException, IOException {
    Pixels pixels;
    try {
      pixels = ImageReader.decode(image(map).encoded(), limits);
    } catch (ImageFormatException e) {
      return false;
    }
    for (int i = 0; i < CHECKED * CHECKED; i++) {
      int x = (int) ((long) pixels.width() * (i % CHECKED) / CHECKED);
      int y = (int) ((long) pixels.height() * (i / CHECKED) / CHECKED);
      int red = pixels.raw(x, y, 0);
      if (red != pixels.raw(x, y, 1) || red != pixels.raw(x, y, 2)) {
        return false;
      }
    }
    return true;
  }
}
