package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.cli.output.ExitCodes;
import io.github.lumbre.image.Pixels;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A picture that cannot be decoded is left out of a model, with a warning that names it. */
class UnreadableTexturesTest {
  @TempDir private Path folder;

  private static byte[] bytes(String start) {
    return Arrays.copyOf(start.getBytes(StandardCharsets.ISO_8859_1), 64);
  }

  private static byte[] png() {
    return Pixels.of(2, 1, 3, new byte[] {0, 0, 0, 1, 1, 1}).toPng();
  }

  static Stream<Arguments> pictures() {
    byte[] damaged = png();
    damaged[45] ^= 1;
    return Stream.of(
        Arguments.of("WebP has no VP8 key frame", bytes("RIFF\0\0\0\0WEBPVP8 ")),
        Arguments.of("a KTX picture", bytes("\u00abKTX 20\u00bb\r\n\u001a\n")),
        Arguments.of("a Basis Universal picture", bytes("sB\u0013\0")),
        Arguments.of("GIF is damaged", bytes("GIF89a")),
        Arguments.of("BMP has a header of 0 bytes", bytes("BM1234\0\0\0\0")),
        Arguments.of("TIFF is truncated", bytes("II*\0")),
        Arguments.of("DDS is truncated", bytes("DDS |")),
        Arguments.of("an AVIF picture", bytes("\0\0\0 ftypavif")),
        Arguments.of("an OpenEXR picture", bytes("v/1\u0001\u0002\0\0\0")),
        Arguments.of("an HTML page", bytes("<!DOCTYPE html><html>")),
        Arguments.of("a Git LFS pointer instead of the file", bytes("version https://git-lfs.")),
        Arguments.of("an empty file", new byte[0]),
        Arguments.of("none of them", new byte[] {0, 0, 2, 0, 0}),
        Arguments.of("PNG is damaged", damaged),
        Arguments.of("PNG is truncated", Arrays.copyOf(png(), 40)));
  }

  /** Returns a quad with a material, whose texture is the picture. */
  private static String gltf(byte[] picture, String material) {
    String data = "data:image/png;base64," + Base64.getEncoder().encodeToString(picture);
    return """
    {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
     "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
     "materials": [%s], "textures": [{"source": 0}], "images": [{"uri": "%s"}],
     "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
     "bufferViews": [{"buffer": 0, "byteLength": 36}],
     "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,%s"}]}
    """
        .formatted(material, data, "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA");
  }

  private static final String TEXTURES =
      """
      {"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 0.8], "metallicFactor": 0.5,
        "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0}},
       "emissiveFactor": [0.1, 0, 0], "emissiveTexture": {"index": 0}, "alphaMode": "BLEND",
       "normalTexture": {"index": 0}, "doubleSided": true}
      """;

  private Path write(String name, byte[] content) throws IOException {
    return Files.write(folder.resolve(name), content);
  }

  private Outcome render(Path model, String... more) {
    String[] command = {"render", model.toString(), "-s", "4", "--size", "16x12"};
    return Outcome.of(
        Stream.of(command, new String[] {"--quiet", "-o", model + ".png", "--overwrite"}, more)
            .flatMap(Arrays::stream)
            .toArray(String[]::new));
  }

  private static int[] pixels(Path model) throws IOException {
    BufferedImage picture = ImageIO.read(new File(model + ".png"));
    return picture.getRGB(0, 0, 16, 12, null, 0, 16);
  }

  private void isLeftOut(Path model, Path plain, String found) throws IOException {
    assertThat(render(plain).exitCode()).isEqualTo(ExitCodes.OK);
    Outcome outcome = render(model);
    assertThat(outcome.exitCode()).as(outcome.err()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err()).contains(found).contains("; the picture is left out");
    assertThat(outcome.err().lines()).hasSize(1);
    assertThat(pixels(model)).isEqualTo(pixels(plain));
    assertThat(render(model, "--strict").exitCode()).isEqualTo(ExitCodes.WARNINGS);
    assertThat(render(model, "--lenient").exitCode()).isEqualTo(ExitCodes.OK);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("pictures")
  void gltfLeavesItOut(String found, byte[] picture) throws IOException {
    // Without its texture, a surface emits nothing.
    String plain =
        TEXTURES
            .replaceAll("\"[A-Za-z]*Texture\": \\{\"index\": 0\\},?", "")
            .replace("[0.1, 0, 0]", "[0, 0, 0]")
            .replaceAll(",\\s*\\}", "}");
    isLeftOut(
        write("a.gltf", gltf(picture, TEXTURES).getBytes(StandardCharsets.US_ASCII)),
        write("b.gltf", gltf(picture, plain).getBytes(StandardCharsets.US_ASCII)),
        found);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("pictures")
  void objLeavesItOut(String found, byte[] picture) throws IOException {
    write("x.png", picture);
    String mtl = "newmtl m\nKd .5 .6 .7\nd .9\nKs .1 .1 .1\nNs 9\n";
    String maps =
        "map_Kd x.png\nmap_Ks x.png\nmap_d x.png\nmap_Bump x.png\nKe 1 0 0\nmap_Ke x.png\n";
    write("a.mtl", (mtl + maps).getBytes(StandardCharsets.US_ASCII));
    write("b.mtl", mtl.getBytes(StandardCharsets.US_ASCII));
    String obj = "mtllib %s\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    isLeftOut(
        write("a.obj", obj.formatted("a.mtl").getBytes(StandardCharsets.US_ASCII)),
        write("b.obj", obj.formatted("b.mtl").getBytes(StandardCharsets.US_ASCII)),
        found);
  }

  @Test
  void texturesOfOtherFormatsAreNamed() throws IOException {
    String model =
        gltf(png(), TEXTURES)
            .replace("{\"source\": 0}", "{\"extensions\": {\"EXT_texture_avif\": {}}}");
    Outcome outcome = render(write("a.gltf", model.getBytes(StandardCharsets.US_ASCII)));
    assertThat(outcome.exitCode()).isEqualTo(ExitCodes.OK);
    assertThat(outcome.err())
        .contains("expected a picture, found EXT_texture_avif; the texture is left out");
  }
}
