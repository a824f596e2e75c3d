package generator;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes the example scenes and everything they need but the models: the scenes as JSON files
 * meant to be read and edited by hand, their textures as PNG files and one mesh as an OBJ file.
 *
 * <p>An argument names another folder to write to than {@code scenes}. Every run writes the same
 * files, whatever the locale; existing files of these names are overwritten.
 *
 * <p>The scenes are left-handed, as the format is: +x right, +y up, +z forward. All lengths are
 * metres but in the Cornell boxes, whose 5.5 units are the original's 55 centimetres.
 */
public final class GenerateScenes {
  private GenerateScenes() {}

  /**
   * Writes all scenes.
   *
   * @param arguments empty, or the folder to write to
   * @throws IOException if a file cannot be written
   */
  public static void main(String[] arguments) throws IOException {
    Path folder = Path.of(arguments.length == 0 ? "scenes" : arguments[0]);
    Files.createDirectories(folder.resolve("textures"));
    Pictures.writeAll(folder.resolve("textures"));
    ReliefMaps.writeAll(folder.resolve("textures"));
    Files.writeString(folder.resolve("torus-knot.obj"), TorusKnot.obj());

    List<Scene> scenes = new ArrayList<>(CornellBoxes.all());
    scenes.add(glassAndMirror());
    scenes.addAll(Courtyard.all());
    scenes.add(torusKnot());
    scenes.add(lantern());
    scenes.add(clockwork());
    scenes.addAll(HardLight.all());
    scenes.addAll(TableScenes.all());
    for (Scene scene : scenes) {
      Files.writeString(folder.resolve(scene.name + ".json"), scene.toJson());
    }
  }

  /** Mirrors and glass on a floor of tiles one metre wide, lit by a panel and a globe. */
  private static Scene glassAndMirror() {
    Scene s = new Scene("glass-and-mirror", 720, 480, 144).set("maxTraceDepth", 12);
    s.set("background", Scene.rgb(.16, .22, .32));
    int tiles = s.textured("tiles", s.image("checker", "textures/checker.png"), 5, 5);
    int mirror = s.mirror("mirror", .95, .95, .95);
    int gold = s.mirror("golden mirror", .95, .7, .3);
    int glass = s.glass("glass", 1.5);
    int diamond = s.glass("diamond", 2.4);
    s.camera("Pinhole", "fieldOfView", 40).at(0, 2.1, -6.6).turn(11, 0, 0);
    s.add(s.infinitePlane("floor", tiles));
    s.add(s.sphere("mirror ball", mirror, 1).at(-1.35, 1, 1.2));
    s.add(s.sphere("glass ball", glass, .85).at(.95, .85, -.3));
    s.add(s.sphere("golden ball", gold, .5).at(2.3, .5, 1.6));
    s.add(s.sphere("diamond ball", diamond, .3).at(-.55, .3, -1.5));
    s.add(s.cube("glass cube", glass, .7, .7, .7).at(-2.1, .36, -.9).turn(0, 30, 0));
    s.add(s.sphere("red ball", s.diffuse("red", .75, .1, .08), .4).at(.5, .4, 2.1));
    s.add(s.sphere("yellow ball", s.diffuse("yellow", .8, .6, .1), .25).at(1.9, .25, -1.3));
    s.add(s.sphere("blue ball", s.diffuse("blue", .1, .2, .7), .3).at(-.2, .3, .9));
    s.add(s.rectangleLight("panel", 3, 2, Scene.rgb(6, 5.7, 5)).at(-1.5, 5, -.5).turn(90, 0, 0));
    s.add(s.sphereLight("globe", .4, Scene.rgb(9, 7, 4.5)).at(3.2, 2.6, 3.2));
    return s;
  }

  /** A trefoil of 26,000 triangles on a plinth. */
  private static Scene torusKnot() {
    Scene s = new Scene("torus-knot", 600, 600, 100).set("background", Scene.rgb(.12, .14, .18));
    int knot =
        s.textured("knot", s.image("gold and ivory", "textures/gold.png"), 24, 2);
    int stone = s.diffuse("stone", .5, .48, .45);
    int mesh = s.mesh("trefoil", "torus-knot.obj");
    s.camera("Pinhole", "fieldOfView", 36).at(0, 2.6, -6).turn(11, 0, 0);
    s.add(s.plane("floor", s.diffuse("floor", .42, .45, .5), 40, 40));
    s.add(s.cube("plinth", stone, 1.8, .5, 1.8).at(0, .25, 0).turn(0, 20, 0));
    s.add(s.meshShape("knot", knot, mesh).at(0, 1.66, 0).turn(-68, 0, 0).scale(.38));
    s.add(s.rectangleLight("key", 2, 2, Scene.rgb(14, 13, 11)).at(-3, 4.8, -3).turn(45, 45, 0));
    s.add(s.rectangleLight("fill", 2, 2, Scene.rgb(1.5, 2, 3)).at(4, 2.5, -1.5).turn(15, -70, 0));
    return s;
  }

  /** The lantern, a glTF model with its own materials and a flame, in a dim studio. */
  private static Scene lantern() {
    Scene s = new Scene("lantern", 560, 640, 400).set("maxTraceDepth", 12);
    s.set("toneMap", "neutral").set("exposure", 1.2);
    int floor = s.diffuse("floor", .28, .27, .26);
    s.camera("Pinhole", "fieldOfView", 22).at(-.32, .42, -1.34).turn(10, 13.5, 0);
    s.add(s.studio("studio", .22));
    s.add(s.model("lantern", "models/lantern.glb").at(0, .03, 0).turn(0, 24, 0));
    s.add(s.infinitePlane("floor", floor));
    return s;
  }

  /** The movement of a clock from near, with the far wheels out of focus. */
  private static Scene clockwork() {
    Scene s = new Scene("clockwork", 960, 600, 256).set("maxTraceDepth", 10);
    s.set("toneMap", "neutral").set("exposure", 1.1);
    int table = s.diffuse("table", .05, .045, .04);
    s.camera("ThinLens", "fieldOfView", 26, "focusDistance", .56, "aperture", .012)
        .at(-.12, .36, -.52)
        .turn(33, 14, 0);
    s.add(s.studio("studio", .35));
    double[] daylight = Scene.rgb(9, 8.6, 8);
    s.add(s.rectangleLight("window", .5, .3, daylight).at(-.6, .6, .5).turn(40, 130, 0));
    s.add(s.model("clockwork", "models/clockwork.glb").at(0, .016, 0));
    s.add(s.infinitePlane("table", table));
    return s;
  }
}
