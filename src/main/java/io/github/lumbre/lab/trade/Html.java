package io.github.lumbre.lab.trade;

import io.github.lumbre.lab.Table;
import java.util.List;
import java.util.function.Function;

/** Builds an HTML page, element by element. Mutable. */
final class Html {
  /** Tables with at least this many columns are wider than narrow screens. */
  private static final int WIDE = 4;

  private final StringBuilder text = new StringBuilder();

  /** Returns a text escaped for HTML and SVG. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  /** Adds HTML without escaping it. */
  Html raw(String html) {
    text.append(html).append('\n');
    return this;
  }

  /** Adds an element with escaped text. */
  Html element(String name, String content) {
    return raw("<" + name + ">" + escaped(content) + "</" + name + ">");
  }

  /** Adds a paragraph in small print. */
  Html note(String content) {
    return raw("<p class=\"note\">" + escaped(content) + "</p>");
  }

  /**
   * Adds a table that scrolls sideways where the page is too narrow for it.
   *
   * @param above an additional header row, as HTML; may be empty
   * @param style returns the CSS class of a row; may be empty
   */
  <T> Html table(String above, Table<T> table, List<T> rows, Function<T, String> style) {
    int columns = table.names().size();
    if (columns >= WIDE) {
      raw("<div class=\"hint\">Scroll sideways for all " + columns + " columns \u2192</div>");
    }
    text.append("<div class=\"scroll\" tabindex=\"0\"><table><thead>").append(above);
    row("<tr>", "th", table.names()).raw("</thead><tbody>");
    for (T row : rows) {
      String name = style.apply(row);
      String open = name.isEmpty() ? "<tr>" : "<tr class=\"" + name + "\">";
      row(open, "td", table.cells(row)).raw("");
    }
    return raw("</tbody></table></div>");
  }

  private Html row(String open, String element, List<String> cells) {
    text.append(open);
    for (String cell : cells) {
      text.append("<" + element + ">" + escaped(cell) + "</" + element + ">");
    }
    text.append("</tr>");
    return this;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
