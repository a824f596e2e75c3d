package io.github.lumbre.parser;

import io.github.lumbre.limit.internal.Interrupts;
import io.github.lumbre.math.internal.Sha256;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/**
 * The SHA-256 over a scene's text and then each file that is read for it. The text may be known
 * after some of the files. Mutable.
 */
final class SceneHash {
  /** Bytes between two checks for an interrupt; a power of two, so that sums do not overflow. */
  private static final int BLOCK = 1 << 24;

  private final MessageDigest digest = Sha256.digest();
  private final List<byte[]> waiting = new ArrayList<>();
  private boolean hasText;

  /** Sets the text of the scene, once. */
  void text(byte[] text) {
    hasText = true;
    update(text);
    waiting.forEach(this::update);
    waiting.clear();
  }

  void add(byte[] file) {
    if (hasText) {
      update(file);
    } else {
      waiting.add(file);
    }
  }

  private void update(byte[] bytes) {
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
