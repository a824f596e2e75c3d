package io.github.lumbre.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.compare.Flip;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests comparisons with golden pictures. */
class GoldenPicturesTest {
  private static final ImageWriter.Options BITS_16 =
      new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 16, Map.of());

  @TempDir private Path folder;

  private Path golden() {
    return folder.resolve("golden");
  }

  private GoldenSettings settings(boolean stores) {
    return new GoldenSettings(golden(), folder.resolve("report"), stores);
  }

  private PictureAssert assertThatPicture(Image image) {
    return new PictureAssert(image, settings(false));
  }

  private void store(Image image, String name) {
    new PictureAssert(image, settings(true)).matches(name);
  }

  /** A ramp with a square of another brightness. */
  private static Image ramp(double square) {
    float[] rgb = new float[3 * 64 * 48];
    for (int i = 0; i < rgb.length; i++) {
      int x = i / 3 % 64;
      int y = i / 3 / 64;
      boolean inSquare = x >= 20 && x < 30 && y >= 20 && y < 30;
      rgb[i] = (float) (inSquare ? square : (x + y) / 112.0);
    }
    return new Image(64, 48, rgb, new float[0]);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a", "a.png", "a.exr", "sub/b-1_2.x.exr"})
  void storedPictureMatches(String name) {
    store(ramp(.5), name);
    assertThatPicture(ramp(.5)).withTolerance(0).matches(name);
    assertThatThrownBy(() -> assertThatPicture(ramp(.9)).matches(name))
        .isInstanceOf(AssertionError.class);
  }

  @Test
  void sixteenBitsSeeWhatEightBitsRoundAway() {
    Image other = ramp(.5001);
    ImageWriter.Options rounded = ImageWriter.Options.ROUNDED;
    new PictureAssert(ramp(.5), settings(true)).developedWith(rounded).matches("eight");
    assertThatPicture(other).developedWith(rounded).withTolerance(0).matches("eight");
    new PictureAssert(ramp(.5), settings(true)).developedWith(BITS_16).matches("sixteen");
    PictureAssert sixteen = assertThatPicture(other).developedWith(BITS_16).withTolerance(0);
    assertThatThrownBy(() -> sixteen.matches("sixteen")).isInstanceOf(AssertionError.class);
    assertThatPicture(other).developedWith(BITS_16).matches("sixteen");
  }

  @Test
  void alphaIsCompared() {
    float[] alpha = new float[64 * 48];
    Arrays.fill(alpha, .5f);
    Image half = new Image(64, 48, ramp(.5).rgb(), alpha);
    store(half, "half");
    assertThatPicture(half).withTolerance(0).matches("half");
    assertThatThrownBy(() -> assertThatPicture(ramp(.5)).matches("half"))
        .isInstanceOf(AssertionError.class);
  }

  /** The default allows a step of 8 bits everywhere, but no change that a viewer may see. */
  @Test
  void defaultToleranceIsBelowWhatIsSeen() {
    Image reference = ramp(.5);
    float[] brighter = reference.rgb().clone();
    for (int i = 0; i < brighter.length; i++) {
      brighter[i] *= 1.002f;
    }
    Image step = new Image(64, 48, brighter, new float[0]);
    assertThat(Flip.mean(step, reference)).isBetween(1e-5, GoldenPictures.DEFAULT_TOLERANCE);
    // The square is 3 % of the picture.
    assertThat(Flip.mean(ramp(.55), reference)).isLessThan(GoldenPictures.DEFAULT_TOLERANCE);
    store(reference, "a");
    assertThatPicture(step).matches("a");
    assertThatThrownBy(() -> assertThatPicture(ramp(.55)).matches("a"))
        .isInstanceOf(AssertionError.class);
    assertThatPicture(ramp(.55)).withTolerance(.1).matches("a");
  }

  @Test
  void failureExplainsItselfAndWritesThePictures() throws IOException {
    store(ramp(.5), "square");
    AssertionError thrown =
        catchThrowableOfType(
            AssertionError.class, () -> assertThatPicture(ramp(1)).matches("square"));
    assertThat(thrown.getMessage())
        .contains("picture differs from " + golden().resolve("square.png") + ": mean FLIP 0.0")
        .contains("100 of 3072 pixels differ")
        .contains(
            "accept it: mvn test"
                + " -Dtest=GoldenPicturesTest#failureExplainsItselfAndWritesThePictures"
                + " -Dlumbre.golden=store");
    Path report = folder.resolve("report/square");
    try (var files = Files.list(report)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrder("actual.png", "expected.png", "difference.png", "index.html");
    }
    assertThat(report.resolve("expected.png"))
        .hasSameBinaryContentAs(golden().resolve("square.png"));
    String page = Files.readString(report.resolve("index.html"));
    assertThat(page).doesNotContain("@").doesNotContain("http").contains("data:image/png;base64,");
  }

  @Test
  void commandNamesTheTestMethod() {
    AssertionError thrown = null;
    try {
      assertThatPicture(ramp(1)).matches("none");
    } catch (AssertionError e) {
      thrown = e;
    }
    assertThat(thrown)
        .hasMessageContaining("expected " + golden().resolve("none.png") + ", found none")
        .hasMessageContaining(
            "make it: mvn test -Dtest=GoldenPicturesTest#commandNamesTheTestMethod"
                + " -Dlumbre.golden=store");
  }

  /** The page goes when the picture is right again, and leaves what it has not written. */
  @Test
  void pageOfAFailureGoesWhenThePicturePasses() throws IOException {
    store(ramp(.5), "square");
    store(ramp(.5), "square/inner");
    for (String name : List.of("square", "square/inner")) {
      assertThatThrownBy(() -> assertThatPicture(ramp(1)).matches(name))
          .isInstanceOf(AssertionError.class);
    }
    Path report = folder.resolve("report/square");
    assertThatPicture(ramp(.5)).matches("square");
    try (var files = Files.list(report)) {
      assertThat(files).containsExactly(report.resolve("inner"));
    }
    Path note = Files.writeString(report.resolve("inner/note.txt"), "mine");
    assertThatPicture(ramp(.5)).matches("square/inner");
    try (var files = Files.list(report.resolve("inner"))) {
      assertThat(files).containsExactly(note);
    }
  }

  @Test
  void pageMarksTheWorstTile() throws IOException {
    store(ramp(.5), "square");
    assertThatThrownBy(() -> assertThatPicture(ramp(1)).matches("square"))
        .hasMessageContaining("in the tile at pixel (24,24) 0.");
    assertThat(Files.readString(folder.resolve("report/square/index.html")))
        .contains("left: 37.500%; top: 50.000%; width: 12.500%; height: 16.667%");
  }

  @Test
  void reportsThatCannotBeWrittenHideNothing() throws IOException {
    store(ramp(.5), "square");
    Files.writeString(folder.resolve("report"), "a file in the place of the folder");
    assertThatThrownBy(() -> assertThatPicture(ramp(1)).matches("square"))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("100 of 3072 pixels differ\n  its page cannot be written: ")
        .hasMessageContaining("\n  accept it: mvn test -Dtest=GoldenPicturesTest#reports");
  }

  /** A helper class of tests, whose name says nothing about the test. */
  private static final class Helper {
    static void check(PictureAssert picture) {
      picture.matches("none");
    }
  }

  @Test
  void commandNamesTheTestAlsoOfAHelperOrALambda() {
    assertThatThrownBy(() -> Helper.check(assertThatPicture(ramp(1))))
        .hasMessageContaining(
            "make it: mvn test"
                + " -Dtest=GoldenPicturesTest#commandNamesTheTestAlsoOfAHelperOrALambda"
                + " -Dlumbre.golden=store");
  }

  @Test
  void commandNamesTheClassOfAnotherThread() throws InterruptedException {
    Throwable[] thrown = new Throwable[1];
    Thread thread = new Thread(() -> assertThatPicture(ramp(1)).matches("none"));
    thread.setUncaughtExceptionHandler((of, e) -> thrown[0] = e);
    thread.start();
    thread.join();
    assertThat(thrown[0])
        .hasMessageContaining("mvn test -Dtest=GoldenPicturesTest -Dlumbre.golden=store");
  }

  @Test
  void otherSizeIsAFailure() {
    store(ramp(.5), "a");
    assertThatThrownBy(() -> assertThatPicture(Image.black(8, 8)).withTolerance(1).matches("a"))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("expected 64x48 pixels, found 8x8");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "../a",
        "/a",
        "a/../../b",
        "a//b",
        ".hidden",
        "a\\b",
        "C:a",
        "a/",
        "a b",
        "a\n"
      })
  void namesStayInTheFolder(String name) {
    for (boolean stores : new boolean[] {false, true}) {
      assertThatThrownBy(() -> new PictureAssert(ramp(1), settings(stores)).matches(name))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("name: expected letters");
    }
    assertThat(golden()).doesNotExist();
  }

  @Test
  void linksStayInTheFolder() throws IOException {
    Path outside = Files.write(folder.resolve("outside.png"), ramp(1).toPng());
    Files.createDirectories(golden());
    Files.createSymbolicLink(golden().resolve("link.png"), outside);
    Files.createSymbolicLink(golden().resolve("up"), folder);
    Files.createSymbolicLink(golden().resolve("broken.png"), folder.resolve("new.png"));
    Files.createSymbolicLink(golden().resolve("nowhere"), folder.resolve("folder"));
    for (String name :
        List.of("link", "up/outside", "up/new", "up/sub/new", "broken", "nowhere/new")) {
      assertThatThrownBy(() -> store(ramp(.2), name))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("found the link");
    }
    assertThatThrownBy(() -> assertThatPicture(ramp(1)).matches("link"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("found the link");
    assertThat(outside).hasBinaryContent(ramp(1).toPng());
    assertThat(folder.resolve("new.png")).doesNotExist();
    assertThat(folder.resolve("sub")).doesNotExist();
    assertThat(folder.resolve("folder")).doesNotExist();
  }

  static Stream<Arguments> damagedFiles() {
    byte[] png = ramp(.5).toPng();
    String pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
    return Stream.of(
        Arguments.of(new byte[0], "an empty file"),
        Arguments.of("no picture".getBytes(StandardCharsets.UTF_8), "a damaged file: "),
        Arguments.of(Arrays.copyOf(png, png.length / 2), "a damaged file: "),
        Arguments.of(
            pointer.getBytes(StandardCharsets.UTF_8),
            "a pointer of Git LFS; 'git lfs pull' fetches the picture"));
  }

  @ParameterizedTest
  @MethodSource("damagedFiles")
  void damagedGoldenPicturesAreNamedAndReplaced(byte[] bytes, String found) throws IOException {
    for (String name : List.of("a.png", "a.exr")) {
      Files.createDirectories(golden());
      Files.write(golden().resolve(name), bytes);
      assertThatThrownBy(() -> assertThatPicture(ramp(1)).matches(name))
          .isInstanceOf(AssertionError.class)
          .hasMessageStartingWith(
              "golden picture " + golden().resolve(name) + ": expected a picture, found " + found)
          .hasMessageContaining(
              "\n  replace it: mvn test"
                  + " -Dtest=GoldenPicturesTest#damagedGoldenPicturesAreNamedAndReplaced"
                  + " -Dlumbre.golden=store");
      store(ramp(1), name);
      assertThatPicture(ramp(1)).withTolerance(0).matches(name);
    }
    try (var files = Files.list(golden())) {
      assertThat(files.filter(file -> file.toString().endsWith(".part"))).isEmpty();
    }
  }

  @Test
  void storingEqualPixelsKeepsTheFile() throws IOException {
    store(ramp(.5), "a");
    Path file = golden().resolve("a.png");
    byte[] other =
        ramp(.5)
            .toPng(new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of("Title", "x")));
    Files.write(file, other);
    store(ramp(.5), "a");
    assertThat(file).hasBinaryContent(other);
    store(ramp(.55), "a");
    assertThatPicture(ramp(.55)).withTolerance(0).matches("a");
  }

  @Test
  void argumentsOutOfRangeAreNamed() {
    assertThatThrownBy(() -> assertThatPicture(ramp(1)).withTolerance(1.5))
        .hasMessage("meanFlip: expected a number from 0 to 1, found 1.5");
    assertThatThrownBy(() -> assertThatPicture(ramp(1)).withTolerance(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class);
    System.setProperty("lumbre.golden", "stroe");
    try {
      assertThatThrownBy(() -> GoldenPictures.assertThatPicture(ramp(1)))
          .hasMessage("-Dlumbre.golden: expected compare or store, found stroe");
    } finally {
      System.clearProperty("lumbre.golden");
    }
  }
}
