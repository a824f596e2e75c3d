package io.github.lumbre.junit;

import io.github.lumbre.compare.Flip;
import io.github.lumbre.image.Image;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;

/** Writes the pictures of a failed comparison, and a page that flips between them. Stateless. */
final class FailurePage {
  private FailurePage() {}

  /**
   * Writes the files into a folder of the golden picture's name.
   *
   * @return the page
   */
  static Path write(
      Path report,
      GoldenFile golden,
      GoldenFile.Encoded actual,
      GoldenFile.Encoded expected,
      String difference)
      throws IOException {
    Path folder = report.resolve(golden.name().replaceFirst("\\.(png|exr)$", ""));
    Files.createDirectories(folder);
    String ending = golden.isExr() ? ".exr" : ".png";
    Files.write(folder.resolve("actual" + ending), actual.bytes());
    Files.write(folder.resolve("expected" + ending), expected.bytes());
    Image a = actual.image();
    Image e = expected.image();
    boolean sameSize = a.width() == e.width() && a.height() == e.height();
    byte[] shown = sameSize ? Flip.picture(a, e).toPng() : Image.black(1, 1).toPng();
    Files.write(folder.resolve("difference.png"), shown);
    Path page = folder.resolve("index.html");
    String html =
        template()
            .replace("@NAME@", escaped(golden.name()))
            .replace("@DIFFERENCE@", escaped(difference))
            .replace("@ACTUAL@", data(golden.isExr() ? a.toPng() : actual.bytes()))
            .replace("@EXPECTED@", data(golden.isExr() ? e.toPng() : expected.bytes()))
            .replace("@MAP@", data(shown));
    return Files.writeString(page, html).toAbsolutePath();
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
