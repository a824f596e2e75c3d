package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.internal.Sha256;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/**
 * The SHA-256 over a scene's text and then each file that is read for it. The text may be known
 * after some of the files, and there may be several texts. Mutable.
 */
final class ContentHash {
  /** Bytes between two checks for an interrupt; a power of two, so that sums do not overflow. */
  private static final int BLOCK = 1 << 24;

  private final MessageDigest digest = Sha256.digest();
  private final List<byte[]> waiting = new ArrayList<>();
  private boolean keepsFiles;
  private boolean hasText;

  /** Keeps the files in memory, for {@link #over}. Call it before the text is set. */
  void keepFiles() {
    keepsFiles = true;
  }

  /** Sets the text of the scene, once. */
  void text(byte[] text) {
    hasText = true;
    update(digest, text);
    waiting.forEach(file -> update(digest, file));
    if (!keepsFiles) {
      waiting.clear();
    }
  }

  void add(byte[] file) {
    if (hasText) {
      update(digest, file);
    }
    if (!hasText || keepsFiles) {
      waiting.add(file);
    }
  }

  /** Returns the hash of the files that were kept with another text, in hexadecimal. */
  String over(byte[] text) {
    MessageDigest other = Sha256.digest();
    update(other, text);
    waiting.forEach(file -> update(other, file));
    return HexFormat.of().formatHex(other.digest());
  }

  private static void update(MessageDigest digest, byte[] bytes) {
    for (int at = 0; at < bytes.length; at += BLOCK) {
      Interrupts.check();
      digest.update(bytes, at, Math.min(BLOCK, bytes.length - at));
    }
  }

  /** Returns the hash in hexadecimal. Call it once, at the end. */
  String value() {
    return HexFormat.of().formatHex(digest.digest());
  }
}
