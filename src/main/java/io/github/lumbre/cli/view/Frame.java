package io.github.lumbre.cli.view;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageLayer;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A picture that the page can show. Immutable.
 *
 * @param version increases with each frame of a session
 * @param image the picture
 * @param layers its layers
 * @param samples the mean number of samples per pixel
 * @param isDraft whether it is a quick picture with fewer pixels
 * @param isFinal whether nothing is added to it any more, so that it is worth all its digits
 * @param metadata attributes that describe the layers
 * @param denoised the picture after denoising, perhaps of fewer samples; empty if there is none
 */
record Frame(
    long version,
    Image image,
    List<ImageLayer> layers,
    double samples,
    boolean isDraft,
    boolean isFinal,
    Map<String, String> metadata,
    Optional<Frame> denoised) {
  Frame {
    layers = List.copyOf(layers);
    metadata = Map.copyOf(metadata);
  }

  /** Returns this frame with its picture after denoising. */
  Frame with(Frame clean) {
    return new Frame(
        version, image, layers, samples, isDraft, isFinal, metadata, Optional.of(clean));
  }

  Optional<ImageLayer> layer(String name) {
    return layers.stream().filter(layer -> layer.name().equals(name)).findFirst();
  }

  /**
   * Returns a picture whose black pixels, most of them without samples, are replaced by a draft's.
   */
  static Image filled(Image image, Image draft) {
    if (image.hasAlpha()) {
      return image;
    }
    float[] rgb = image.rgb().clone();
    for (int i = 0; i < rgb.length; i += 3) {
      if (rgb[i] == 0 && rgb[i + 1] == 0 && rgb[i + 2] == 0) {
        int x = (int) ((long) (i / 3 % image.width()) * draft.width() / image.width());
        int y = (int) ((long) (i / 3 / image.width()) * draft.height() / image.height());
        System.arraycopy(draft.rgb(), 3 * (y * draft.width() + x), rgb, i, 3);
      }
    }
    return new Image(image.width(), image.height(), rgb, new float[0]);
  }
}
