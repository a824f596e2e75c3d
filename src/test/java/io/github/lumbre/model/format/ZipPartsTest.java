package io.github.lumbre.model.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the reading of archives. */
class ZipPartsTest {
  private static final byte[] TEXT = "some text ".repeat(20).getBytes(StandardCharsets.US_ASCII);

  private static byte[] zip(boolean isStored, String... names) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      for (String name : names) {
        ZipEntry entry = new ZipEntry(name);
        if (isStored) {
          CRC32 crc = new CRC32();
          crc.update(TEXT);
          entry.setMethod(ZipEntry.STORED);
          entry.setSize(TEXT.length);
          entry.setCrc(crc.getValue());
        }
        zip.putNextEntry(entry);
        zip.write(TEXT);
      }
    }
    return out.toByteArray();
  }

  private static byte[] read(byte[] zip, String name) throws ModelFormatException {
    return ZipParts.of(zip, Limits.NONE).read(name, "here");
  }

  private static String refusal(byte[] zip, Limits limits) {
    ModelFormatException thrown =
        catchThrowableOfType(
            ModelFormatException.class, () -> ZipParts.of(zip, limits).read("a", "here"));
    return thrown.kind() + " " + thrown.getMessage();
  }

  /** Returns the offset of the last record of a kind. */
  private static int last(byte[] zip, int kind) {
    ByteBuffer bytes = little(zip);
    int at = zip.length - 4;
    while (bytes.getInt(at) != kind) {
      at--;
    }
    return at;
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static int entry(byte[] zip) {
    return last(zip, 0x02014b50);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void partsAreStoredOrDeflated(boolean isStored) throws Exception {
    byte[] zip = zip(isStored, "3D/a.model", "b");
    assertThat(read(zip, "/3d/A.model")).isEqualTo(TEXT);
    assertThat(read(zip, "b")).isEqualTo(TEXT);
  }

  @Test
  void bytesBeforeAndAfterTheArchiveAreAllowed() throws Exception {
    byte[] zip = zip(false, "a");
    assertThat(read(Arrays.copyOf(zip, zip.length + 1000), "a")).isEqualTo(TEXT);
  }

  @Test
  void sizesMayHave64Bits() throws Exception {
    byte[] zip = zip(true, "a");
    int at = entry(zip);
    int end = last(zip, 0x06054b50);
    ByteBuffer out = ByteBuffer.allocate(500).order(ByteOrder.LITTLE_ENDIAN);
    out.put(zip, 0, at + 46).put((byte) 'a');
    out.putInt(at + 20, -1).putInt(at + 24, -1).putInt(at + 42, -1).putShort(at + 30, (short) 28);
    out.putShort((short) 1).putShort((short) 24);
    out.putLong(TEXT.length).putLong(TEXT.length).putLong(0);
    int end64 = out.position();
    out.putInt(0x06064b50).putLong(44).putShort((short) 45).putShort((short) 45);
    out.putInt(0).putInt(0).putLong(1).putLong(1).putLong(end64 - at).putLong(at);
    out.putInt(0x07064b50).putInt(0).putLong(end64).putInt(1);
    int newEnd = out.position();
    out.put(zip, end, 22).putShort(newEnd + 10, (short) -1).putInt(newEnd + 16, -1);
    assertThat(read(Arrays.copyOf(out.array(), out.position()), "a")).isEqualTo(TEXT);
  }

  @ParameterizedTest
  @ValueSource(strings = {"../x", "a/../../x", "/x", "C:\\x", "c:x", "..\\x", "\\x"})
  void namesStayInside(String name) throws IOException {
    assertThat(refusal(zip(false, "a", name), Limits.NONE))
        .startsWith("MALFORMED expected names inside the archive, found ");
  }

  @Test
  void namesAreUnique() throws IOException {
    assertThat(refusal(zip(false, "a", "A"), Limits.NONE))
        .isEqualTo("MALFORMED expected one entry \"A\", found several");
  }

  @Test
  void entriesAreLimited() throws IOException {
    String[] names = new String[ZipParts.MAX_ENTRIES + 1];
    Arrays.setAll(names, i -> "a" + i);
    assertThat(refusal(zip(true, names), Limits.NONE))
        .isEqualTo("TOO_LARGE expected at most 10000 entries in the archive, found 10001");
  }

  @Test
  void ratioIsLimitedBeforeAnythingIsInflated() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(out)) {
      zip.putNextEntry(new ZipEntry("a"));
      zip.write(new byte[20_000_000]);
    }
    assertThat(refusal(out.toByteArray(), Limits.NONE))
        .startsWith("TOO_LARGE a: expected at most ")
        .contains("inflated bytes of an archive of ")
        .endsWith("found 20000000");
  }

  @Test
  void bytesOfAllPartsAreLimited() throws IOException {
    assertThat(refusal(zip(false, "a"), Limits.NONE.withBytes(199)))
        .isEqualTo("TOO_LARGE a: expected at most 199 bytes in all files, found 200");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "24|100|MALFORMED a: expected the checksum",
        "24|201|MALFORMED a: expected 201 bytes, found 200",
        "24|-2|TOO_LARGE a: expected at most",
        "20|9999|MALFORMED expected an archive with 9999 bytes at offset 31, found one of",
        "42|7|MALFORMED byte 7: expected a record of the archive, found another one",
        "16|7|MALFORMED a: expected the checksum 00000007, found ",
        "8|1|UNSUPPORTED a: expected a part that is stored or deflated, found an encrypted one"
      })
  void claimsAreCompared(int offset, int value, String message) throws IOException {
    byte[] zip = zip(false, "a");
    if (offset == 8) {
      little(zip).putShort(entry(zip) + offset, (short) value);
    } else {
      little(zip).putInt(entry(zip) + offset, value);
    }
    assertThat(refusal(zip, Limits.NONE)).startsWith(message);
  }

  @Test
  void otherMethodsAreRefused() throws IOException {
    byte[] zip = zip(false, "a");
    zip[entry(zip) + 10] = 12;
    assertThat(refusal(zip, Limits.NONE))
        .isEqualTo("UNSUPPORTED a: expected a part that is stored or deflated, found method 12");
  }

  @Test
  void damagedBytesAreRefused() throws IOException {
    byte[] zip = zip(false, "a");
    Arrays.fill(zip, 33, 38, (byte) -1);
    assertThat(refusal(zip, Limits.NONE)).startsWith("MALFORMED a: expected ");
    assertThat(refusal(Arrays.copyOf(zip, 40), Limits.NONE))
        .isEqualTo("MALFORMED expected a ZIP archive, found no directory at its end");
  }
}
