package io.github.lumbre.model.format.meshopt;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.format.meshopt.MeshoptSamples.Sample;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Streams are decoded to the bits that meshoptimizer returns, or refused with a reason. */
class MeshoptModeTest {
  static List<Sample> samples() {
    return MeshoptSamples.all();
  }

  private static ModelFormatException refusal(Sample sample, byte[] stream) {
    return catchThrowableOfType(ModelFormatException.class, () -> sample.decode(stream));
  }

  @ParameterizedTest
  @MethodSource("samples")
  void bytesAreThoseOfMeshoptimizer(Sample sample)
      throws ModelFormatException, NoSuchAlgorithmException {
    ByteBuffer decoded = sample.decode(sample.stream());
    assertThat(decoded.remaining()).isEqualTo(sample.count() * sample.stride());
    MessageDigest hash = MessageDigest.getInstance("SHA-256");
    hash.update(decoded);
    assertThat(HexFormat.of().formatHex(hash.digest())).isEqualTo(sample.sha256());
  }

  @Test
  void samplesHaveAllModesAndFilters() {
    Set<MeshoptMode> modes = EnumSet.noneOf(MeshoptMode.class);
    Set<MeshoptFilter> filters = EnumSet.noneOf(MeshoptFilter.class);
    MeshoptSamples.all().forEach(sample -> modes.add(sample.mode()));
    MeshoptSamples.all().forEach(sample -> filters.add(sample.filter()));
    assertThat(modes).containsExactly(MeshoptMode.values());
    assertThat(filters).containsExactly(MeshoptFilter.values());
  }

  /** The example in the specification of four-bit differences. */
  @Test
  void differencesAreThoseOfTheSpecification() throws ModelFormatException {
    String group = "175ff0bc77a9210034b5";
    byte[] stream = HexFormat.of().parseHex("a0" + "02" + group + "00".repeat(3) + "00".repeat(32));
    ByteBuffer decoded =
        MeshoptMode.ATTRIBUTES.decode(ByteBuffer.wrap(stream), 16, Integer.BYTES, "");
    int[] differences = {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
    int sum = 0;
    for (int i = 0; i < differences.length; i++) {
      sum += differences[i];
      assertThat(decoded.getInt(4 * i)).isEqualTo(sum & 0xff);
    }
  }

  @Test
  void everyTruncatedStreamIsRefused() {
    for (String name :
        List.of("bytes-100-8-v0", "bytes-100-8-v1-3", "grid-triangles-2", "soup-indices-4")) {
      Sample sample = MeshoptSamples.of(name);
      for (int length = 0; length < sample.stream().length; length++) {
        ModelFormatException e = refusal(sample, Arrays.copyOf(sample.stream(), length));
        assertThat(e).as(name + " " + length).isNotNull();
        assertThat(e.kind()).isEqualTo(Kind.MALFORMED);
        assertThat(e).hasMessageStartingWith("bufferViews[0]: byte ");
      }
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "bytes-16-8-v0 | a2 | byte 1 of its meshopt data: expected 0xa0 or 0xa1 (version 0 or 1)"
            + " at byte 0, found 0xa2",
        "rows-triangles-2 | d1 | byte 1 of its meshopt data: expected 0xe1 at byte 0, found 0xd1",
        "rows-indices-2 | e1 | byte 1 of its meshopt data: expected 0xd1 at byte 0, found 0xe1",
        "rows-triangles-2 | e100 | byte 99 of its meshopt data: expected one of 0 recent values,"
            + " found 0",
        "rows-indices-2 | d1ffffffffff | byte 6 of its meshopt data: expected a number of at most"
            + " 5 bytes, found a longer one"
      })
  void damagedStreamsAreRefused(String name, String start, String message) {
    Sample sample = MeshoptSamples.of(name);
    byte[] stream = sample.stream().clone();
    byte[] changed = HexFormat.of().parseHex(start);
    System.arraycopy(changed, 0, stream, 0, changed.length);
    assertThat(refusal(sample, stream).detail()).isEqualTo(message);
  }

  @Test
  void otherModesOfChannelsAreRefused() {
    Sample sample = MeshoptSamples.of("bytes-100-8-v1-3");
    for (int mode : new int[] {3, 15, 0x10, 0x41}) {
      byte[] stream = sample.stream().clone();
      stream[stream.length - 1] = (byte) mode;
      assertThat(refusal(sample, stream))
          .hasMessageEndingWith("expected channel mode 0, 1 or 2, found 0x%02x".formatted(mode));
    }
  }

  @ParameterizedTest
  @CsvSource({"bytes-100-8-v0, 32", "grid-triangles-2, 16", "soup-indices-4, 4"})
  void bytesBeforeTheTailAreRefused(String name, int tail) {
    Sample sample = MeshoptSamples.of(name);
    byte[] stream = sample.stream();
    byte[] longer = Arrays.copyOf(stream, stream.length + 2);
    System.arraycopy(stream, stream.length - tail, longer, longer.length - tail, tail);
    assertThat(refusal(sample, longer))
        .hasMessageEndingWith("expected its tail, found 2 more bytes before it");
  }

  /** Few bytes cannot announce so many elements that the heap is full. */
  @Test
  void bombsEndBeforeMemoryIsAllocated() {
    ByteBuffer stream = ByteBuffer.allocate(100);
    for (MeshoptMode mode : MeshoptMode.values()) {
      assertThatThrownBy(() -> mode.decode(stream, Integer.MAX_VALUE / 4, 4, "x"))
          .isInstanceOf(ModelFormatException.class)
          .hasMessageContaining("more bytes, found 100");
    }
  }

  @Test
  void floatsKeepTheirBits() {
    ByteBuffer numbers = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
    numbers.putInt(0x00000003).putInt(0xfefffffd).putInt(0x9c7fffff).putInt(0x64800000);
    MeshoptFilter.EXPONENTIAL.restore(numbers.flip(), 8);
    assertThat(numbers.getFloat()).isEqualTo(3);
    assertThat(numbers.getFloat()).isEqualTo(-.75f);
    assertThat(numbers.getFloat()).isEqualTo((float) (8388607 * Math.pow(2, -100)));
    assertThat(numbers.getFloat()).isEqualTo((float) (-8388608 * Math.pow(2, 100)));
  }

  @Test
  void decodingIsInterrupted() {
    for (String name : List.of("bytes-100-8-v0", "grid-triangles-2", "soup-indices-4")) {
      Sample sample = MeshoptSamples.of(name);
      assertCancelled(() -> sample.decode(sample.stream()));
    }
  }
}
