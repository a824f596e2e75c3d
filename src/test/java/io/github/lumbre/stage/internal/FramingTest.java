package io.github.lumbre.stage.internal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelReader;
import io.github.lumbre.model.internal.ModelScene;
import io.github.lumbre.stage.Stage.View;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Cameras that are framed for a model have all of it in their frame, and as large as possible. */
class FramingTest {
  private static final double FILL = .92;
  private static final double FOV = 35;

  private static final ModelFolder NO_FILES =
      (name, location) -> {
        throw new AssertionError(name);
      };

  /** The largest and smallest positions of a model in a frame of half width and half height 1. */
  private record Frame(double left, double right, double bottom, double top) {
    double extent() {
      return Math.max(right - left, top - bottom) / 2;
    }
  }

  /** Returns a model of random triangles, in the shape of a tall, off-center block. */
  private static List<Vec3> vertices(long seed) {
    Random random = new Random(seed);
    List<Vec3> vertices = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      // Numbers with few digits are the same in the file.
      vertices.add(
          new Vec3(
              3 + random.nextInt(16) / 8.,
              -2 + random.nextInt(40) / 8.,
              1 + random.nextInt(9) / 8. * (random.nextBoolean() ? 1 : -.5)));
    }
    return vertices;
  }

  private static Framing framing(List<Vec3> vertices) throws ModelFormatException, IOException {
    StringBuilder obj = new StringBuilder();
    for (Vec3 v : vertices) {
      // glTF and OBJ are right-handed; scenes mirror x.
      obj.append("v " + v.x() + " " + v.y() + " " + v.z() + "\n");
    }
    for (int i = 1; i + 2 <= vertices.size(); i += 3) {
      obj.append("f " + i + " " + (i + 1) + " " + (i + 2) + "\n");
    }
    byte[] file = obj.toString().getBytes(StandardCharsets.US_ASCII);
    Model model = ModelReader.read("a.obj", file, NO_FILES, ModelOptions.DEFAULT);
    return Framing.of(model);
  }

  /** Projects by the rotation that the scene's camera gets. */
  private static Frame project(List<Vec3> vertices, View view, Vec3 eye, double aspect) {
    Transform toWorld =
        Transform.translation(eye)
            .times(Transform.rotationDegrees(new Vec3(view.elevation(), -view.azimuth(), 0)));
    double tan = Math.tan(Math.toRadians(FOV / 2));
    double[] frame = {9, -9, 9, -9};
    for (Vec3 v : vertices) {
      Vec3 world = ModelScene.TO_LEFT_HANDED.point(v);
      Vec3 local = toWorld.inversePoint(world);
      assertThat(local.z()).isPositive();
      double x = local.x() / local.z() / (tan * aspect);
      double y = local.y() / local.z() / tan;
      frame[0] = Math.min(frame[0], x);
      frame[1] = Math.max(frame[1], x);
      frame[2] = Math.min(frame[2], y);
      frame[3] = Math.max(frame[3], y);
    }
    return new Frame(frame[0], frame[1], frame[2], frame[3]);
  }

  @ParameterizedTest
  @CsvSource({
    "30, 20, 1.3333",
    "0, 0, 1",
    "180, 0, 0.5",
    "-90, 0, 2",
    "0, 90, 1",
    "45, 35, 3",
    "10, -80, 1"
  })
  void theModelTouchesTheMarginsOfOneAxisAndIsInTheMiddleOfTheOther(
      double azimuth, double elevation, double aspect) throws ModelFormatException, IOException {
    for (int seed = 0; seed < 20; seed++) {
      List<Vec3> vertices = vertices(seed);
      View view = new View(azimuth, elevation);
      Vec3 eye = framing(vertices).eye(view, FOV, aspect, Set.of());
      Frame frame = project(vertices, view, eye, aspect);
      boolean isWide = frame.right() > frame.top();
      double high = isWide ? frame.right() : frame.top();
      double low = isWide ? frame.left() : frame.bottom();
      assertThat(high).isCloseTo(FILL, within(1e-9));
      assertThat(low).isCloseTo(-FILL, within(1e-9));
      double other = isWide ? frame.top() : frame.right();
      assertThat(other).isLessThan(FILL + 1e-9);
      assertThat(isWide ? frame.bottom() : frame.left()).isCloseTo(-other, within(1e-4));
    }
  }

  @ParameterizedTest
  @CsvSource({"20, 1.3333", "0, 1", "60, 0.5", "-30, 2", "90, 1"})
  void camerasOfATurntableStayAtOneDistanceAndHeight(double elevation, double aspect)
      throws ModelFormatException, IOException {
    for (int seed = 0; seed < 10; seed++) {
      List<Vec3> vertices = vertices(seed);
      Framing framing = framing(vertices);
      View first = new View(30, elevation);
      Vec3 center = null;
      double fullest = 0;
      for (int degrees = 0; degrees < 360; degrees += 1) {
        View view = first.turned(degrees);
        Vec3 eye = framing.eye(view, FOV, aspect, Set.of());
        Vec3 opposite = framing.eye(view.turned(180), FOV, aspect, Set.of());
        Vec3 middle = eye.plus(opposite).times(.5);
        center = center == null ? middle : center;
        assertThat(middle.minus(center).length()).isLessThan(1e-9);
        assertThat(eye.y()).isCloseTo(center.y(), within(1e-9));
        Frame frame = project(vertices, view, eye, aspect);
        assertThat(frame.right()).isLessThan(FILL + 1e-9);
        assertThat(frame.left()).isGreaterThan(-FILL - 1e-9);
        assertThat(frame.top()).isLessThan(FILL + 1e-9);
        assertThat(frame.bottom()).isGreaterThan(-FILL - 1e-9);
        double across = Math.max(frame.right(), -frame.left());
        fullest = Math.max(fullest, Math.max(across, Math.max(frame.top(), -frame.bottom())));
      }
      assertThat(fullest).as("largest extent of all views").isCloseTo(FILL, within(.01));
    }
  }

  /** Projects without perspective, by the rotation that the scene's camera gets. */
  private static Frame projectParallel(
      List<Vec3> vertices, View view, Framing.Parallel camera, double aspect) {
    Transform toWorld =
        Transform.translation(camera.eye())
            .times(Transform.rotationDegrees(new Vec3(view.elevation(), -view.azimuth(), 0)));
    double[] frame = {9, -9, 9, -9};
    for (Vec3 v : vertices) {
      Vec3 local = toWorld.inversePoint(ModelScene.TO_LEFT_HANDED.point(v));
      assertThat(local.z()).isPositive();
      double x = 2 * local.x() / (camera.height() * aspect);
      double y = 2 * local.y() / camera.height();
      frame[0] = Math.min(frame[0], x);
      frame[1] = Math.max(frame[1], x);
      frame[2] = Math.min(frame[2], y);
      frame[3] = Math.max(frame[3], y);
    }
    return new Frame(frame[0], frame[1], frame[2], frame[3]);
  }

  @ParameterizedTest
  @CsvSource({"30, 20, 1.3333", "0, 0, 1", "180, 0, 0.5", "0, 90, 1", "45, 35, 3", "10, -80, 1"})
  void aParallelFrameIsFilledAlongOneAxisAndEvenAlongBoth(
      double azimuth, double elevation, double aspect) throws ModelFormatException, IOException {
    for (int seed = 0; seed < 20; seed++) {
      List<Vec3> vertices = vertices(seed);
      View view = new View(azimuth, elevation, false, true);
      Framing.Parallel camera = framing(vertices).parallel(view, aspect, 1, Set.of());
      Frame frame = projectParallel(vertices, view, camera, aspect);
      assertThat(frame.extent()).isCloseTo(FILL, within(1e-9));
      assertThat(frame.left()).isCloseTo(-frame.right(), within(1e-9));
      assertThat(frame.bottom()).isCloseTo(-frame.top(), within(1e-9));
    }
  }

  @ParameterizedTest
  @CsvSource({"20, 1.3333", "0, 1", "60, 0.5", "-30, 2", "90, 1"})
  void parallelCamerasOfATurntableHaveOneHeight(double elevation, double aspect)
      throws ModelFormatException, IOException {
    for (int seed = 0; seed < 10; seed++) {
      List<Vec3> vertices = vertices(seed);
      Framing framing = framing(vertices);
      View first = new View(30, elevation);
      double height = framing.parallel(first.turned(0), aspect, 1, Set.of()).height();
      double fullest = 0;
      for (int degrees = 0; degrees < 360; degrees += 1) {
        View view = first.turned(degrees);
        Framing.Parallel camera = framing.parallel(view, aspect, 1, Set.of());
        assertThat(camera.height()).isCloseTo(height, within(1e-9 * height));
        Frame frame = projectParallel(vertices, view, camera, aspect);
        double across = Math.max(frame.right(), -frame.left());
        fullest = Math.max(fullest, Math.max(across, Math.max(frame.top(), -frame.bottom())));
      }
      assertThat(fullest).as("largest extent of all views").isBetween(FILL - .01, FILL + 1e-9);
    }
  }

  @Test
  void aModelOfOnePointIsSeenFromADistance() throws ModelFormatException, IOException {
    List<Vec3> line = List.of(new Vec3(0, 0, -1), new Vec3(0, 0, 1), new Vec3(1e-9, 0, 0));
    View front = new View(0, 0);
    Frame frame = project(line, front, framing(line).eye(front, FOV, 1, Set.of()), 1);
    assertThat(frame.extent()).isLessThan(FILL + 1e-9);
  }
}
