package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.cli.output.Messages;
import io.github.lumbre.cli.run.CommandLineHost;
import io.github.lumbre.lab.SceneFolder;
import io.github.lumbre.lab.gallery.GalleryRenderer;
import io.github.lumbre.lab.perf.Hardware;
import io.github.lumbre.lab.perf.SampleBudget;
import io.github.lumbre.scene.RenderSettings;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the gallery command and its table. */
class GalleryCommandTest {
  @TempDir private Path directory;

  @BeforeEach
  void writeScenes() throws IOException {
    Files.writeString(directory.resolve("b-scene.json"), TinyScene.JSON);
    Files.writeString(
        directory.resolve("a-scene.json"), TinyScene.with("\"width\": 16", "\"width\": 10"));
    Files.writeString(directory.resolve("notes.csv"), "");
  }

  private Outcome gallery(String... arguments) {
    Stream<String> first =
        Stream.of("gallery", "--scenes", "" + directory, "--out", "" + out(), "--seconds", "1");
    return Outcome.of(Stream.concat(first, Stream.of(arguments)).toArray(String[]::new));
  }

  private Path out() {
    return directory.resolve("pictures");
  }

  private List<String> rows() throws IOException {
    return Files.readAllLines(out().resolve("README.md")).stream()
        .filter(line -> line.startsWith("| ["))
        .toList();
  }

  @Test
  void everySceneBecomesAPictureAndARow() throws IOException {
    Outcome outcome = gallery();
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    assertThat(outcome.out()).isEmpty();
    assertThat(ImageIO.read(out().resolve("a-scene.png").toFile()).getWidth()).isEqualTo(10);
    assertThat(ImageIO.read(out().resolve("b-scene.png").toFile()).getWidth()).isEqualTo(16);
    assertThat(rows()).hasSize(2);
    String samples = rows().get(1).split("\\|")[4].trim();
    assertThat(Integer.parseInt(samples)).isGreaterThanOrEqualTo(64);
    assertThat(Files.readString(out().resolve("b-scene.png"), StandardCharsets.ISO_8859_1))
        .contains("Scene\000b-scene.json", "Samples\000" + samples);
    assertThat(rows().get(0)).startsWith("| [a-scene](a-scene.png) |").contains("| 10x12 | ");
    assertThat(rows().get(1)).contains("src=\"b-scene.png\"", Hardware.here().cpu());
  }

  @Test
  void rowsOfOtherPicturesStayAsLongAsThePictures() throws IOException {
    gallery();
    String kept = rows().get(0);
    assertThat(gallery("b-scene").exitCode()).isZero();
    assertThat(rows()).hasSize(2).contains(kept);
    Files.delete(out().resolve("a-scene.png"));
    gallery("b-scene");
    assertThat(rows()).hasSize(1).noneMatch(row -> row.contains("a-scene"));
  }

  @Test
  void unknownScenesAndFoldersAreUsageErrors() throws IOException {
    gallery("c-scene")
        .assertFailed(ExitCodes.USAGE, "expected some of a-scene, b-scene, found c-scene");
    assertThat(out()).doesNotExist();
    Outcome.of("gallery", "--scenes", directory + "/no").assertFailed(ExitCodes.USAGE, "no");
    Outcome.of("gallery", "--seconds", "0").assertFailed(ExitCodes.USAGE, "--seconds");
    gallery("--threads", "-1").assertFailed(ExitCodes.USAGE, "--threads: expected 0 to");
  }

  @Test
  void threadsAreThoseAskedFor() throws IOException {
    assertThat(gallery("--threads", "1", "a-scene").exitCode()).isZero();
    assertThat(rows().get(0).split("\\|")[6].strip()).isEqualTo("1");
    assertThat(gallery("--threads", "3", "a-scene").exitCode()).isZero();
    assertThat(rows().get(0).split("\\|")[6].strip()).isEqualTo("3");
  }

  @Test
  void denoisedPicturesSaySoAndStateTheNoiseBefore() throws IOException {
    assertThat(gallery("--denoise", "a-scene").exitCode()).isZero();
    assertThat(rows().get(0)).matches(".*\\| [0-9.]+ %, then denoised \\|");
    assertThat(Files.readString(out().resolve("a-scene.png"), StandardCharsets.ISO_8859_1))
        .contains("Denoiser\000built-in", "DenoiserChange\000");
    assertThat(gallery("b-scene").exitCode()).isZero();
    assertThat(rows().get(1)).matches(".*\\| [0-9.]+ % \\|");
    assertThat(Files.readString(out().resolve("b-scene.png"), StandardCharsets.ISO_8859_1))
        .doesNotContain("Denoiser");
  }

  @Test
  void aTimeTooShortForTheFewestSamplesIsNamed() {
    RenderSettings settings = new RenderSettings.Builder().size(10, 20).build();
    assertThat(SampleBudget.leastSeconds(6400, settings)).isEqualTo(2);
    StringWriter text = new StringWriter();
    Messages messages = new Messages(new PrintWriter(text, true));
    GalleryRenderer renderer =
        new GalleryRenderer(
            new SceneFolder(directory), 1, 0, false, new CommandLineHost(null, false, messages));
    renderer.warnIfTooShort("a-scene", settings, 12800);
    assertThat(text.toString()).isEmpty();
    renderer.warnIfTooShort("a-scene", settings, 6400);
    assertThat(text.toString().strip())
        .isEqualTo(
            "warning: a-scene: --seconds 1 is too short for the minimum of 64 samples per pixel,"
                + " which take about 2 s");
  }

  @ParameterizedTest
  @CsvSource({
    "100, 64",
    "7000, 64",
    "12900, 128",
    "100000, 992",
    "1000000, 10000",
    "1e300, 1073741824"
  })
  void samplesFillTheTimeInMultiplesOfSixteen(double rate, int samples) {
    RenderSettings settings = new RenderSettings.Builder().size(10, 20).samples(4).build();
    assertThat(SampleBudget.samples(rate, 2, settings)).isEqualTo(samples);
  }
}
