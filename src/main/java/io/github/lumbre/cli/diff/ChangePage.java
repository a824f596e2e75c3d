package io.github.lumbre.cli.diff;

import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.internal.ImageFormat;
import io.github.lumbre.image.internal.Srgb;
import io.github.lumbre.model.difference.PartChange;
import io.github.lumbre.model.difference.PartChange.Kind;
import io.github.lumbre.scenefile.SceneFile;
import io.github.lumbre.stage.drawing.DisplayLight;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The page of a difference: one file, without scripts, that shows it everywhere. */
public final class ChangePage {
  /** What a page starts with, so that it is recognized. */
  public static final String TITLE = "What changed";

  private static final String STYLE =
      """
      body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 90rem; padding: 0 1rem; }
      .pictures { display: flex; flex-wrap: wrap; gap: 1rem; }
      figure { flex: 1 1 20rem; margin: 0; }
      img { width: 100%; height: auto; border: 1px solid #8888; }
      table { border-collapse: collapse; margin-top: 1rem; }
      th, td { text-align: left; padding: .25rem 1rem .25rem 0; border-bottom: 1px solid #8884; }
      td, figcaption { overflow-wrap: anywhere; }
      .key { display: inline-block; width: .8em; height: .8em; margin-right: .4em; }
      @media (prefers-color-scheme: dark) { body { background: #111; color: #ddd; } }
      """;

  private ChangePage() {}

  /**
   * A model with its picture.
   *
   * @param picture for the screen
   */
  public record Side(Path path, SceneFile file, DisplayLight picture) {}

  /**
   * Returns the page.
   *
   * @param summary of the changes in one line
   * @param lines a text for each change
   * @param notCompared what was not compared, in words; empty for nothing
   */
  public static String of(
      Side old,
      Side now,
      List<PartChange> changes,
      String summary,
      List<String> lines,
      String notCompared) {
    StringBuilder html = new StringBuilder();
    html.append("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n")
        .append("<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n")
        .append("<link rel=\"icon\" href=\"data:,\">\n")
        .append("<title>" + TITLE + ": " + escaped(now.path().toString()) + "</title>\n")
        .append("<style>\n" + STYLE + "</style></head>\n<body>\n")
        .append("<h1>" + TITLE + "</h1>\n<p>" + escaped(summary) + "</p>\n")
        .append("<div class=\"pictures\">\n");
    figure("old: " + old.path(), old.picture(), html);
    figure("new: " + now.path(), now.picture(), html);
    ChangePicture.Drawn difference =
        ChangePicture.of(
            old.file().parsed(),
            old.picture().image(),
            now.file().parsed(),
            now.picture().image(),
            changes);
    figure("difference", new DisplayLight(difference.image(), ImageWriter.Options.ROUNDED), html);
    html.append("</div>\n");
    legend(difference.colors(), html);
    table(changes, lines, html);
    if (!notCompared.isEmpty()) {
      html.append("<p>Not compared: " + escaped(notCompared) + ".</p>\n");
    }
    return html.append("</body></html>\n").toString();
  }

  private static void figure(String caption, DisplayLight picture, StringBuilder html) {
    byte[] png = ImageFormat.PNG.bytes(picture.image(), picture.options());
    String data = Base64.getEncoder().encodeToString(png);
    html.append("<figure><img alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64,")
        .append(data)
        .append("\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n");
  }

  private static void legend(Map<String, Rgb> keys, StringBuilder html) {
    html.append("<p>");
    keys.forEach(
        (name, rgb) ->
            html.append("<span class=\"key\" style=\"background:" + css(rgb) + "\"></span>" + name)
                .append(" &nbsp; "));
    html.append("</p>\n");
  }

  /** Returns a linear color as CSS writes it. */
  public static String css(Rgb rgb) {
    return String.format(
        Locale.ROOT,
        "#%02x%02x%02x",
        Math.round(255 * Srgb.encode(rgb.r())),
        Math.round(255 * Srgb.encode(rgb.g())),
        Math.round(255 * Srgb.encode(rgb.b())));
  }

  private static void table(List<PartChange> changes, List<String> lines, StringBuilder html) {
    if (changes.isEmpty()) {
      return;
    }
    html.append("<table><tr><th>part</th><th></th><th>what</th></tr>\n");
    for (int i = 0; i < changes.size(); i++) {
      PartChange change = changes.get(i);
      html.append("<tr><td>" + escaped(change.name()))
          .append("</td><td>" + word(change.kind()))
          .append("</td><td>" + escaped(lines.get(i)) + "</td></tr>\n");
    }
    html.append("</table>\n");
  }

  /** Returns a kind of change as users read it. */
  public static String word(Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }

  /** Returns a text escaped for HTML. */
  private static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
