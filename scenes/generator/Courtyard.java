package generator;

import java.util.List;
import java.util.Locale;

/** A walled yard in which every direction looks different, seen by one camera after another. */
final class Courtyard {
  private static final double SIZE = 10;
  private static final double WALL = 4;
  private static final double RING = 3.2;

  static List<Scene> all() {
    return List.of(pinhole(), thinLens(), bokeh(), cylindrical(), fishEye(), spherical());
  }

  private static Scene pinhole() {
    Scene s = new Scene("camera-pinhole", 720, 480, 100);
    s.camera("Pinhole", "fieldOfView", 60).at(-1.2, 2.4, -4.7).turn(12, 12, 0);
    return byDay(s);
  }

  private static Scene thinLens() {
    Scene s = new Scene("camera-thin-lens", 720, 480, 128);
    s.camera("ThinLens", "fieldOfView", 50, "focusDistance", 2.6, "aperture", .06)
        .at(-1, 1.7, -4.7)
        .turn(4, -6, 0);
    return byDay(s);
  }

  private static Scene cylindrical() {
    Scene s = new Scene("camera-cylindrical", 960, 320, 100);
    s.camera("Cylindrical", "height", 1).at(0, 1.6, 0);
    return byDay(s);
  }

  private static Scene fishEye() {
    Scene s = new Scene("camera-fisheye", 560, 560, 100);
    s.camera("FishEye", "angle", 180).at(0, 1.6, 0).turn(-15, 0, 0);
    return byDay(s);
  }

  private static Scene spherical() {
    Scene s = new Scene("camera-spherical", 960, 480, 80);
    s.camera("Spherical").at(0, 1.6, 0);
    return byDay(s);
  }

  /** By night, small lamps behind the plane of focus become hearts; before it, turned hearts. */
  private static Scene bokeh() {
    Scene s = new Scene("camera-bokeh", 480, 320, 256).set("maxTraceDepth", 2);
    s.set("background", Scene.rgb(.006, .009, .02));
    int heart = s.image("heart", "textures/heart.png");
    s.camera(
            "ThinLens",
            "fieldOfView",
            50,
            "focusDistance",
            1.7,
            "aperture",
            .22,
            "bokehTextureId",
            heart)
        .at(.6, 1.55, -4.85);
    furnish(s);
    s.add(
        s.rectangleLight("lamp", .8, .8, Scene.rgb(10, 8, 6))
            .at(2.5, 3.9, -4.6)
            .turn(60, -45, 0));
    garland(s);
    Node near = s.add(s.group("lamps before the focus").at(.6, 1.55, -4.05));
    int green = s.emitter("near lamp", 4, 60, 10);
    near.child(s.sphere("lamp", green, .01).at(.33, -.21, 0));
    near.child(s.sphere("lamp", green, .01).at(.12, -.27, 0));
    near.child(s.sphere("lamp", green, .01).at(.44, -.03, 0));
    return s;
  }

  private static void garland(Scene s) {
    int[] colours = {
      s.emitter("red lamp", 60, 5, 8),
      s.emitter("golden lamp", 55, 24, 2),
      s.emitter("pink lamp", 50, 6, 26),
      s.emitter("blue lamp", 3, 10, 60)
    };
    Node garland = s.add(s.group("garland").at(0, 0, 4.6));
    for (int i = 0; i < 6; i++) {
      double sag = i % 2 * .35;
      garland.child(s.sphere("lamp", colours[i % 4], .09).at(-3.2 + i * 1.5, 2.7 - sag, 0));
      garland.child(
          s.sphere("lamp", colours[(i + 2) % 4], .09).at(-3.9 + i * 1.5, 4.4 - sag, 0));
    }
  }

  private static Scene byDay(Scene s) {
    furnish(s);
    s.add(s.dome("sky", s.smoothImage("sky", "textures/sky.png"), 14).turn(0, 135, 0));
    return s;
  }

  private static void furnish(Scene s) {
    floor(s);
    wall(s, Compass.NORTH, Scene.rgb(.25, .4, .75));
    wall(s, Compass.EAST, Scene.rgb(.72, .2, .16));
    wall(s, Compass.SOUTH, Scene.rgb(.8, .62, .18));
    wall(s, Compass.WEST, Scene.rgb(.25, .55, .25));

    int stone = s.diffuse("stone", .6, .6, .58);
    onPlinth(s, stone, 0, ball(s, s.diffuse("purple", .4, .12, .6)));
    onPlinth(s, stone, 45, ball(s, s.mirror("mirror", .95, .95, .95)));
    onPlinth(s, stone, 90, ball(s, s.diffuse("orange", .85, .35, .05)));
    onPlinth(s, stone, 135, ball(s, s.glass("glass", 1.5)));
    onPlinth(s, stone, 180, ball(s, s.diffuse("white", .8, .8, .8)));
    int banner = s.image("banner", "textures/banner.png");
    onPlinth(s, stone, 225, ball(s, s.textured("banner", banner, 2, -1)).turn(0, -27, 0));
    onPlinth(s, stone, 270, ball(s, s.diffuse("cyan", .1, .6, .65)));
    int up = s.image("up", "textures/arrow.png");
    Node crate = s.cube("crate", s.textured("crate", up, 1, -1), .7, .7, .7);
    onPlinth(s, stone, 315, crate.at(0, 1.15, 0).turn(0, -35, 0));
  }

  private static void floor(Scene s) {
    int checker = s.image("checker", "textures/checker.png");
    int arrow = s.image("arrow", "textures/arrow.png");
    s.add(s.plane("floor", s.textured("tiles", checker, 5, 5), SIZE, SIZE));
    s.add(
        s.plane("arrow to the north", s.textured("arrow", arrow, 1, 1), 1.6, 1.6)
            .at(0, .01, 1.2)
            .turn(0, 180, 0));
  }

  /** A wall on one side of the yard, with its sign; the sign's arrow points clockwise. */
  private static void wall(Scene s, Compass side, double[] colour) {
    String name = side.name().toLowerCase(Locale.ROOT);
    Node group = s.add(s.group(name).turn(0, side.heading, 0));
    int paint = s.diffuse(name + " wall", colour[0], colour[1], colour[2]);
    group.child(s.wall("wall", paint, SIZE, WALL, Compass.SOUTH).at(0, WALL / 2, SIZE / 2));
    int letters = s.image(name, "textures/" + name + ".png");
    int sign = s.textured(name + " sign", letters, 1, 1);
    double width = Pictures.signWidth(side.name()) * .1;
    double height = Pictures.SIGN_HEIGHT * .1;
    group.child(s.wall("sign", sign, width, height, Compass.SOUTH).at(0, 2.8, SIZE / 2 - .02));
  }

  private static Node ball(Scene s, int material) {
    return s.sphere("ball", material, .4).at(0, 1.2, 0);
  }

  private static void onPlinth(Scene s, int stone, double heading, Node thing) {
    double x = RING * StrictMath.sin(StrictMath.toRadians(heading));
    double z = RING * StrictMath.cos(StrictMath.toRadians(heading));
    Node group = s.add(s.group("plinth at " + (int) heading).at(x, 0, z));
    group.child(s.cube("plinth", stone, .7, .8, .7).at(0, .4, 0));
    group.child(thing);
  }
}
