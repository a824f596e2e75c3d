package io.github.lumbre.scenefile;

import static io.github.lumbre.scenefile.SceneFixture.json;
import static io.github.lumbre.testing.Near.assertNear;
import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.math.Frame;
import io.github.lumbre.math.Transform;
import io.github.lumbre.math.Vec3;
import io.github.lumbre.scenefile.ObjectTree.Placed;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the transforms of nested objects. */
class ObjectTreeTest {
  private static List<Placed> objects(String text) {
    Problems problems = new Problems("s.json");
    try {
      JsonNode root =
          JsonNode.read(
              json("{'objects': [" + text + "]}").getBytes(StandardCharsets.UTF_8),
              problems,
              Limits.NONE);
      return ObjectTree.of(root).objects();
    } catch (SceneFormatException e) {
      throw new AssertionError(e);
    }
  }

  private static Vec3 image(String objects, int number, Vec3 point) {
    return objects(objects).get(number).toWorld().point(point);
  }

  @Test
  void rotationsAreInDegreesAboutZThenXThenY() {
    assertNear(image("{'localRotation': {'x': 90}}", 0, Vec3.Z), new Vec3(0, -1, 0), 1e-14);
    assertNear(image("{'localRotation': {'y': 90}}", 0, Vec3.Z), Vec3.X, 1e-14);
    assertNear(image("{'localRotation': {'z': 90}}", 0, Vec3.X), Vec3.Y, 1e-14);
    assertNear(image("{'localRotation': {'x': 90, 'z': 90}}", 0, Vec3.X), Vec3.Z, 1e-14);
    assertNear(image("{'localRotation': {'x': 90, 'y': 90, 'z': 90}}", 0, Vec3.X), Vec3.X, 1e-14);
  }

  @Test
  void pointsAreScaledThenTurnedThenMovedAndThenByTheParents() {
    String nested =
        "{'localPosition': {'x': 1, 'y': 2, 'z': 3}, 'localRotation': {'y': 90},"
            + " 'localScale': {'x': 2, 'y': 2, 'z': 2}, 'children': ["
            + "{'localPosition': {'z': 1}, 'localRotation': {'x': 90},"
            + " 'localScale': {'x': 1, 'y': 1, 'z': 5}}]}";
    // (1,1,1) → scaled (1,1,5) → turned (1,-5,1) → moved (1,-5,2)
    // → scaled (2,-10,4) → turned (4,-10,-2) → moved (5,-8,1).
    assertNear(image(nested, 1, new Vec3(1, 1, 1)), new Vec3(5, -8, 1), 1e-14);
  }

  @Test
  void parentsComeBeforeChildrenInTheOrderOfTheFile() {
    List<Placed> found =
        objects(
            "{'id': 1, 'children': [{'id': 2, 'children': [{'id': 3}]}, {'id': 4}]}, {'id': 5}");
    assertThat(found)
        .extracting(p -> p.stated(ObjectKeys.ID).orElseThrow())
        .containsExactly(1, 2, 3, 4, 5);
  }

  /** Pairs of translations and quarter turns that cancel are exact at any depth. */
  @ParameterizedTest
  @ValueSource(ints = {2, 10, 1000, 2000})
  void chainsThatUndoThemselvesLeaveTheirChildInPlace(int depth) {
    String out = "{'localPosition': {'x': 1, 'y': 2, 'z': 3}, 'localRotation': {'y': 90}";
    String back = "{'localPosition': {'x': 3, 'y': -2, 'z': -1}, 'localRotation': {'y': -90}";
    List<Placed> chain = objects(nested(depth, i -> i % 2 == 0 ? out : back));
    assertThat(chain).hasSize(depth);
    Vec3 point = new Vec3(.3, -.7, 11);
    assertThat(chain.get(depth - 1).toWorld().point(point)).isEqualTo(point);
    assertThat(chain.get(depth - 1).toWorld().inversePoint(point)).isEqualTo(point);
  }

  /** A camera below many small rotations has the direction of a single large rotation. */
  @ParameterizedTest
  @ValueSource(ints = {1, 10, 1000, 2000})
  void chainsOfSmallTurnsAreTheWholeTurn(int depth) {
    for (double whole : new double[] {90, 180, 270, 77}) {
      String level = "{'localRotation': {'y': " + whole / depth + "}";
      Frame axes = objects(nested(depth, i -> level)).get(depth - 1).axes();
      Transform turn = Transform.rotationDegrees(new Vec3(0, whole, 0));
      double bound = depth * 8 * 0x1p-52;
      assertThat(axes.tangent().minus(turn.vector(Vec3.X)).length()).isLessThan(bound);
      assertThat(axes.bitangent().minus(turn.vector(Vec3.Y)).length()).isLessThan(bound);
      assertThat(axes.normal().minus(turn.vector(Vec3.Z)).length()).isLessThan(bound);
    }
  }

  /** Returns nested objects; each object's text comes without its end. */
  private static String nested(int depth, IntFunction<String> object) {
    return IntStream.range(0, depth).mapToObj(object).collect(joining(", 'children': ["))
        + "}"
        + "]}".repeat(depth - 1);
  }

  @Test
  void axesFollowTheRotationsAlone() {
    Placed child =
        objects(
                "{'localScale': {'x': -3, 'y': 2, 'z': 1}, 'localRotation': {'y': 90}, 'children':"
                    + " [{'localPosition': {'x': 1}, 'localRotation': {'x': 90}}]}")
            .get(1);
    assertNear(child.axes().normal(), new Vec3(0, -1, 0), 1e-14);
    assertNear(child.axes().tangent(), new Vec3(0, 0, -1), 1e-14);
    assertNear(child.axes().bitangent(), Vec3.X, 1e-14);
    assertNear(child.position(), new Vec3(0, 0, 3), 1e-14);
  }
}
