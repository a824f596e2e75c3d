package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.dds.DdsFixture;
import io.github.lumbre.image.imageio.LegacyFixture;
import io.github.lumbre.image.ktx.KtxSamples;
import io.github.lumbre.image.tga.TgaFixture;
import io.github.lumbre.image.webp.WebpSamples;
import io.github.lumbre.limit.Limits;
import io.github.lumbre.testing.Effort;
import io.github.lumbre.testing.FileMutator;
import java.lang.management.ManagementFactory;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Every damaged picture is decoded or refused, soon, and with no more memory than it counts. */
class EncodedMutationTest {
  private static final int QUICK = 2000;
  private static final int MANY = 100_000;
  private static final Limits LIMITS = Limits.NONE.withTexels(1 << 20);
  private static final long MAX_SECONDS = 2;

  /** Bytes of classes that are loaded, of messages and of Java's decoders. */
  private static final long UNCOUNTED = 8_000_000;

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
    run(form, Effort.seed(1), Effort.count(QUICK, MANY));
  }

  @ParameterizedTest
  @EnumSource
  @Tag("fuzz")
  void manyMutantsAreDecodedOrRefused(Form form) {
    run(form, Long.getLong("lumbre.fuzz.seed", System.nanoTime()), MANY);
  }

  private static void run(Form form, long seed, int count) {
    int decoded = 0;
    for (int i = 0; i < count; i++) {
      Random random = new Random(seed + i);
      byte[] original = form.files.get(random.nextInt(form.files.size()));
      byte[] file = new FileMutator(random).changed(original, form.header);
      try {
        decoded += isDecoded(file) ? 1 : 0;
      } catch (RuntimeException | Error e) {
        throw new AssertionError("seed " + (seed + i) + ": " + HexFormat.of().formatHex(file), e);
      }
    }
    assertThat(decoded).isBetween(count / 20, count * 19 / 20);
  }

  private static boolean isDecoded(byte[] file) {
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long bytes = threads.getCurrentThreadAllocatedBytes();
    long start = threads.getCurrentThreadCpuTime();
    long counted = 0;
    try {
      EncodedPicture picture = EncodedFormat.open(file, LIMITS);
      counted = (long) picture.bytesPerPixel() * picture.width() * picture.height();
      Pixels pixels = picture.decoder().decode();
      assertThat(pixels.width()).isEqualTo(picture.width());
      assertThat(pixels.height()).isEqualTo(picture.height());
      return true;
    } catch (ImageFormatException e) {
      assertThat(e.getMessage())
          .hasSizeLessThan(250)
          .doesNotContain("null", "Exception", "java.")
          .doesNotContainPattern("\\p{Cntrl}");
      return false;
    } finally {
      assertThat(threads.getCurrentThreadCpuTime() - start)
          .isLessThan(TimeUnit.SECONDS.toNanos(MAX_SECONDS));
      assertThat(threads.getCurrentThreadAllocatedBytes() - bytes).isLessThan(counted + UNCOUNTED);
    }
  }
}
