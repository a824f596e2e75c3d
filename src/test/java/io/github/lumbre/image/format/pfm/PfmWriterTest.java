package io.github.lumbre.image.format.pfm;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFixture;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests written portable float maps. */
class PfmWriterTest {
  private static final ImageWriter.Options OPTIONS =
      new ImageWriter.Options(Exposure.of(3), ToneCurve.ACES, 8, Map.of("Seed", "1"));

  @TempDir Path directory;

  private ByteBuffer body(Image image) throws IOException {
    byte[] file = ImageFixture.written(image, directory.resolve("a.pfm"), OPTIONS);
    String header = "PF\n" + image.width() + " " + image.height() + "\n-1.0\n";
    assertThat(new String(file, 0, header.length(), StandardCharsets.US_ASCII)).isEqualTo(header);
    assertThat(file).hasSize(header.length() + 12 * image.width() * image.height());
    return ByteBuffer.wrap(file, header.length(), file.length - header.length())
        .order(ByteOrder.LITTLE_ENDIAN);
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "5, 3", "65500, 1", "1, 65500"})
  void everyBitSurvivesAndTheBottomRowComesFirst(int width, int height) throws IOException {
    Image image = ImageFixture.random(width, height, false);
    ByteBuffer body = body(image);
    for (int y = height - 1; y >= 0; y--) {
      for (int i = 0; i < 3 * width; i++) {
        assertThat(body.getFloat()).isEqualTo(image.rgb()[3 * y * width + i]);
      }
    }
  }

  @Test
  void everyValueIsFinite() throws IOException {
    float[] rgb = {Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NaN};
    ByteBuffer body = body(new Image(1, 1, rgb, new float[0]));
    assertThat(body.getFloat()).isEqualTo(Float.MAX_VALUE);
    assertThat(body.getFloat()).isEqualTo(-Float.MAX_VALUE);
    assertThat(body.getFloat()).isZero();
  }

  @Test
  void alphaIsLeftOut() throws IOException {
    assertThat(body(new Image(1, 1, new float[] {1, 2, 3}, new float[] {0})).getFloat())
        .isEqualTo(1);
  }
}
