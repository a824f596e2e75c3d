package io.github.lumbre.image.format.exr;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.lumbre.image.Image;
import io.github.lumbre.image.ImageFormatException;
import io.github.lumbre.image.ImageLayer;
import io.github.lumbre.image.LayeredImage;
import io.github.lumbre.image.internal.LinearReader;
import io.github.lumbre.testing.SampleFiles;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests lossy compressions by files of OpenEXR's own package, which {@code src/comparison/exr.py}
 * writes: halves of all kinds, floats, integers, layers, equal values and linear channels.
 */
class ExrLossyTest {
  /** The bytes of the numbers at the start of a DWA block. */
  private static final int DWA_HEADER = 11 * Long.BYTES;

  private static byte[] resource(String name) {
    return SampleFiles.bytes(ExrLossyTest.class, name + ".exr");
  }

  private static void update(MessageDigest digest, float[] values) {
    ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length);
    bytes.order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().put(values);
    digest.update(bytes.array());
  }

  private static String hash(LayeredImage image) throws NoSuchAlgorithmException {
    TreeMap<String, float[]> channels = new TreeMap<>();
    for (ImageLayer layer : image.layers()) {
      int count = layer.channels().size();
      for (int channel = 0; channel < count; channel++) {
        float[] values = new float[layer.values().length / count];
        for (int i = 0; i < values.length; i++) {
          values[i] = layer.values()[i * count + channel];
        }
        String prefix = layer.name().isEmpty() ? "" : layer.name() + ".";
        channels.put(prefix + layer.channels().get(channel), values);
      }
    }
    MessageDigest digest = MessageDigest.getInstance("SHA-256");
    channels.values().forEach(values -> update(digest, values));
    return HexFormat.of().formatHex(digest.digest());
  }

  /** The hashes are those of the values that OpenEXR 3.5.3 reads on x86-64. */
  @ParameterizedTest
  @CsvSource({
    "pxr24, dcb2d790948c9437482bedb3daadfa587efd4158fe5d3b148cc99a5f81914367",
    "b44, ba7e3d2f771519088c1d291aae32d15746f5fb096854c270854ce31580fa5da0",
    "b44a, ba7e3d2f771519088c1d291aae32d15746f5fb096854c270854ce31580fa5da0",
    "dwaa, 9255e805b3a8149181223959a8727381583ca32d31f347a7c38c64cd5aeef8ce",
    "dwab, c9fc52ab276d7d21f5fa51db6291a7970146dab1cb84e1b2029bd2211e80bc4a",
    "dwaa-tiles, 652dac5801836f4db9d69781f53cea8eb99696a95b9e230fba535f6817f0a604"
  })
  void valuesAreThoseOfOpenExr(String name, String hash)
      throws IOException, NoSuchAlgorithmException {
    assertThat(hash(LayeredImage.of(resource(name)))).isEqualTo(hash);
  }

  private static int firstBlock(byte[] file) throws IOException {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN).position(Long.BYTES);
    ExrHeader.attributes(in);
    return (int) in.getLong();
  }

  /** Returns a file whose blocks are of an old version, whose rules are fixed. */
  private static byte[] withoutRules(byte[] file, int version) throws IOException {
    ByteBuffer in = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
    ByteBuffer out = ByteBuffer.allocate(file.length).order(ByteOrder.LITTLE_ENDIAN);
    out.put(file, 0, firstBlock(file));
    in.position(firstBlock(file));
    while (in.hasRemaining()) {
      out.putInt(in.getInt());
      int size = in.getInt();
      int start = in.position();
      if (in.getLong(start) == 2) {
        int rules = in.getShort(start + DWA_HEADER);
        out.putInt(size - rules).putLong(version).put(file, start + 8, DWA_HEADER - 8);
        out.put(file, start + DWA_HEADER + rules, size - DWA_HEADER - rules);
      } else {
        out.putInt(size).put(file, start, size);
      }
      in.position(start + size);
    }
    return Arrays.copyOf(out.array(), out.position());
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1})
  void oldVersionsOfDwaHaveFixedRules(int version) throws Exception {
    byte[] file = resource("dwab");
    byte[] old = withoutRules(file, version);
    assertThat(old.length).isLessThan(file.length);
    assertThat(hash(LayeredImage.of(old))).isEqualTo(hash(LayeredImage.of(file)));
    ByteBuffer.wrap(old).order(ByteOrder.LITTLE_ENDIAN).putLong(firstBlock(old) + 8, 3);
    assertThatThrownBy(() -> LayeredImage.of(old))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageContaining("expected DWA compression of version 0 to 2, found 3");
  }

  @ParameterizedTest
  @ValueSource(strings = {"pxr24", "b44", "b44a", "dwaa", "dwab", "dwaa-tiles"})
  void everyTruncationIsRefused(String name) throws IOException {
    byte[] file = resource(name);
    for (int length = 0; length < file.length; length += length < 900 ? 7 : 61) {
      byte[] part = Arrays.copyOf(file, length);
      assertThatThrownBy(() -> LinearReader.decode(part)).isInstanceOf(ImageFormatException.class);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"pxr24", "b44", "dwaa"})
  void readingCanBeInterrupted(String name) throws IOException {
    byte[] file = resource(name);
    assertCancelled(() -> LinearReader.decode(file));
  }

  /** Each block of the picture is a few bytes, which stand for 66,000 times as many. */
  @Test
  void blackPicturesAreReadHoweverFewTheirBytes() throws IOException {
    Image image = LinearReader.decode(resource("black"));
    assertThat(image.rgb()).isEqualTo(new float[3 * 2048 * 512]);
  }
}
