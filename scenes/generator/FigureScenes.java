package generator;

import java.util.ArrayList;
import java.util.List;

/** Rows 7 to 10 and the Cornell box beside them: pictures that normal maps make. */
final class FigureScenes {
  private static final double WIDTH = 5.56;
  private static final double HEIGHT = 5.48;
  private static final double DEPTH = 5.6;

  private FigureScenes() {}

  static List<Scene> all() {
    return List.of(
        suited("07-suited-figure", true),
        suited("08-suited-figure-without-normal-maps", false),
        grey("09-grey-figure", true),
        grey("10-grey-figure-without-normal-maps", false),
        cornellBox());
  }

  /** The armoured figure, 1.8 units tall, facing -z. */
  static Node armoured(Scene s) {
    int colour = s.smoothImage("armour", "models/armoured-figure.png");
    int normals = s.smoothImage("armour's relief", "models/armoured-figure-normal.png");
    int coat =
        s.material(
            "armour",
            "CookTorrance",
            "color",
            Scene.rgb(.7, .7, .7),
            "colorTextureId",
            colour,
            "specularColor",
            Scene.rgb(.3, .3, .3),
            "roughness",
            .3,
            "normalTextureId",
            normals);
    int mesh = s.mesh("armoured figure", "models/armoured-figure.obj");
    return s.meshShape("armoured figure", coat, mesh);
  }

  /** The frog, 0.6 units tall, facing -z, in its own colours. */
  static Node frog(Scene s) {
    int colour = s.smoothImage("frog", "models/frog.png");
    int normals = s.smoothImage("frog's relief", "models/frog-normal.png");
    int skin =
        s.material(
            "frog",
            "CookTorrance",
            "color",
            Scene.rgb(.7, .7, .7),
            "colorTextureId",
            colour,
            "specularColor",
            Scene.rgb(.3, .3, .3),
            "roughness",
            .2,
            "normalTextureId",
            normals);
    return s.meshShape("frog", skin, s.mesh("frog", "models/frog.obj"));
  }

  private static Scene suited(String name, boolean reliefs) {
    Scene s = TableScenes.row(name, 1280, 720, 1000, 32);
    int plate = s.smoothImage("tread plate", "textures/tread-plate.png");
    int suit = s.smoothImage("suit", "models/suited-figure.png");
    List<Object> floor = new ArrayList<>(List.of("colorTextureId", plate));
    floor.addAll(List.of("color", Scene.rgb(.6, .6, .6), "colorScale", new double[] {12, 12}));
    floor.addAll(List.of("specularColor", Scene.rgb(.4, .4, .4), "exponent", 40.0));
    List<Object> figure = new ArrayList<>(List.of("colorTextureId", suit, "roughness", .35));
    figure.addAll(List.of("color", Scene.rgb(.6, .6, .6), "specularColor", Scene.rgb(.4, .4, .4)));
    if (reliefs) {
      addReliefs(s, floor, figure);
    }
    furnish(
        s,
        s.material("tread plate", "Phong", floor.toArray()),
        s.material("suit", "CookTorrance", figure.toArray()));
    double[] warm = Scene.rgb(16, 15.2, 14);
    s.add(s.rectangleLight("key", 1.6, 1.6, warm).at(2.2, 3.8, -3).turn(45, -35, 0));
    s.add(s.rectangleLight("back", 2, 1, warm).at(-.6, 4.4, 4).turn(60, 180, 0));
    s.add(s.rectangleLight("left", 1, 2, Scene.rgb(4, 4.7, 6)).at(-4, 2.5, -1).turn(15, 75, 0));
    return s;
  }

  private static Scene grey(String name, boolean reliefs) {
    Scene s =
        Scene.rayTraced("table-" + name, 1920, 1080, 2)
            .set("maxTraceDepth", 5)
            .set("reflectionTraceDepth", 5)
            .set("refractionTraceDepth", 5)
            .set("bucketSize", 32)
            .set("threads", 8);
    List<Object> floor = new ArrayList<>(List.of("color", Scene.rgb(.4, .4, .4)));
    floor.addAll(List.of("specularColor", Scene.rgb(.3, .3, .3), "exponent", 30.0));
    List<Object> figure = new ArrayList<>(List.of("color", Scene.rgb(.42, .36, .36)));
    figure.addAll(List.of("specularColor", Scene.rgb(.25, .25, .25), "exponent", 40.0));
    if (reliefs) {
      addReliefs(s, floor, figure);
    }
    furnish(
        s,
        s.material("grey plate", "Phong", floor.toArray()),
        s.material("grey suit", "Phong", figure.toArray()));
    s.add(s.point("key", Scene.rgb(1.3, 1.3, 1.3)).at(1.6, 3.6, -4.2));
    s.add(s.point("back", Scene.rgb(.45, .45, .45)).at(-1.5, 4, 3.5));
    s.add(s.point("left", Scene.rgb(.4, .4, .4)).at(-4, 2.2, -2));
    return s;
  }

  private static void addReliefs(Scene s, List<Object> floor, List<Object> figure) {
    int plate = s.smoothImage("tread plate's relief", "textures/tread-plate-normal.png");
    int suit = s.smoothImage("suit's relief", "models/suited-figure-normal.png");
    floor.addAll(List.of("normalTextureId", plate, "normalScale", new double[] {12, 12}));
    figure.addAll(List.of("normalTextureId", suit));
  }

  /** The figure on a floor of plates, with a wall of the same behind it. */
  private static void furnish(Scene s, int plate, int suit) {
    s.camera("Pinhole", "fieldOfView", 38).at(.05, 2.35, -3.45).turn(21.5, 0, 1.5);
    s.add(s.plane("floor", plate, 16, 16).at(0, 0, 1));
    s.add(s.wall("wall", plate, 16, 16, Compass.SOUTH).at(0, 0, 5));
    int mesh = s.mesh("suited figure", "models/suited-figure.obj");
    s.add(s.meshShape("suited figure", suit, mesh));
  }

  /** A Cornell box of plain shapes that look rough. */
  private static Scene cornellBox() {
    Scene s = TableScenes.row("normal-map-cornell-box", 1280, 720, 1000, 32);
    int tan = s.diffuse("tan", .73, .56, .36);
    int brick = s.smoothImage("bricks", "textures/brick-normal.png");
    int plaster = s.smoothImage("plaster", "textures/plaster-normal.png");
    int tread = s.smoothImage("tread plate", "textures/tread-plate-normal.png");
    int rings = s.smoothImage("rings", "textures/rings-normal.png");
    int red = rough(s, "red bricks", brick, 3, Scene.rgb(.55, .04, .04));
    int green = rough(s, "green bricks", brick, 3, Scene.rgb(.04, .4, .1));
    int back = rough(s, "plaster", plaster, 2, Scene.rgb(.73, .56, .36));
    int grey = rough(s, "rings", rings, 1, Scene.rgb(.6, .55, .5));
    int steel =
        s.material(
            "tread plate",
            "CookTorrance",
            "color",
            Scene.rgb(.12, .12, .12),
            "specularColor",
            Scene.rgb(.85, .85, .85),
            "roughness",
            .3,
            "normalTextureId",
            tread,
            "normalScale",
            new double[] {8, 4});
    s.camera("Pinhole", "fieldOfView", 36).at(0, 2.6, -8);
    s.add(s.plane("floor", tan, WIDTH, DEPTH).at(0, 0, DEPTH / 2));
    s.add(s.plane("ceiling", tan, WIDTH, DEPTH).at(0, HEIGHT, DEPTH / 2).turn(180, 0, 0));
    s.add(s.wall("back", back, WIDTH, HEIGHT, Compass.SOUTH).at(0, HEIGHT / 2, DEPTH));
    s.add(
        s.wall("left", red, DEPTH, HEIGHT, Compass.EAST).at(-WIDTH / 2, HEIGHT / 2, DEPTH / 2));
    s.add(
        s.wall("right", green, DEPTH, HEIGHT, Compass.WEST).at(WIDTH / 2, HEIGHT / 2, DEPTH / 2));
    s.add(s.sphere("sphere", steel, 1.3).at(-1.25, 1.3, 3.9));
    s.add(s.cube("cube", grey, 1.9, 1.9, 1.9).at(1.05, .95, 2.8).turn(0, 4, 0));
    s.add(
        s.rectangleLight("lamp", 1.4, 1.1, Scene.rgb(34, 29, 22))
            .at(0, HEIGHT - .01, 2.1)
            .turn(90, 0, 0));
    return s;
  }

  private static int rough(Scene s, String name, int relief, double times, double[] colour) {
    return s.material(
        name,
        "Diffuse",
        "color",
        colour,
        "normalTextureId",
        relief,
        "normalScale",
        new double[] {times, times});
  }
}
