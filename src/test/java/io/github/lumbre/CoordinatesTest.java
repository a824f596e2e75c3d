package io.github.lumbre;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The README shows the Maven coordinates of the build. */
class CoordinatesTest {
  private static final Pattern COORDINATES =
      Pattern.compile(
          "<groupId>(.+)</groupId>\\s*<artifactId>(.+)</artifactId>\\s*<version>(.+)</version>");

  private static String first(Path file) throws IOException {
    Matcher found = COORDINATES.matcher(Files.readString(file));
    assertThat(found.find()).isTrue();
    return found.group(1) + ":" + found.group(2) + ":" + found.group(3);
  }

  @Test
  void readmeHasTheCoordinatesOfTheBuild() throws IOException {
    assertThat(first(Path.of("README.md"))).isEqualTo(first(Path.of("pom.xml")));
  }
}
