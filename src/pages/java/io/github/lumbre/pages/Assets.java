package io.github.lumbre.pages;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;

/** Files of the repository that pages show or link to. They are copied into the site. */
final class Assets {
  private static final float QUALITY = 0.86f;

  private final Path repository;
  private final Path output;
  private final TreeSet<Path> files = new TreeSet<>();
  private final Map<Path, Path> sized = new TreeMap<>();

  Assets(Path repository, Path output) {
    this.repository = repository;
    this.output = output;
  }

  int count() {
    return files.size() + sized.size();
  }

  /** Returns where a file or the list of a folder will be in the site. */
  Path file(Path file) {
    files.add(file);
    Path copy = Path.of("files").resolve(file);
    return Files.isDirectory(repository.resolve(file)) ? copy.resolve("index.html") : copy;
  }

  /**
   * Returns where an image will be in the site.
   *
   * @param width of the copy in pixels; 0 keeps the image as it is
   */
  Path image(Path file, int width) {
    if (width == 0 || !file.toString().endsWith(".png")) {
      return file(file);
    }
    Path copy = Path.of("small", width + "-" + file.getFileName().toString().replace("png", "jpg"));
    sized.put(copy, repository.resolve(file));
    return copy;
  }

  /** Copies all files. */
  void write() throws IOException {
    for (Path file : files) {
      Path from = repository.resolve(file);
      Path to = output.resolve("files").resolve(file);
      if (Files.isDirectory(from)) {
        Files.createDirectories(to);
        Files.writeString(to.resolve("index.html"), list(file));
      } else if (Files.isRegularFile(from)) {
        copy(from, to);
      }
    }
    for (Map.Entry<Path, Path> image : sized.entrySet()) {
      String name = image.getKey().getFileName().toString();
      int width = Integer.parseInt(name.substring(0, name.indexOf('-')));
      scale(image.getValue(), output.resolve(image.getKey()), width);
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    Files.createDirectories(to.getParent());
    Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
  }

  private String list(Path folder) throws IOException {
    StringBuilder html = new StringBuilder("<!DOCTYPE html>\n<html lang=\"en\"><head>");
    html.append("<meta charset=\"utf-8\"><title>").append(folder).append("</title></head>\n<body>");
    html.append("<main><h1>").append(folder).append("</h1>\n<ul>\n");
    try (Stream<Path> entries = Files.list(repository.resolve(folder))) {
      List<Path> regular = entries.filter(Files::isRegularFile).sorted().toList();
      for (Path entry : regular) {
        copy(entry, output.resolve("files").resolve(folder).resolve(entry.getFileName()));
        String name = Page.escape(entry.getFileName().toString());
        html.append("<li><a href=\"").append(name).append("\">").append(name).append("</a></li>\n");
      }
    }
    return html.append("</ul></main></body></html>\n").toString();
  }

  private static void scale(Path from, Path to, int width) throws IOException {
    BufferedImage image = ImageIO.read(from.toFile());
    int w = Math.min(width, image.getWidth());
    int h = Math.max(1, Math.round((float) image.getHeight() * w / image.getWidth()));
    BufferedImage small = new BufferedImage(w, h, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = small.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
    graphics.drawImage(halved(image, 2 * w), 0, 0, w, h, null);
    graphics.dispose();
    Files.createDirectories(to.getParent());
    Files.deleteIfExists(to);
    ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    ImageWriteParam parameters = writer.getDefaultWriteParam();
    parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
    parameters.setCompressionQuality(QUALITY);
    try (ImageOutputStream out = ImageIO.createImageOutputStream(to.toFile())) {

      writer.setOutput(out);
      writer.write(null, new IIOImage(small, null, null), parameters);
    } finally {
      writer.dispose();
    }
  }

  /** Returns the image halved until it is narrower than a limit, which avoids aliases. */
  private static BufferedImage halved(BufferedImage image, int limit) {
    BufferedImage current = image;
    while (current.getWidth() > limit) {
      BufferedImage half =
          new BufferedImage(
              current.getWidth() / 2,
              Math.max(1, current.getHeight() / 2),
              BufferedImage.TYPE_INT_RGB);
      Graphics2D graphics = half.createGraphics();
      graphics.setRenderingHint(
          RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
      graphics.drawImage(current, 0, 0, half.getWidth(), half.getHeight(), null);
      graphics.dispose();
      current = half;
    }
    return current;
  }
}
