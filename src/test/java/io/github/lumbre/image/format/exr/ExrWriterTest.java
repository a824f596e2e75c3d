package io.github.lumbre.image.format.exr;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFixture;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.DataFormatException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests written OpenEXR files with an independent reader. */
class ExrWriterTest {
  @TempDir Path directory;

  private byte[] exr(Image image, Map<String, String> metadata) throws IOException {
    return ImageFixture.written(
        image,
        directory.resolve("a.exr"),
        new ImageWriter.Options(Exposure.of(3), ToneCurve.ACES, 8, metadata));
  }

  private ExrFixture read(Image image) throws IOException, DataFormatException {
    return ExrFixture.read(exr(image, Map.of()));
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "3, 16", "5, 17", "100, 100", "65500, 1", "1, 65500"})
  void everyBitSurvives(int width, int height) throws IOException, DataFormatException {
    Image image = ImageFixture.random(width, height, false);
    ExrFixture file = read(image);
    assertThat(file.width()).isEqualTo(width);
    assertThat(file.height()).isEqualTo(height);
    assertThat(file.channels().keySet()).containsExactly("B", "G", "R");
    assertThat(component(file, "R")).isEqualTo(component(image, 0));
    assertThat(component(file, "G")).isEqualTo(component(image, 1));
    assertThat(component(file, "B")).isEqualTo(component(image, 2));
  }

  private static float[] component(ExrFixture file, String name) {
    return file.channels().get(name);
  }

  private static float[] component(Image image, int component) {
    float[] values = new float[image.rgb().length / 3];
    for (int i = 0; i < values.length; i++) {
      values[i] = image.rgb()[3 * i + component];
    }
    return values;
  }

  @Test
  void evenSurfacesAreCompressed() throws IOException {
    assertThat(exr(Image.black(500, 500), Map.of())).hasSizeLessThan(20_000);
  }

  @Test
  void colorsAreMultipliedByAlphaAboveZero() throws IOException, DataFormatException {
    float[] rgb = {1, 2, 3, 1, 2, 3, 1, 2, 3};
    ExrFixture file = read(new Image(3, 1, rgb, new float[] {0, .5f, 1}));
    assertThat(file.channels().keySet()).containsExactly("A", "B", "G", "R");
    assertThat(component(file, "A")).containsExactly(0, .5f, 1);
    assertThat(component(file, "R")).containsExactly(1, .5f, 1);
    assertThat(component(file, "G")).containsExactly(2, 1, 2);
    assertThat(component(file, "B")).containsExactly(3, 1.5f, 3);
  }

  @Test
  void everyValueIsFinite() throws IOException, DataFormatException {
    float[] rgb = {
      Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NaN, Float.MAX_VALUE, 1e-45f, -0f
    };
    ExrFixture file = read(new Image(2, 1, rgb, new float[0]));
    assertThat(component(file, "R")).containsExactly(Float.MAX_VALUE, Float.MAX_VALUE);
    assertThat(component(file, "G")).containsExactly(-Float.MAX_VALUE, 1e-45f);
    assertThat(component(file, "B")).containsExactly(0f, -0f);
  }

  @Test
  void metadataAreTextAttributesInOrder() throws IOException, DataFormatException {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("Software", "Lumbre");
    metadata.put("Scene", "火の粉.json");
    metadata.put("Empty", "");
    ExrFixture file = ExrFixture.read(exr(Image.black(1, 1), metadata));
    assertThat(file.attributes().keySet()).containsSequence("Software", "Scene", "Empty");
    metadata.forEach(
        (keyword, text) -> {
          assertThat(file.types()).containsEntry(keyword, "string");
          assertThat(file.string(keyword)).isEqualTo(text);
        });
    assertThat(file.version()).isEqualTo(2);
  }

  @Test
  void longNamesAreAnnounced() throws IOException, DataFormatException {
    ExrFixture file = ExrFixture.read(exr(Image.black(1, 1), Map.of("k".repeat(32), "v")));
    assertThat(file.version()).isEqualTo(0x402);
  }

  @Test
  void theAttributesThatTheFormatDemandsAreThere() throws IOException, DataFormatException {
    assertThat(read(Image.black(1, 1)).types())
        .containsOnly(
            Map.entry("channels", "chlist"),
            Map.entry("compression", "compression"),
            Map.entry("dataWindow", "box2i"),
            Map.entry("displayWindow", "box2i"),
            Map.entry("lineOrder", "lineOrder"),
            Map.entry("pixelAspectRatio", "float"),
            Map.entry("screenWindowCenter", "v2f"),
            Map.entry("screenWindowWidth", "float"));
  }

  @Test
  void metadataCannotBearTheNamesOfTheFormat() throws IOException, DataFormatException {
    assertThat(ExrWriter.RESERVED)
        .containsAll(read(Image.black(1, 1)).attributes().keySet())
        .contains("type", "tiles", "version", "chunkCount");
  }

  @Test
  void namesOfUpTo31LettersAreShort() throws IOException, DataFormatException {
    ExrFixture file = ExrFixture.read(exr(Image.black(1, 1), Map.of("k".repeat(31), "v")));
    assertThat(file.version()).isEqualTo(2);
  }
}
