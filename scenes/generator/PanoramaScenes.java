package generator;

import java.util.List;

/** Rows 15 to 17: pictures that see more than one side of a room. */
final class PanoramaScenes {
  private static final double ROOM = 4;
  private static final double HEIGHT = 4.9;

  private PanoramaScenes() {}

  static List<Scene> all() {
    return List.of(frog(), spherical(), cylindrical());
  }

  /** The frog in a corner of a coloured box, seen through a fisheye. */
  private static Scene frog() {
    Scene s = TableScenes.row("15-frog", 750, 750, 500, 30);
    s.camera("FishEye", "angle", 180).at(.05, .68, -.82).turn(10, 0, 0);
    double side = 2.6;
    int green = s.diffuse("green", .1, .42, .2);
    int olive = s.diffuse("olive", .3, .32, .08);
    Node box = s.add(s.group("box").turn(0, 45, 0));
    box.child(s.plane("floor", s.diffuse("cyan", .1, .38, .42), side, side));
    box.child(
        s.plane("ceiling", s.diffuse("mauve", .42, .3, .36), side, side)
            .at(0, side, 0)
            .turn(180, 0, 0));
    double half = side / 2;
    box.child(s.wall("far right", olive, side, side, Compass.SOUTH).at(0, half, half));
    box.child(s.wall("near left", olive, side, side, Compass.NORTH).at(0, half, -half));
    box.child(s.wall("far left", green, side, side, Compass.EAST).at(-half, half, 0));
    box.child(s.wall("near right", green, side, side, Compass.WEST).at(half, half, 0));
    s.add(FigureScenes.frog(s).at(0, 0, -.05).turn(0, 50, 0).scale(1.5));
    s.add(
        s.rectangleLight("lamp", .7, .7, Scene.rgb(26, 25, 23))
            .at(0, side - .01, -1.1)
            .turn(90, 45, 0));
    return s;
  }

  private static Scene spherical() {
    Scene s = TableScenes.row("16-spherical", 750, 750, 250, 30);
    s.camera("Spherical").at(0, 1.95, 0);
    return room(s);
  }

  private static Scene cylindrical() {
    Scene s = TableScenes.row("17-cylindrical", 750, 750, 500, 30);
    s.camera("Cylindrical", "height", 1.35).at(0, 1.95, 0);
    return room(s);
  }

  /** A room with walls of two colours, in which two figures face each other. */
  private static Scene room(Scene s) {
    double half = ROOM / 2;
    int yellow = s.diffuse("yellow", .72, .62, .24);
    int pink = s.diffuse("pink", .58, .36, .62);
    int red = s.diffuse("red", .68, .2, .17);
    int tiles = s.textured("tiles", s.image("checker", "textures/checker.png"), 4, 4);
    s.add(s.plane("floor", tiles, ROOM, ROOM));
    s.add(s.plane("ceiling", red, ROOM, ROOM).at(0, HEIGHT, 0).turn(180, 0, 0));
    s.add(s.wall("ahead", yellow, ROOM, HEIGHT, Compass.SOUTH).at(0, HEIGHT / 2, half));
    s.add(s.wall("behind", yellow, ROOM, HEIGHT, Compass.NORTH).at(0, HEIGHT / 2, -half));
    s.add(s.wall("left", pink, ROOM, HEIGHT, Compass.EAST).at(-half, HEIGHT / 2, 0));
    s.add(s.wall("right", pink, ROOM, HEIGHT, Compass.WEST).at(half, HEIGHT / 2, 0));
    s.add(
        s.rectangleLight("lamp", 1, 1, Scene.rgb(34, 34, 33))
            .at(0, HEIGHT - .01, 0)
            .turn(90, 0, 0));
    int steel =
        s.material(
            "steel",
            "CookTorrance",
            "color",
            Scene.rgb(.25, .28, .36),
            "specularColor",
            Scene.rgb(.6, .65, .64),
            "roughness",
            .25,
            "normalTextureId",
            s.smoothImage("armour's relief", "models/armoured-figure-normal.png"));
    int green = s.glossy("green", Scene.rgb(.12, .5, .16), Scene.rgb(.4, .5, .4), .2);
    int armour = s.mesh("armoured figure", "models/armoured-figure.obj");
    int frog = s.mesh("frog", "models/frog.obj");
    standing(s, s.meshShape("armoured figure", steel, armour), -41, 1.3);
    standing(s, s.meshShape("frog", green, frog).scale(2.2), 132, 1.6);
    return s;
  }

  /** Places what faces -z so far from the middle, facing it. */
  private static void standing(Scene s, Node figure, double heading, double distance) {
    double a = StrictMath.toRadians(heading);
    double x = distance * StrictMath.sin(a);
    double z = distance * StrictMath.cos(a);
    s.add(figure.at(x, 0, z).turn(0, heading, 0));
  }
}
