package io.github.lumbre.scenefile;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.scenefile.internal.LateHash;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;

/**
 * The SHA-256 over a scene's text and then each file that is read for it. The text may be known
 * after some of the files, and there may be several texts. Mutable.
 */
final class ContentHash {
  /** Bytes between two checks for an interrupt; a power of two, so that sums do not overflow. */
  private static final int BLOCK = 1 << 24;

  /** Of what was too large to wait. */
  private Optional<MessageDigest> begun = Optional.empty();

  /** The files that the digest lacks, or all of them if they are kept. */
  private final List<byte[]> files = new ArrayList<>();

  private long length;
  private boolean keepsFiles;

  /** The text, until the digest has it. */
  private byte[] text = {};

  private boolean hasText;

  /** Keeps the files in memory, for {@link #over}. Call it before the text is set. */
  void keepFiles() {
    keepsFiles = true;
  }

  /** Sets the text of the scene, once. */
  void text(byte[] first) {
    hasText = true;
    text = first;
    limit();
  }

  void add(byte[] file) {
    files.add(file);
    length += file.length;
    limit();
  }

  /** Hashes what waits if it is large, to set it free. */
  private void limit() {
    if (hasText && !keepsFiles && length > LateHash.MOST_WAITING) {
      MessageDigest digest = begun.orElseGet(Sha256::digest);
      begun = Optional.of(digest);
      checked(digest, text);
      files.forEach(file -> checked(digest, file));
      text = new byte[0];
      files.clear();
      length = 0;
    }
  }

  /** Returns the hash of the files that were kept with another text, in hexadecimal. */
  String over(byte[] other) {
    return over(Sha256.digest(), other, files);
  }

  private static String over(MessageDigest digest, byte[] text, List<byte[]> files) {
    digest.update(text);
    files.forEach(digest::update);
    return HexFormat.of().formatHex(digest.digest());
  }

  /** Adds bytes while files are read. What comes later, such as a hash, no interrupt ends. */
  private static void checked(MessageDigest digest, byte[] bytes) {
    for (int at = 0; at < bytes.length; at += BLOCK) {
      Interrupts.check();
      digest.update(bytes, at, Math.min(BLOCK, bytes.length - at));
    }
  }

  /** Returns the hash. Call it once, at the end. */
  LateHash value() {
    byte[] first = text;
    List<byte[]> rest = List.copyOf(files);
    Optional<MessageDigest> digest = begun;
    return new LateHash(() -> over(digest.orElseGet(Sha256::digest), first, rest));
  }
}
