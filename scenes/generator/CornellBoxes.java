package generator;

import java.util.List;

/** The Cornell box, under three kinds of light. */
final class CornellBoxes {
  private static final double WIDTH = 5.56;
  private static final double HEIGHT = 5.48;
  private static final double DEPTH = 5.6;

  static List<Scene> all() {
    return List.of(rectangleLight(), sphereLight(), dome());
  }

  private static Scene rectangleLight() {
    Scene s = box("cornell-box", true);
    s.add(
        s.rectangleLight("lamp", 1.3, 1.05, Scene.rgb(36, 28, 18))
            .at(0, HEIGHT - .01, 2.8)
            .turn(90, 0, 0));
    return s;
  }

  private static Scene sphereLight() {
    Scene s = box("cornell-box-sphere-light", true);
    int white = s.diffuse("cord", .3, .3, .3);
    s.add(s.cube("cord", white, .03, .9, .03).at(0, HEIGHT - .45, 2.8));
    s.add(s.sphereLight("lamp", .45, Scene.rgb(18, 14, 9)).at(0, HEIGHT - 1.35, 2.8));
    return s;
  }

  private static Scene dome() {
    Scene s = box("cornell-box-dome", false);
    s.add(s.dome("sky", s.smoothImage("sky", "textures/sky.png"), 15).turn(0, 150, 0));
    return s;
  }

  /** The box without its light: red to the left, green to the right, open towards the camera. */
  private static Scene box(String name, boolean ceiling) {
    Scene s = new Scene(name, 512, 512, 64).set("maxTraceDepth", 8);
    int white = s.diffuse("white", .73, .73, .73);
    int red = s.diffuse("red", .63, .06, .05);
    int green = s.diffuse("green", .14, .45, .09);
    s.camera("Pinhole", "fieldOfView", 39.3).at(0, 2.73, -8);
    Node walls = s.add(s.group("walls"));
    walls.child(s.plane("floor", white, WIDTH, DEPTH).at(0, 0, DEPTH / 2));
    if (ceiling) {
      walls.child(
          s.plane("ceiling", white, WIDTH, DEPTH).at(0, HEIGHT, DEPTH / 2).turn(180, 0, 0));
    }
    walls.child(s.wall("back", white, WIDTH, HEIGHT, Compass.SOUTH).at(0, HEIGHT / 2, DEPTH));
    walls.child(
        s.wall("left", red, DEPTH, HEIGHT, Compass.EAST).at(-WIDTH / 2, HEIGHT / 2, DEPTH / 2));
    walls.child(
        s.wall("right", green, DEPTH, HEIGHT, Compass.WEST).at(WIDTH / 2, HEIGHT / 2, DEPTH / 2));
    s.add(s.cube("tall block", white, 1.65, 3.3, 1.65).at(-.91, 1.65, 3.51).turn(0, -17.2, 0));
    s.add(s.cube("short block", white, 1.65, 1.65, 1.65).at(.92, .825, 1.69).turn(0, 17, 0));
    return s;
  }
}
