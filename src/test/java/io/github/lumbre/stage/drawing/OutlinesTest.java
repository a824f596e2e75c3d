package io.github.lumbre.stage.drawing;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.camera.Lens;
import io.github.lumbre.geometry.Mesh;
import io.github.lumbre.geometry.Shape;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.material.Matte;
import io.github.lumbre.math.Point2;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scene.RenderSettings;
import io.github.lumbre.scene.Scene;
import io.github.lumbre.scene.SceneBuilder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OutlinesTest {
  private static final double[] NONE = {};
  private static final Vec3 EYE = new Vec3(2.4, 1.7, -3.3);

  /** Returns a cube from -1 to 1. Each face has its own vertices, in no consistent order. */
  static TriangleMesh cube() {
    double[] positions = new double[6 * 4 * 3];
    int[] indices = new int[36];
    for (int face = 0; face < 6; face++) {
      for (int corner = 0; corner < 4; corner++) {
        int at = 3 * (4 * face + corner);
        positions[at + face % 3] = face < 3 ? -1 : 1;
        positions[at + (face + 1) % 3] = corner % 2 == 0 ? -1 : 1;
        positions[at + (face + 2) % 3] = corner < 2 ? -1 : 1;
      }
      int[] corners = {0, 1, 2, 1, 2, 3};
      for (int i = 0; i < 6; i++) {
        indices[6 * face + i] = 4 * face + corners[i];
      }
    }
    return TriangleMesh.of(positions, NONE, NONE, indices);
  }

  private static SceneBuilder looking(Lens lens) {
    return Scene.builder().lookingAt(EYE, Vec3.ZERO, lens);
  }

  private static Lens lens(boolean isParallel) {
    return isParallel ? Lens.orthographic(4.4) : Lens.pinhole(50);
  }

  private static Strokes strokes(Scene scene, int size) {
    return Outlines.of(scene)
        .sketch(scene, RenderSettings.builder().size(size, size).build(), PartOf.ONE, false)
        .orElseThrow()
        .of(0, true);
  }

  private static Scene scene(Lens lens, Shape... shapes) {
    SceneBuilder builder = looking(lens);
    for (Shape shape : shapes) {
      builder.add(shape, Matte.of(Rgb.gray(.5)));
    }
    return builder.build().framed(1);
  }

  private static Image drawn(Strokes strokes, int size, double width) {
    float[] white = new float[3 * size * size];
    Arrays.fill(white, 1);
    Canvas canvas = new Canvas(new Image(size, size, white, new float[0]));
    canvas.draw(strokes, new Pen(Rgb.BLACK, width));
    return canvas.image();
  }

  private static double length(Strokes strokes) {
    double length = 0;
    for (int i = 0; i < strokes.count(); i++) {
      length +=
          Math.hypot(
              strokes.coordinate(i, 2) - strokes.coordinate(i, 0),
              strokes.coordinate(i, 3) - strokes.coordinate(i, 1));
    }
    return length;
  }

  private static Vec3 corner(int bits) {
    return new Vec3((bits & 1) * 2 - 1, (bits & 2) - 1, (bits & 4) / 2 - 1);
  }

  private static Point2 pixel(Scene scene, Vec3 point, int size) {
    Point2 film = scene.camera().project(point).orElseThrow();
    return new Point2(film.x() * size, film.y() * size);
  }

  /** The corner that the cube itself hides, seen from {@link #EYE}. */
  private static final int HIDDEN = 4;

  /** Returns the ends of the visible edges of the cube in pixels. */
  private static List<Point2[]> visibleEdges(Scene scene, int size) {
    List<Point2[]> edges = new ArrayList<>();
    for (int one = 0; one < 8; one++) {
      for (int bit = 1; bit < 8; bit *= 2) {
        if ((one & bit) == 0 && one != HIDDEN && (one | bit) != HIDDEN) {
          edges.add(
              new Point2[] {
                pixel(scene, corner(one), size), pixel(scene, corner(one | bit), size)
              });
        }
      }
    }
    return edges;
  }

  /** Measures the darkness across each visible edge, in a rendered picture of the lines. */
  @ParameterizedTest
  @CsvSource({"200,false", "200,true", "2000,false", "2000,true"})
  void eachCreaseOfACubeIsInPlaceAndOfOneWidth(int size, boolean isParallel) {
    Scene scene = scene(lens(isParallel), Mesh.of(cube()));
    double width = 1.5;
    Image image = drawn(strokes(scene, size), size, width);
    List<Point2[]> edges = visibleEdges(scene, size);
    assertThat(edges).hasSize(9);
    for (Point2[] edge : edges) {
      double dx = edge[1].x() - edge[0].x();
      double dy = edge[1].y() - edge[0].y();
      double length = Math.hypot(dx, dy);
      double meanWidth = 0;
      int steps = (int) (length * .6);
      for (int i = 0; i < steps; i++) {
        double along = .2 + .6 * (i + .5) / steps;
        Profile profile =
            Profile.across(image, edge[0].x() + along * dx, edge[0].y() + along * dy, dx, dy);
        // The samples of a pixel give its coverage with an error of 0.05; see CanvasTest.
        assertThat(profile.center).isCloseTo(0, within(.2));
        assertThat(profile.width).isCloseTo(width, within(.35));
        meanWidth += profile.width / steps;
      }
      assertThat(meanWidth).isCloseTo(width, within(.03));
    }
  }

  /**
   * The darkness along a short line across an edge: its width if it were black, and its center. The
   * picture counts as constant within a pixel, so that single profiles vary.
   */
  private record Profile(double width, double center) {
    private static final double REACH = 2.5;
    private static final int STEPS = 400;

    static Profile across(Image image, double x, double y, double dx, double dy) {
      double length = Math.hypot(dx, dy);
      double sum = 0;
      double moment = 0;
      for (int i = 0; i < STEPS; i++) {
        double at = REACH * (2 * (i + .5) / STEPS - 1);
        double dark = 1 - bilinear(image, x - at * dy / length, y + at * dx / length);
        sum += dark * 2 * REACH / STEPS;
        moment += dark * at * 2 * REACH / STEPS;
      }
      return new Profile(sum, moment / sum);
    }

    private static double bilinear(Image image, double x, double y) {
      int left = (int) Math.floor(x - .5);
      int top = (int) Math.floor(y - .5);
      double right = x - .5 - left;
      double down = y - .5 - top;
      return (1 - down)
              * ((1 - right) * image.pixel(left, top).r() + right * image.pixel(left + 1, top).r())
          + down
              * ((1 - right) * image.pixel(left, top + 1).r()
                  + right * image.pixel(left + 1, top + 1).r());
    }
  }

  @ParameterizedTest
  @CsvSource({"false", "true"})
  void hiddenEdgesAndDiagonalsAreNotDrawn(boolean isParallel) {
    Scene scene = scene(lens(isParallel), Mesh.of(cube()));
    double expected = 0;
    for (Point2[] edge : visibleEdges(scene, 500)) {
      expected += Math.hypot(edge[1].x() - edge[0].x(), edge[1].y() - edge[0].y());
    }
    assertThat(length(strokes(scene, 500))).isCloseTo(expected, within(.5));
  }

  /** A disk of sectors whose middle corners differ by rounding, with slivers between them. */
  @Test
  void sliversBetweenCornersOfOnePlaceAreNoLines() {
    List<Vec3> corners = new ArrayList<>();
    // Off the axes, so that products of coordinates are rounded.
    Transform turned =
        Transform.translation(new Vec3(.1, .2, .3))
            .times(Transform.rotationDegrees(new Vec3(10, 20, 30)));
    for (int i = 0; i < 12; i++) {
      Vec3 middle = new Vec3(1e-9 * i, 0, 1e-9 * i * i);
      Vec3 next = new Vec3(1e-9 * (i + 1), 0, 1e-9 * (i + 1) * (i + 1));
      Vec3 one = new Vec3(Math.cos(i * Math.PI / 6), 0, Math.sin(i * Math.PI / 6));
      Vec3 other =
          new Vec3(Math.cos((i + 1) % 12 * Math.PI / 6), 0, Math.sin((i + 1) % 12 * Math.PI / 6));
      for (Vec3 corner : List.of(one, other, middle, middle, other, next)) {
        corners.add(turned.point(corner));
      }
    }
    Scene scene = scene(Lens.pinhole(50), Mesh.of(triangles(corners.toArray(Vec3[]::new))));
    assertThat(strokes(scene, 300).count()).isEqualTo(12);
  }

  @Test
  void linesEndWhereASurfaceInFrontBegins() {
    // A sheet between the eye and the cube, whose left border is a vertical line in the picture.
    Vec3 toEye = EYE.normalized();
    Vec3 right = toEye.cross(Vec3.Y).normalized();
    Vec3 up = right.cross(toEye);
    Vec3 middle = EYE.times(.6);
    for (int sign : new int[] {1, -1}) {
      Vec3 far = middle.plus(20. * sign, right);
      Scene scene =
          scene(
              Lens.pinhole(50),
              Mesh.of(cube()),
              Mesh.of(triangles(middle.plus(-50, up), middle.plus(50, up), far)));
      Strokes strokes = strokes(scene, 400);
      double reached = 0;
      for (int i = 0; i < strokes.count(); i++) {
        for (int end = 0; end < 4; end += 2) {
          double x = sign * (strokes.coordinate(i, end) - 200);
          double y = strokes.coordinate(i, end + 1);
          if (y > 0 && y < 400 && Math.abs(x) > .01) {
            // The sheet covers the middle of the picture to its side's edge.
            assertThat(x).isLessThan(.1);
          }
          reached += Math.abs(x) < .1 && Math.abs(x) > 1e-3 ? 1 : 0;
        }
      }
      assertThat(reached).isGreaterThanOrEqualTo(2);
    }
  }

  private static final Vec3 TO_EYE = EYE.normalized();
  private static final Vec3 RIGHT = TO_EYE.cross(Vec3.Y).normalized();
  private static final Vec3 UP = RIGHT.cross(TO_EYE);

  /** Returns a direction perpendicular to {@link #RIGHT}; 90° is towards the eye. */
  private static Vec3 tilted(double degrees) {
    double angle = Math.toRadians(degrees);
    return UP.times(Math.cos(angle)).plus(Math.sin(angle), TO_EYE);
  }

  /** Returns how many pixels of lines are on the row in the middle of the picture. */
  private static double lengthInTheMiddle(Strokes strokes, int size) {
    double sum = 0;
    for (int i = 0; i < strokes.count(); i++) {
      double middle = .5 * size;
      boolean isThere =
          Math.abs(strokes.coordinate(i, 1) - middle) < .01
              && Math.abs(strokes.coordinate(i, 3) - middle) < .01;
      sum += isThere ? Math.abs(strokes.coordinate(i, 2) - strokes.coordinate(i, 0)) : 0;
    }
    return sum;
  }

  /** A triangle on one side of a line, and two on the other, with a corner within the line. */
  @ParameterizedTest
  @CsvSource({
    "0,180,false", // flat
    "0,160,false", // bent by less than a crease
    "0,120,true", // bent by more
    "-85,75,true" // bent by little, as a silhouette
  })
  void cornersWithinAnEdgeMakeNoBorderInAFlatFace(double one, double other, boolean isLine) {
    Vec3 left = RIGHT.times(-1);
    Vec3 tip = tilted(one).times(.9);
    Vec3 otherTip = tilted(other).times(.9);
    Mesh mesh =
        Mesh.of(triangles(left, RIGHT, tip, left, Vec3.ZERO, otherTip, Vec3.ZERO, RIGHT, otherTip));
    Scene scene = scene(Lens.pinhole(50), mesh);
    double all = Math.abs(pixel(scene, RIGHT, 400).x() - pixel(scene, left, 400).x());
    double drawn = lengthInTheMiddle(strokes(scene, 400), 400);
    // The surface is sought 1e-4 of the scene's radius beside the line, less than 0.1 pixels; both
    // pieces of the line may be drawn.
    assertThat(drawn).isBetween(isLine ? all - .5 : 0, isLine ? 2 * all + .5 : .5);
  }

  /** Corners of one place differ, so that a triangle of the edge is in front of the edge. */
  @Test
  void trianglesOfAnEdgeDoNotHideIt() {
    Vec3 left = RIGHT.times(-1);
    Vec3 shift = UP.times(-2e-7);
    Mesh mesh =
        Mesh.of(
            triangles(
                left,
                RIGHT,
                UP.times(-.9),
                left.plus(shift),
                RIGHT.plus(shift),
                tilted(89.9).times(.5)));
    Scene scene = scene(Lens.orthographic(4.4), mesh);
    double all = Math.abs(pixel(scene, RIGHT, 400).x() - pixel(scene, left, 400).x());
    assertThat(lengthInTheMiddle(strokes(scene, 400), 400)).isGreaterThan(all - .5);
  }

  @Test
  void interruptsEndTheSearchForLines() {
    Scene scene = scene(Lens.pinhole(50), Mesh.of(cube()));
    Outlines outlines = Outlines.of(scene);
    RenderSettings settings = RenderSettings.builder().size(40, 30).build();
    assertCancelled(() -> Outlines.of(scene));
    assertCancelled(() -> outlines.sketch(scene, settings, PartOf.ONE, false));
  }

  private static TriangleMesh triangles(Vec3... corners) {
    double[] positions = new double[3 * corners.length];
    for (int i = 0; i < corners.length; i++) {
      positions[3 * i] = corners[i].x();
      positions[3 * i + 1] = corners[i].y();
      positions[3 * i + 2] = corners[i].z();
    }
    int[] indices = new int[corners.length];
    Arrays.setAll(indices, i -> i);
    return TriangleMesh.of(positions, NONE, NONE, indices);
  }
}
