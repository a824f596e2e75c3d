package generator;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A scene being written. Methods named after things make them; {@link #add} places them. */
final class Scene {
  final String name;
  private final Map<String, Object> options = new LinkedHashMap<>();
  private final List<Object> assets = new ArrayList<>();
  private final List<Object> objects = new ArrayList<>();

  Scene(String name, int width, int height, int samples) {
    this.name = name;
    set("mode", "path").set("width", width).set("height", height).set("samples", samples);
  }

  static double[] rgb(double r, double g, double b) {
    return new double[] {r, g, b};
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
