package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * All links in the documentation are valid, the index lists every page, and documentation comments
 * in sources belong to a declaration.
 */
class DocumentationTest {
  private static final Path DOCS = Path.of("docs");
  private static final Pattern LINK =
      Pattern.compile("]\\(([^)\\s]+)\\)|(?:href|src)=\"([^\"]+)\"");
  private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");

  private static List<Path> pages() throws IOException {
    List<Path> pages = new ArrayList<>();
    for (String name : List.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md")) {
      pages.add(Path.of(name));
    }
    for (Path folder : List.of(DOCS, Path.of("renders"), Path.of("src"))) {
      try (Stream<Path> files = Files.walk(folder)) {
        files.filter(file -> file.toString().endsWith(".md")).forEach(pages::add);
      }
    }
    return pages;
  }

  @Test
  void everyLinkLeadsToAFileAndAHeading() throws IOException {
    List<String> broken = new ArrayList<>();
    int links = 0;
    for (Path page : pages()) {
      for (MatchResult found : LINK.matcher(Files.readString(page)).results().toList()) {
        String link = found.group(1) == null ? found.group(2) : found.group(1);
        if (!link.startsWith("http")) {
          links++;
          if (!exists(page, link)) {
            broken.add(page + ": " + link);
          }
        }
      }
    }
    assertThat(broken).isEmpty();
    assertThat(links).isGreaterThan(100);
  }

  private static boolean exists(Path page, String link) throws IOException {
    String[] parts = link.split("#", 2);
    Path target = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]).normalize();
    if (!Files.exists(target)) {
      return false;
    }
    return parts.length == 1
        || HEADING
            .matcher(Files.readString(target))
            .results()
            .anyMatch(heading -> anchor(heading.group(1)).equals(parts[1]));
  }

  /** Returns the anchor that GitHub generates for a heading. */
  private static String anchor(String heading) {
    return heading.strip().toLowerCase(Locale.ROOT).replaceAll("[^\\w\\- ]", "").replace(' ', '-');
  }

  /** The compiler of JDK 25 rejects a documentation comment that another one follows. */
  @Test
  void documentationCommentsBelongToDeclarations() throws IOException {
    Pattern detached = Pattern.compile("\\*/\\R\\s*/\\*\\*");
    List<Path> found = new ArrayList<>();
    int sources = 0;
    for (String folder : List.of("src", "junit/src", "spark/src")) {
      try (Stream<Path> files = Files.walk(Path.of(folder))) {
        for (Path file : files.filter(f -> f.toString().endsWith(".java")).toList()) {
          sources++;
          if (detached.matcher(Files.readString(file)).find()) {
            found.add(file);
          }
        }
      }
    }
    assertThat(found).isEmpty();
    assertThat(sources).isGreaterThan(1000);
  }

  @Test
  void indexListsEveryPage() throws IOException {
    String index = Files.readString(DOCS.resolve("README.md"));
    try (Stream<Path> files = Files.list(DOCS)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .filteredOn(name -> name.endsWith(".md") && !name.equals("README.md"))
          .allSatisfy(name -> assertThat(index).contains("(" + name + ")"));
    }
    String measurements = Files.readString(DOCS.resolve("measurements/README.md"));
    try (Stream<Path> files = Files.list(DOCS.resolve("measurements"))) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .filteredOn(name -> name.endsWith(".md") && !name.equals("README.md"))
          .allSatisfy(name -> assertThat(measurements).contains("(" + name + ")"));
    }
  }
}
