package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageReader;
import io.github.lumbre.image.format.ktx.KtxSamples;
import io.github.lumbre.image.format.webp.WebpSamples;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** KTX 2 and WebP files are pictures wherever PNG files are, with the same result. */
class TextureFormatsTest extends CommandFixture {
  private static final String OBJ =
      "mtllib %s.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
          + "f 1/1 2/2 3/3\n";
  private static final String SCENE =
      """
      {"mainCameraId": 7,
       "assets": [{"assetType": "Texture", "id": 1, "file": "%s"}],
       "objects": [{"type": "Camera", "id": 7, "cameraType": "Pinhole"},
                   {"type": "Light", "lightType": "Dome", "intensity": 1, "textureId": 1}]}
      """;
  private static final String GLTF =
      """
      {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
       "meshes": [{"primitives":
         [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
       "materials": [{"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}],
       "images": [{"uri": "%s"}], "textures": [{%s}],
       "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                     {"bufferView": 0, "componentType": 5126, "type": "VEC2", "count": 3}],
       "bufferViews": [{"buffer": 0, "byteLength": 36}],
       "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,%s"}]}
      """;
  private static final String CORNERS = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

  private byte[] rendered(String name) throws IOException {
    String picture = name + ".out.png";
    String flags = " -s 4 --size 24x18 --quiet --no-denoise -o T/";
    assertThat(said("render T/" + name + flags + picture)).isEmpty();
    return ImageReader.decode(bytes(picture)).toPng();
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(directory.resolve(name), text, StandardCharsets.US_ASCII);
  }

  static Stream<Arguments> pictures() {
    return Stream.of(
        Arguments.of("KHR_texture_basisu", KtxSamples.file("ETC1S")),
        Arguments.of("KHR_texture_basisu", KtxSamples.file("UASTC with Zstandard")),
        Arguments.of("EXT_texture_webp", WebpSamples.file("lossy")),
        Arguments.of("EXT_texture_webp", WebpSamples.file("lossless-opaque")));
  }

  @ParameterizedTest
  @MethodSource("pictures")
  void picturesAreThoseOfPng(String extension, byte[] encoded) throws IOException {
    Files.write(directory.resolve("a.picture"), encoded);
    Files.write(directory.resolve("b.png"), ImageReader.decode(encoded).toPng());
    for (String name : new String[] {"a.picture", "b.png"}) {
      String stem = name.substring(0, 1);
      write(stem + ".obj", OBJ.formatted(stem));
      write(stem + ".mtl", "newmtl m\nKd 1 1 1\nmap_Kd " + name + "\n");
      write(stem + ".json", SCENE.formatted(name));
    }
    String source = "\"extensions\": {\"" + extension + "\": {\"source\": 0}}";
    write("a.gltf", GLTF.formatted("a.picture", source, CORNERS));
    write("b.gltf", GLTF.formatted("b.png", "\"source\": 0", CORNERS));
    for (String ending : new String[] {".obj", ".json", ".gltf"}) {
      assertThat(rendered("a" + ending)).as(ending).isEqualTo(rendered("b" + ending));
    }
  }
}
