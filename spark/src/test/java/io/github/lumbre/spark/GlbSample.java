package io.github.lumbre.spark;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/**
 * A GLB file: two textured quadrilaterals, one of which moves by 1 in 1 s, in the animation {@code
 * lift}. The texture is {@code beside.png}.
 */
final class GlbSample {
  private static final float[] NUMBERS = {
    0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, .4f, // positions
    0, 1, 1, 1, 0, 0, 1, 0, // texture coordinates
    0, 1, // times
    0, 0, 0, 0, 1, 0 // translations
  };

  private static final short[] INDICES = {0, 1, 2, 2, 1, 3};

  private static final String JSON =
      """
      {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
       "nodes": [{"mesh": 0, "name": "sheet"},
        {"mesh": 0, "name": "wall", "translation": [1.5, 0, -1]}],
       "meshes": [{"primitives": [
        {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
       "materials": [{"pbrMetallicRoughness":
        {"baseColorTexture": {"index": 0}, "metallicFactor": 0}}],
       "textures": [{"source": 0}], "images": [{"uri": "beside.png"}],
       "animations": [{"name": "lift", "samplers": [{"input": 3, "output": 4}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
       "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
         "min": [0, 0, 0], "max": [1, 1, 0.4]},
        {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
        {"bufferView": 4, "componentType": 5123, "count": 6, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR",
         "min": [0], "max": [1]},
        {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC3"}],
       "bufferViews": [
        {"buffer": 0, "byteOffset": 0, "byteLength": 48},
        {"buffer": 0, "byteOffset": 48, "byteLength": 32},
        {"buffer": 0, "byteOffset": 80, "byteLength": 8},
        {"buffer": 0, "byteOffset": 88, "byteLength": 24},
        {"buffer": 0, "byteOffset": 112, "byteLength": 12}],
       "buffers": [{"byteLength": 124}]}
      """;

  private GlbSample() {}

  static byte[] bytes() {
    byte[] json = JSON.getBytes(StandardCharsets.US_ASCII);
    int padded = (json.length + 3) / 4 * 4;
    int binary = Float.BYTES * NUMBERS.length + Short.BYTES * INDICES.length;
    ByteBuffer file = ByteBuffer.allocate(28 + padded + binary).order(ByteOrder.LITTLE_ENDIAN);
    file.put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(2).putInt(file.capacity());
    file.putInt(padded).put("JSON".getBytes(StandardCharsets.US_ASCII)).put(json);
    while (file.position() < 20 + padded) {
      file.put((byte) ' ');
    }
    file.putInt(binary).put("BIN\0".getBytes(StandardCharsets.US_ASCII));
    for (float number : NUMBERS) {
      file.putFloat(number);
    }
    for (short index : INDICES) {
      file.putShort(index);
    }
    return file.array();
  }

  /** Writes a file with the bytes, and the texture beside it. */
  static void write(Path glb) throws IOException {
    BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, 2, 2, new int[] {0xe04020, 0x20a040, 0x2040e0, 0xe0e0e0}, 0, 2);
    ImageIO.write(image, "png", glb.resolveSibling("beside.png").toFile());
    Files.write(glb, bytes());
  }
}
