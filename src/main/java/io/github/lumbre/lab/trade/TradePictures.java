package io.github.lumbre.lab.trade;

import io.github.lumbre.compare.ErrorMap;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.lab.Numbers;
import java.util.Base64;
import java.util.List;

/**
 * The section of a study's page that shows each picture beside its error map.
 *
 * @param options options for writing the pictures
 */
record TradePictures(TradeResult result, ImageWriter.Options options) {
  /** Adds the pictures to a page. */
  void addTo(Html html) {
    html.element("h2", "Pictures and error maps")
        .raw("<div class=\"pictures\"><figure>")
        .raw(image(result.reference(), options, "reference"))
        .raw("<figcaption>reference, " + result.referenceSamples() + " samples</figcaption>")
        .raw("</figure></div>");
    scale(html);
    html.element("h3", "Baseline with increasing samples");
    pairs(html, result.usual());
    html.element("h3", "Other settings");
    pairs(
        html,
        result.rows().stream()
            .map(TradeRow::setting)
            .distinct()
            .skip(1)
            .map(result::most)
            .toList());
  }

  /** Adds the color scale of the error maps. */
  private static void scale(Html html) {
    html.raw(
        "<div class=\"scale\" style=\"background:linear-gradient(90deg,"
            + String.join(",", ErrorMap.webColors())
            + ")\"></div><div class=\"marks\"><span>0.1 %</span><span>1 %</span><span>10"
            + " %</span><span>100 %</span></div><p class=\"note\">Colors of the relative error of"
            + " pixels.</p>");
  }

  private void pairs(Html html, List<TradeRow> rows) {
    html.raw("<div class=\"pictures\">");
    for (TradeRow row : rows) {
      String name = row.setting().label() + ", " + Numbers.count(row.samples(), "sample");
      String error = TradeText.rootPercent(row.seeds().get(0).error().relativeMse());
      Image map = ErrorMap.of(row.picture(), result.reference());
      html.raw("<figure><div class=\"pair\">")
          .raw(image(row.picture(), options, name))
          .raw(image(map, ImageWriter.Options.DEFAULT, "error of " + name))
          .raw("</div><figcaption>" + Html.escaped(name + ": " + error))
          .raw("</figcaption></figure>");
    }
    html.raw("</div>");
  }

  private static String image(Image image, ImageWriter.Options how, String name) {
    String data = Base64.getEncoder().encodeToString(image.toPng(how));
    return "<img width=\"%d\" height=\"%d\" alt=\"%s\" src=\"data:image/png;base64,%s\">"
        .formatted(image.width(), image.height(), Html.escaped(name), data);
  }
}
