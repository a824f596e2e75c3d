package io.github.lumbre.image.internal;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.image.ImageReader;
import io.github.lumbre.testing.Pictures;
import java.awt.color.ColorSpace;
import java.awt.color.ICC_Profile;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;

/** Tests the detection of color spaces other than sRGB in picture files. */
class ColorTagTest {
  private static final int AFTER_HEADER = 33;

  private static byte[] picture(String format) throws IOException {
    return Pictures.file(Pictures.of(2, 2, 0), format);
  }

  private static byte[] inserted(byte[] file, int at, byte[] piece) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(file, 0, at);
    out.writeBytes(piece);
    out.write(file, at, file.length - at);
    return out.toByteArray();
  }

  private static byte[] png(String type, byte[] data) throws IOException {
    byte[] body = inserted(data, 0, type.getBytes(StandardCharsets.US_ASCII));
    CRC32 crc = new CRC32();
    crc.update(body);
    ByteBuffer chunk = ByteBuffer.allocate(body.length + 8);
    chunk.putInt(data.length).put(body).putInt((int) crc.getValue());
    return inserted(picture("png"), AFTER_HEADER, chunk.array());
  }

  private static byte[] gamma(int value) throws IOException {
    return png("gAMA", ByteBuffer.allocate(4).putInt(value).array());
  }

  private static byte[] profiled(byte[] profile) throws IOException {
    ByteArrayOutputStream data = new ByteArrayOutputStream();
    data.writeBytes("name\0\0".getBytes(StandardCharsets.US_ASCII));
    try (DeflaterOutputStream deflated = new DeflaterOutputStream(data)) {
      deflated.write(profile);
    }
    return png("iCCP", data.toByteArray());
  }

  private static byte[] jpeg(byte[] profile) throws IOException {
    byte[] head = "ICC_PROFILE\0\1\1".getBytes(StandardCharsets.ISO_8859_1);
    ByteBuffer segment = ByteBuffer.allocate(4 + head.length + profile.length);
    segment.putShort((short) 0xffe2).putShort((short) (2 + head.length + profile.length));
    return inserted(picture("jpeg"), 2, segment.put(head).put(profile).array());
  }

  /** Returns a TIFF whose directory, the last in the file, has a profile after it. */
  private static byte[] tiff(byte[] profile, ByteOrder order) {
    ByteBuffer file = ByteBuffer.allocate(8 + 2 + 2 * 12 + 4 + profile.length).order(order);
    file.put(order == ByteOrder.LITTLE_ENDIAN ? new byte[] {'I', 'I'} : new byte[] {'M', 'M'});
    file.putShort((short) 42).putInt(8).putShort((short) 2);
    file.putShort((short) 256).putShort((short) 4).putInt(1).putInt(1);
    file.putShort((short) 34675).putShort((short) 7).putInt(profile.length).putInt(38);
    return file.putInt(0).put(profile).array();
  }

  /** Returns a BMP of the fifth header with a profile. */
  private static byte[] bmp(byte[] profile) {
    ByteBuffer file = ByteBuffer.allocate(14 + 124 + profile.length);
    file.order(ByteOrder.LITTLE_ENDIAN).put((byte) 'B').put((byte) 'M');
    file.putInt(14, 124).putInt(70, 0x4d424544).putInt(126, 124).putInt(130, profile.length);
    return file.position(138).put(profile).array();
  }

  private static byte[] profile(int space) {
    return ICC_Profile.getInstance(space).getData();
  }

  /** Returns a profile with only a description, in the older format. */
  private static byte[] named(String name) {
    byte[] text = (name + "\0").getBytes(StandardCharsets.ISO_8859_1);
    ByteBuffer profile = ByteBuffer.allocate(156 + text.length);
    profile.position(128).putInt(1).putInt(0x64657363).putInt(144).putInt(12 + text.length);
    profile.putInt(0x64657363).putInt(0).putInt(text.length).put(text);
    return profile.array();
  }

  @Test
  void gammasOtherThanThatOfSrgbAreReported() throws IOException {
    assertThat(ImageReader.ignoredColorSpace(gamma(45455))).isEmpty();
    assertThat(ImageReader.ignoredColorSpace(gamma(45500))).isEmpty();
    assertThat(ImageReader.ignoredColorSpace(gamma(55556))).contains("a gamma of 0.55556");
    assertThat(ImageReader.ignoredColorSpace(gamma(100000))).contains("a gamma of 1.0");
  }

  @Test
  void profilesOtherThanSrgbAreReported() throws IOException {
    byte[] srgb = profile(ColorSpace.CS_sRGB);
    assertThat(ImageReader.ignoredColorSpace(profiled(srgb))).isEmpty();
    assertThat(ImageReader.ignoredColorSpace(jpeg(srgb))).isEmpty();
    byte[] adobe = named("Adobe RGB (1998)");
    String found = "an ICC profile (Adobe RGB (1998))";
    assertThat(ImageReader.ignoredColorSpace(profiled(adobe))).contains(found);
    assertThat(ImageReader.ignoredColorSpace(jpeg(adobe))).contains(found);
    for (ByteOrder order : new ByteOrder[] {ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN}) {
      assertThat(ImageReader.ignoredColorSpace(tiff(adobe, order))).contains(found);
      assertThat(ImageReader.ignoredColorSpace(tiff(srgb, order))).isEmpty();
    }
    assertThat(ImageReader.ignoredColorSpace(bmp(adobe))).contains(found);
    assertThat(ImageReader.ignoredColorSpace(bmp(srgb))).isEmpty();
    byte[] linear = profile(ColorSpace.CS_LINEAR_RGB);
    assertThat(ImageReader.ignoredColorSpace(profiled(linear)).orElseThrow())
        .startsWith("an ICC profile");
  }

  @Test
  void picturesThatStateNothingOrSrgbAreNotReported() throws IOException {
    assertThat(ImageReader.ignoredColorSpace(picture("png"))).isEmpty();
    assertThat(ImageReader.ignoredColorSpace(picture("jpeg"))).isEmpty();
    assertThat(ImageReader.ignoredColorSpace(png("sRGB", new byte[1]))).isEmpty();
  }

  @Test
  void cutOffFilesAndDamagedProfilesAreNoFaults() throws IOException {
    byte[] png = profiled(named("Adobe RGB (1998)"));
    byte[] jpeg = jpeg(named("Adobe RGB (1998)"));
    for (int length = 0; length < png.length; length++) {
      assertThat(ImageReader.ignoredColorSpace(Arrays.copyOf(png, length))).isNotNull();
    }
    for (int length = 0; length < jpeg.length; length++) {
      assertThat(ImageReader.ignoredColorSpace(Arrays.copyOf(jpeg, length))).isNotNull();
    }
    byte[] tiff = tiff(named("Adobe RGB (1998)"), ByteOrder.BIG_ENDIAN);
    for (int length = 0; length < tiff.length; length++) {
      assertThat(ImageReader.ignoredColorSpace(Arrays.copyOf(tiff, length))).isEmpty();
    }
    byte[] bmp = bmp(named("Adobe RGB (1998)"));
    for (int length = 0; length < bmp.length; length++) {
      assertThat(ImageReader.ignoredColorSpace(Arrays.copyOf(bmp, length))).isEmpty();
    }
    byte[] wild = named("x");
    ByteBuffer.wrap(wild).putInt(136, Integer.MAX_VALUE);
    assertThat(ImageReader.ignoredColorSpace(jpeg(wild))).contains("an ICC profile");
  }
}
