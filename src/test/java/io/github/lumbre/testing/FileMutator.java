package io.github.lumbre.testing;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Changes files at a few places: binary files by bytes and numbers, texts by words. Mutable. */
public final class FileMutator {
  private static final int[] INTS = {
    0,
    1,
    -1,
    2,
    3,
    7,
    8,
    127,
    128,
    255,
    256,
    32767,
    32768,
    65535,
    65536,
    1 << 24,
    1 << 28,
    Integer.MAX_VALUE,
    Integer.MIN_VALUE,
    0x7fc00000,
    0x7f800000,
    0x7f7fffff
  };

  private static final String[] WORDS = {
    "",
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "5",
    "99",
    "255",
    "256",
    "65536",
    "2147483647",
    "2147483648",
    "-2147483648",
    "4294967297",
    "99999999999999999999",
    "1e400",
    "1e150",
    "-1e150",
    "1.1e150",
    "1e-320",
    "nan",
    "inf",
    "0x1p3",
    "1f",
    "1,5",
    ".5",
    "+1",
    "--1",
    "\\",
    "\\\n",
    "#",
    "\n",
    "\r",
    "\u0000",
    "\u00ff",
    "\u001b[31m",
    "/",
    "../../x"
  };

  private final Random random;

  public FileMutator(Random random) {
    this.random = random;
  }

  /**
   * Returns a changed copy of a binary file.
   *
   * @param header the length of its beginning, which is changed half of the time
   */
  public byte[] changed(byte[] file, int header) {
    byte[] result = file.clone();
    for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
      int end = random.nextBoolean() ? Math.min(header, result.length) : result.length;
      result = changedOnce(result, random.nextInt(end));
    }
    boolean isCut = random.nextInt(10) == 0;
    return isCut ? Arrays.copyOf(result, 1 + random.nextInt(result.length)) : result;
  }

  private byte[] changedOnce(byte[] file, int at) {
    byte[] result = file.clone();
    switch (random.nextInt(8)) {
      case 0 -> result[at] = (byte) random.nextInt(256);
      case 1 -> result[at] ^= (byte) (1 << random.nextInt(8));
      case 2 -> result[at] = (byte) random.nextInt(4);
      case 3, 4, 5 -> {
        if (at <= result.length - Integer.BYTES) {
          boolean isLittle = random.nextBoolean();
          ByteBuffer.wrap(result)
              .order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN)
              .putInt(at, INTS[random.nextInt(INTS.length)]);
        }
      }
      default -> {
        // Remove or repeat a few bytes.
        int length = 1 + random.nextInt(Math.min(16, file.length - at));
        boolean isRemoved = random.nextBoolean() && file.length > length;
        int rest = isRemoved ? at + length : at;
        int to = isRemoved ? at : at + length;
        result = Arrays.copyOf(file, to + file.length - rest);
        System.arraycopy(file, rest, result, to, file.length - rest);
      }
    }
    return result;
  }

  /**
   * Returns a changed copy of a text.
   *
   * @param keywords words of the format, which replace others, besides numbers of all kinds
   */
  public byte[] changedWords(String text, String... keywords) {
    List<String> words = new ArrayList<>(List.of(text.split("(?<=[ \n])|(?=[ \n])")));
    for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
      int at = random.nextInt(words.size());
      String word =
          random.nextInt(3) == 0
              ? keywords[random.nextInt(keywords.length)]
              : WORDS[random.nextInt(WORDS.length)];
      switch (random.nextInt(5)) {
        case 0 -> words.add(at, word);
        case 1 -> words.set(at, "");
        case 2 -> words.set(at, words.get(random.nextInt(words.size())));
        default -> words.set(at, word);
      }
    }
    String changed = String.join("", words);
    int end = random.nextInt(10) == 0 ? random.nextInt(changed.length() + 1) : changed.length();
    return changed.substring(0, end).getBytes(StandardCharsets.ISO_8859_1);
  }
}
