package io.github.lumbre;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import io.github.lumbre.testing.Folders;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

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

  /** The pages about films and releases have versions as examples. */
  @Test
  @DisabledOnOs(OS.WINDOWS)
  void preparingAReleaseChangesTheVersionEverywhere(@TempDir Path copy) throws Exception {
    String version = first("pom.xml", "(?m)^  <version>(.+)</version>$");
    List<Path> files = new ArrayList<>(Folders.files(Path.of("docs"), ".md"));
    files.removeAll(List.of(Path.of("docs/film-format.md"), Path.of("docs/releasing.md")));
    Stream.of("pom.xml", "spark/pom.xml", "junit/pom.xml", "README.md", "CITATION.cff")
        .map(Path::of)
        .forEach(files::add);
    files.addAll(List.of(CATALOG, Path.of("codemeta.json"), Path.of("release/prepare")));
    for (Path file : files) {
      Files.createDirectories(copy.resolve(file).getParent());
      Files.copy(file, copy.resolve(file), StandardCopyOption.COPY_ATTRIBUTES);
    }
    Process prepare =
        new ProcessBuilder(copy.resolve("release/prepare").toString(), "98.7.6")
            .redirectErrorStream(true)
            .start();
    String said = new String(prepare.getInputStream().readAllBytes(), UTF_8);
    assertThat(prepare.waitFor()).as(said).isZero();
    assertThat(Files.readString(copy.resolve("docs/java.md"))).contains("lumbre:98.7.6\n");
    assertThat(Files.readString(copy.resolve("docs/install.md")))
        .contains("lumbre_98.7.6_amd64.deb", "lumbre-98.7.6-linux", "<version>98.7.6</version>")
        .contains("lumbre-98.7.6-cli.jar", "lumbre-98.7.6-lab.jar");
    for (Path file : files) {
      assertThat(Files.readString(copy.resolve(file)))
          .as(file.toString())
          .doesNotContain("lumbre:" + version, "lumbre-" + version, ">" + version + "<");
    }
  }

  /** What registries of research software read agrees with the build and the citation. */
  @Test
  void codeMetaStatesWhatTheBuildStates() throws IOException {
    JsonObject meta =
        JsonParser.parseString(Files.readString(Path.of("codemeta.json"))).getAsJsonObject();
    assertThat(meta.get("version").getAsString())
        .isEqualTo(first("pom.xml", "(?m)^  <version>(.+)</version>$"));
    assertThat(meta.get("name").getAsString()).isEqualTo(first("pom.xml", "<name>(.+)</name>"));
    assertThat(meta.get("description").getAsString())
        .isEqualTo(first("pom.xml", "<description>(.+)</description>"));
    String license = first("pom.xml", "<license>\\s*<name>(.+)</name>");
    assertThat(license).isEqualTo(first("CITATION.cff", "(?m)^license: (.+)$"));
    assertThat(meta.get("license").getAsString()).isEqualTo("https://spdx.org/licenses/" + license);
    assertThat(meta.get("runtimePlatform").getAsString())
        .isEqualTo("Java " + first("pom.xml", "<maven.compiler.release>(\\d+)<") + " or newer");
    JsonObject author = meta.getAsJsonArray("author").get(0).getAsJsonObject();
    assertThat(author.get("name").getAsString())
        .isEqualTo(first("CITATION.cff", "(?m)^  - name: (.+)$"));
    List<String> keywords =
        Pattern.compile("(?m)^  - (?!name)(.+)$")
            .matcher(Files.readString(Path.of("CITATION.cff")))
            .results()
            .map(found -> found.group(1))
            .toList();
    assertThat(meta.getAsJsonArray("keywords").asList().stream().map(JsonElement::getAsString))
        .isEqualTo(keywords);
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void sumsAreThoseOfTheFiles(@TempDir Path folder) throws Exception {
    Files.writeString(folder.resolve("b c.deb"), "second");
    Files.writeString(folder.resolve("A.tar.gz"), "first");
    Files.writeString(folder.resolve("SHA256SUMS"), "old");
    Files.createDirectory(folder.resolve("0"));
    Files.createDirectory(folder.resolve("other"));
    assertThat(sums(folder)).isZero();
    assertThat(Files.readString(folder.resolve("SHA256SUMS")))
        .isEqualTo(sha256("first") + "  A.tar.gz\n" + sha256("second") + "  b c.deb\n");
    assertThat(sums(folder.resolve("other"))).isEqualTo(2);
    assertThat(sums(folder.resolve("none"))).isEqualTo(2);
  }

  private static int sums(Path folder) throws Exception {
    return new ProcessBuilder("release/sums", folder.toString())
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start()
        .waitFor();
  }

  private static String sha256(String text) throws NoSuchAlgorithmException {
    byte[] hash = MessageDigest.getInstance("SHA-256").digest(text.getBytes(US_ASCII));
    return HexFormat.of().formatHex(hash);
  }

  /** Every workflow names a release of each action, and what it is allowed to write. */
  @Test
  void workflowsNameReleasesOfTheirActions() throws IOException {
    for (Path workflow : Folders.files(Path.of(".github", "workflows"), ".yml")) {
      String text = Files.readString(workflow);
      assertThat(text).contains("\npermissions:\n  contents: read\n");
      Pattern.compile("uses: (.*)")
          .matcher(text)
          .results()
          .forEach(
              found ->
                  assertThat(found.group(1))
                      .as("%s", workflow)
                      .matches("[\\w-]+/[\\w-]+@(v\\d+|[0-9a-f]{40} # v[\\d.]+)"));
    }
  }

  @Test
  void pagesSayTheSameOfWindows() throws IOException {
    for (String page : List.of("README.md", "docs/install.md", "docs/releasing.md")) {
      assertThat(Files.readString(Path.of(page)).replaceAll("\\s+", " "))
          .as(page)
          .contains("`lumbre.cmd` was tried under Wine, not on Windows.");
    }
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
