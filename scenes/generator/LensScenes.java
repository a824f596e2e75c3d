package generator;

import java.util.List;
import java.util.Random;

/** Rows 1 to 6: pictures that the thin lens makes. */
final class LensScenes {
  private static final int LIGHTS = 82;

  private LensScenes() {}

  static List<Scene> all() {
    return List.of(
        spheres("01-depth-of-field-400mm", .4),
        spheres("02-depth-of-field-200mm", .2),
        spheres("03-depth-of-field-100mm", .1),
        figure("04-armoured-figure", 40000, 32, false),
        hearts(),
        figure("06-armoured-figure-stars", 1500, 128, true));
  }

  /** A row of glossy spheres that runs away from the camera, the third of them in focus. */
  private static Scene spheres(String name, double aperture) {
    Scene s = TableScenes.row(name, 1280, 720, 1000, 32);
    int white = s.diffuse("white", .8, .8, .8);
    int[] coats = {
      s.glossy("emerald", Scene.rgb(.03, .42, .18), Scene.rgb(.2, .55, .4), .15),
      s.glossy("amber", Scene.rgb(.3, .15, .02), Scene.rgb(.7, .45, .1), .15),
      s.glossy("violet", Scene.rgb(.1, .05, .45), Scene.rgb(.3, .2, .55), .15),
      s.glossy("pearl", Scene.rgb(.45, .45, .45), Scene.rgb(.55, .55, .55), .15),
      s.glossy("ruby", Scene.rgb(.5, .03, .04), Scene.rgb(.5, .2, .22), .15),
      s.glossy("lemon", Scene.rgb(.45, .45, .04), Scene.rgb(.5, .55, .2), .15)
    };
    s.camera("ThinLens", "fieldOfView", 60, "focusDistance", 8, "aperture", aperture)
        .at(.6, 2.8, -8.15)
        .turn(21.4, -6.5, 0);
    for (int k = 0; k < 7; k++) {
      int coat = coats[k < 6 ? k : 2];
      s.add(s.sphere("sphere", coat, .75).at(2.7 - 1.6 * k, .75, -4.1 + 1.8 * k + .1 * k * k));
    }
    s.add(s.plane("floor", white, 80, 22).at(0, 0, 1));
    s.add(s.plane("ceiling", white, 80, 22).at(0, 7, 1).turn(180, 0, 0));
    s.add(s.wall("back", white, 80, 7, Compass.SOUTH).at(0, 3.5, 12));
    s.add(s.wall("front", white, 80, 7, Compass.NORTH).at(0, 3.5, -10));
    double[] warm = Scene.rgb(9, 8.8, 8.5);
    s.add(s.rectangleLight("left", 3, 2, warm).at(-12, 4, -3).turn(20, 70, 0));
    s.add(s.rectangleLight("before", 3, 2, warm).at(-2.5, 5.5, -8.5).turn(40, 12, 0));
    s.add(s.rectangleLight("right", 2, 2, warm).at(8, 4.5, -4).turn(30, -60, 0));
    s.add(s.rectangleLight("over the wall", 8, 1.6, warm).at(3, 6.8, 6).turn(50, 0, 0));
    return s;
  }

  /** A figure before a swarm of lamps so far behind the plane of focus that they become discs. */
  private static Scene figure(String name, int samples, int bucketSize, boolean stars) {
    Scene s = TableScenes.row(name, 1280, 720, samples, bucketSize);
    Node camera = s.camera("ThinLens", "fieldOfView", 19, "focusDistance", 10.65, "aperture", .3);
    if (stars) {
      camera.with("bokehTextureId", s.image("star", "textures/star.png"));
    }
    camera.at(0, 1.35, 0);
    int floor = s.glossy("floor", Scene.rgb(.5, .5, .5), Scene.rgb(.5, .5, .5), .4);
    s.add(s.plane("floor", floor, 60, 40).at(0, 0, 18));
    s.add(FigureScenes.armoured(s).at(1.37, 0, 10.65).turn(0, -8, 0));
    s.add(
        s.rectangleLight("key", 1.6, 1.6, Scene.rgb(10, 9.6, 8.5))
            .at(-2.5, 4.2, 7.5)
            .turn(50, 50, 0));
    lamps(s);
    return s;
  }

  private static void lamps(Scene s) {
    Random random = new Random(82);
    double[][] colours = {{1, .93, .85}, {1, .88, .5}, {.95, .95, 1}, {1, .8, .3}};
    Node swarm = s.add(s.group("lamps"));
    for (int i = 0; i < LIGHTS; i++) {
      double x = -1.8 + 3.1 * random.nextDouble();
      double y = -.23 + 1.2 * StrictMath.pow(random.nextDouble(), 1.5);
      double distance = 14 + 11 * random.nextDouble();
      double height = .1673 * distance;
      double[] colour = colours[random.nextInt(colours.length)].clone();
      double brightness = 3 + 20 * random.nextDouble() * random.nextDouble();
      for (int c = 0; c < 3; c++) {
        colour[c] *= brightness;
      }
      swarm.child(
          s.rectangleLight("lamp", .06, .06, colour)
              .at(x * height, 1.35 + y * height, distance)
              .turn(20, 180, 0));
    }
  }

  /** Nothing but small red lamps, seen through a lens with the shape of a heart. */
  private static Scene hearts() {
    Scene s = TableScenes.row("05-hearts", 1920, 1080, 10000, 32);
    int heart = s.image("heart", "textures/heart.png");
    s.camera(
            "ThinLens",
            "fieldOfView",
            20,
            "focusDistance",
            8,
            "aperture",
            .5,
            "bokehTextureId",
            heart)
        .at(0, 3, 0);
    Node trail = s.add(s.group("lamps"));
    Random random = new Random(24);
    for (int i = 0; i < 24; i++) {
      double t = i / 23.0;
      double distance = 14.5 - 3 * random.nextDouble();
      double height = .1763 * distance;
      double x = -.55 + 1.6 * t + (i % 3 - 1) * (.15 + .1 * random.nextDouble());
      double y = -.78 + 1.7 * t + (random.nextDouble() - .5) * .16;
      double brightness = 6 + 5 * t + 4 * random.nextDouble();
      double pale = .17 + .2 * (1 - t) * random.nextDouble();
      double[] colour = {.8 * brightness, pale * brightness, pale * brightness};
      trail.child(
          s.rectangleLight("lamp", .08, .08, colour)
              .at(x * height, 3 + y * height, distance)
              .turn(0, 180, 0));
    }
    return s;
  }
}
