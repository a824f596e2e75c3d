package io.github.lumbre.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Changes OBJ texts word by word. */
final class MeshMutator {
  private static final String SOUND =
      """
      v 0 0 0
      v 1 0 0
      v 1 1 0
      v 0 1 .5
      vt 0 0
      vt 1 0
      vt 1 1
      vn 0 0 1
      vn 0 1 0
      f 1/1/1 2/2/1 3/3/2
      f 1//1 3//2 4//1
      f -4 -3 -2 -1
      f 1/1 2/2 4/3
      """;

  private static final String[] WORDS = {
    "0",
    "1",
    "-1",
    "5",
    "-9",
    "4294967297",
    "2147483648",
    "-2147483648",
    "1/2/3/4",
    "1//",
    "/1",
    "//",
    "1/0/0",
    "1/99/1",
    "1//-9",
    "1e400",
    "-1e150",
    "1e150",
    "1.1e150",
    "1e-320",
    "nan",
    "inf",
    "0x1p3",
    "1f",
    ",5",
    "1,5",
    "+1",
    "--1",
    "",
    "\\",
    "\\\n",
    "#",
    "\n",
    "\r",
    "f",
    "v",
    "vt",
    "vn",
    "vp",
    "g",
    "usemtl ../../x",
    "mtllib /etc/passwd",
    "\u0000",
    "\u00ff",
    "99999999999999999999",
    "f 1 2 3 4 1 2 3 4 1 2 3 4"
  };

  private final Random random;

  MeshMutator(Random random) {
    this.random = random;
  }

  /** Returns an OBJ text that differs from the given one, or from a valid one if that is empty. */
  byte[] changed(byte[] old) {
    String text =
        old.length == 0 || random.nextBoolean()
            ? SOUND
            : new String(old, StandardCharsets.ISO_8859_1);
    List<String> words = new ArrayList<>(List.of(text.split("(?<=[ \n])|(?=[ \n])")));
    for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
      int at = random.nextInt(words.size());
      String word = WORDS[random.nextInt(WORDS.length)];
      switch (random.nextInt(4)) {
        case 0 -> words.add(at, word);
        case 1 -> words.set(at, "");
        default -> words.set(at, word);
      }
    }
    String changed = String.join("", words);
    int end = random.nextInt(10) == 0 ? random.nextInt(changed.length() + 1) : changed.length();
    return changed.substring(0, end).getBytes(StandardCharsets.ISO_8859_1);
  }
}
