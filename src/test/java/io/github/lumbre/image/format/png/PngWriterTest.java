package io.github.lumbre.image.format.png;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Exposure;
import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageWriter;
import io.github.lumbre.image.Rgb;
import io.github.lumbre.image.ToneCurve;
import io.github.lumbre.image.internal.ImageFixture;
import io.github.lumbre.image.internal.Srgb;
import java.awt.GraphicsEnvironment;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests written PNG files and their text chunks. */
class PngWriterTest {
  @TempDir Path directory;

  private byte[] png(Image image, ImageWriter.Options options) throws IOException {
    return ImageFixture.written(image, directory.resolve("a.png"), options);
  }

  private Raster raster(Image image, ImageWriter.Options options) throws IOException {
    return ImageIO.read(new ByteArrayInputStream(png(image, options))).getRaster();
  }

  /** Returns the data of each chunk of a type. */
  private static List<byte[]> chunks(byte[] png, String type) {
    List<byte[]> found = new ArrayList<>();
    ByteBuffer in = ByteBuffer.wrap(png).position(8);
    while (in.hasRemaining()) {
      byte[] data = new byte[in.getInt()];
      byte[] name = new byte[4];
      in.get(name).get(data).getInt();
      if (new String(name, StandardCharsets.US_ASCII).equals(type)) {
        found.add(data);
      }
    }
    return found;
  }

  @Test
  void noDisplayIsNeeded() throws IOException {
    assertThat(GraphicsEnvironment.isHeadless()).isTrue();
    assertThat(raster(Image.black(2, 3), ImageWriter.Options.DEFAULT).getHeight()).isEqualTo(3);
  }

  @ParameterizedTest
  @CsvSource({
    "SRGB, 0, 0",
    "SRGB, 1, 255",
    "SRGB, 1.5, 255",
    "SRGB, 3e38, 255",
    "SRGB, -1, 0",
    "SRGB, .5, 188",
    "SRGB, .18, 118",
    "SRGB, 1.51e-4, 0",
    "SRGB, 1.52e-4, 1",
    "GAMMA22, 0, 0",
    "GAMMA22, 1, 255",
    "GAMMA22, 7, 255",
    "GAMMA22, .5, 186",
    "GAMMA22, .18, 117",
    "GAMMA22, 1.1e-6, 0",
    "GAMMA22, 1.12e-6, 1",
    "REINHARD, 0, 0",
    "REINHARD, 1, 188",
    "REINHARD, 3e38, 255",
    "ACES, 0, 0",
    "ACES, .5, 206",
    "ACES, 1, 232",
    "ACES, 3e38, 255",
  })
  void eightBitsAreTheRoundedCurve(ToneCurve curve, double gray, int expected) throws IOException {
    int[] pixel = new int[3];
    raster(ImageFixture.grays(gray), ImageFixture.options(curve, 8)).getPixel(0, 0, pixel);
    assertThat(pixel).containsOnly(expected);
  }

  @Test
  void tiesAreRoundedUp() throws IOException {
    // Encoded values of exactly k + 1/2 occur where the curve is linear: 12.92 v · 255.
    for (int k = 0; k < 10; k++) {
      double tie = (k + .5) / 255 / 12.92;
      float above = Math.nextUp((float) tie);
      float below = Math.nextDown((float) tie);
      Raster raster =
          raster(ImageFixture.grays(below, above), ImageFixture.options(ToneCurve.SRGB, 8));
      assertThat(raster.getSample(0, 0, 0)).isEqualTo(k);
      assertThat(raster.getSample(1, 0, 0)).isEqualTo(k + 1);
    }
  }

  @ParameterizedTest
  @EnumSource
  void everyPixelIsTheRoundedCurve(ToneCurve curve) throws IOException {
    Image image = ImageFixture.random(31, 7, true);
    for (int bits : new int[] {8, 16}) {
      int max = (1 << bits) - 1;
      Raster raster = raster(image, ImageFixture.options(curve, bits));
      for (int y = 0; y < 7; y++) {
        for (int x = 0; x < 31; x++) {
          Rgb shown = curve.apply(image.pixel(x, y));
          assertThat(raster.getPixel(x, y, new int[4]))
              .containsExactly(
                  (int) Math.floor(max * shown.r() + .5),
                  (int) Math.floor(max * shown.g() + .5),
                  (int) Math.floor(max * shown.b() + .5),
                  (int) Math.floor(max * (double) image.alpha(x, y) + .5));
        }
      }
    }
  }

  @Test
  void alphaExistsOnlyIfThePictureHasIt() throws IOException {
    Image opaque = ImageFixture.random(3, 3, false);
    Image clear = new Image(1, 1, new float[] {1, .5f, 0}, new float[] {0});
    assertThat(raster(opaque, ImageWriter.Options.DEFAULT).getNumBands()).isEqualTo(3);
    assertThat(raster(clear, ImageWriter.Options.DEFAULT).getPixel(0, 0, new int[4]))
        .as("straight: the color of a clear pixel stays")
        .containsExactly(255, 188, 0, 0);
  }

  @Test
  void exposureComesBeforeTheCurve() throws IOException {
    Raster raster =
        raster(
            ImageFixture.grays(.25),
            new ImageWriter.Options(Exposure.of(1), ToneCurve.SRGB, 8, Map.of()));
    assertThat(raster.getSample(0, 0, 0)).isEqualTo(188);
  }

  @ParameterizedTest
  @EnumSource
  void extremeExposuresMakeBlackOrWhite(ToneCurve curve) throws IOException {
    for (double stops : new double[] {-5000, 5000}) {
      Raster raster =
          raster(
              ImageFixture.grays(0, 1e-30, 3e38, Float.POSITIVE_INFINITY, Float.NaN),
              new ImageWriter.Options(new Exposure(OptionalDouble.of(stops)), curve, 8, Map.of()));
      int lit = stops > 0 ? 255 : 0;
      assertThat(raster.getSample(0, 0, 0)).isZero();
      assertThat(raster.getSample(1, 0, 0)).isEqualTo(lit);
      assertThat(raster.getSample(2, 0, 0)).isEqualTo(lit);
      assertThat(raster.getSample(4, 0, 0)).isZero();
    }
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "65500, 1", "1, 65500"})
  void extremeSizesAreWritten(int width, int height) throws IOException {
    Image image = ImageFixture.random(width, height, false);
    for (int bits : new int[] {8, 16}) {
      Raster raster = raster(image, ImageFixture.options(ToneCurve.SRGB, bits));
      assertThat(raster.getWidth()).isEqualTo(width);
      assertThat(raster.getHeight()).isEqualTo(height);
      int max = (1 << bits) - 1;
      assertThat(raster.getSample(width - 1, height - 1, 2))
          .isEqualTo((int) Math.round(max * Srgb.encode(image.pixel(width - 1, height - 1).b())));
    }
  }

  @Test
  void latinTextsSurviveInOrder() throws IOException {
    Map<String, String> metadata = new LinkedHashMap<>();
    metadata.put("Software", "Lumbre 1.0");
    metadata.put("Samples", "100");
    metadata.put("Author", "Zoë Ångström");
    metadata.put("Comment", "two\nlines");
    List<byte[]> texts =
        chunks(
            png(
                Image.black(1, 1),
                new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, metadata)),
            "tEXt");
    assertThat(texts)
        .extracting(data -> new String(data, StandardCharsets.ISO_8859_1))
        .containsExactly(
            "Software\0Lumbre 1.0",
            "Samples\000100",
            "Author\0Zoë Ångström",
            "Comment\0two\nlines");
  }

  @Test
  void otherTextsSurviveAsUnicode() throws IOException {
    String text = "火の粉 \uD83D\uDD25 €";
    byte[] png =
        png(
            Image.black(1, 1),
            new ImageWriter.Options(
                Exposure.NONE, ToneCurve.SRGB, 8, Map.of("Scene", text, "Seed", "1")));
    assertThat(chunks(png, "tEXt")).hasSize(1);
    assertThat(chunks(png, "iTXt"))
        .extracting(data -> new String(data, StandardCharsets.UTF_8))
        .containsExactly("Scene\0\0\0\0\0" + text);
  }

  @Test
  void textsThatNoChunkHoldsAreMendedNotRefused() throws IOException {
    byte[] png =
        png(
            Image.black(1, 1),
            new ImageWriter.Options(
                Exposure.NONE, ToneCurve.SRGB, 8, Map.of("Scene", "a\0b", "Title", "")));
    assertThat(chunks(png, "iTXt"))
        .extracting(data -> new String(data, StandardCharsets.UTF_8))
        .containsExactly("Scene\0\0\0\0\0a\uFFFDb");
    assertThat(chunks(png, "tEXt")).hasSize(1);
  }

  @ParameterizedTest
  @EnumSource
  void theFileSaysWhichCurveItHas(ToneCurve curve) throws IOException {
    byte[] png = png(Image.black(1, 1), ImageFixture.options(curve, 8));
    boolean srgb = curve != ToneCurve.GAMMA22;
    assertThat(chunks(png, "sRGB")).hasSize(srgb ? 1 : 0);
    assertThat(chunks(png, "gAMA"))
        .hasSize(srgb ? 0 : 1)
        .allSatisfy(data -> assertThat(ByteBuffer.wrap(data).getInt()).isEqualTo(45455));
  }

  /** Tests the first and last printable Latin-1 characters and their neighbors. */
  @Test
  void printableLatinIsWrittenAsLatin() throws IOException {
    for (String latin : new String[] {"a ~b", "\u00a1\u00ff", "\n"}) {
      byte[] png = png(Image.black(1, 1), withText(latin));
      assertThat(chunks(png, "tEXt")).hasSize(1);
      assertThat(chunks(png, "iTXt")).isEmpty();
    }
    for (String other : new String[] {"\u001f", "\u007f", "\u00a0", "\u0100", "\t"}) {
      byte[] png = png(Image.black(1, 1), withText(other));
      assertThat(chunks(png, "tEXt")).isEmpty();
      assertThat(chunks(png, "iTXt")).hasSize(1);
    }
  }

  private static ImageWriter.Options withText(String text) {
    return new ImageWriter.Options(Exposure.NONE, ToneCurve.SRGB, 8, Map.of("Title", text));
  }
}
