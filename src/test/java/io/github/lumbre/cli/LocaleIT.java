package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests file names with non-ASCII letters without a locale, as in cron and in containers. The
 * commands are in files, because a JVM without a locale cannot pass such names on.
 */
@DisabledOnOs(OS.WINDOWS)
class LocaleIT {
  @TempDir private Path directory;

  @BeforeEach
  void writeScene() throws IOException, InterruptedException {
    String texture = "{\"id\": 9, \"assetType\": \"Texture\", \"file\": \"m\\u00e4r.png\"}";
    String scene =
        TinyScene.withAsset(texture).replace("\"Diffuse\",", "\"Diffuse\", \"colorTextureId\": 9,");
    Files.writeString(directory.resolve("plain.json"), scene);
    Files.write(directory.resolve("plain.png"), Pictures.png(2, 2, 0));
    assertThat(sh("cp plain.json bär.json && mv plain.png mär.png").exitCode()).isZero();
  }

  private Outcome sh(String commands) throws IOException, InterruptedException {
    Path script = directory.resolve("commands.sh");
    Files.write(script, commands.getBytes(StandardCharsets.UTF_8));
    return Program.run(directory, List.of("sh", script.toString()));
  }

  private static String without(String locale) {
    return "unset LANG LC_ALL LC_CTYPE LC_MESSAGES\n" + locale + "\n";
  }

  private static String jar() {
    return "'" + Program.java("java") + "' -jar '" + Program.JAR + "'";
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "export LC_ALL=C", "export LANG=POSIX", "export LANG=xx_YY.UTF-8"})
  void launcherReadsAndWritesSuchNames(String locale) throws IOException, InterruptedException {
    assumeTrue(
        sh("LC_ALL=C.UTF-8 locale charmap").out().equals("UTF-8\n"), "there is no C.UTF-8 here");
    Outcome outcome =
        sh(without(locale)
                + "export JAVA_HOME='"
                + System.getProperty("java.home")
                + "'\n'"
                + Path.of("lumbre").toAbsolutePath()
                + "' render bär.json -o blüte.png && test -s blüte.png")
            .done();
    assertThat(outcome.err()).startsWith("blüte.png: 16x12 pixels");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "export LC_ALL=C", "export LANG=POSIX"})
  void jarNamesTheLocaleAndTheRemedy(String locale) throws IOException, InterruptedException {
    String remedy = "set the environment variable LC_ALL to C.UTF-8";
    Outcome argument = sh(without(locale) + jar() + " render bär.json");
    assertThat(argument.exitCode()).isEqualTo(ExitCodes.USAGE);
    assertThat(argument.err()).contains("ANSI_X3.4-1968", remedy).doesNotContain("Exception");
    Outcome asset = sh(without(locale) + jar() + " render plain.json");
    assertThat(asset.exitCode()).isEqualTo(ExitCodes.ASSET);
    assertThat(asset.err())
        .contains("plain.json: $.assets[0].file: ", "\"mär.png\"", "ANSI_X3.4-1968", remedy)
        .doesNotContain("Exception");
  }

  @Test
  void namesOfAsciiNeedNoLocale() throws IOException, InterruptedException {
    Files.writeString(directory.resolve("tiny.json"), TinyScene.JSON);
    Outcome outcome = sh(without("export LC_ALL=C") + jar() + " render tiny.json").done();
  }

  @Test
  void numbersHaveTheSameDigitsEverywhere() throws IOException, InterruptedException {
    ModelSample.write(directory);
    String render = " render sample.glb --turntable 1 -o a.png --size 8x6 -s 1";
    String persian = jar().replace(" -jar ", " -Duser.language=fa -jar ");
    Outcome outcome = sh(without("export LC_ALL=C.UTF-8") + persian + render).done();
    assertThat(directory.resolve("a-000.png")).exists();
  }
}
