package io.github.lumbre.lab.trade;

import java.util.List;

/** Writes a page, element by element. Mutable. */
final class Html {
  /** From this number of columns on, a table is wider than narrow screens. */
  private static final int WIDE = 4;

  private final StringBuilder text = new StringBuilder();

  /**
   * A table's line.
   *
   * @param cells texts, one for each column
   * @param style class of the line; may be empty
   */
  record Row(List<String> cells, String style) {
    static Row of(String... cells) {
      return new Row(List.of(cells), "");
    }
  }

  /** Returns a text as HTML and SVG can hold it. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }

  /** Adds what is HTML already. */
  Html raw(String html) {
    text.append(html).append('\n');
    return this;
  }

  /** Adds an element that holds a text. */
  Html element(String name, String content) {
    return raw("<" + name + ">" + escaped(content) + "</" + name + ">");
  }

  /** Adds a paragraph in small print. */
  Html note(String content) {
    return raw("<p class=\"note\">" + escaped(content) + "</p>");
  }

  /** Adds a table that scrolls sideways by itself where the page is too narrow for it. */
  Html table(List<String> head, List<Row> rows) {
    return table("", head, rows);
  }

  /**
   * Adds a table.
   *
   * @param above a line of the head above the other, as HTML; may be empty
   */
  Html table(String above, List<String> head, List<Row> rows) {
    if (head.size() >= WIDE) {
      raw(
          "<div class=\"hint\">Scroll the table sideways for all "
              + head.size()
              + " columns \u2192</div>");
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
