package io.github.lumbre.stage.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Camera;
import io.github.lumbre.camera.internal.Projection;
import io.github.lumbre.geometry.NearestHit;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Ray;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.math.sampling.internal.SobolSampler;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelOption;
import io.github.lumbre.model.ModelOptions.Up;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.scenefile.SceneFormatException;
import io.github.lumbre.scenefile.SceneParser;
import io.github.lumbre.scenefile.internal.ParsedScene;
import io.github.lumbre.stage.Stage;
import io.github.lumbre.stage.Stage.View;
import io.github.lumbre.stage.StagedModel;
import io.github.lumbre.stage.internal.ModelSequence.Motion;
import io.github.lumbre.stage.internal.ViewNumbers.Seen;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The cameras that a stage puts before a model. */
class StagedCameraTest {
  private static final int WIDTH = 240;
  private static final int HEIGHT = 180;
  private static final double FILL = .92;

  /** A block of 60 x 40 x 20, off the origin. */
  private static final String BLOCK = box("block", new Vec3(100, 5, -7), new Vec3(60, 40, 20), 0);

  /** The block, and a small cube far from it. */
  private static final String TWO =
      BLOCK + box("cube", new Vec3(300, 50, 90), new Vec3(8, 8, 8), 8);

  private static String box(String name, Vec3 corner, Vec3 size, int before) {
    StringBuilder obj = new StringBuilder("o " + name + "\n");
    for (int i = 0; i < 8; i++) {
      Vec3 at = corner(corner, size, i);
      obj.append("v " + at.x() + " " + at.y() + " " + at.z() + "\n");
    }
    int[][] faces = {
      {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };
    for (int[] face : faces) {
      obj.append("f");
      for (int vertex : face) {
        obj.append(" " + (before + vertex + 1));
      }
      obj.append("\n");
    }
    return obj.toString();
  }

  private static Vec3 corner(Vec3 corner, Vec3 size, int i) {
    return corner.plus(
        new Vec3(size.x() * (i & 1), size.y() * (i >> 1 & 1), size.z() * (i >> 2 & 1)));
  }

  /** A plate of 60 x 60 x 20 with a hole of 48 sides and radius 10 along z. */
  private static String bored() {
    int sides = 48;
    StringBuilder obj = new StringBuilder();
    for (int z = 0; z <= 20; z += 20) {
      for (int ring = 0; ring < 2; ring++) {
        for (int i = 0; i < sides; i++) {
          double angle = 2 * Math.PI * i / sides;
          double cos = Math.cos(angle);
          double sin = Math.sin(angle);
          double r = ring == 0 ? 10 : 30 / Math.max(Math.abs(cos), Math.abs(sin));
          obj.append(String.format(Locale.ROOT, "v %.9f %.9f %d%n", r * cos, r * sin, z));
        }
      }
    }
    for (int i = 1; i <= sides; i++) {
      int j = i % sides + 1;
      obj.append(quad(i, j, j + 2 * sides, i + 2 * sides));
      obj.append(quad(i + sides, j + sides, j + 3 * sides, i + 3 * sides));
      obj.append(quad(i + 2 * sides, i + 3 * sides, j + 3 * sides, j + 2 * sides));
      obj.append(quad(i, j, j + sides, i + sides));
    }
    return obj.toString();
  }

  private static String quad(int a, int b, int c, int d) {
    return "f " + a + " " + b + " " + c + " " + d + "\n";
  }

  private static ParsedScene scene(String obj, Stage stage) throws Exception {
    SceneParser parser =
        new SceneParser().overriding(s -> s.toBuilder().size(WIDTH, HEIGHT).build());
    byte[] model = obj.getBytes(StandardCharsets.US_ASCII);
    return StagedModel.read("a.obj", model, ModelFolder.NONE, stage, parser).scene().parsed();
  }

  private static Stage from(String view) {
    return Stage.DEFAULT.seenFrom(View.of(view));
  }

  private static ViewNumbers numbers(ParsedScene scene) {
    return ViewNumbers.of(
        scene.scene(), scene.settings(), scene.model().orElseThrow().parts(scene.scene()));
  }

  private static Seen block(Stage stage) throws Exception {
    return numbers(scene(BLOCK, stage)).seen().get(0);
  }

  private static int width(Seen seen) {
    return seen.right() - seen.left();
  }

  private static int height(Seen seen) {
    return seen.bottom() - seen.top();
  }

  @Test
  void aBlockHasItsRatiosFromTheStandardViews() throws Exception {
    assertSize(block(from("front")), FILL * WIDTH, FILL * WIDTH / 1.5);
    assertSize(block(from("left")), FILL * HEIGHT / 2, FILL * HEIGHT);
    assertSize(block(from("top")), FILL * WIDTH, FILL * WIDTH / 3);
  }

  private static void assertSize(Seen seen, double width, double height) {
    assertThat((double) width(seen)).isCloseTo(width, within(1.));
    assertThat((double) height(seen)).isCloseTo(height, within(1.));
  }

  @ParameterizedTest
  @ValueSource(strings = {"front", "back", "left", "right", "top", "bottom", "iso", "33,-21"})
  void theMatrixMapsCornersToThePixelsThatShowThem(String view) throws Exception {
    ParsedScene scene = scene(BLOCK, from(view).with(Stage.PARALLEL, true));
    Projection matrix = numbers(scene).projection().orElseThrow();
    assertThat(matrix.isParallel()).isTrue();
    Camera camera = scene.scene().camera();
    double pixel = Projection.frameHeight(camera) / HEIGHT;
    for (int i = 0; i < 8; i++) {
      Vec3 corner = corner(new Vec3(100, 5, -7), new Vec3(60, 40, 20), i);
      Vec3 at = matrix.pixel(corner);
      Point2 film = new Point2(at.x() / WIDTH, at.y() / HEIGHT);
      Ray ray = camera.rayFor(film, new SobolSampler(0)).orElseThrow();
      Vec3 offset = ModelScene.TO_LEFT_HANDED.point(corner).minus(ray.origin());
      double depth = offset.dot(ray.direction());
      assertThat(offset.minus(ray.direction().times(depth)).length()).isLessThan(.01 * pixel);
      assertThat(at.z()).isPositive().isCloseTo(depth, within(1e-9 * depth));
    }
  }

  /** The pixels that do not show the plate are those of the hole, whose walls are not seen. */
  @Test
  void aHoleAlongTheViewShowsNoWall() throws Exception {
    double scale = FILL * HEIGHT / 60;
    double area = 24 * 10 * 10 * Math.sin(2 * Math.PI / 48) * scale * scale;
    assertThat(hole(from("front"))).isCloseTo(area, within(.02 * area));
    assertThat(hole(from("front").with(Stage.PERSPECTIVE, true))).isLessThan(.9 * area);
  }

  private static double hole(Stage stage) throws Exception {
    Seen plate = numbers(scene(bored(), stage)).seen().get(0);
    return (double) width(plate) * height(plate) - plate.pixels();
  }

  @Test
  void onlyNamedViewsAreParallelUnlessAFlagSaysSo() {
    assertThat(Stage.DEFAULT.isParallel()).isFalse();
    assertThat(View.standard().keySet()).allMatch(name -> from(name).isParallel());
    assertThat(from("0,0").isParallel()).isFalse();
    assertThat(from("0,0").with(Stage.PARALLEL, true).isParallel()).isTrue();
    assertThat(from("front").with(Stage.FOV, 35.).isParallel()).isFalse();
    assertThat(from("front").with(Stage.PERSPECTIVE, true).isParallel()).isFalse();
    Stage turned = Motion.turntable(4).stage(from("front"), 0);
    assertThat(turned.isParallel()).isFalse();
    assertThat(turned.get(Stage.VIEW).azimuth()).isZero();
  }

  /** Rays from above start above the floor, wherever they are in the frame. */
  @ParameterizedTest
  @ValueSource(doubles = {90, 35.264389682754654, 10, 1, .01})
  void aFloorIsSeenFromAbove(double elevation) throws Exception {
    Stage stage =
        Stage.DEFAULT
            .seenFrom(new View(20, elevation))
            .with(Stage.PARALLEL, true)
            .with(Stage.GROUND, true)
            .with(Stage.ZOOM, .2);
    ParsedScene scene = scene(BLOCK, stage);
    for (double v : new double[] {-.02, .5, .99, 1.02}) {
      Point2 film = new Point2(.03, v);
      Ray ray = scene.scene().camera().rayFor(film, new SobolSampler(0)).orElseThrow();
      assertThat(scene.scene().intersect(ray, new NearestHit())).as("v = %s", v).isTrue();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"front", "0,0"})
  void zoomEnlargesWhatIsInTheMiddle(String view) throws Exception {
    Seen whole = block(from(view).with(Stage.ZOOM, .2));
    Seen twice = block(from(view).with(Stage.ZOOM, .4));
    assertThat((double) width(twice)).isCloseTo(2. * width(whole), within(2.));
    assertThat((double) height(twice)).isCloseTo(2. * height(whole), within(2.));
  }

  @ParameterizedTest
  @ValueSource(strings = {"front", "top", "iso", "30,20"})
  void aPartThatIsFittedFillsTheFrame(String view) throws Exception {
    ParsedScene scene = scene(TWO, from(view).with(Stage.FIT, "cub*"));
    ViewNumbers numbers = numbers(scene);
    Seen cube =
        numbers.seen().stream().filter(seen -> seen.part() == 1).findFirst().orElseThrow();
    double extent = Math.max((double) height(cube) / HEIGHT, (double) width(cube) / WIDTH);
    assertThat(extent).isCloseTo(FILL, within(.02));
    assertThat(cube.left() + cube.right()).isCloseTo(WIDTH, within(3));
    assertThat(cube.top() + cube.bottom()).isCloseTo(HEIGHT, within(3));
  }

  @Test
  void aCameraStandsAtTheEyeInTheFilesAxesAndUnit() throws Exception {
    Stage stage =
        Stage.DEFAULT
            .with(ModelOption.UP, Up.Z)
            .with(ModelOption.UNIT, .001)
            .with(Stage.EYE, new Vec3(130, -200, 3))
            .with(Stage.TARGET, new Vec3(130, 5, 3));
    ParsedScene scene = scene(BLOCK, stage);
    Vec3 world = ModelScene.TO_LEFT_HANDED.point(new Vec3(.130, .003, .200));
    assertThat(scene.scene().camera().position().minus(world).length()).isLessThan(1e-12);
    Projection matrix = numbers(scene).projection().orElseThrow();
    Vec3 middle = matrix.pixel(new Vec3(.130, .003, -.005));
    assertThat(middle.minus(new Vec3(.5 * WIDTH, .5 * HEIGHT, .205)).length()).isLessThan(1e-6);
    // One millimeter of the file's y is .205 m away; half of the angle is 17.5 degrees.
    Vec3 beside = matrix.pixel(new Vec3(.130, .003 + .205 * Math.tan(Math.toRadians(17.5)), -.005));
    assertThat(beside.y()).isCloseTo(0, within(1e-6));
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void withoutATargetTheMiddleIsInTheMiddle(boolean isParallel) throws Exception {
    Stage stage =
        Stage.DEFAULT.with(Stage.EYE, new Vec3(400, 300, 200)).with(Stage.PARALLEL, isParallel);
    Vec3 middle =
        numbers(scene(BLOCK, stage)).projection().orElseThrow().pixel(new Vec3(130, 25, 3));
    assertThat(middle.x()).isCloseTo(.5 * WIDTH, within(1e-6));
    assertThat(middle.y()).isCloseTo(.5 * HEIGHT, within(1e-6));
  }

  @Test
  void aParallelCameraAtAnEyeFramesTheBox() throws Exception {
    Vec3 eye = new Vec3(130, 25, 500);
    Seen seen = block(Stage.DEFAULT.with(Stage.EYE, eye).with(Stage.PARALLEL, true));
    assertSize(seen, FILL * WIDTH, FILL * WIDTH / 1.5);
  }

  @Test
  void aPartIsFittedFromAnEye() throws Exception {
    Stage stage =
        Stage.DEFAULT.with(Stage.EYE, new Vec3(304, 54, 400)).with(Stage.FIT, "cube");
    ViewNumbers numbers = numbers(scene(TWO, stage));
    assertThat(numbers.seen()).hasSize(1);
    assertThat(height(numbers.seen().get(0)))
        .isCloseTo((int) Math.round(FILL * HEIGHT), within(1));
    assertRefused(
        TWO, stage.with(Stage.EYE, new Vec3(304, 54, 95)), "expected a part in front of the eye");
  }

  @Test
  void whatDoesNotSuitTheModelIsRefused() {
    assertRefused(
        TWO, Stage.DEFAULT.with(Stage.FIT, "cone"), "expected \"block\" or \"cube\", found");
    assertRefused(
        BLOCK,
        Stage.DEFAULT.with(Stage.EYE, new Vec3(130, 25, 3)),
        "expected another point than the eye, found 130,25,3");
  }

  private static void assertRefused(String obj, Stage stage, String message) {
    assertThatThrownBy(() -> scene(obj, stage))
        .isInstanceOfSatisfying(
            SceneFormatException.class,
            e -> assertThat(e.kind()).isEqualTo(SceneFormatException.Kind.OPTION))
        .hasMessageContaining(message);
  }

  /** The camera of a model with a camera of its own is framed if an option says so. */
  @Test
  void optionsOfAFramedCameraReplaceTheFilesCamera() {
    for (Stage stage :
        List.of(
            from("front"),
            Stage.DEFAULT.with(Stage.EYE, Vec3.X),
            Stage.DEFAULT.with(Stage.FIT, "a"),
            Stage.DEFAULT.with(Stage.PARALLEL, true),
            Stage.DEFAULT.with(Stage.PERSPECTIVE, true))) {
      assertThat(stage.isFramed()).isTrue();
      assertThat(stage.framed()).isEqualTo(stage);
    }
    assertThat(Stage.DEFAULT.with(Stage.ZOOM, 2.).isFramed()).isFalse();
    assertThat(Stage.DEFAULT.framed().find(Stage.VIEW)).contains(View.DEFAULT);
  }
}
