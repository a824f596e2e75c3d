package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The files that packages are made from agree with the build. */
class ReleaseFilesTest {
  private static final Path CATALOG = Path.of("jbang-catalog.json");
  private static final String VECTORS = "--add-modules=jdk.incubator.vector";

  private static String first(String file, String pattern) throws IOException {
    return Pattern.compile(pattern)
        .matcher(Files.readString(Path.of(file)))
        .results()
        .findFirst()
        .map(found -> found.group(1))
        .orElseThrow(() -> new AssertionError(file + " holds nothing like " + pattern));
  }

  private static JsonObject catalog() throws IOException {
    return JsonParser.parseString(Files.readString(CATALOG)).getAsJsonObject();
  }

  private static JsonObject alias(JsonObject catalog) {
    return catalog.getAsJsonObject("aliases").getAsJsonObject("lumbre");
  }

  @Test
  void allFilesStateTheSameVersion() throws IOException {
    String version = first("pom.xml", "(?m)^  <version>(.+)</version>$");
    for (String pom : List.of("spark/pom.xml", "junit/pom.xml")) {
      assertThat(first(pom, "(?m)^  <version>(.+)</version>$")).isEqualTo(version);
    }
    for (String page : List.of("README.md", "docs/golden.md", "docs/java.md")) {
      assertThat(first(page, "<version>(.+)</version>")).isEqualTo(version);
    }
    assertThat(first("docs/java.md", "\"io.github.lumbre:lumbre:(.+)\"")).isEqualTo(version);
    assertThat(first("CITATION.cff", "(?m)^version: (.+)$")).isEqualTo(version);
    assertThat(alias(catalog()).get("script-ref").getAsString())
        .isEqualTo("io.github.lumbre:lumbre:" + version + ":cli");
    assertThat(alias(catalog()).getAsJsonArray("dependencies").get(0).getAsString())
        .isEqualTo("io.github.lumbre:lumbre:" + version + ":lab");
  }

  /** The catalog's options are a copy, which {@code -Dlumbre.write=true} makes anew. */
  @Test
  void catalogPassesTheOptionsOfTheLaunchers() throws IOException {
    JsonArray options = new JsonArray();
    options.add(VECTORS);
    try (Stream<String> lines = Files.lines(Path.of("src", "main", "jvm", "options"))) {
      lines.filter(line -> line.startsWith("-")).forEach(options::add);
    }
    if (Boolean.getBoolean("lumbre.write")) {
      JsonObject catalog = catalog();
      alias(catalog).add("runtime-options", options);
      Gson gson = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();
      Files.writeString(CATALOG, gson.toJson(catalog) + "\n");
    }
    assertThat(alias(catalog()).get("runtime-options")).isEqualTo(options);
  }

  /** No file names a place that nobody has chosen yet. */
  @Test
  void projectLivesWhereWhoeverReleasesItSays() throws IOException {
    assertThat(first("pom.xml", "<lumbre.url>(.+)</lumbre.url>")).startsWith("https://");
    List<MatchResult> urls =
        Pattern.compile("(?m)^  <url>(.+)</url>$")
            .matcher(Files.readString(Path.of("pom.xml")))
            .results()
            .toList();
    assertThat(urls).hasSize(1);
    assertThat(urls.get(0).group(1)).isEqualTo("${lumbre.url}");
  }
}
