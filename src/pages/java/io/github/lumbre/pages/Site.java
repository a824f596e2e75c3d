package io.github.lumbre.pages;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * Makes the static site: {@code Site REPOSITORY OUTPUT VERSION}. Every Markdown page becomes an
 * HTML page; files that pages link to are copied beside them, so that no link leaves the site
 * unless it names a host. A link that leads nowhere fails the build.
 */
final class Site {
  /** The groups of the navigation; pages that no group names are in the last one. */
  private static final Map<String, List<String>> GROUPS = new LinkedHashMap<>();

  static {
    GROUPS.put("Start", List.of("install", "gallery", "cli", "java"));
    GROUPS.put(
        "Scenes",
        List.of("models", "model-pictures", "animations", "scene-format", "materials", "layers"));
    GROUPS.put("Rendering", List.of("long-renders", "cluster", "trade", "performance"));
    GROUPS.put("Trust", List.of("numerics", "stability", "reliability", "SECURITY", "testing"));
    GROUPS.put("More", List.of());
  }

  private final Path repository;
  private final Path output;
  private final String version;
  private final Map<Path, Page> pages = new TreeMap<>();
  private final Assets assets;
  private final List<String> broken = new ArrayList<>();

  private Site(Path repository, Path output, String version) {
    this.repository = repository;
    this.output = output;
    this.version = version;
    assets = new Assets(repository, output);
  }

  /** Makes the site and exits with 1 if a link is broken. */
  public static void main(String[] args) throws IOException {
    new Site(Path.of(args[0]).toAbsolutePath().normalize(), Path.of(args[1]), args[2]).make();
  }

  private void make() throws IOException {
    readPages();
    Links links = new Links(repository, pages, assets, broken);
    String template = resource("page.html");
    SearchIndex index = new SearchIndex();
    for (Page page : pages.values()) {
      index.add(page);
      write(page.target(), fill(template, page, links.rewrite(page), page.target()));
    }
    Path landing = Path.of("index.html");
    String body = links.rewrite(new Page(Path.of("index.html"), landing, "Lumbre", front()));
    write(landing, fill(resource("landing.html"), pages.values().iterator().next(), body, landing));
    write(Path.of("search-index.js"), index.script());
    for (String name : List.of("style.css", "site.js", "favicon.svg")) {
      write(Path.of(name), resource(name));
    }
    assets.write();
    if (!broken.isEmpty()) {
      broken.forEach(System.err::println);
      System.exit(1);
    }
    System.out.println(pages.size() + " pages, " + assets.count() + " files, no broken links");
  }

  private void readPages() throws IOException {
    List<Path> sources = new ArrayList<>();
    for (String name : List.of("CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md")) {
      sources.add(Path.of(name));
    }
    for (String folder : List.of("docs", "renders")) {
      try (Stream<Path> files = Files.walk(repository.resolve(folder))) {
        files
            .filter(file -> file.toString().endsWith(".md"))
            .map(repository::relativize)
            .sorted()
            .forEach(sources::add);
      }
    }
    for (Path source : sources) {
      String text = Files.readString(repository.resolve(source));
      pages.put(source, Page.of(source, text));
    }
  }

  private String front() throws IOException {
    return resource("front.html");
  }

  private String fill(String template, Page page, String body, Path target) {
    String root = "../".repeat(target.getNameCount() - 1);
    return template
        .replace("{{navigation}}", navigation(target, root))
        .replace("{{title}}", Page.escape(page.title()))
        .replace("{{root}}", root)
        .replace("{{version}}", Page.escape(version))
        .replace("{{body}}", body);
  }

  private String navigation(Path current, String root) {
    Map<String, List<Page>> groups = new LinkedHashMap<>();
    GROUPS.keySet().forEach(name -> groups.put(name, new ArrayList<>()));
    for (Map.Entry<String, List<String>> group : GROUPS.entrySet()) {
      for (String name : group.getValue()) {
        pages.values().stream()
            .filter(page -> page.name().equals(name))
            .forEach(groups.get(group.getKey())::add);
      }
    }
    for (Page page : pages.values()) {
      boolean isListed = groups.values().stream().anyMatch(list -> list.contains(page));
      boolean isTop = page.source().getNameCount() <= 2;
      if (!isListed && isTop) {
        groups.get("More").add(page);
      }
    }
    StringBuilder html = new StringBuilder();
    for (Map.Entry<String, List<Page>> group : groups.entrySet()) {
      html.append("<p class=\"group\">").append(group.getKey()).append("</p>\n<ul>\n");
      for (Page page : group.getValue()) {
        html.append("<li><a href=\"").append(root).append(Links.url(page.target())).append('"');
        html.append(page.target().equals(current) ? " aria-current=\"page\"" : "").append('>');
        html.append(Page.escape(page.shortTitle())).append("</a></li>\n");
      }
      html.append("</ul>\n");
    }
    return html.toString();
  }

  private String resource(String name) throws IOException {
    return Files.readString(repository.resolve("src/pages/site").resolve(name));
  }

  private void write(Path target, String text) throws IOException {
    Path file = output.resolve(target);
    Files.createDirectories(file.toAbsolutePath().getParent());
    Files.writeString(file, text);
  }
}
