package io.github.lumbre.render.denoise;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.junit.jupiter.api.Test;

/** Tests the weights of the network. */
class NetworkTest {
  /** Training does not repeat bit for bit: this file is the network. */
  @Test
  void weightsAreThoseOfTheMeasurements() throws IOException, NoSuchAlgorithmException {
    try (InputStream in = Network.class.getResourceAsStream(Network.RESOURCE)) {
      byte[] bytes = in.readAllBytes();
      String hash = HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
      assertThat(hash)
          .isEqualTo("1b77145cf0810314231b27f153b09a107e7aa026ed905b5625647baee7be49b9");
      assertThat(bytes).hasSize(2 * 425_960);
      assertThat(Network.NAME).isEqualTo("builtin " + hash.substring(0, 8));
    }
  }

  /** Values of the file, as numpy reads them. */
  @Test
  void halfFloatsAreDecoded() {
    Network.Layer first = Network.get().down(0)[0];
    assertThat(first.weights()[0]).isEqualTo(.07342529f);
    assertThat(first.biases()[15]).isEqualTo(-.009819031f);
    Network.Layer last = Network.get().head(4);
    int end = last.weights().length - last.stride() + last.inputs();
    assertThat(last.weights()[end - 1]).isEqualTo(.053375244f);
    assertThat(last.weights()[end]).isZero();
    assertThat(last.biases()[26]).isZero();
  }
}
