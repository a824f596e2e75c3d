package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelGeometry;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Builds small glTF files. In all JSON given to it, ' stands for ". Mutable. */
public final class GltfFile {
  /** A folder without files. */
  public static final ModelFolder EMPTY =
      (name, location) -> {
        throw new ModelFormatException(Kind.ASSET, location, "no file " + name);
      };

  private final Map<String, List<String>> sections = new LinkedHashMap<>();
  private final Map<String, String> members = new LinkedHashMap<>();
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  public GltfFile() {
    members.put("asset", "{'version': '2.0'}");
  }

  /** Returns a file with one node, whose mesh is a triangle. */
  public static GltfFile ofTriangle() {
    GltfFile file = new GltfFile();
    file.add("nodes", "{'mesh': " + file.triangle("") + "}");
    return file;
  }

  /** Sets a member of the outermost object, in place of a list of that name. */
  public GltfFile set(String member, String json) {
    members.put(member, json);
    return this;
  }

  /** Adds an item to a list of the file, and returns its index. */
  public int add(String section, String json) {
    List<String> items = sections.computeIfAbsent(section, s -> new ArrayList<>());
    items.add(json);
    return items.size() - 1;
  }

  /** Adds bytes and a buffer view of them, and returns its index. */
  public int view(byte[] data, String more) {
    int offset = bytes.size();
    bytes.writeBytes(data);
    bytes.writeBytes(new byte[-data.length & 3]);
    return add(
        "bufferViews",
        "{'buffer': 0, 'byteOffset': %d, 'byteLength': %d%s}".formatted(offset, data.length, more));
  }

  /** Adds an accessor of 32-bit floats, and returns its index. */
  public int floats(String type, double... values) {
    ByteBuffer data = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (double value : values) {
      data.putFloat((float) value);
    }
    return accessor(data.array(), 5126, type, values.length, "");
  }

  /** Adds an accessor of 16-bit integers, and returns its index. */
  int shorts(int component, String type, String more, int... values) {
    ByteBuffer data = ByteBuffer.allocate(2 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int value : values) {
      data.putShort((short) value);
    }
    return accessor(data.array(), component, type, values.length, more);
  }

  /** Adds an accessor of bytes, and returns its index. */
  public int bytes(int component, String type, String more, int... values) {
    byte[] data = new byte[values.length];
    for (int i = 0; i < data.length; i++) {
      data[i] = (byte) values[i];
    }
    return accessor(data, component, type, values.length, more);
  }

  /** Adds an accessor of 32-bit integers, and returns its index. */
  public int ints(String type, int... values) {
    ByteBuffer data = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int value : values) {
      data.putInt(value);
    }
    return accessor(data.array(), 5125, type, values.length, "");
  }

  private int accessor(byte[] data, int component, String type, int numbers, String more) {
    int width = type.equals("SCALAR") ? 1 : type.equals("MAT4") ? 16 : type.charAt(3) - '0';
    return add(
        "accessors",
        "{'bufferView': %d, 'componentType': %d, 'type': '%s', 'count': %d%s}"
            .formatted(view(data, ""), component, type, numbers / width, more));
  }

  /** Adds the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) as a mesh, and returns its index. */
  public int triangle(String more) {
    return mesh("'POSITION': " + floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0), more);
  }

  /** Adds a mesh of one primitive, and returns its index. */
  public int mesh(String attributes, String more) {
    return add("meshes", "{'primitives': [{'attributes': {" + attributes + "}" + more + "}]}");
  }

  /** Adds a node with a mesh of one primitive, and returns its index. */
  int meshNode(String attributes, String more) {
    return add("nodes", "{'mesh': " + mesh(attributes, more) + "}");
  }

  private String json(Optional<String> uri) {
    Map<String, String> all = new LinkedHashMap<>();
    sections.forEach((name, items) -> all.put(name, "[" + String.join(",", items) + "]"));
    all.putAll(members);
    if (bytes.size() > 0) {
      String buffer =
          "{'byteLength': " + bytes.size() + uri.map(u -> ", 'uri': '" + u + "'").orElse("") + "}";
      all.putIfAbsent("buffers", "[" + buffer + "]");
    }
    return all.entrySet().stream()
        .map(e -> "\"" + e.getKey() + "\":" + e.getValue())
        .collect(Collectors.joining(",", "{", "}"))
        .replace('\'', '"')
        .replaceAll("\\n *|(?<=[,:]) ", "");
  }

  /** Returns a .gltf file whose buffer is a data URI. */
  public byte[] gltf() {
    String data = Base64.getEncoder().encodeToString(buffer());
    return gltf("data:application/octet-stream;base64," + data);
  }

  /** Returns a .gltf file whose buffer has a URI. */
  public byte[] gltf(String uri) {
    return json(Optional.of(uri)).getBytes(StandardCharsets.UTF_8);
  }

  /** Returns the bytes of the buffer. */
  public byte[] buffer() {
    return bytes.toByteArray();
  }

  /** Returns a .glb file. */
  public byte[] glb() {
    return glb(json(Optional.empty()).getBytes(StandardCharsets.UTF_8), buffer());
  }

  /** Returns a .glb file with two chunks. */
  public static byte[] glb(byte[] json, byte[] binary) {
    int padding = -json.length & 3;
    int length = 12 + 8 + json.length + padding + 8 + binary.length;
    ByteBuffer file = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546c67).putInt(2).putInt(length);
    file.putInt(json.length + padding).putInt(0x4e4f534a).put(json);
    file.put("   ".getBytes(StandardCharsets.US_ASCII), 0, padding);
    file.putInt(binary.length).putInt(0x004e4942).put(binary);
    return file.array();
  }

  /** Reads the file, as .glb, with default options. */
  public Model read() throws ModelFormatException, IOException {
    return read(ModelOptions.DEFAULT);
  }

  public Model read(ModelOptions options) throws ModelFormatException, IOException {
    return GltfReader.read(glb(), EMPTY, options);
  }

  /** Reads the mesh of the first part. */
  ModelGeometry geometry() throws ModelFormatException, IOException {
    return read().parts().get(0).geometry();
  }
}
