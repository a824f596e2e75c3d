package io.github.lumbre.image.format.zstd;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.image.ImageFormatException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Frames are decoded to the bytes that the zstd program compressed, or refused with a reason. */
class ZstandardTest {
  /**
   * A frame.
   *
   * @param sha256 of its content
   */
  record Frame(String name, int size, String sha256, byte[] bytes) {
    byte[] decode(int found) throws ImageFormatException {
      return Zstandard.decode(bytes, 0, bytes.length, found);
    }

    @Override
    public String toString() {
      return name;
    }
  }

  static List<Frame> frames() throws IOException {
    try (InputStream in = ZstandardTest.class.getResourceAsStream("frames.csv")) {
      return new String(in.readAllBytes(), StandardCharsets.US_ASCII)
          .lines()
          .skip(1)
          .map(line -> line.split(","))
          .map(c -> new Frame(c[0], Integer.parseInt(c[1]), c[2], Base64.getDecoder().decode(c[3])))
          .toList();
    }
  }

  private static Frame frame(String name) throws IOException {
    return frames().stream().filter(frame -> frame.name.equals(name)).findFirst().orElseThrow();
  }

  private static String hash(byte[] bytes) throws NoSuchAlgorithmException {
    return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
  }

  @ParameterizedTest
  @MethodSource("frames")
  void contentIsThatOfTheProgram(Frame frame) throws IOException, NoSuchAlgorithmException {
    assertThat(hash(frame.decode(frame.size))).isEqualTo(frame.sha256);
  }

  @ParameterizedTest
  @MethodSource("frames")
  void frameMayLieInsideOtherBytes(Frame frame) throws IOException, NoSuchAlgorithmException {
    byte[] file = new byte[frame.bytes.length + 7];
    Arrays.fill(file, (byte) 0xa5);
    System.arraycopy(frame.bytes, 0, file, 3, frame.bytes.length);
    byte[] decoded = Zstandard.decode(file, 3, 3 + frame.bytes.length, frame.size);
    assertThat(hash(decoded)).isEqualTo(frame.sha256);
  }

  @ParameterizedTest
  @MethodSource("frames")
  void everyBeginningIsRefused(Frame frame) {
    for (int length = 0; length < frame.bytes.length; length += 1 + length / 20) {
      int end = length;
      assertThatThrownBy(() -> Zstandard.decode(frame.bytes, 0, end, frame.size))
          .isInstanceOf(ImageFormatException.class);
    }
  }

  @ParameterizedTest
  @MethodSource("frames")
  void anotherSizeIsRefused(Frame frame) {
    assertThatThrownBy(() -> frame.decode(frame.size + 1))
        .isInstanceOf(ImageFormatException.class)
        .hasMessageEndingWith(
            "expected " + (frame.size + 1) + " decoded bytes, found " + frame.size);
    if (frame.size > 0) {
      assertThatThrownBy(() -> frame.decode(frame.size - 1))
          .isInstanceOf(ImageFormatException.class)
          .hasMessageEndingWith("expected " + (frame.size - 1) + " decoded bytes, found more");
    }
  }

  /** Frames by hand: magic number, descriptor, size or window, blocks. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "28b52ffd 20 03 190000 616263 | 616263",
        "28b52ffd 20 05 2b0000 7a | 7a7a7a7a7a",
        "28b52ffd 20 05 100000 6162 1b0000 7a | 61627a7a7a",
        "28b52ffd 00 58 190000 616263 | 616263",
        "28b52ffd 60 0500 190000 616263 | 616263",
        "28b52ffd 24 03 190000 616263 01020304 | 616263",
        "28b52ffd 22 0000 03 190000 616263 | 616263",
      })
  void framesByHandAreDecoded(String hex, String content) throws ImageFormatException {
    byte[] frame = HexFormat.of().parseHex(hex.replace(" ", ""));
    byte[] expected = HexFormat.of().parseHex(content);
    assertThat(Zstandard.decode(frame, 0, frame.length, expected.length)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "28b52ffe 20 03 190000 616263 | byte 4: expected a frame, found fe2fb528",
        "28b52ffd 28 03 190000 616263 | byte 5: expected a reserved bit of 0, found 1",
        "28b52ffd 21 07 03 190000 616263 | byte 6: expected no dictionary, found number 7",
        "28b52ffd 20 03 1f0000 616263 | byte 9: expected a block of type 0, 1 or 2, found 3",
        "28b52ffd 20 03 190010 616263"
            + " | byte 9: expected a block of at most 131072 bytes, found 131075",
        "28b52ffd 20 03 190000 6162 | byte 9: expected 3 bytes, found the last 2",
        "28b52ffd 20 03 190000 616263 00 | byte 12: expected one frame, found 1 more bytes",
        // Three literals that are repeated, and a sequence of predefined codes.
        "28b52ffd 20 03 250000 1961 00 99 | byte 12: expected the end of a block, found 1 bytes",
        "28b52ffd 20 03 450000 1961 01 54000500 3f | byte 17: expected an offset from 1 to 0, found"
            + " 60",
        "28b52ffd 20 03 2d0000 1961 01 0000 | byte 13: expected the bits of a stream, found none",
        "28b52ffd 20 03 2d0000 1961 01 ff03 | byte 13: expected a table to repeat, found none",
        "28b52ffd 20 03 1d0000 030000 | byte 12: expected a Huffman code, found none",
      })
  void damageIsNamed(String hex, String message) {
    byte[] frame = HexFormat.of().parseHex(hex.replace(" ", ""));
    ImageFormatException refusal =
        catchThrowableOfType(
            ImageFormatException.class, () -> Zstandard.decode(frame, 0, frame.length, 3));
    assertThat(refusal).hasMessage("Zstandard data are damaged at " + message);
  }

  @Test
  void interruptsStopDecoding() throws IOException {
    Frame frame = frame("zeros");
    assertCancelled(() -> frame.decode(frame.size));
  }
}
