package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.format.imageio.LegacyFixture;
import io.github.lumbre.testing.Pictures;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a picture has and textures lack is a warning: a color space, further pictures. */
class PictureWarningsTest {
  private static final int AFTER_HEADER = 33;

  private static String pngWithGamma(int gamma) throws IOException {
    ByteBuffer chunk = ByteBuffer.allocate(16).putInt(4);
    chunk.put("gAMA".getBytes(StandardCharsets.US_ASCII)).putInt(gamma);
    CRC32 crc = new CRC32();
    crc.update(chunk.array(), 4, 8);
    chunk.putInt((int) crc.getValue());
    byte[] file = Pictures.png(2, 2, 0);
    ByteBuffer all = ByteBuffer.allocate(file.length + 16).put(file, 0, AFTER_HEADER);
    all.put(chunk.array()).put(file, AFTER_HEADER, file.length - AFTER_HEADER);
    return Base64.getEncoder().encodeToString(all.array());
  }

  private static List<String> warnings(String picture) throws IOException, SceneFormatException {
    String scene =
        """
        {"mainCameraId": 1,
         "assets": [
          {"id": 2, "assetType": "Texture", "base64PNG": "%s"},
          {"id": 3, "assetType": "Material", "materialType": "Diffuse", "colorTextureId": 2}],
         "objects": [
          {"id": 1, "type": "Camera", "cameraType": "Pinhole"},
          {"id": 4, "type": "Shape", "shapeType": "Sphere", "materialID": 3, "radius": 1},
          {"id": 5, "type": "Light", "lightType": "Point"}]}
        """
            .formatted(picture);
    byte[] content = scene.getBytes(StandardCharsets.UTF_8);
    return new SceneParser()
        .parse(content, Path.of("s.json")).warnings().stream().map(Object::toString).toList();
  }

  @Test
  void aGammaThatIsIgnoredIsAWarningAtTheTexture() throws IOException, SceneFormatException {
    assertThat(warnings(pngWithGamma(100000)))
        .filteredOn(warning -> warning.contains("gamma"))
        .containsExactly(
            "s.json: $.assets[0].base64PNG: the picture has a gamma of 1.0, which is ignored; its"
                + " colors are read as sRGB; convert it to sRGB");
    assertThat(warnings(pngWithGamma(45455))).noneMatch(warning -> warning.contains("gamma"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"gif", "tiff"})
  void picturesThatAreIgnoredAreAWarning(String format) throws IOException, SceneFormatException {
    assertThat(warnings(Base64.getEncoder().encodeToString(LegacyFixture.two(format))))
        .filteredOn(warning -> warning.contains("base64PNG"))
        .containsExactly(
            "s.json: $.assets[0].base64PNG: the file has several pictures; only the first one is"
                + " shown");
  }
}
