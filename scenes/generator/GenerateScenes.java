import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/**
 * Writes the example scenes and everything they need: the scenes as JSON files meant to be read and
 * edited by hand, their textures as PNG files and one mesh as an OBJ file. Run it from the top of
 * the repository:
 *
 * <pre>java scenes/generator/GenerateScenes.java</pre>
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
    Files.writeString(folder.resolve("torus-knot.obj"), TorusKnot.obj());

    List<Scene> scenes = new ArrayList<>(CornellBoxes.all());
    scenes.add(glassAndMirror());
    scenes.addAll(Courtyard.all());
    scenes.add(torusKnot());
    for (Scene scene : scenes) {
      Files.writeString(folder.resolve(scene.name + ".json"), scene.toJson());
    }
  }

  // ---------------------------------------------------------------------------------- scenes

  /** The Cornell box, under three kinds of light. */
  private static final class CornellBoxes {
    private static final double WIDTH = 5.56;
    private static final double HEIGHT = 5.48;
    private static final double DEPTH = 5.6;

    static List<Scene> all() {
      return List.of(rectangleLight(), sphereLight(), dome());
    }

    private static Scene rectangleLight() {
      Scene s = box("cornell-box", true);
      s.add(
          s.rectangleLight("lamp", 1.3, 1.05, rgb(36, 28, 18))
              .at(0, HEIGHT - .01, 2.8)
              .turn(90, 0, 0));
      return s;
    }

    private static Scene sphereLight() {
      Scene s = box("cornell-box-sphere-light", true);
      int white = s.diffuse("cord", .3, .3, .3);
      s.add(s.cube("cord", white, .03, .9, .03).at(0, HEIGHT - .45, 2.8));
      s.add(s.sphereLight("lamp", .45, rgb(18, 14, 9)).at(0, HEIGHT - 1.35, 2.8));
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

  /** Mirrors and glass on a floor of tiles one metre wide, lit by a panel and a globe. */
  private static Scene glassAndMirror() {
    Scene s = new Scene("glass-and-mirror", 720, 480, 144).set("maxTraceDepth", 12);
    s.set("background", rgb(.16, .22, .32));
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
    s.add(s.rectangleLight("panel", 3, 2, rgb(6, 5.7, 5)).at(-1.5, 5, -.5).turn(90, 0, 0));
    s.add(s.sphereLight("globe", .4, rgb(9, 7, 4.5)).at(3.2, 2.6, 3.2));
    return s;
  }

  /** A trefoil of 26,000 triangles on a plinth. */
  private static Scene torusKnot() {
    Scene s = new Scene("torus-knot", 600, 600, 100).set("background", rgb(.12, .14, .18));
    int knot =
        s.textured("knot", s.image("gold and ivory", "textures/gold.png"), 24, 2);
    int stone = s.diffuse("stone", .5, .48, .45);
    int mesh = s.mesh("trefoil", "torus-knot.obj");
    s.camera("Pinhole", "fieldOfView", 36).at(0, 2.6, -6).turn(11, 0, 0);
    s.add(s.plane("floor", s.diffuse("floor", .42, .45, .5), 40, 40));
    s.add(s.cube("plinth", stone, 1.8, .5, 1.8).at(0, .25, 0).turn(0, 20, 0));
    s.add(s.meshShape("knot", knot, mesh).at(0, 1.66, 0).turn(-68, 0, 0).scale(.38));
    s.add(s.rectangleLight("key", 2, 2, rgb(14, 13, 11)).at(-3, 4.8, -3).turn(45, 45, 0));
    s.add(s.rectangleLight("fill", 2, 2, rgb(1.5, 2, 3)).at(4, 2.5, -1.5).turn(15, -70, 0));
    return s;
  }

  /** A walled yard in which every direction looks different, seen by one camera after another. */
  private static final class Courtyard {
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
      s.set("background", rgb(.006, .009, .02));
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
      s.add(s.rectangleLight("lamp", .8, .8, rgb(10, 8, 6)).at(2.5, 3.9, -4.6).turn(60, -45, 0));
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
      wall(s, Compass.NORTH, rgb(.25, .4, .75));
      wall(s, Compass.EAST, rgb(.72, .2, .16));
      wall(s, Compass.SOUTH, rgb(.8, .62, .18));
      wall(s, Compass.WEST, rgb(.25, .55, .25));

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

  /** Points of the compass, by their heading in degrees: north is +z, east is +x. */
  private enum Compass {
    NORTH(0),
    EAST(90),
    SOUTH(180),
    WEST(270);

    final double heading;

    Compass(double heading) {
      this.heading = heading;
    }
  }

  private static double[] rgb(double r, double g, double b) {
    return new double[] {r, g, b};
  }

  // --------------------------------------------------------------------- the scene language

  /** A scene being written. Methods named after things make them; {@link #add} places them. */
  private static final class Scene {
    final String name;
    private final Map<String, Object> options = new LinkedHashMap<>();
    private final List<Object> assets = new ArrayList<>();
    private final List<Object> objects = new ArrayList<>();

    Scene(String name, int width, int height, int samples) {
      this.name = name;
      set("mode", "path").set("width", width).set("height", height).set("samples", samples);
    }

    Scene set(String option, Object value) {
      options.put(option, Json.value(option, value));
      return this;
    }

    Node add(Node node) {
      objects.add(node.map);
      return node;
    }

    String toJson() {
      Map<String, Object> root = new LinkedHashMap<>();
      root.put("mainCameraId", 1);
      root.put("renderOptions", options);
      root.put("assets", assets);
      root.put("objects", objects);
      Node.number(objects, 1);
      return Json.write(root) + "\n";
    }

    int diffuse(String name, double r, double g, double b) {
      return material(name, "Diffuse", "color", rgb(r, g, b));
    }

    /** A Lambertian material that shows an image so many times over. */
    int textured(String name, int texture, double uScale, double vScale) {
      if (uScale == 1 && vScale == 1) {
        return material(name, "Diffuse", "colorTextureId", texture);
      }
      Map<String, Object> scale = Json.map("x", uScale, "y", vScale);
      return material(name, "Diffuse", "colorTextureId", texture, "colorScale", scale);
    }

    int emitter(String name, double r, double g, double b) {
      return material(name, "Color", "color", rgb(r, g, b));
    }

    int mirror(String name, double r, double g, double b) {
      return material(name, "Reflective", "reflectivityColor", rgb(r, g, b));
    }

    int glass(String name, double ior) {
      return material(name, "Refractive", "ior", ior);
    }

    /** An image of which each texel is a plain patch. */
    int image(String name, String file) {
      return asset("Texture", name, "textureType", "Image", "file", file);
    }

    /** An image interpolated between its texels. */
    int smoothImage(String name, String file) {
      return asset("Texture", name, "textureType", "Image", "file", file, "filter", "bilinear");
    }

    int mesh(String name, String file) {
      return asset("Mesh", name, "file", file);
    }

    private int material(String name, String type, Object... channels) {
      Object[] all = new Object[channels.length + 2];
      all[0] = "materialType";
      all[1] = type;
      System.arraycopy(channels, 0, all, 2, channels.length);
      return asset("Material", name, all);
    }

    private int asset(String type, String name, Object... keys) {
      Map<String, Object> asset =
          Json.map("id", assets.size() + 1, "assetType", type, "name", name);
      asset.putAll(Json.map(keys));
      assets.add(asset);
      return assets.size();
    }

    /** The main camera, already placed as the first object. */
    Node camera(String type, Object... keys) {
      return add(new Node("Camera", "camera", "cameraType", type).with(keys));
    }

    Node group(String name) {
      return new Node("None", name);
    }

    /** A floor: width along x, depth along z, seen from above. */
    Node plane(String name, int material, double width, double depth) {
      return shape("Plane", name, material, "finite", true, "width", width, "height", depth);
    }

    Node infinitePlane(String name, int material) {
      return shape("Plane", name, material);
    }

    /** An upright plane that shows its front, and images unmirrored, towards the given side. */
    Node wall(String name, int material, double width, double height, Compass towards) {
      return plane(name, material, width, height).turn(90, towards.heading, 0);
    }

    Node cube(String name, int material, double width, double height, double depth) {
      return shape("Cube", name, material, "width", width, "height", height, "depth", depth);
    }

    Node sphere(String name, int material, double radius) {
      return shape("Sphere", name, material, "radius", radius);
    }

    Node meshShape(String name, int material, int mesh) {
      return shape("Mesh", name, material, "meshId", mesh);
    }

    private Node shape(String type, String name, int material, Object... keys) {
      return new Node("Shape", name, "shapeType", type, "materialID", material).with(keys);
    }

    /** A lamp of the given radiance that shines along its +z. */
    Node rectangleLight(String name, double width, double height, double[] radiance) {
      return light("Rectangle", name, radiance).with("width", width, "height", height);
    }

    Node sphereLight(String name, double radius, double[] radiance) {
      return light("Sphere", name, radiance).with("radius", radius);
    }

    Node dome(String name, int texture, double intensity) {
      return new Node("Light", name, "lightType", "Dome")
          .with("textureId", texture, "intensity", intensity);
    }

    /** The largest component becomes the intensity, the rest the colour. */
    private static Node light(String type, String name, double[] radiance) {
      double intensity = Math.max(radiance[0], Math.max(radiance[1], radiance[2]));
      double[] colour = radiance.clone();
      for (int i = 0; i < 3; i++) {
        colour[i] /= intensity;
      }
      return new Node("Light", name, "lightType", type)
          .with("unit", "radiance", "intensity", intensity, "color", colour);
    }
  }

  /** An object of a scene: what it is, where it stands and what hangs on it. */
  private static final class Node {
    final Map<String, Object> map = new LinkedHashMap<>();

    Node(String type, String name, Object... keys) {
      with("id", 0, "name", name, "type", type).with(keys);
    }

    Node with(Object... keys) {
      map.putAll(Json.map(keys));
      return this;
    }

    Node at(double x, double y, double z) {
      return with("localPosition", new double[] {x, y, z});
    }

    /** Turns in degrees: about z first, then x, then y. */
    Node turn(double x, double y, double z) {
      return with("localRotation", new double[] {x, y, z});
    }

    Node scale(double factor) {
      return with("localScale", new double[] {factor, factor, factor});
    }

    Node child(Node child) {
      children(map).add(child.map);
      return child;
    }

    @SuppressWarnings("unchecked")
    private static List<Object> children(Map<String, Object> map) {
      return (List<Object>) map.computeIfAbsent("children", key -> new ArrayList<Object>());
    }

    /** Numbers the objects in the order of the file. Returns the first number not used. */
    @SuppressWarnings("unchecked")
    static int number(List<Object> objects, int first) {
      int next = first;
      for (Object object : objects) {
        Map<String, Object> map = (Map<String, Object>) object;
        map.put("id", next++);
        if (map.containsKey("children")) {
          List<Object> last = (List<Object>) map.remove("children");
          map.put("children", last);
          next = number(last, next);
        }
      }
      return next;
    }
  }

  /** Maps, lists, strings, booleans and numbers as JSON; whatever fits a line stays on it. */
  private static final class Json {
    private static final int LINE = 120;

    static Map<String, Object> map(Object... keysAndValues) {
      Map<String, Object> map = new LinkedHashMap<>();
      for (int i = 0; i < keysAndValues.length; i += 2) {
        String key = (String) keysAndValues[i];
        map.put(key, value(key, keysAndValues[i + 1]));
      }
      return map;
    }

    /** Triples are colours under the keys of colours, and vectors elsewhere. */
    static Object value(String key, Object value) {
      if (!(value instanceof double[] v)) {
        return value;
      }
      boolean vector = key.startsWith("local");
      return vector ? map("x", v[0], "y", v[1], "z", v[2]) : map("r", v[0], "g", v[1], "b", v[2]);
    }

    static String write(Object value) {
      return write(value, "", 0);
    }

    private static String write(Object value, String indent, int used) {
      String line = oneLine(value);
      boolean container = value instanceof Map || value instanceof List;
      boolean root = indent.isEmpty();
      if (!container || !root && !hasChildren(value) && used + line.length() < LINE) {
        return line;
      }
      String inner = indent + "  ";
      List<String> items = new ArrayList<>();
      if (value instanceof Map<?, ?> map) {
        map.forEach((key, v) -> items.add(member(String.valueOf(key), v, inner)));
      } else {
        ((List<?>) value).forEach(v -> items.add(inner + write(v, inner, inner.length())));
      }
      String open = value instanceof Map ? "{\n" : "[\n";
      String close = value instanceof Map ? "}" : "]";
      return open + String.join(",\n", items) + "\n" + indent + close;
    }

    private static String member(String key, Object value, String indent) {
      String start = indent + quote(key) + ": ";
      return start + write(value, indent, start.length());
    }

    /** Lists of maps never share a line. */
    private static boolean hasChildren(Object value) {
      return value instanceof List || value instanceof Map<?, ?> map && map.containsKey("children");
    }

    private static String oneLine(Object value) {
      if (value instanceof Map<?, ?> map) {
        List<String> members = new ArrayList<>();
        map.forEach((key, v) -> members.add(quote(String.valueOf(key)) + ": " + oneLine(v)));
        return "{" + String.join(", ", members) + "}";
      }
      if (value instanceof List<?> list) {
        return "[" + String.join(", ", list.stream().map(Json::oneLine).toList()) + "]";
      }
      return value instanceof String s ? quote(s) : scalar(value);
    }

    /** Numbers in plain notation with at most four decimals. */
    private static String scalar(Object value) {
      if (!(value instanceof Double d)) {
        return String.valueOf(value);
      }
      BigDecimal rounded = BigDecimal.valueOf(d).setScale(4, RoundingMode.HALF_EVEN);
      return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }

    /** The scenes' names are plain; nothing needs an escape. */
    private static String quote(String text) {
      return '"' + text + '"';
    }
  }

  // ------------------------------------------------------------------------- textures, mesh

  /** The textures. Pixels are 0xRRGGBB, row 0 at the top. */
  private static final class Pictures {
    static final int SIGN_HEIGHT = 18;

    private static final int INK = 0x20242C;
    private static final int PAPER = 0xF2EEE2;
    private static final int RED = 0xB03020;

    private static final int[][] BAYER = {
      {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}
    };

    /** Letters five pixels wide and seven high, row by row. */
    private static final Map<Character, String> FONT =
        Map.ofEntries(
            Map.entry('A', "01110 10001 10001 11111 10001 10001 10001"),
            Map.entry('B', "11110 10001 10001 11110 10001 10001 11110"),
            Map.entry('E', "11111 10000 10000 11110 10000 10000 11111"),
            Map.entry('H', "10001 10001 10001 11111 10001 10001 10001"),
            Map.entry('L', "10000 10000 10000 10000 10000 10000 11111"),
            Map.entry('M', "10001 11011 10101 10101 10001 10001 10001"),
            Map.entry('N', "10001 10001 11001 10101 10011 10001 10001"),
            Map.entry('O', "01110 10001 10001 10001 10001 10001 01110"),
            Map.entry('R', "11110 10001 10001 11110 10100 10010 10001"),
            Map.entry('S', "01111 10000 10000 01110 00001 00001 11110"),
            Map.entry('T', "11111 00100 00100 00100 00100 00100 00100"),
            Map.entry('U', "10001 10001 10001 10001 10001 10001 01110"),
            Map.entry('W', "10001 10001 10001 10101 10101 11011 10001"));

    static void writeAll(Path folder) throws IOException {
      Png.write(folder.resolve("checker.png"), checker(0xE8E4DA, 0x4A4640));
      Png.write(folder.resolve("gold.png"), checker(0xE0A848, 0xF0E8D8));
      Png.write(folder.resolve("arrow.png"), upArrow(24));
      Png.write(folder.resolve("heart.png"), heart(128));
      Png.write(folder.resolve("sky.png"), sky(512, 256));
      Png.write(folder.resolve("banner.png"), banner("LUMBRE"));
      for (Compass side : Compass.values()) {
        String file = side.name().toLowerCase(Locale.ROOT) + ".png";
        Png.write(folder.resolve(file), sign(side.name()));
      }
    }

    private static int[][] checker(int a, int b) {
      return new int[][] {{a, b}, {b, a}};
    }

    static int signWidth(String word) {
      return 6 * word.length() + 3;
    }

    /** A word above an arrow to the right. */
    private static int[][] sign(String word) {
      int width = signWidth(word);
      int[][] pixels = filled(width, SIGN_HEIGHT, PAPER);
      letters(pixels, word, 2, 2);
      for (int x = 2; x < width - 2; x++) {
        int reach = x < width - 5 ? 0 : width - 3 - x;
        for (int y = 13 - reach; y <= 13 + reach; y++) {
          pixels[y][x] = RED;
        }
      }
      return pixels;
    }

    /** A word around half a ball, upright when the ball's image is turned over. */
    private static int[][] banner(String word) {
      int width = 6 * word.length();
      int[][] pixels = filled(width, width / 2, 0xE8B830);
      for (int y = width / 4 - 5; y < width / 4 + 6; y++) {
        Arrays.fill(pixels[y], PAPER);
      }
      letters(pixels, word, 0, width / 4 - 3);
      return pixels;
    }

    private static void letters(int[][] pixels, String word, int left, int top) {
      for (int i = 0; i < word.length(); i++) {
        String[] rows = FONT.get(word.charAt(i)).split(" ");
        for (int y = 0; y < 7; y++) {
          for (int x = 0; x < 5; x++) {
            if (rows[y].charAt(x) == '1') {
              pixels[top + y][left + 6 * i + x] = INK;
            }
          }
        }
      }
    }

    private static int[][] upArrow(int size) {
      int[][] pixels = filled(size, size, PAPER);
      int middle = size / 2;
      for (int y = 2; y < size - 2; y++) {
        int half = y < middle ? y - 1 : 3;
        for (int x = middle - half; x < middle + half; x++) {
          pixels[y][x] = RED;
        }
      }
      return pixels;
    }

    /** The curve x² + (1.25y − √|x|)² = 1, white on black. */
    private static int[][] heart(int size) {
      int[][] pixels = filled(size, size, 0);
      for (int row = 0; row < size; row++) {
        for (int column = 0; column < size; column++) {
          double x = ((column + .5) / size * 2 - 1) * 1.05;
          double y = (1 - (row + .5) / size * 2) * 1.05 + .21;
          double bent = 1.25 * y - Math.sqrt(Math.abs(x));
          if (x * x + bent * bent <= 1) {
            pixels[row][column] = 0xFFFFFF;
          }
        }
      }
      return pixels;
    }

    /**
     * All directions by longitude and latitude: a clear sky with the sun 50° high in the middle
     * column, and the ground below.
     */
    private static int[][] sky(int width, int height) {
      int[][] pixels = filled(width, height, 0);
      double sunHeight = StrictMath.toRadians(50);
      for (int row = 0; row < height; row++) {
        double latitude = Math.PI * (.5 - (row + .5) / height);
        for (int column = 0; column < width; column++) {
          double longitude = 2 * Math.PI * ((column + .5) / width - .5);
          double cosine =
              StrictMath.cos(latitude) * StrictMath.cos(sunHeight) * StrictMath.cos(longitude)
                  + StrictMath.sin(latitude) * StrictMath.sin(sunHeight);
          double fromSun = StrictMath.toDegrees(StrictMath.acos(Math.min(1, cosine)));
          pixels[row][column] =
              dithered(skyColour(StrictMath.sin(latitude), fromSun), row, column);
        }
      }
      return pixels;
    }

    private static double[] skyColour(double sine, double degreesFromSun) {
      if (sine < 0) {
        return rgb(.02, .018, .016);
      }
      double up = StrictMath.sqrt(sine);
      double glow = .06 * StrictMath.exp(-degreesFromSun / 12);
      double sun = Math.max(0, Math.min(1, 9 - degreesFromSun));
      return new double[] {
        .04 - .032 * up + glow + sun,
        .045 - .029 * up + .9 * glow + .93 * sun,
        .05 - .01 * up + .75 * glow + .8 * sun
      };
    }

    /** Pixels by the sRGB curve, dithered so that slow gradients show no steps. */
    private static int dithered(double[] linear, int row, int column) {
      double threshold = (BAYER[row % 4][column % 4] + .5) / 16;
      int pixel = 0;
      for (double c : linear) {
        pixel = pixel << 8 | (int) StrictMath.floor(srgb(c) * 255 + threshold);
      }
      return pixel;
    }

    /** The sRGB curve, IEC 61966-2-1. */
    private static double srgb(double linear) {
      double c = Math.min(1, linear);
      return c <= .0031308 ? 12.92 * c : 1.055 * StrictMath.pow(c, 1 / 2.4) - .055;
    }

    private static int[][] filled(int width, int height, int colour) {
      int[][] pixels = new int[height][width];
      for (int[] row : pixels) {
        Arrays.fill(row, colour);
      }
      return pixels;
    }
  }

  /** Writes truecolour PNG files of 8 bits a channel. */
  private static final class Png {
    static void write(Path file, int[][] pixels) throws IOException {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      DataOutputStream out = new DataOutputStream(bytes);
      out.writeLong(0x89504E470D0A1A0AL);
      ByteArrayOutputStream header = new ByteArrayOutputStream();
      DataOutputStream fields = new DataOutputStream(header);
      fields.writeInt(pixels[0].length);
      fields.writeInt(pixels.length);
      fields.write(new byte[] {8, 2, 0, 0, 0});
      chunk(out, "IHDR", header.toByteArray());
      chunk(out, "IDAT", compressed(pixels));
      chunk(out, "IEND", new byte[0]);
      Files.write(file, bytes.toByteArray());
    }

    /** Each row is preceded by its filter, 0 for none. */
    private static byte[] compressed(int[][] pixels) throws IOException {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      try (DeflaterOutputStream out =
          new DeflaterOutputStream(bytes, new Deflater(Deflater.BEST_COMPRESSION))) {
        for (int[] row : pixels) {
          out.write(0);
          for (int pixel : row) {
            out.write(new byte[] {(byte) (pixel >> 16), (byte) (pixel >> 8), (byte) pixel});
          }
        }
      }
      return bytes.toByteArray();
    }

    private static void chunk(DataOutputStream out, String type, byte[] data) throws IOException {
      byte[] name = type.getBytes(StandardCharsets.US_ASCII);
      CRC32 crc = new CRC32();
      crc.update(name);
      crc.update(data);
      out.writeInt(data.length);
      out.write(name);
      out.write(data);
      out.writeInt((int) crc.getValue());
    }
  }

  /**
   * A tube around the trefoil knot (2 + cos 3t)·(cos 2t, 0, sin 2t) + sin 3t · (0, 1, 0), with
   * normals and with uv that grow along the knot and around the tube.
   */
  private static final class TorusKnot {
    private static final int ALONG = 325;
    private static final int AROUND = 40;
    private static final double RADIUS = .58;

    static String obj() {
      StringBuilder out = new StringBuilder("# trefoil, " + 2 * ALONG * AROUND + " triangles\n");
      for (int i = 0; i <= ALONG; i++) {
        for (int j = 0; j <= AROUND; j++) {
          vertex(out, (double) i / ALONG, (double) j / AROUND);
        }
      }
      for (int i = 0; i < ALONG; i++) {
        for (int j = 0; j < AROUND; j++) {
          int a = i * (AROUND + 1) + j + 1;
          int b = a + AROUND + 1;
          face(out, a, b, b + 1);
          face(out, a, b + 1, a + 1);
        }
      }
      return out.toString();
    }

    /** One vertex; u along the knot and v around the tube, both in [0,1]. */
    private static void vertex(StringBuilder out, double u, double v) {
      double t = 2 * Math.PI * u;
      double angle = 2 * Math.PI * v;
      double[] here = knot(t);
      double[] tangent = unit(sum(knot(t + 1e-4), 1, knot(t - 1e-4), -1));
      // The knot lies on a torus, whose normal turns with it more evenly than the curve's own.
      double[] outward = torusNormal(t);
      double[] sideways = unit(cross(tangent, outward));
      double[] normal = sum(outward, StrictMath.cos(angle), sideways, StrictMath.sin(angle));
      line(out, "v", sum(here, 1, normal, RADIUS));
      line(out, "vt", new double[] {u, v});
      line(out, "vn", normal);
    }

    private static double[] knot(double t) {
      double ring = 2 + StrictMath.cos(3 * t);
      return new double[] {
        ring * StrictMath.cos(2 * t), StrictMath.sin(3 * t), ring * StrictMath.sin(2 * t)
      };
    }

    private static double[] torusNormal(double t) {
      double c = StrictMath.cos(3 * t);
      return new double[] {
        c * StrictMath.cos(2 * t), StrictMath.sin(3 * t), c * StrictMath.sin(2 * t)
      };
    }

    private static void line(StringBuilder out, String key, double[] numbers) {
      out.append(key);
      for (double number : numbers) {
        out.append(' ').append(Json.scalar(number));
      }
      out.append('\n');
    }

    private static void face(StringBuilder out, int... vertices) {
      out.append('f');
      for (int v : vertices) {
        out.append(' ').append(v).append('/').append(v).append('/').append(v);
      }
      out.append('\n');
    }

    private static double[] sum(double[] a, double s, double[] b, double t) {
      return new double[] {a[0] * s + b[0] * t, a[1] * s + b[1] * t, a[2] * s + b[2] * t};
    }

    private static double[] cross(double[] a, double[] b) {
      return new double[] {
        a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
      };
    }

    private static double[] unit(double[] a) {
      double length = Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
      return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }
  }
}
