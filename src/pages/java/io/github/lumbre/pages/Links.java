package io.github.lumbre.pages;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Makes the links of pages lead to pages and files of the site. */
final class Links {
  private static final Pattern IMAGE = Pattern.compile("<img ([^>]*)>");
  private static final Pattern SOURCE = Pattern.compile("src=\"([^\"]+)\"");
  private static final Pattern WIDTH = Pattern.compile("width=\"(\\d+)\"");
  private static final Pattern LINK = Pattern.compile("href=\"([^\"]+)\"");

  private final Path repository;
  private final Map<Path, Page> pages;
  private final Assets assets;
  private final List<String> broken;

  Links(Path repository, Map<Path, Page> pages, Assets assets, List<String> broken) {
    this.repository = repository;
    this.pages = pages;
    this.assets = assets;
    this.broken = broken;
  }

  /** Returns the content of a page with links that work in the site. */
  String rewrite(Page page) {
    String images =
        IMAGE.matcher(page.html()).replaceAll(found -> quoted(image(page, found.group(1))));
    String linked =
        LINK.matcher(images).replaceAll(found -> quoted("href=\"" + link(page, found) + '"'));
    return linked
        .replace("<th></th>", "<td></td>")
        .replace("<pre>", "<pre tabindex=\"0\">")
        .replaceAll(
            "(?s)(<table.*?</table>)",
            "<div class=\"table\" tabindex=\"0\" role=\"group\" aria-label=\"Table\">$1</div>");
  }

  private static String quoted(String replacement) {
    return Matcher.quoteReplacement(replacement);
  }

  /** Returns an image as a smaller copy if it has a width, described by its name if by nothing. */
  private String image(Page page, String attributes) {
    Matcher source = SOURCE.matcher(attributes);
    if (!source.find() || isAbsolute(source.group(1))) {
      return "<img " + attributes + ">";
    }
    Path file = resolve(page, source.group(1));
    if (!Files.isRegularFile(repository.resolve(file))) {
      broken.add(page.source() + ": " + source.group(1));
    }
    Matcher width = WIDTH.matcher(attributes);
    int pixels = width.find() ? 2 * Integer.parseInt(width.group(1)) : 0;
    Path copy = assets.image(file, pixels);
    String name = file.getFileName().toString().replaceAll("\\.\\w+$", "").replace('-', ' ');
    String described = attributes.replace("alt=\"\"", "alt=\"" + name + '"');
    String url = relative(page, copy);
    return "<img "
        + SOURCE.matcher(described).replaceAll(quoted("src=\"" + url + "\" loading=\"lazy\""))
        + ">";
  }

  private String link(Page page, MatchResult found) {
    String link = found.group(1);
    if (isAbsolute(link) || link.startsWith("api/")) {
      return link;
    }
    String[] parts = link.split("#", 2);
    String fragment = parts.length == 1 ? "" : "#" + parts[1];
    Path file = parts[0].isEmpty() ? page.source() : resolve(page, parts[0]);
    Page other = pages.get(file);
    if (other == null && Files.isDirectory(repository.resolve(file))) {
      other = pages.get(file.resolve("README.md"));
    }
    if (file.equals(Path.of("README.md"))) {
      return relative(page, Path.of("index.html"));
    }
    if (other != null) {
      if (!fragment.isEmpty() && !other.html().contains("id=\"" + parts[1] + '"')) {
        broken.add(page.source() + ": " + link);
      }
      return relative(page, other.target()) + fragment;
    }
    if (!Files.exists(repository.resolve(file))) {
      broken.add(page.source() + ": " + link);
    }
    return relative(page, assets.file(file));
  }

  private static boolean isAbsolute(String link) {
    return link.matches("(?i)[a-z][a-z0-9+.-]*:.*");
  }

  private Path resolve(Page page, String link) {
    Path folder = repository.resolve(page.source()).getParent();
    String decoded = URLDecoder.decode(link.replace("+", "%2B"), StandardCharsets.UTF_8);
    Path file = folder.resolve(decoded).normalize();
    if (!file.startsWith(repository)) {
      broken.add(page.source() + ": " + link + " leads out of the repository");
      return page.source();
    }
    return repository.relativize(file);
  }

  private static String relative(Page page, Path target) {
    Path folder = page.target().getParent();
    return url(folder == null ? target : folder.relativize(target));
  }

  /** Returns a path as a URL. */
  static String url(Path path) {
    return path.toString().replace('\\', '/');
  }
}
