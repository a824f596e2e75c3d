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

  /** A path traced scene with so many samples per pixel. */
  Scene(String name, int width, int height, int samples) {
    this(name, "path", width, height);
    set("samples", samples);
  }

  private Scene(String name, String mode, int width, int height) {
    this.name = name;
    set("mode", mode).set("width", width).set("height", height);
  }

  /** A ray traced scene; 2 to the power of its antialiasing is the samples per pixel. */
  static Scene rayTraced(String name, int width, int height, int antialiasing) {
    return new Scene(name, "ray", width, height).set("antialiasing", antialiasing);
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

  /** A dielectric coat of microfacets over a Lambertian ground. */
  int glossy(String name, double[] colour, double[] specular, double roughness) {
    return material(
        name,
        "CookTorrance",
        "color",
        colour,
        "specularColor",
        specular,
        "roughness",
        roughness);
  }

  int mesh(String name, String file) {
    return asset("Mesh", name, "file", file);
  }

  /** A texture of an image or, of another type, computed. */
  int texture(String name, String type, Object... keys) {
    Object[] all = new Object[keys.length + 2];
    all[0] = "textureType";
    all[1] = type;
    System.arraycopy(keys, 0, all, 2, keys.length);
    return asset("Texture", name, all);
  }

  int material(String name, String type, Object... channels) {
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

  /** Soft boxes all around. */
  Node studio(String name, double intensity) {
    return new Node("Light", name, "lightType", "Dome", "sky", "studio", "intensity", intensity);
  }

  /** A model with materials of its own. */
  Node model(String name, String file) {
    return new Node("Model", name, "file", file);
  }

  Node dome(String name, int texture, double intensity) {
    return new Node("Light", name, "lightType", "Dome")
        .with("textureId", texture, "intensity", intensity);
  }

  /** A light without extent, of the given irradiance at every distance. */
  Node point(String name, double[] irradiance) {
    return shining(new Node("Light", name, "lightType", "Point"), irradiance);
  }

  private static Node light(String type, String name, double[] radiance) {
    Node light = new Node("Light", name, "lightType", type).with("unit", "radiance");
    return shining(light, radiance);
  }

  /** The largest component becomes the intensity, the rest the colour. */
  private static Node shining(Node light, double[] rgb) {
    double intensity = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
    double[] colour = rgb.clone();
    for (int i = 0; i < 3; i++) {
      colour[i] /= intensity;
    }
    return light.with("intensity", intensity, "color", colour);
  }
}
