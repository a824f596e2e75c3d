package io.github.lumbre.scenefile;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.lumbre.math.internal.Sha256;
import io.github.lumbre.scenefile.internal.LateHash;
import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class ContentHashTest {
  private static final byte[] TEXT = {1, 2, 3};

  private static byte[] file(int length) {
    byte[] file = new byte[length];
    Arrays.fill(file, (byte) length);
    return file;
  }

  private static String expected(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return Sha256.of(all.toByteArray());
  }

  @Test
  void textComesFirstAlsoIfItIsKnownLater() {
    ContentHash hash = new ContentHash();
    hash.add(file(5));
    hash.text(TEXT);
    hash.add(file(6));
    assertThat(hash.value().value()).isEqualTo(expected(TEXT, file(5), file(6)));
  }

  @Test
  void filesThatAreTooLargeToWaitAreHashedInTheSameOrder() {
    byte[] large = file(LateHash.MOST_WAITING - 2);
    ContentHash hash = new ContentHash();
    hash.text(TEXT);
    hash.add(file(5));
    hash.add(large);
    hash.add(file(6));
    hash.add(large);
    hash.add(file(7));
    assertThat(hash.value().value())
        .isEqualTo(expected(TEXT, file(5), large, file(6), large, file(7)));
  }

  @Test
  void keptFilesGiveTheHashesOfSeveralTexts() {
    ContentHash hash = new ContentHash();
    hash.keepFiles();
    hash.add(file(5));
    hash.text(TEXT);
    hash.add(file(LateHash.MOST_WAITING));
    LateHash first = hash.value();
    assertThat(hash.over(file(9)))
        .isEqualTo(expected(file(9), file(5), file(LateHash.MOST_WAITING)));
    assertThat(first.value()).isEqualTo(expected(TEXT, file(5), file(LateHash.MOST_WAITING)));
    assertThat(first.value()).isEqualTo(first.value());
  }

  /** A partial picture states the hash, too. */
  @Test
  void anInterruptedThreadGetsTheHash() {
    ContentHash hash = new ContentHash();
    hash.text(TEXT);
    hash.add(file(LateHash.MOST_WAITING));
    hash.add(file(5));
    LateHash late = hash.value();
    Thread.currentThread().interrupt();
    try {
      assertThat(late.value()).isEqualTo(expected(TEXT, file(LateHash.MOST_WAITING), file(5)));
    } finally {
      assertThat(Thread.interrupted()).isTrue();
    }
  }
}
