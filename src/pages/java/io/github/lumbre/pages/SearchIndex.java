package io.github.lumbre.pages;

import com.google.gson.Gson;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What the search of the site knows: the sections of all pages. */
final class SearchIndex {
  private static final Pattern HEADING =
      Pattern.compile("(?s)<h([1-6]) id=\"([^\"]*)\">(.*?)</h\\1>");
  private static final int LONGEST = 2000;

  private final List<Section> sections = new ArrayList<>();

  private record Section(String page, String heading, String url, String text) {}

  void add(Page page) {
    Matcher headings = HEADING.matcher(page.html());
    int start = 0;
    String heading = page.title();
    String url = Links.url(page.target());
    while (headings.find()) {
      addSection(page, heading, url, page.html().substring(start, headings.start()));
      heading = plain(headings.group(3));
      url = Links.url(page.target()) + "#" + headings.group(2);
      start = headings.end();
    }
    addSection(page, heading, url, page.html().substring(start));
  }

  private void addSection(Page page, String heading, String url, String html) {
    String text = plain(html);
    if (!text.isEmpty()) {
      String kept = text.length() > LONGEST ? text.substring(0, LONGEST) : text;
      sections.add(new Section(page.title(), heading, url, kept));
    }
  }

  private static String plain(String html) {
    return html.replaceAll("<[^>]*>", " ")
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&amp;", "&")
        .replaceAll("\\s+", " ")
        .strip();
  }

  /** Returns a script that defines the index, since pages opened as files cannot fetch JSON. */
  String script() {
    return "window.lumbreIndex = " + new Gson().toJson(sections) + ";\n";
  }
}
