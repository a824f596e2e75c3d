package io.github.lumbre.model.format.gltf;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Damages glTF files: bytes, numbers, words and structure. */
final class GltfMutator {
  private static final List<String> VALUES =
      List.of(
          "0",
          "-1",
          "1",
          "2",
          "3",
          "255",
          "65536",
          "2147483647",
          "2147483648",
          "4294967295",
          "9007199254740993",
          "-0",
          "0.5",
          "1e-320",
          "1e308",
          "-1e308",
          "1e999",
          "null",
          "true",
          "\"\"",
          "\"\\u0000\"",
          "\"..\"",
          "[]",
          "{}",
          "[[]]",
          "[0,0,0]",
          "5120",
          "5121",
          "5123",
          "5125",
          "5126",
          "16777216",
          "134217728");

  private final Random random;

  GltfMutator(long seed) {
    random = new Random(seed);
  }

  /** Returns a damaged copy of a .glb file. */
  byte[] mutant(byte[] glb) {
    int length = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN).getInt(12);
    String json = new String(glb, 20, length, StandardCharsets.ISO_8859_1);
    byte[] binary = Arrays.copyOfRange(glb, Math.min(glb.length, 28 + length), glb.length);
    int changes = 1 + random.nextInt(3);
    for (int i = 0; i < changes; i++) {
      if (random.nextInt(4) == 0) {
        damage(binary);
      } else {
        json = changed(json);
      }
    }
    byte[] file = GltfFile.glb(json.getBytes(StandardCharsets.ISO_8859_1), binary);
    if (random.nextInt(20) == 0) {
      damage(file);
    }
    return random.nextInt(20) == 0 ? Arrays.copyOf(file, random.nextInt(file.length)) : file;
  }

  private void damage(byte[] bytes) {
    if (bytes.length == 0) {
      return;
    }
    int at = random.nextInt(bytes.length);
    switch (random.nextInt(3)) {
      case 0 -> bytes[at] = (byte) random.nextInt(256);
      case 1 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
      default -> Arrays.fill(bytes, at, Math.min(bytes.length, at + 4), (byte) 0xff);
    }
  }

  private String changed(String json) {
    return switch (random.nextInt(8)) {
      case 0 -> spliced(json);
      case 1 -> withoutCharacter(json);
      case 2 -> renamed(json);
      default -> renumbered(json);
    };
  }

  /** Replaces a number. */
  private String renumbered(String json) {
    int from = random.nextInt(json.length());
    while (from < json.length() && !isNumeric(json.charAt(from))) {
      from++;
    }
    int to = from;
    while (to < json.length() && isNumeric(json.charAt(to))) {
      to++;
    }
    String value =
        random.nextInt(3) == 0
            ? Integer.toString(random.nextInt(40))
            : VALUES.get(random.nextInt(VALUES.size()));
    return json.substring(0, from) + value + json.substring(to);
  }

  private static boolean isNumeric(char c) {
    return c >= '0' && c <= '9' || c == '.' || c == '-';
  }

  /** Copies a piece to another place. */
  private String spliced(String json) {
    int from = random.nextInt(json.length());
    int to = Math.min(json.length(), from + random.nextInt(60));
    int at = random.nextInt(json.length());
    return json.substring(0, at) + json.substring(from, to) + json.substring(at);
  }

  private String withoutCharacter(String json) {
    int at = random.nextInt(json.length());
    return json.substring(0, at) + json.substring(Math.min(json.length(), at + 1));
  }

  /** Replaces a key by another key of the file. */
  private String renamed(String json) {
    String[] words = json.split("\"");
    if (words.length < 4) {
      return json;
    }
    words[2 * random.nextInt(words.length / 2) + 1] =
        words[2 * random.nextInt(words.length / 2) + 1];
    return String.join("\"", words);
  }
}
