package io.github.lumbre.models;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;

/** A picture of pictures, which have one size. */
final class ContactSheet {
  private ContactSheet() {}

  /** Writes pictures in rows of so many columns, transparent ones on gray. */
  static void write(Path file, List<BufferedImage> pictures, int columns) throws IOException {
    int width = pictures.isEmpty() ? 1 : pictures.get(0).getWidth();
    int height = pictures.isEmpty() ? 1 : pictures.get(0).getHeight();
    int rows = Math.max(1, (pictures.size() + columns - 1) / columns);
    BufferedImage sheet =
        new BufferedImage(columns * width, rows * height, BufferedImage.TYPE_INT_RGB);
    var graphics = sheet.createGraphics();
    graphics.setColor(Color.GRAY);
    graphics.fillRect(0, 0, sheet.getWidth(), sheet.getHeight());
    for (int i = 0; i < pictures.size(); i++) {
      graphics.drawImage(pictures.get(i), i % columns * width, i / columns * height, null);
    }
    graphics.dispose();
    ImageIO.write(sheet, "png", file.toFile());
  }
}
