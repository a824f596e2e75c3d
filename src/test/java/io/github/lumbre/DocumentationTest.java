package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
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
      pages.addAll(Folders.below(folder, ".md"));
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
      for (Path file : Folders.below(Path.of(folder), ".java")) {
        sources++;
        if (detached.matcher(Files.readString(file)).find()) {
          found.add(file);
        }
      }
    }
    assertThat(found).isEmpty();
    assertThat(sources).isGreaterThan(1000);
  }

  @Test
  void indexListsEveryPage() throws IOException {
    String index = Files.readString(DOCS.resolve("README.md"));
    assertThat(Folders.names(DOCS))
        .filteredOn(name -> name.endsWith(".md") && !name.equals("README.md"))
        .allSatisfy(name -> assertThat(index).contains("(" + name + ")"));
    String measurements = Files.readString(DOCS.resolve("measurements/README.md"));
    assertThat(Folders.names(DOCS.resolve("measurements")))
        .filteredOn(name -> name.endsWith(".md") && !name.equals("README.md"))
        .allSatisfy(name -> assertThat(measurements).contains("(" + name + ")"));
  }
}
