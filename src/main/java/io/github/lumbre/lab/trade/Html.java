package io.github.lumbre.lab.trade;

import java.util.List;

/** Builds an HTML page, element by element. Mutable. */
final class Html {
  /** Tables with at least this many columns are wider than narrow screens. */
  private static final int WIDE = 4;

  private final StringBuilder text = new StringBuilder();

  /**
   * A table row.
   *
   * @param cells text of each column
   * @param style CSS class of the row; may be empty
   */
  record Row(List<String> cells, String style) {
    static Row of(String... cells) {
      return new Row(List.of(cells), "");
    }
  }

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

  /** Adds a table that scrolls sideways where the page is too narrow for it. */
  Html table(List<String> head, List<Row> rows) {
    return table("", head, rows);
  }

  /**
   * Adds a table.
   *
   * @param above an additional header row, as HTML; may be empty
   */
  Html table(String above, List<String> head, List<Row> rows) {
    if (head.size() >= WIDE) {
      raw("<div class=\"hint\">Scroll sideways for all " + head.size() + " columns \u2192</div>");
    }
    text.append("<div class=\"scroll\" tabindex=\"0\"><table><thead>").append(above).append("<tr>");
    head.forEach(cell -> text.append("<th>").append(escaped(cell)).append("</th>"));
    text.append("</tr></thead><tbody>\n");
    for (Row row : rows) {
      text.append(row.style.isEmpty() ? "<tr>" : "<tr class=\"" + row.style + "\">");
      row.cells.forEach(cell -> text.append("<td>").append(escaped(cell)).append("</td>"));
      text.append("</tr>\n");
    }
    text.append("</tbody></table></div>\n");
    return this;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
