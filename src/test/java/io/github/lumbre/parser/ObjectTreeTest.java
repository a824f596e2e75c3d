package io.github.lumbre.parser;

import static io.github.lumbre.parser.SceneFixture.json;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.Vec3;
import io.github.lumbre.parser.ObjectTree.Placed;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class ObjectTreeTest {
  private static List<Placed> objects(String text) {
    Problems problems = new Problems("s.json");
    try {
      JsonNode root =
          JsonTree.read(
              json("{'objects': [" + text + "]}").getBytes(StandardCharsets.UTF_8), problems);
      return ObjectTree.of(root).objects();
    } catch (SceneFormatException e) {
      throw new AssertionError(e);
    }
  }

  private static Vec3 image(String objects, int number, Vec3 point) {
    return objects(objects).get(number).toWorld().point(point);
  }

  private static void assertNear(Vec3 found, Vec3 expected) {
    assertThat(found.minus(expected).length()).isLessThan(1e-14);
  }

  @Test
  void rotationsAreInDegreesAboutZThenXThenY() {
    assertNear(image("{'localRotation': {'x': 90}}", 0, Vec3.Z), new Vec3(0, -1, 0));
    assertNear(image("{'localRotation': {'y': 90}}", 0, Vec3.Z), Vec3.X);
    assertNear(image("{'localRotation': {'z': 90}}", 0, Vec3.X), Vec3.Y);
    assertNear(image("{'localRotation': {'x': 90, 'z': 90}}", 0, Vec3.X), Vec3.Z);
    assertNear(image("{'localRotation': {'x': 90, 'y': 90, 'z': 90}}", 0, Vec3.X), Vec3.X);
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
    assertNear(image(nested, 1, new Vec3(1, 1, 1)), new Vec3(5, -8, 1));
  }

  @Test
  void parentsComeBeforeChildrenInTheOrderOfTheFile() {
    List<Placed> found =
        objects(
            "{'id': 1, 'children': [{'id': 2, 'children': [{'id': 3}]}, {'id': 4}]}, {'id': 5}");
    assertThat(found)
        .extracting(p -> p.node().id("id").orElseThrow())
        .containsExactly(1, 2, 3, 4, 5);
  }

  @Test
  void axesFollowTheRotationsAlone() {
    Placed child =
        objects(
                "{'localScale': {'x': -3, 'y': 2, 'z': 1}, 'localRotation': {'y': 90}, 'children':"
                    + " [{'localPosition': {'x': 1}, 'localRotation': {'x': 90}}]}")
            .get(1);
    assertNear(child.axes().normal(), new Vec3(0, -1, 0));
    assertNear(child.axes().tangent(), new Vec3(0, 0, -1));
    assertNear(child.axes().bitangent(), Vec3.X);
    assertNear(child.position(), new Vec3(0, 0, 3));
  }
}
