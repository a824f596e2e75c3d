package io.github.lumbre.cli.view;

import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.scene.Layer;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.stream.Collectors;

/** The page: one text with its style and its script inside. */
final class Page {
  private static final String[] SCRIPTS = {"tone.js", "chart.js", "paths.js", "page.js"};

  private Page() {}

  /**
   * Returns the page.
   *
   * @param nonce the only style and script with this mark may run
   */
  static String text(String nonce) {
    String script = Arrays.stream(SCRIPTS).map(Page::resource).collect(Collectors.joining("\n"));
    String curves =
        Arrays.stream(ToneCurve.values())
            .map(curve -> "<option>" + curve.label() + "</option>")
            .collect(Collectors.joining());
    String layers =
        Arrays.stream(Layer.values())
            .map(layer -> "<option>" + layer.text() + "</option>")
            .collect(Collectors.joining());
    return resource("page.html")
        .replace("<!--curves-->", curves)
        .replace("/*style*/", resource("page.css"))
        .replace("/*script*/", script)
        .replace("<!--layers-->", layers)
        .replace("NONCE", nonce);
  }

  private static String resource(String name) {
    try (InputStream in = Page.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new AssertionError(name);
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
