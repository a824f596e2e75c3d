package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.dds.DdsFixture;
import io.github.lumbre.image.format.imageio.LegacyFixture;
import io.github.lumbre.image.format.ktx.KtxSamples;
import io.github.lumbre.image.format.tga.TgaFixture;
import io.github.lumbre.image.format.webp.WebpSamples;
import io.github.lumbre.testing.FileMutator;
import io.github.lumbre.testing.Mutants;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every damaged picture is decoded or refused, soon, and with no more memory than it counts. */
class EncodedMutationTest {
  private static final int QUICK = 2000;
  private static final Limits LIMITS = Limits.NONE.withTexels(1 << 20);

  private enum Form {
    TGA(30, TgaFixture.files()),
    WEBP(60, WebpSamples.files()),
    KTX(300, KtxSamples.all().stream().map(KtxSamples.Sample::file)),
    DDS(150, DdsFixture.files()),
    BMP(140, LegacyFixture.bmps()),
    GIF(40, LegacyFixture.gifs()),
    TIFF(300, LegacyFixture.tiffs());

    private final int header;
    private final List<byte[]> files;

    Form(int header, Stream<byte[]> files) {
      this.header = header;
      this.files = files.toList();
    }
  }

  @ParameterizedTest
  @EnumSource
  void mutantsAreDecodedOrRefused(Form form) {
    Mutants.few(QUICK, seed -> isDecoded(form, seed));
  }

  @ParameterizedTest
  @EnumSource
  @Tag("fuzz")
  void manyMutantsAreDecodedOrRefused(Form form) {
    Mutants.many(seed -> isDecoded(form, seed));
  }

  private static boolean isDecoded(Form form, long seed) {
    Random random = new Random(seed);
    byte[] original = form.files.get(random.nextInt(form.files.size()));
    byte[] file = new FileMutator(random).changed(original, form.header);
    Mutants.Needs needs = new Mutants.Needs();
    long counted = 0;
    try {
      EncodedPicture picture = EncodedFormat.open(file, LIMITS);
      counted = (long) picture.bytesPerPixel() * picture.width() * picture.height();
      Pixels pixels = picture.decoder().decode();
      assertThat(pixels.width()).isEqualTo(picture.width());
      assertThat(pixels.height()).isEqualTo(picture.height());
      return true;
    } catch (ImageFormatException e) {
      Mutants.assertPrintable(e.getMessage(), 250);
      return false;
    } finally {
      needs.assertLittle(counted);
    }
  }
}
