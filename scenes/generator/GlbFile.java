package generator;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A binary glTF 2.0 file of one scene: a node for each part; some nodes turn about axes. Mutable
 * while it is built.
 */
final class GlbFile {
  private static final int MAGIC = 0x46546C67;
  private static final int JSON = 0x4E4F534A;
  private static final int BIN = 0x004E4942;
  private static final int FLOAT = 5126;
  private static final int UNSIGNED_SHORT = 5123;

  private final ByteArrayOutputStream data = new ByteArrayOutputStream();
  private final List<Object> views = new ArrayList<>();
  private final List<Object> accessors = new ArrayList<>();
  private final List<Object> meshes = new ArrayList<>();
  private final List<Map<String, Object>> nodes = new ArrayList<>();
  private final List<Object> roots = new ArrayList<>();
  private final List<Object> channels = new ArrayList<>();
  private final List<Object> samplers = new ArrayList<>();
  private final List<Object> materials = new ArrayList<>();
  private final List<Object> images = new ArrayList<>();
  private final List<Object> textures = new ArrayList<>();
  private final Map<String, Object> extensions = new LinkedHashMap<>();

  /** The surface of one part, with every corner written once. */
  static final class Part implements Triangles<Integer> {
    private final Map<List<Float>, Integer> corners = new LinkedHashMap<>();
    private final List<Integer> faces = new ArrayList<>();

    @Override
    public Integer corner(Vec p, double u, double v, Vec n) {
      List<Float> numbers = new ArrayList<>();
      for (double number : new double[] {p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), u, v}) {
        numbers.add((float) number + 0f);
      }
      corners.putIfAbsent(numbers, corners.size());
      return corners.get(numbers);
    }

    @Override
    public void face(Integer a, Integer b, Integer c) {
      faces.addAll(List.of(a, b, c));
    }

    boolean isEmpty() {
      return faces.isEmpty();
    }

    /** Replaces the texture coordinates by x and z, scaled. */
    Part fromAbove(double scale) {
      Part result = new Part();
      List<Integer> moved = new ArrayList<>();
      corners.forEach(
          (k, i) ->
              moved.add(
                  result.corner(
                      new Vec(k.get(0), k.get(1), k.get(2)),
                      k.get(0) * scale + .5,
                      k.get(2) * scale + .5,
                      new Vec(k.get(3), k.get(4), k.get(5)))));
      faces.forEach(i -> result.faces.add(moved.get(i)));
      return result;
    }
  }

  /** Returns the index of a texture, for {@code baseColorTexture}. */
  int texture(Raster raster) throws IOException {
    images.add(map("bufferView", view(Png.bytes(raster)), "mimeType", "image/png"));
    textures.add(map("source", images.size() - 1));
    return textures.size() - 1;
  }

  /** Returns the index of a material with the keys of glTF; its extensions are listed. */
  int material(String name, Map<String, Object> material) {
    material.put("name", name);
    if (material.get("extensions") instanceof Map<?, ?> used) {
      used.keySet().forEach(key -> extensions.put((String) key, key));
    }
    materials.add(material);
    return materials.size() - 1;
  }

  /** Adds a part that stands still, with a material of its own. */
  void add(String name, Part part, Map<String, Object> material) {
    add(name, part, material(name, material));
  }

  /** Adds a part that stands still. */
  void add(String name, Part part, int material) {
    roots.add(node(name, part, material));
  }

  /**
   * Adds parts that turn about an upright axis, around which they lie in the scene's space: at rest
   * the two translations cancel exactly.
   *
   * @param parts by the index of their material
   * @param times in seconds
   * @param turns at these times, from x to z
   */
  void addTurning(String name, Vec axis, Map<Integer, Part> parts, float[] times, double[] turns) {
    List<Object> inner = new ArrayList<>();
    parts.forEach(
        (material, part) ->
            inner.add(
                node(
                    name + " " + ((Map<?, ?>) materials.get(material)).get("name"),
                    part,
                    material)));
    int back = node(map("translation", numbers(axis.times(-1)), "children", inner));
    int turning = node(map("name", name, "children", List.of(back)));
    roots.add(node(map("translation", numbers(axis), "children", List.of(turning))));
    float[] quaternions = new float[4 * times.length];
    for (int i = 0; i < times.length; i++) {
      quaternions[4 * i + 1] = (float) -StrictMath.sin(Math.PI * turns[i]);
      quaternions[4 * i + 3] = (float) StrictMath.cos(Math.PI * turns[i]);
    }
    samplers.add(
        map("input", bounded(times, accessor(times, 1), 1), "output", accessor(quaternions, 4)));
    channels.add(
        map("sampler", samplers.size() - 1, "target", map("node", turning, "path", "rotation")));
  }

  private int node(Map<String, Object> node) {
    nodes.add(node);
    return nodes.size() - 1;
  }

  private static List<Object> numbers(Vec v) {
    return List.of(v.x(), v.y(), v.z());
  }

  private int node(String name, Part part, int material) {
    int count = part.corners.size();
    float[][] columns = new float[3][];
    int[] firsts = {0, 3, 6};
    int[] sizes = {3, 3, 2};
    for (int c = 0; c < 3; c++) {
      columns[c] = new float[count * sizes[c]];
      int i = 0;
      for (List<Float> numbers : part.corners.keySet()) {
        for (int k = 0; k < sizes[c]; k++) {
          columns[c][i++] = numbers.get(firsts[c] + k);
        }
      }
    }
    Map<String, Object> attributes =
        map(
            "POSITION", bounded(columns[0], accessor(columns[0], 3), 3),
            "NORMAL", accessor(columns[1], 3),
            "TEXCOORD_0", accessor(columns[2], 2));
    Map<String, Object> primitive =
        map("attributes", attributes, "indices", indices(part.faces), "material", material);
    meshes.add(map("name", name, "primitives", List.of(primitive)));
    return node(map("name", name, "mesh", meshes.size() - 1));
  }

  private int accessor(float[] numbers, int size) {
    ByteBuffer bytes = ByteBuffer.allocate(4 * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
    for (float number : numbers) {
      bytes.putFloat(number);
    }
    int view = view(bytes.array());
    int count = numbers.length / size;
    accessors.add(
        map(
            "bufferView",
            view,
            "componentType",
            FLOAT,
            "type",
            size == 1 ? "SCALAR" : "VEC" + size,
            "count",
            count));
    return accessors.size() - 1;
  }

  /** Positions and times must state their bounds. */
  private int bounded(float[] values, int accessor, int size) {
    List<Object> min = new ArrayList<>();
    List<Object> max = new ArrayList<>();
    for (int axis = 0; axis < size; axis++) {
      float least = Float.POSITIVE_INFINITY;
      float most = Float.NEGATIVE_INFINITY;
      for (int i = axis; i < values.length; i += size) {
        least = Math.min(least, values[i]);
        most = Math.max(most, values[i]);
      }
      min.add(new Exact(least));
      max.add(new Exact(most));
    }
    @SuppressWarnings("unchecked")
    Map<String, Object> map = (Map<String, Object>) accessors.get(accessor);
    map.put("min", min);
    map.put("max", max);
    return accessor;
  }

  /** A number that is written with all its digits. */
  private record Exact(float value) {
    @Override
    public String toString() {
      return Float.toString(value);
    }
  }

  private int indices(List<Integer> faces) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * faces.size()).order(ByteOrder.LITTLE_ENDIAN);
    faces.forEach(index -> bytes.putShort(index.shortValue()));
    int view = view(bytes.array());
    accessors.add(
        map(
            "bufferView",
            view,
            "componentType",
            UNSIGNED_SHORT,
            "type",
            "SCALAR",
            "count",
            faces.size()));
    return accessors.size() - 1;
  }

  private int view(byte[] bytes) {
    views.add(map("buffer", 0, "byteOffset", data.size(), "byteLength", bytes.length));
    data.writeBytes(bytes);
    data.writeBytes(new byte[-bytes.length & 3]);
    return views.size() - 1;
  }

  void write(Path file, String title) throws IOException {
    Map<String, Object> root =
        map("asset", map("version", "2.0", "generator", "Lumbre", "title", title));
    root.put("extensionsUsed", List.copyOf(extensions.keySet()));
    root.put("scene", 0);
    root.put("scenes", List.of(map("nodes", roots)));
    root.put("nodes", nodes);
    if (!channels.isEmpty()) {
      root.put(
          "animations", List.of(map("name", "run", "channels", channels, "samplers", samplers)));
    }
    root.put("meshes", meshes);
    root.put("materials", materials);
    root.put("textures", textures);
    root.put("images", images);
    root.put("accessors", accessors);
    root.put("bufferViews", views);
    root.put("buffers", List.of(map("byteLength", data.size())));
    byte[] json = Json.write(root).getBytes(StandardCharsets.UTF_8);
    int padding = -json.length & 3;
    ByteBuffer out =
        ByteBuffer.allocate(28 + json.length + padding + data.size())
            .order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(MAGIC).putInt(2).putInt(out.capacity());
    out.putInt(json.length + padding).putInt(JSON).put(json).put("   ".getBytes(), 0, padding);
    out.putInt(data.size()).putInt(BIN).put(data.toByteArray());
    Files.write(file, out.array());
  }

  /** Returns a map that keeps the order of its keys. */
  static Map<String, Object> map(Object... keysAndValues) {
    Map<String, Object> map = new LinkedHashMap<>();
    for (int i = 0; i < keysAndValues.length; i += 2) {
      map.put((String) keysAndValues[i], keysAndValues[i + 1]);
    }
    return map;
  }
}
