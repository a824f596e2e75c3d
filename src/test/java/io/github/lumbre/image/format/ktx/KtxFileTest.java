package io.github.lumbre.image.format.ktx;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageFormatException.Kind;
import io.github.lumbre.image.Pixels;
import io.github.lumbre.image.format.ktx.KtxSamples.Sample;
import io.github.lumbre.image.internal.EncodedPicture;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Files are decoded to the values of the Basis Universal transcoder, or refused by name. */
class KtxFileTest {
  private static final String ETC1S = "ETC1S with alpha";
  private static final String UASTC = "UASTC with alpha and levels";
  private static final int HEADER_BYTES = 104;
  private static final int DESCRIPTOR_BYTES = 44;

  static List<Sample> samples() {
    return KtxSamples.all();
  }

  private static Pixels decode(byte[] file) throws ImageFormatException {
    return KtxFile.open(file).decoder().decode();
  }

  private static byte[] rgba(Pixels pixels) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (int y = 0; y < pixels.height(); y++) {
      for (int x = 0; x < pixels.width(); x++) {
        for (int channel = 0; channel < 3; channel++) {
          out.write(pixels.raw(x, y, channel));
        }
        out.write(pixels.alpha(x, y));
      }
    }
    return out.toByteArray();
  }

  private static ByteBuffer buffer(byte[] file) {
    return ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static ImageFormatException refusal(byte[] file) {
    return catchThrowableOfType(ImageFormatException.class, () -> decode(file));
  }

  @ParameterizedTest
  @MethodSource("samples")
  void valuesAreThoseOfTheTranscoder(Sample sample)
      throws ImageFormatException, NoSuchAlgorithmException {
    assertThat(KtxFile.startsIn(sample.file())).isTrue();
    EncodedPicture file = KtxFile.open(sample.file());
    Pixels pixels = file.decoder().decode();
    assertThat(List.of(file.width(), file.height(), pixels.width(), pixels.height()))
        .isEqualTo(List.of(sample.width(), sample.height(), sample.width(), sample.height()));
    assertThat(pixels.hasAlpha()).isEqualTo(sample.hasAlpha());
    byte[] hash = MessageDigest.getInstance("SHA-256").digest(rgba(pixels));
    assertThat(HexFormat.of().formatHex(hash)).isEqualTo(sample.sha256());
  }

  /** Returns a file without a data format of Basis Universal. */
  private static byte[] plain(int vkFormat, int width, int height, byte[] metadata, int... values) {
    int data = HEADER_BYTES + DESCRIPTOR_BYTES + metadata.length;
    ByteBuffer out = buffer(new byte[data + values.length]);
    out.put(HexFormat.of().parseHex("ab4b5458203230bb0d0a1a0a")).putInt(vkFormat).putInt(1);
    out.putInt(width).putInt(height).putInt(0).putInt(0).putInt(1).putInt(1).putInt(0);
    out.putInt(HEADER_BYTES).putInt(DESCRIPTOR_BYTES);
    out.putInt(HEADER_BYTES + DESCRIPTOR_BYTES).putInt(metadata.length).putLong(0).putLong(0);
    out.putLong(data).putLong(values.length).putLong(values.length);
    out.position(HEADER_BYTES + DESCRIPTOR_BYTES).put(metadata);
    for (int value : values) {
      out.put((byte) value);
    }
    return out.array();
  }

  private static byte[] metadata(String key, String value) {
    byte[] text = (key + "\0" + value + "\0").getBytes(StandardCharsets.US_ASCII);
    ByteBuffer out = buffer(new byte[Integer.BYTES + (text.length + 3 & -4)]);
    return out.putInt(text.length).put(text).array();
  }

  @ParameterizedTest
  @CsvSource({
    "9,  1 1 1 255 2 2 2 255",
    "16, 1 2 0 255 3 4 0 255",
    "29, 1 2 3 255 4 5 6 255",
    "43, 1 2 3 4 5 6 7 8"
  })
  void channelsOf8BitsAreRead(int vkFormat, String expected) throws ImageFormatException {
    int count = vkFormat == 9 ? 2 : vkFormat == 16 ? 4 : vkFormat == 29 ? 6 : 8;
    int[] values = Arrays.copyOf(new int[] {1, 2, 3, 4, 5, 6, 7, 8}, count);
    Pixels pixels = decode(plain(vkFormat, 2, 1, new byte[0], values));
    StringBuilder found = new StringBuilder();
    for (byte value : rgba(pixels)) {
      found.append(' ').append(value & 0xff);
    }
    assertThat(found.substring(1)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({"rd, 1 2 3 4", "ld, 2 1 4 3", "ru, 3 4 1 2", "lu, 4 3 2 1"})
  void orientationIsApplied(String orientation, String expected) throws ImageFormatException {
    Pixels pixels = decode(plain(9, 2, 2, metadata("KTXorientation", orientation), 1, 2, 3, 4));
    assertThat(
            "%d %d %d %d"
                .formatted(
                    pixels.raw(0, 0, 0),
                    pixels.raw(1, 0, 0),
                    pixels.raw(0, 1, 0),
                    pixels.raw(1, 1, 0)))
        .isEqualTo(expected);
  }

  @Test
  void otherMetadataAreIgnored() throws ImageFormatException {
    assertThat(decode(plain(9, 1, 1, metadata("KTXswizzle", "rgba"), 7)).raw(0, 0, 0)).isEqualTo(7);
    assertThat(decode(plain(9, 1, 1, metadata("KTXwriter", "x"), 7)).raw(0, 0, 0)).isEqualTo(7);
    assertThat(refusal(plain(9, 1, 1, metadata("KTXswizzle", "rrr1"), 7)))
        .hasMessage("KTX has channels in another order (KTXswizzle), expected rgba");
  }

  /** Numbers of four bytes in the header. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "12 | 145 | KTX has the Vulkan format 145, expected ETC1S, UASTC or 1 to 4 channels of 8"
            + " bits",
        "20 | 0 | the picture has no pixels",
        "24 | 0 | KTX has a picture of one dimension, expected one picture of two dimensions",
        "28 | 3 | KTX has a volume, expected one picture of two dimensions",
        "32 | 9 | KTX has an array or a video of 9 pictures, expected one picture of two"
            + " dimensions",
        "36 | 6 | KTX has a cube map, expected one picture of two dimensions",
        "40 | 99 | KTX has 99 levels, expected at most 32",
        "44 | 4 | KTX has the supercompression scheme 4, expected 0 to 3",
        "44 | 1 | KTX has UASTC_ALPHA with BASIS_LZ, expected BASIS_LZ with ETC1S",
        "48 | 9999 | KTX is damaged: expected a data format descriptor of 44 bytes from byte 9999"
            + " on, found 0 bytes in all",
        "20 | 34 | KTX has 640 bytes at level 0 for 720 bytes",
      })
  void othersAreRefusedByName(int at, int value, String message) {
    byte[] file = KtxSamples.file(UASTC);
    buffer(file).putInt(at, value);
    assertThat(refusal(file))
        .hasMessage(message.replaceAll("\\b0 bytes in all", file.length + " bytes in all"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "UASTC | 12 | 162 | KTX has the color model 162, expected 163 (ETC1S) or 166 (UASTC)",
        "UASTC | 15 | 1 | KTX has colors that are multiplied by alpha, expected straight ones",
        "UASTC | 31 | 6 | KTX has two channels of data, expected colors, with or without alpha",
        "UASTC | 31 | 9 | KTX has the channels 9 and 15, expected colors",
        "ETC1S with alpha | 47 | 4 | KTX has two channels of data, expected colors, with or"
            + " without alpha",
      })
  void otherDataAreRefusedByName(String name, int at, int value, String message) {
    byte[] file = KtxSamples.file(name);
    file[buffer(file).getInt(48) + at] = (byte) value;
    assertThat(refusal(file)).hasMessage(message);
  }

  @Test
  void version1IsRefusedByName() {
    byte[] file = Arrays.copyOf("\u00abKTX 11\u00bb".getBytes(StandardCharsets.ISO_8859_1), 99);
    assertThat(KtxFile.startsIn(file)).isTrue();
    assertThat(refusal(file)).hasMessage("KTX has version 1, expected version 2");
  }

  @Test
  void framesOfVideosAreRefusedByName() {
    byte[] file = KtxSamples.file(ETC1S);
    file[(int) buffer(file).getLong(64) + 20] |= 2;
    assertThat(refusal(file)).hasMessage("KTX has a frame of a video, expected one picture");
  }

  @Test
  void sizesAreLimited() {
    byte[] file = KtxSamples.file(ETC1S);
    buffer(file).putInt(20, 65536);
    assertThat(refusal(file).kind()).isEqualTo(Kind.TOO_LARGE);
    assertThat(refusal(file)).hasMessageStartingWith("the picture has 65536x40 pixels, expected");
  }

  @Test
  void blocksThatMeanNothingAreNamed() {
    byte[] file = KtxSamples.file("UASTC of each mode");
    int level = (int) buffer(file).getLong(80);
    byte[] patterned = file.clone();
    file[level + 16] = 0x45;
    assertThat(refusal(file)).hasMessage("KTX is damaged: UASTC block 1 has no mode");
    // The third mode has patterns after 20 bits.
    buffer(patterned).putInt(level, 0x1d | 31 << 20);
    assertThat(refusal(patterned))
        .hasMessage("KTX is damaged: UASTC block 0 has the pattern 31, expected at most 29");
  }

  @Test
  void partsOutsideTheFileAreNamed() {
    byte[] file = KtxSamples.file(ETC1S);
    buffer(file).putLong(80, Long.MIN_VALUE);
    assertThat(refusal(file))
        .hasMessageStartingWith("KTX is damaged: expected level 0 of ")
        .hasMessageContaining(" from byte 9223372036854775808 on, found " + file.length);
    byte[] codes = KtxSamples.file(ETC1S);
    buffer(codes).putInt((int) buffer(codes).getLong(64) + 4, 1);
    assertThat(refusal(codes))
        .hasMessage("KTX is damaged: the code book of colors ends after 1 bytes");
  }

  @Test
  void everyBeginningIsRefused() {
    for (Sample sample : KtxSamples.all()) {
      byte[] file = sample.file();
      for (int length = 80; length < file.length; length += 1 + length / 20) {
        byte[] start = Arrays.copyOf(file, length);
        boolean hasLevel = length >= buffer(file).getLong(80) + buffer(file).getLong(88);
        if (!hasLevel) {
          assertThat(refusal(start).kind()).isEqualTo(Kind.MALFORMED);
        }
      }
    }
  }

  @Test
  void interruptsStopDecoding() {
    for (Sample sample : KtxSamples.all()) {
      assertCancelled(() -> decode(sample.file()));
    }
  }
}
