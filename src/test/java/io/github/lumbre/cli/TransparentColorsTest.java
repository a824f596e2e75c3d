package io.github.lumbre.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.testing.Pictures;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Models whose PNG textures have transparent colors look as those with an alpha channel. */
class TransparentColorsTest extends CommandFixture {
  private static final String RGBA = "rgba_MASK.glb";

  private static byte[] read(String name) throws IOException {
    return Files.readAllBytes(Path.of("src/test/resources/cases", name));
  }

  /** Returns the pixels of a model before a transparent background. */
  private int[] pixels(String name, byte[] model) throws IOException {
    Files.write(directory.resolve(name), model);
    String flags = " --overwrite --quiet --view front -s 4 --size 32x32";
    runs("render T/" + name + " -o T/x.png --sky white --background transparent" + flags);
    return pixels("x.png");
  }

  private static double meanAlpha(int... pixels) {
    return Arrays.stream(pixels).map(p -> p >>> 24).average().orElseThrow() / 255;
  }

  /** Returns a GLB file with another alpha mode. */
  private static byte[] with(String mode, byte[] glb) {
    int end = 20 + ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
    String json = new String(glb, 20, end - 20, StandardCharsets.UTF_8).strip();
    byte[] text = json.replace("\"MASK\"", '"' + mode + '"').getBytes(StandardCharsets.UTF_8);
    int padded = text.length + 3 & ~3;
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteBuffer header = ByteBuffer.allocate(20).order(ByteOrder.LITTLE_ENDIAN).put(glb, 0, 8);
    header.putInt(20 + padded + glb.length - end).putInt(padded).put(glb, 16, 4);
    out.writeBytes(header.array());
    out.writeBytes(text);
    out.writeBytes(" ".repeat(padded - text.length).getBytes(StandardCharsets.US_ASCII));
    out.write(glb, end, glb.length - end);
    return out.toByteArray();
  }

  @ParameterizedTest
  @CsvSource({"pal8_trns_MASK.glb, MASK", "rgb_trns_MASK.glb, MASK", "rgb_trns_MASK.glb, BLEND"})
  void gltfShowsThem(String name, String mode) throws IOException {
    int[] expected = pixels("b.glb", with(mode, read(RGBA)));
    assertThat(meanAlpha(expected)).isBetween(.6, .67);
    assertThat(pixels("a.glb", with(mode, read(name)))).isEqualTo(expected);
  }

  /** Returns the picture in a GLB file. */
  private static byte[] stored(String name) throws IOException {
    String glb = new String(read(name), StandardCharsets.ISO_8859_1);
    int end = glb.indexOf("IEND") + 8;
    return glb.substring(glb.indexOf("\u0089PNG"), end).getBytes(StandardCharsets.ISO_8859_1);
  }

  /** Returns a PNG file with an alpha channel, as the JDK's decoder reads and writes it. */
  private static byte[] withChannel(byte[] png) throws IOException {
    BufferedImage in = ImageIO.read(new ByteArrayInputStream(png));
    BufferedImage rgba =
        new BufferedImage(in.getWidth(), in.getHeight(), BufferedImage.TYPE_INT_ARGB);
    int width = in.getWidth();
    rgba.setRGB(0, 0, width, in.getHeight(), Pictures.pixels(in), 0, width);
    return Pictures.file(rgba, "png");
  }

  private int[] objPixels(byte[] picture) throws IOException {
    Files.write(directory.resolve("t.png"), picture);
    String mtl = "newmtl m\nKd 1 1 1\nmap_Kd t.png\nmap_d t.png\n";
    Files.writeString(directory.resolve("a.mtl"), mtl);
    String obj =
        "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
            + "vt 0 1\nf 1/1 2/2 3/3 4/4\n";
    return pixels("a.obj", obj.getBytes(StandardCharsets.US_ASCII));
  }

  @ParameterizedTest
  @ValueSource(strings = {"pal8_trns_MASK.glb", "rgb_trns_MASK.glb"})
  void objShowsThem(String name) throws IOException {
    int[] expected = objPixels(withChannel(stored(name)));
    assertThat(meanAlpha(expected)).isBetween(.5, .67);
    assertThat(objPixels(stored(name))).isEqualTo(expected);
  }
}
