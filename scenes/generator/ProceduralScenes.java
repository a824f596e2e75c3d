package generator;

import java.util.List;

/** Rows 11 to 14: pictures of computed textures. */
final class ProceduralScenes {
  private static final double SIDE = 5.5;

  private ProceduralScenes() {}

  static List<Scene> all() {
    return List.of(marble(), wood(), voronoi(), sideBySide());
  }

  private static Scene marble() {
    Scene s = TableScenes.row("11-marble", 760, 760, 250, 30);
    int cloud = s.texture("clouds", "Cloud", "width", 500, "height", 500);
    int walls =
        s.material("clouds", "Diffuse", "color", Scene.rgb(.9, .9, .9), "colorTextureId", cloud);
    return boxed(s, walls, s.textured("marble", marbleTexture(s), 1, 1), 5.3);
  }

  private static Scene voronoi() {
    Scene s = TableScenes.row("13-voronoi", 750, 750, 1000, 30);
    int cells =
        s.texture(
            "grey cells",
            "Voronoi",
            "width",
            500,
            "height",
            500,
            "samples",
            30,
            "blackAndWhite",
            true);
    int walls =
        s.material(
            "grey cells", "Diffuse", "color", Scene.rgb(.9, .9, .9), "colorTextureId", cells);
    return boxed(s, walls, s.textured("coloured cells", cellTexture(s), 1, 1), 8.5);
  }

  private static int marbleTexture(Scene s) {
    return s.texture("marble", "Marble", "width", 500, "height", 500);
  }

  private static int cellTexture(Scene s) {
    return s.texture("coloured cells", "Voronoi", "width", 500, "height", 500, "samples", 30);
  }

  private static int woodTexture(Scene s, double rings) {
    return s.texture("wood", "Wood", "width", 1000, "height", 1000, "rings", rings);
  }

  /** A mirror ball afloat in a closed box; the camera looks through the back of the front wall. */
  private static Scene boxed(Scene s, int walls, int floor, double radiance) {
    s.camera("ThinLens", "fieldOfView", 27, "focusDistance", 12.5, "aperture", .2)
        .at(.1, SIDE / 2, -10.6);
    int white = s.diffuse("white", .85, .85, .85);
    double middle = SIDE / 2;
    s.add(s.plane("floor", floor, SIDE, SIDE).at(0, 0, middle));
    s.add(s.plane("ceiling", white, SIDE, SIDE).at(0, SIDE, middle).turn(180, 0, 0));
    s.add(s.wall("back", walls, SIDE, SIDE, Compass.SOUTH).at(0, middle, SIDE));
    s.add(s.wall("front", walls, SIDE, SIDE, Compass.NORTH).at(0, middle, 0));
    s.add(s.wall("left", walls, SIDE, SIDE, Compass.EAST).at(-middle, middle, middle));
    s.add(s.wall("right", walls, SIDE, SIDE, Compass.WEST).at(middle, middle, middle));
    s.add(s.sphere("ball", s.mirror("mirror", .95, .95, .95), 1.4).at(.05, 2, 2.4));
    s.add(
        s.rectangleLight("lamp", 2, 1.8, Scene.rgb(radiance, radiance, radiance))
            .at(.05, SIDE - .03, 2.6)
            .turn(90, 0, 0));
    return s;
  }

  private static Scene wood() {
    Scene s = TableScenes.row("12-wood", 750, 750, 300, 30);
    s.set("background", Scene.rgb(.55, .55, .55));
    s.camera("Pinhole", "fieldOfView", 39).at(0, 2.05, -1.88).turn(39.5, 0, 0);
    int checker = s.image("checker", "textures/checker.png");
    int pink = s.diffuse("pink", .8, .4, .4);
    s.add(s.plane("floor", s.textured("tiles", checker, 4, 4), 4, 4).at(0, 0, -.2));
    s.add(s.wall("wall", pink, 4, 4, Compass.SOUTH).at(0, 2, 1.1));
    int rings = woodTexture(s, 8);
    int stained =
        s.material(
            "stained wood", "Diffuse", "color", Scene.rgb(.32, .2, .14), "colorTextureId", rings);
    s.add(s.meshShape("table", stained, s.mesh("table", "models/table.obj")));
    s.add(s.plane("top", s.textured("wood", rings, 1, 1), 1.56, .86).at(0, .7504, 0));
    int glass = s.glass("glass", 1.5);
    int wine = s.mesh("wine glass", "models/wine-glass.obj");
    s.add(s.meshShape("far glass", glass, wine).at(.47, .7506, .07).scale(1.55));
    s.add(s.meshShape("near glass", glass, wine).at(.6, .7506, -.22).scale(1.55));
    s.add(
        s.rectangleLight("lamp", 3, 2, Scene.rgb(3.5, 3.4, 3.1))
            .at(-.5, 3.6, -1.2)
            .turn(70, 20, 0));
    return s;
  }

  /** The four textures on four squares. */
  private static Scene sideBySide() {
    Scene s = TableScenes.row("14-procedurals", 720, 720, 1000, 32);
    s.camera("Pinhole", "fieldOfView", 27).at(0, 0, -10);
    int cloud = s.texture("clouds", "Cloud", "width", 500, "height", 500);
    square(s, "cells", cellTexture(s), -1.1, 1.05);
    square(s, "marble", marbleTexture(s), 1.1, 1.05);
    square(s, "clouds", cloud, -1.1, -1.15);
    square(s, "wood", woodTexture(s, 7), 1.1, -1.15);
    s.add(s.rectangleLight("lamp", 12, 12, Scene.rgb(1.4, 1.4, 1.4)).at(0, 0, -12));
    return s;
  }

  private static void square(Scene s, String name, int texture, double x, double y) {
    int material = s.textured(name, texture, 1, 1);
    s.add(s.wall(name, material, 1.98, 1.98, Compass.SOUTH).at(x, y, 0));
  }
}
