package io.github.lumbre.cli;

import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes a small .glb: a textured tetrahedron with cameras, an animation and a variant. */
public final class ModelSample {
  private static final String JSON =
      """
      {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
       "extensionsUsed": ["KHR_materials_variants"],
       "extensions": {"KHR_materials_variants": {"variants": [{"name": "red"}, {"name": "blue"}]}},
       "nodes": [{"name": "body", "mesh": 0, "translation": [5, 1, -2]},
         {"camera": 0, "translation": [5, 1.3, 4]}, {"camera": 1, "translation": [5, 1.3, 9]}],
       "cameras": [
         {"name": "close", "type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}},
         {"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1}}],
       "meshes": [{"name": "shell", "primitives": [
         {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0,
          "extensions": {"KHR_materials_variants":
            {"mappings": [{"material": 1, "variants": [0]}]}}}]}],
       "materials": [
         {"name": "paint", "doubleSided": true, "pbrMetallicRoughness":
           {"metallicFactor": 0, "baseColorTexture": {"index": 0}}},
         {"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
       "textures": [{"source": 0}], "images": [{"uri": "paint.png"}],
       "animations": [{"name": "lift", "channels":
          [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
         "samplers": [{"input": 3, "output": 4}]}],
       "accessors": [
         {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4,
          "min": [0, 0, 0], "max": [1, 1, 1]},
         {"bufferView": 1, "componentType": 5126, "type": "VEC2", "count": 4},
         {"bufferView": 2, "componentType": 5123, "type": "SCALAR", "count": 12},
         {"bufferView": 3, "componentType": 5126, "type": "SCALAR", "count": 2,
          "min": [0], "max": [1]},
         {"bufferView": 4, "componentType": 5126, "type": "VEC3", "count": 2}],
       "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
         {"buffer": 0, "byteOffset": 48, "byteLength": 32},
         {"buffer": 0, "byteOffset": 80, "byteLength": 24},
         {"buffer": 0, "byteOffset": 104, "byteLength": 8},
         {"buffer": 0, "byteOffset": 112, "byteLength": 24}],
       "buffers": [{"byteLength": 136}]}
      """;

  private ModelSample() {}

  /** Writes the model and its texture, paint.png, into a folder, and returns the model's path. */
  public static Path write(Path folder) throws IOException {
    return write(folder, JSON);
  }

  /** As {@link #write(Path)}, with one text of the model replaced. */
  static Path writeWith(Path folder, String old, String replacement) throws IOException {
    return write(folder, JSON.replace(old, replacement));
  }

  private static Path write(Path folder, String json) throws IOException {
    byte[] paint = Pictures.png(2, 2, 0xc0a080, 0x80c0a0, 0xa080c0, 0xc0c0c0);
    Files.write(folder.resolve("paint.png"), paint);
    return Files.write(folder.resolve("sample.glb"), glb(json));
  }

  private static byte[] glb(String text) {
    byte[] json = (text + " ".repeat(-text.length() & 3)).getBytes(StandardCharsets.UTF_8);
    ByteBuffer file =
        ByteBuffer.allocate(20 + json.length + 8 + 136).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546c67).putInt(2).putInt(file.capacity());
    file.putInt(json.length).putInt(0x4e4f534a).put(json);
    file.putInt(136).putInt(0x004e4942);
    for (int v : new int[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 1}) {
      file.putFloat(v);
    }
    for (int i : new int[] {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}) {
      file.putShort((short) i);
    }
    for (int v : new int[] {0, 1, 5, 1, -2, 5, 3, -2}) {
      file.putFloat(v);
    }
    return file.array();
  }
}
