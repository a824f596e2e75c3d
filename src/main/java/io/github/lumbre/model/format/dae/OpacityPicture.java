package io.github.lumbre.model.format.dae;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.format.FormatFile;
import io.github.lumbre.model.format.dae.DaeEffect.Transparency;
import io.github.lumbre.model.internal.ModelImage;
import io.github.lumbre.model.internal.ModelTexture;
import java.util.Optional;

/** Makes gray pictures of opacity of those that state transparency otherwise. Stateless. */
final class OpacityPicture {
  private static final double MAX_BYTE = 255;

  private OpacityPicture() {}

  /**
   * Returns a texture whose red is the opacity; empty, with a warning, if the picture cannot be
   * decoded.
   */
  static Optional<ModelTexture> of(
      ModelTexture stated, Transparency kind, double transparency, FormatFile file)
      throws ModelFormatException {
    Pixels pixels;
    try {
      pixels = ImageReader.decode(stated.image().encoded(), file.options().limits());
    } catch (ImageFormatException e) {
      file.warnings()
          .add(
              stated.image().location(),
              "the picture of transparency is left out: " + e.getMessage());
      return Optional.empty();
    }
    file.take(stated.image().location(), 2L * pixels.width() * pixels.height());
    byte[] gray = new byte[pixels.width() * pixels.height()];
    double[] color = new double[4];
    for (int y = 0; y < pixels.height(); y++) {
      for (int x = 0; x < pixels.width(); x++) {
        for (int c = 0; c < 3; c++) {
          color[c] = pixels.value(x, y, c);
        }
        color[3] = (double) pixels.alpha(x, y) / pixels.max();
        double opacity = kind.opacity(transparency, color);
        gray[y * pixels.width() + x] = (byte) Math.round(MAX_BYTE * opacity);
      }
    }
    byte[] png = Pixels.of(pixels.width(), pixels.height(), 1, gray).toPng();
    return Optional.of(
        new ModelTexture(
            new ModelImage(PrintableText.escaped(stated.image().location()), png),
            stated.uvSet(),
            stated.wrapU(),
            stated.wrapV(),
            stated.nearest(),
            stated.uvTransform()));
  }
}
