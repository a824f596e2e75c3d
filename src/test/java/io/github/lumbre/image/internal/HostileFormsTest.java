package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.format.exr.ExrBuilder;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import io.github.lumbre.testing.SampleFiles;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every changed OpenEXR or Radiance file gives a picture, or is refused for a reason. */
class HostileFormsTest {
  private static final int QUICK = 300;

  private enum Form {
    RLE(470, new ExrBuilder(12, 5, 1).rgb("", HostileFormsTest::value).file()),
    HALF(
        470,
        new ExrBuilder(12, 5, 0).channel("Y", 1, (x, y) -> 1).channel("A", 0, (x, y) -> 1).file()),
    TILES(500, new ExrBuilder(12, 9, 3).rgb("a.", HostileFormsTest::value).tiles(8, 4, 1).file()),
    PARTS(
        900,
        new ExrBuilder(12, 9, 3)
            .rgb("", HostileFormsTest::value)
            .fileBefore(new ExrBuilder(3, 3, 0).rgb("", (x, y) -> 0))),
    PIZ(800, resource("piz.exr")),
    PXR24(900, resource("pxr24.exr")),
    B44(900, resource("b44.exr")),
    B44A(900, resource("b44a.exr")),
    DWAA(1000, resource("dwaa.exr")),
    DWAB(1000, resource("dwab.exr")),
    DWAA_TILES(1000, resource("dwaa-tiles.exr")),
    RADIANCE_OLD(60, radiance(4, 9, 8, 7, 136, 1, 1, 1, 4, 6, 0, 0, 136)),
    RADIANCE_NEW(60, radiance(9, 2, 2, 0, 9, 137, 5, 4, 1, 2, 3, 4, 133, 7, 137, 8, 137, 136));

    private final int header;
    private final byte[] file;

    Form(int header, byte[] file) {
      this.header = header;
      this.file = file;
    }
  }

  private static double value(int x, int y) {
    return x < 8 ? x / 3.0 + y : 7;
  }

  private static byte[] resource(String name) {
    return SampleFiles.bytes(ExrBuilder.class, name);
  }

  private static byte[] radiance(int width, int... data) {
    int pixels = width == 4 ? 6 : width;
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    String text = "#?RADIANCE\nEXPOSURE=2\nCOLORCORR=1 2 1\n\n-Y 2 +X " + pixels + "\n";
    out.writeBytes(text.getBytes(StandardCharsets.US_ASCII));
    for (int i = 0; i < 2 * data.length; i++) {
      out.write(data[i % data.length]);
    }
    return out.toByteArray();
  }

  private static boolean isRead(Form form, long seed) {
    byte[] file = new FileMutator(new Random(seed)).changed(form.file, form.header);
    try {
      Image image = LinearReader.decode(file);
      assertThat(image.rgb()).hasSize(3 * image.width() * image.height());
      return true;
    } catch (ImageFormatException e) {
      Mutants.assertPrintable(e.getMessage(), 300);
      return false;
    }
  }

  @ParameterizedTest
  @EnumSource
  void changedFilesAreReadOrRefused(Form form) {
    Mutants.few(QUICK, .01, .9, seed -> isRead(form, seed));
  }

  @ParameterizedTest
  @EnumSource
  @Tag("fuzz")
  void manyChangedFilesAreReadOrRefused(Form form) {
    Mutants.many(.01, .9, seed -> isRead(form, seed));
  }
}
