package generator;

import java.util.List;

/**
 * Four rooms whose light comes by ways that light sampling cannot find: through the gap of a door,
 * through water, through glasses, and from a lamp behind a shade.
 */
final class HardLight {
  private HardLight() {}

  static List<Scene> all() {
    return List.of(doorAjar(), pool(), glassesOnATable(), lampShade());
  }

  /** A room that is lit by a bright hall behind a door left ajar. */
  private static Scene doorAjar() {
    Scene s = new Scene("door-ajar", 640, 480, 256).set("maxTraceDepth", 10).set("exposure", 1.5);
    int wall = s.diffuse("wall", .75, .72, .66);
    int wood = s.glossy("door", Scene.rgb(.32, .17, .08), Scene.rgb(.12, .12, .12), .3);
    int boards = s.diffuse("boards", .36, .24, .15);
    int hall = s.diffuse("hall", .8, .8, .78);
    int iron = s.glossy("iron", Scene.rgb(.05, .05, .05), Scene.rgb(.5, .5, .5), .25);
    s.camera("Pinhole", "fieldOfView", 55).at(1.5, 1.45, -2.6).turn(5, -14, 0);
    room(s, wall, boards, wall, 4.4, 2.6, 6);
    // The wall with the doorway, 0.9 wide and 2.05 high.
    s.add(s.cube("wall to the left", wall, 1.35, 2.6, .12).at(-1.525, 1.3, 3.06));
    s.add(s.cube("wall to the right", wall, 2.15, 2.6, .12).at(1.125, 1.3, 3.06));
    s.add(s.cube("lintel", wall, .9, .55, .12).at(-.4, 2.325, 3.06));
    Node hinge = s.add(s.group("hinge").at(-.85, 0, 3.1).turn(0, -24, 0));
    hinge.child(s.cube("door", wood, .9, 2.04, .04).at(.45, 1.02, 0));
    hinge.child(s.sphere("knob", iron, .03).at(.83, 1, -.06));
    s.add(s.plane("hall floor", hall, 3.4, 2).at(-.4, 0, 4.12));
    s.add(s.plane("hall ceiling", hall, 3.4, 2).at(-.4, 2.6, 4.12).turn(180, 0, 0));
    s.add(s.wall("hall back", hall, 3.4, 2.6, Compass.SOUTH).at(-.4, 1.3, 5.12));
    s.add(s.wall("hall left", hall, 2, 2.6, Compass.EAST).at(-2.1, 1.3, 4.12));
    s.add(s.wall("hall right", hall, 2, 2.6, Compass.WEST).at(1.3, 1.3, 4.12));
    s.add(
        s.rectangleLight("hall lamp", .5, .5, Scene.rgb(60, 52, 40))
            .at(-.4, 2.58, 4.3)
            .turn(90, 0, 0));
    furniture(s);
    return s;
  }

  private static void furniture(Scene s) {
    int oak = s.glossy("oak", Scene.rgb(.4, .26, .13), Scene.rgb(.1, .1, .1), .35);
    int glaze = s.glossy("glaze", Scene.rgb(.12, .3, .42), Scene.rgb(.3, .3, .3), .1);
    int table = s.mesh("table", "models/table.obj");
    int tumbler = s.mesh("tumbler", "models/tumbler.obj");
    s.add(s.meshShape("table", oak, table).at(.85, 0, .6).turn(0, 12, 0));
    s.add(s.sphere("bowl", glaze, .14).at(.65, .89, .5));
    s.add(s.meshShape("tumbler", s.glass("glass", 1.5), tumbler).at(1, .7505, .35));
    s.add(s.cube("stool", s.diffuse("red", .5, .09, .06), .4, .45, .4).at(-.35, .225, .3)
        .turn(0, 25, 0));
    s.add(s.sphere("ball", s.diffuse("yellow", .75, .55, .1), .2).at(-1.4, .2, 1.4));
  }

  /** A hall with a basin of rippled water under a globe lamp. */
  private static Scene pool() {
    Scene s = new Scene("pool", 640, 480, 256).set("maxTraceDepth", 12);
    int wall = s.diffuse("wall", .62, .66, .68);
    int stone = s.diffuse("stone", .6, .57, .5);
    int tiles = s.textured("tiles", s.image("checker", "textures/checker.png"), 6, 4);
    int blue = s.diffuse("basin wall", .35, .62, .72);
    s.camera("Pinhole", "fieldOfView", 52).at(-2.2, 1.9, -3.6).turn(22, 27, 0);
    s.add(s.plane("ceiling", wall, 8, 9).at(0, 3.4, .5).turn(180, 0, 0));
    s.add(s.wall("back", wall, 8, 3.4, Compass.SOUTH).at(0, 1.7, 5));
    s.add(s.wall("front", wall, 8, 3.4, Compass.NORTH).at(0, 1.7, -4));
    s.add(s.wall("left", wall, 9, 3.4, Compass.EAST).at(-4, 1.7, .5));
    s.add(s.wall("right", wall, 9, 3.4, Compass.WEST).at(4, 1.7, .5));
    // The floor around a basin 5 wide, 4 long and 1.2 deep, filled up to 0.12 below the rim.
    s.add(s.cube("rim in front", stone, 8, .3, 3).at(0, -.15, -2.5));
    s.add(s.cube("rim behind", stone, 8, .3, 2).at(0, -.15, 4));
    s.add(s.cube("rim to the left", stone, 1.5, .3, 4).at(-3.25, -.15, 1));
    s.add(s.cube("rim to the right", stone, 1.5, .3, 4).at(3.25, -.15, 1));
    s.add(s.plane("bottom", tiles, 5, 4).at(0, -1.2, 1));
    s.add(s.wall("basin back", blue, 5, 1.2, Compass.SOUTH).at(0, -.6, 3));
    s.add(s.wall("basin front", blue, 5, 1.2, Compass.NORTH).at(0, -.6, -1));
    s.add(s.wall("basin left", blue, 4, 1.2, Compass.EAST).at(-2.5, -.6, 1));
    s.add(s.wall("basin right", blue, 4, 1.2, Compass.WEST).at(2.5, -.6, 1));
    int water = s.mesh("water", "models/pool-water.obj");
    s.add(s.meshShape("water", s.glass("water", 1.33), water).at(0, -.12, 1));
    s.add(s.sphere("ball", s.diffuse("red", .7, .12, .08), .25).at(.9, -.1, 1.7));
    s.add(s.sphereLight("globe", .18, Scene.rgb(130, 122, 105)).at(.6, 2.3, 1.4));
    return s;
  }

  /** The rippled surface of the pool, 5.2 by 4.2 units, as an open mesh. */
  static ObjFile water() {
    int columns = 48;
    int rows = 40;
    ObjFile out = new ObjFile(4);
    for (int i = 0; i < columns; i++) {
      for (int j = 0; j < rows; j++) {
        String a = ripple(out, (double) i / columns, (double) j / rows);
        String b = ripple(out, (i + 1.) / columns, (double) j / rows);
        String c = ripple(out, (i + 1.) / columns, (j + 1.) / rows);
        String d = ripple(out, (double) i / columns, (j + 1.) / rows);
        out.face(a, d, b);
        out.face(d, c, b);
      }
    }
    return out;
  }

  private static String ripple(ObjFile out, double u, double v) {
    double x = 5.2 * (u - .5);
    double z = 4.2 * (v - .5);
    double[][] waves = {{4.1, 1.3, .011, 0}, {-2.2, 4.6, .009, 1}, {6.3, -5.2, .005, 2}, {1.1, 8.4, .003, 4}};
    double height = 0;
    double slopeX = 0;
    double slopeZ = 0;
    for (double[] wave : waves) {
      double phase = wave[0] * x + wave[1] * z + wave[3];
      height += wave[2] * StrictMath.sin(phase);
      slopeX += wave[2] * wave[0] * StrictMath.cos(phase);
      slopeZ += wave[2] * wave[1] * StrictMath.cos(phase);
    }
    double length = Math.sqrt(slopeX * slopeX + 1 + slopeZ * slopeZ);
    Vec normal = new Vec(-slopeX / length, 1 / length, -slopeZ / length);
    return out.corner(new Vec(x, height, z), u, v, normal);
  }

  /** Wine glasses and tumblers on a table, under a small lamp that hangs low. */
  private static Scene glassesOnATable() {
    Scene s = new Scene("glasses-on-a-table", 640, 480, 256).set("maxTraceDepth", 14);
    int wall = s.diffuse("wall", .5, .47, .42);
    int cloth = s.diffuse("cloth", .72, .7, .66);
    int glass = s.glass("glass", 1.5);
    s.camera("Pinhole", "fieldOfView", 34).at(-.1, 1.17, -.85).turn(31, 4, 0);
    room(s, wall, s.diffuse("floor", .3, .22, .16), wall, 3.6, 2.6, 4.4);
    s.add(s.meshShape("table", s.diffuse("oak", .4, .26, .13), s.mesh("table", "models/table.obj")));
    s.add(s.plane("cloth", cloth, 1.3, .7).at(0, .752, 0));
    int wine = s.mesh("wine glass", "models/wine-glass.obj");
    int tumbler = s.mesh("tumbler", "models/tumbler.obj");
    s.add(s.meshShape("wine glass", glass, wine).at(-.17, .7525, .02));
    s.add(s.meshShape("wine glass", glass, wine).at(.1, .7525, .1));
    s.add(s.meshShape("tumbler", glass, tumbler).at(.02, .7525, -.13));
    s.add(s.meshShape("tumbler", glass, tumbler).at(.24, .7525, -.08));
    s.add(s.sphere("glass ball", glass, .045).at(-.12, .7975, -.15));
    s.add(s.sphere("lemon", s.diffuse("lemon", .8, .62, .08), .034).at(.15, .7865, -.2));
    s.add(s.sphereLight("lamp", .05, Scene.rgb(150, 128, 95)).at(-.35, 1.55, .45));
    return s;
  }

  /** A corner with a table lamp whose bulb only the shade, the table and the ceiling see. */
  private static Scene lampShade() {
    Scene s = new Scene("lamp-shade", 640, 480, 256).set("maxTraceDepth", 10).set("exposure", .5);
    int wall = s.diffuse("wall", .7, .66, .6);
    int brass = s.glossy("brass", Scene.rgb(.1, .06, .02), Scene.rgb(.75, .55, .25), .2);
    s.camera("Pinhole", "fieldOfView", 48).at(-.5, 1.25, -2).turn(4, 12, 0);
    room(s, wall, s.diffuse("floor", .34, .24, .16), wall, 3.6, 2.5, 4.4);
    int table = s.mesh("table", "models/table.obj");
    Node stand = s.add(s.group("stand").at(.35, 0, 1));
    stand.child(s.meshShape("table", s.diffuse("oak", .4, .26, .13), table));
    stand.child(s.cube("foot", brass, .16, .02, .16).at(0, .76, 0));
    stand.child(s.cube("stem", brass, .02, .3, .02).at(0, .92, 0));
    int shade = s.mesh("shade", "models/lamp-shade.obj");
    stand.child(s.meshShape("shade", s.diffuse("shade", .62, .5, .36), shade).at(0, 1.02, 0));
    stand.child(s.sphereLight("bulb", .035, Scene.rgb(420, 350, 240)).at(0, 1.12, 0));
    stand.child(s.sphere("apple", s.diffuse("apple", .55, .1, .05), .04).at(-.4, .79, -.2));
    s.add(s.cube("chest", s.diffuse("chest", .18, .28, .2), .8, .5, .5).at(-1.1, .25, 1.5));
    s.add(s.sphere("ball", s.diffuse("ball", .75, .75, .75), .18).at(-1.1, .68, 1.5));
    return s;
  }

  /** A thin opaque shade, open at the top and at the bottom, 0.24 units tall. */
  static ObjFile shade() {
    return new Lathe()
        .curve(1, .155, 0, .09, .24)
        .curve(1, .09, .24, .086, .24)
        .curve(1, .086, .24, .151, 0)
        .curve(1, .151, 0, .155, 0)
        .into(new ObjFile(4), 48);
  }

  /** The floor, the ceiling and three walls of a room around the origin; +z stays open. */
  private static void room(
      Scene s, int wall, int floor, int ceiling, double width, double height, double depth) {
    s.add(s.plane("floor", floor, width, depth));
    s.add(s.plane("ceiling", ceiling, width, depth).at(0, height, 0).turn(180, 0, 0));
    s.add(s.wall("front", wall, width, height, Compass.NORTH).at(0, height / 2, -depth / 2));
    s.add(s.wall("left", wall, depth, height, Compass.EAST).at(-width / 2, height / 2, 0));
    s.add(s.wall("right", wall, depth, height, Compass.WEST).at(width / 2, height / 2, 0));
    if (!s.name.equals("door-ajar")) {
      s.add(s.wall("back", wall, width, height, Compass.SOUTH).at(0, height / 2, depth / 2));
    }
  }
}
