package io.github.lumbre.junit;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.compare.Flip;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Writes the pictures of a failed comparison, and a page that flips between them. Stateless. */
final class FailurePage {
  private static final String PAGE = "index.html";
  private static final String MAP = "difference.png";

  private FailurePage() {}

  /** Returns the folder of a golden picture's failure. */
  private static Path folder(Path report, GoldenFile golden) {
    return report.resolve(golden.name().replaceFirst("\\.(png|exr)$", ""));
  }

  /** Deletes what an earlier failure has written. */
  static void delete(Path report, GoldenFile golden) throws IOException {
    Path folder = folder(report, golden);
    if (Files.isRegularFile(folder.resolve(PAGE))) {
      for (String name : List.of(PAGE, MAP, actual(golden), expected(golden))) {
        Files.deleteIfExists(folder.resolve(name));
      }
      deleteIfEmpty(folder);
    }
  }

  private static void deleteIfEmpty(Path folder) throws IOException {
    try {
      Files.delete(folder);
    } catch (DirectoryNotEmptyException e) {
      // Pictures whose names begin with this one's are below, or files of others.
    }
  }

  private static String actual(GoldenFile golden) {
    return "actual" + (golden.isExr() ? ".exr" : ".png");
  }

  private static String expected(GoldenFile golden) {
    return "expected" + (golden.isExr() ? ".exr" : ".png");
  }

  /**
   * Writes the files into a folder of the golden picture's name.
   *
   * @param difference empty if the pictures have different sizes
   * @param text says the difference
   * @return the page
   */
  static Path write(
      Path report,
      GoldenFile golden,
      GoldenFile.Encoded actual,
      GoldenFile.Encoded expected,
      Optional<Difference> difference,
      String text)
      throws IOException {
    Path folder = Files.createDirectories(folder(report, golden));
    Files.write(folder.resolve(actual(golden)), actual.bytes());
    Files.write(folder.resolve(expected(golden)), expected.bytes());
    Image a = actual.image();
    Image e = expected.image();
    byte[] shown = (difference.isPresent() ? Flip.picture(a, e) : Image.black(1, 1)).toPng();
    Files.write(folder.resolve(MAP), shown);
    String html =
        template()
            .replace("@NAME@", escaped(golden.name()))
            .replace("@DIFFERENCE@", escaped(text))
            .replace("@TILE@", difference.map(each -> place(each, a)).orElse("display: none"))
            .replace("@ACTUAL@", data(golden.isExr() ? a.toPng() : actual.bytes()))
            .replace("@EXPECTED@", data(golden.isExr() ? e.toPng() : expected.bytes()))
            .replace("@MAP@", data(shown));
    return Files.writeString(folder.resolve(PAGE), html).toAbsolutePath();
  }

  /** Returns the style that puts a frame around the worst tile of a picture. */
  private static String place(Difference difference, Image picture) {
    return String.format(
        Locale.ROOT,
        "left: %.3f%%; top: %.3f%%; width: %.3f%%; height: %.3f%%",
        100.0 * difference.left() / picture.width(),
        100.0 * difference.top() / picture.height(),
        100.0
            * Math.min(GoldenPictures.TILE, picture.width() - difference.left())
            / picture.width(),
        100.0
            * Math.min(GoldenPictures.TILE, picture.height() - difference.top())
            / picture.height());
  }

  private static String template() throws IOException {
    try (var in = FailurePage.class.getResourceAsStream("page.html")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static String data(byte[] png) {
    return "data:image/png;base64," + Base64.getEncoder().encodeToString(png);
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
  }
}
