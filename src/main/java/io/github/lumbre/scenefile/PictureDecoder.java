package io.github.lumbre.scenefile;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.internal.EncodedFormat;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.LinearPicture;
import io.github.lumbre.scenefile.SceneFormatException.Kind;
import io.github.lumbre.texture.internal.ImageTexture.Filter;
import java.util.Optional;

/**
 * Decodes the pictures of a scene.
 *
 * @param allowance what is left for texels
 * @param lenient whether colors that are not finite are a warning instead of an error
 */
record PictureDecoder(Allowance allowance, boolean lenient) {
  /** Files with more texels per byte are reported as possible decompression bombs. */
  private static final int SUSPICIOUS_TEXELS_PER_BYTE = 250;

  /** The memory for a texel of linear light. */
  private static final int LINEAR_BYTES = 3 * Float.BYTES;

  /** Returns the picture in the bytes of a file; empty, with an error added, if there is none. */
  Optional<Picture> read(AssetData.Content content, Filter filter) {
    try {
      return ImageFormat.startsLinear(content.bytes())
          ? linear(content)
          : Optional.of(new Picture.Decoded(decoded(content), filter));
    } catch (ImageFormatException e) {
      boolean tooLarge = e.kind() == ImageFormatException.Kind.TOO_LARGE;
      content.error(tooLarge ? Kind.LIMIT : Kind.ASSET, PrintableText.escaped(e.getMessage()));
      return Optional.empty();
    }
  }

  private Optional<Picture> linear(AssetData.Content content) throws ImageFormatException {
    LinearPicture read = ImageFormat.read(content.bytes(), allowance.texelsLeft(LINEAR_BYTES));
    Image light = read.light();
    allowance.addTexels((long) light.width() * light.height());
    return isUsable(content, light)
        ? Optional.of(new Picture.Linear(read, content::warn))
        : Optional.empty();
  }

  /**
   * Replaces negative colors by 0, and if missing assets are tolerated, those that are not finite;
   * otherwise returns false, and reports the first of these.
   */
  private boolean isUsable(AssetData.Content content, Image image) {
    float[] rgb = image.rgb();
    int negative = 0;
    int broken = 0;
    String first = "";
    for (int i = 0; i < rgb.length; i++) {
      boolean isFinite = Float.isFinite(rgb[i]);
      if (!isFinite && broken++ == 0) {
        int pixel = i / 3;
        first = rgb[i] + " at pixel " + pixel % image.width() + "," + pixel / image.width();
      }
      negative += rgb[i] < 0 && isFinite ? 1 : 0;
      rgb[i] = rgb[i] > 0 && isFinite ? rgb[i] : 0;
    }
    if (broken > 0 && !lenient) {
      content.error(Kind.ASSET, "expected finite colors, found " + first);
      return false;
    }
    if (broken > 0) {
      content.warn("has " + broken + " colors that are not finite, which count as 0: " + first);
    }
    if (negative > 0) {
      content.warn("has " + negative + " negative colors, which count as 0");
    }
    return true;
  }

  private Pixels decoded(AssetData.Content content) throws ImageFormatException {
    Pixels pixels = ImageReader.decode(content.bytes(), allowance.left());
    allowance.addTexels((long) pixels.width() * pixels.height());
    warnOfBomb(content, pixels);
    warnOfColorSpace(content);
    if (EncodedFormat.hasMorePictures(content.bytes())) {
      content.warn("the file has several pictures; only the first one is shown");
    }
    return pixels;
  }

  private static void warnOfColorSpace(AssetData.Content content) {
    ImageReader.ignoredColorSpace(content.bytes())
        .ifPresent(
            space ->
                content.warn(
                    "the picture has "
                        + PrintableText.shortened(space)
                        + ", which is ignored; its colors are read as sRGB;"
                        + " convert it to sRGB"));
  }

  private static void warnOfBomb(AssetData.Content content, Pixels pixels) {
    long texels = (long) pixels.width() * pixels.height();
    int bytes = content.bytes().length;
    if (texels > (long) SUSPICIOUS_TEXELS_PER_BYTE * bytes) {
      String size = pixels.width() + "x" + pixels.height();
      content.warn(bytes + " bytes decode to " + size + " pixels");
    }
  }
}
