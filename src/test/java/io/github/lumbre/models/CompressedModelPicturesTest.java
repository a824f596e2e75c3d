package io.github.lumbre.models;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.Outcome;
import io.github.lumbre.image.compare.Flip;
import io.github.lumbre.image.internal.LinearReader;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * A model looks the same with compressed meshes and textures. The pictures are in {@code
 * target/models/pictures/compressed}, with a table and a contact sheet for each model.
 */
@Tag("models")
class CompressedModelPicturesTest {
  private static final Path FOLDER = ModelSource.ROOT.resolve("pictures").resolve("compressed");
  private static final int WIDTH = 128;
  private static final int HEIGHT = 96;
  private static final int COLUMNS = 6;
  private static final double LARGEST_FLIP = .02;

  /** For lossy textures of a chart with flat, saturated colors. */
  private static final double LARGEST_FLIP_OF_CHART = .03;

  private static final String CHART = "transforms";
  private static final Set<String> LOSSY = Set.of("webp", "etc1s", "draco-webp", "meshopt-etc1s");

  /** What the reference decoder left of a file, without compression. */
  private static final String DECODED = "-decoded";

  private static final List<String> LINES = new ArrayList<>();

  /** The pictures of each model. */
  private static final Map<String, List<Path>> PICTURES = new TreeMap<>();

  static List<Path> variants() throws IOException, InterruptedException {
    if (!ModelSource.selected().contains(ModelSource.COMPRESSED)) {
      return List.of();
    }
    return ModelSource.COMPRESSED.fetch().stream()
        .filter(file -> !isUncompressed(file))
        .sorted(Comparator.comparing(Path::toString))
        .toList();
  }

  private static boolean isUncompressed(Path file) {
    String kind = kind(file);
    return kind.equals("plain") || kind.equals("copies") || kind.endsWith(DECODED);
  }

  @ParameterizedTest(allowZeroInvocations = true)
  @MethodSource("variants")
  void theCompressedModelHasThePictureOfThePlainOne(Path file) throws IOException {
    String kind = kind(file);
    Path picture = render(file);
    Path plain = render(sibling(file, kind.endsWith("instances") ? "copies" : "plain"));
    double flip = Flip.mean(LinearReader.read(picture), LinearReader.read(plain));
    Path decoded = sibling(file, kind + DECODED);
    boolean isLossless = kind.equals("webp-lossless");
    LINES.add(String.format(Locale.ROOT, "| %s | %s | %.4f |", model(file), kind, flip));
    if (isLossless) {
      assertThat(pixels(picture)).as("pixels of the plain model").isEqualTo(pixels(plain));
    }
    if (Files.exists(decoded)) {
      assertThat(pixels(picture))
          .as("pixels of the model that the reference decoder decoded")
          .isEqualTo(pixels(render(decoded)));
    }
    boolean isChart = model(file).equals(CHART) && LOSSY.contains(kind);
    assertThat(flip)
        .as("FLIP beside the uncompressed model")
        .isLessThanOrEqualTo(isChart ? LARGEST_FLIP_OF_CHART : LARGEST_FLIP);
  }

  /** Renders a model if its picture is not there, and returns the picture. */
  private static Path render(Path model) throws IOException {
    Path picture = FOLDER.resolve(model.getFileName().toString().replace(".glb", ".png"));
    List<Path> known = PICTURES.computeIfAbsent(model(model), name -> new ArrayList<>());
    if (known.contains(picture)) {
      return picture;
    }
    Files.createDirectories(FOLDER);
    Outcome outcome =
        Outcome.of(
            "render",
            model.toString(),
            "-o",
            picture.toString(),
            "--overwrite",
            "--quiet",
            "--size",
            WIDTH + "x" + HEIGHT,
            "--samples",
            "64");
    assertThat(outcome.exitCode()).as(outcome.err()).isZero();
    known.add(picture);
    return picture;
  }

  /** Returns the name of a model, which ends at the first hyphen. */
  private static String model(Path file) {
    String name = file.getFileName().toString();
    return name.substring(0, name.indexOf('-'));
  }

  private static String kind(Path file) {
    String name = file.getFileName().toString();
    return name.substring(name.indexOf('-') + 1, name.lastIndexOf('.'));
  }

  private static Path sibling(Path file, String kind) {
    return file.resolveSibling(model(file) + "-" + kind + ".glb");
  }

  private static int[] pixels(Path picture) throws IOException {
    return ImageIO.read(picture.toFile()).getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
  }

  @AfterAll
  static void writeTableAndSheets() throws IOException {
    Files.createDirectories(FOLDER);
    List<String> table = new ArrayList<>(List.of("| model | variant | FLIP |", "|---|---|--:|"));
    table.addAll(LINES);
    Files.write(FOLDER.resolve("table.md"), table);
    for (Map.Entry<String, List<Path>> model : PICTURES.entrySet()) {
      List<BufferedImage> pictures = new ArrayList<>();
      for (Path picture : model.getValue()) {
        pictures.add(ImageIO.read(picture.toFile()));
      }
      ContactSheet.write(FOLDER.resolve("sheet-" + model.getKey() + ".png"), pictures, COLUMNS);
    }
  }
}
