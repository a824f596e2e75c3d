package io.github.lumbre.model.format.draco;

import static io.github.lumbre.testing.Refusals.assertCancelled;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.format.draco.DracoSamples.Sample;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Meshes are decoded to the bits that Google's decoder returns, or refused with a reason. */
class DracoMeshTest {
  private static final DracoLimits LIMITS = new DracoLimits(5000, 5000, bytes -> {});

  static List<Sample> samples() {
    return DracoSamples.all();
  }

  private static DracoMesh decode(byte[] file) throws ModelFormatException {
    return DracoMesh.decode(file, "bufferViews[0]", LIMITS);
  }

  private static ModelFormatException refusal(byte[] file, DracoLimits limits) {
    return catchThrowableOfType(
        ModelFormatException.class, () -> DracoMesh.decode(file, "bufferViews[0]", limits));
  }

  @ParameterizedTest
  @MethodSource("samples")
  void valuesAreThoseOfGooglesDecoder(Sample sample)
      throws ModelFormatException, NoSuchAlgorithmException {
    DracoMesh mesh = decode(DracoSamples.file(sample.name()));
    assertThat(mesh.corners()).hasSize(3 * sample.faces());
    assertThat(mesh.pointCount()).isEqualTo(sample.points());
    MessageDigest hash = MessageDigest.getInstance("SHA-256");
    ByteBuffer corners = ByteBuffer.allocate(4 * mesh.corners().length);
    corners.order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().put(mesh.corners());
    hash.update(corners);
    mesh.attributes().forEach(attribute -> hash.update(attribute.values().duplicate()));
    assertThat(HexFormat.of().formatHex(hash.digest())).isEqualTo(sample.sha256());
  }

  /** Google's encoder does not write compressed corners, nor integers without a prediction. */
  @Test
  void codingsThatEncodersMayWriteAreRead() throws ModelFormatException {
    byte[] file = {
      'D',
      'R',
      'A',
      'C',
      'O',
      2,
      2,
      1,
      0,
      0,
      0, // sequential
      2,
      4, // 2 faces of 4 points
      0,
      0,
      4,
      11,
      1,
      64,
      1,
      0,
      (byte) 0x90,
      0x30,
      2, // compressed corners: tagged, 3 bits each
      1,
      1,
      4,
      1,
      2,
      0,
      7,
      1, // an attribute with the number 7: pairs of INT8, as integers
      -2,
      0,
      1,
      0,
      1,
      2,
      3,
      4,
      5,
      6,
      7 // no prediction, not compressed, 1 byte each
    };
    DracoMesh mesh = decode(file);
    assertThat(mesh.corners()).containsExactly(0, 1, 2, 2, 1, 3);
    byte[] values = {0, -1, 1, -2, 2, -3, 3, -4};
    DracoAttribute expected =
        new DracoAttribute(7, DracoType.INT8, 2, false, ByteBuffer.wrap(values));
    assertThat(mesh.attributes()).containsExactly(expected);
  }

  @Test
  void attributesHaveTheirTypes() throws ModelFormatException {
    assertThat(decode(DracoSamples.file("holes-5")).attributes())
        .extracting(a -> a.id() + " " + a.components() + " " + a.type())
        .containsExactlyInAnyOrder(
            "0 3 FLOAT32",
            "1 3 FLOAT32",
            "2 2 FLOAT32",
            "3 4 UINT8",
            "4 4 UINT16",
            "5 4 FLOAT32",
            "6 1 FLOAT32");
  }

  @ParameterizedTest
  @MethodSource("samples")
  void memoryIsCountedBeforeItIsAllocated(Sample sample) throws ModelFormatException {
    byte[] file = DracoSamples.file(sample.name());
    decode(file);
    long[] counted = {0};
    DracoLimits limits = new DracoLimits(5000, 5000, bytes -> counted[0] += bytes);
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = threads.getCurrentThreadAllocatedBytes();
    DracoMesh.decode(file, "", limits);
    long allocated = threads.getCurrentThreadAllocatedBytes() - before;
    assertThat(allocated).isLessThan(counted[0] + 30_000);
    assertThat(counted[0]).isLessThan(3 * allocated);
  }

  @Test
  void everyTruncatedFileIsRefused() {
    for (String name : List.of("holes-0", "holes-10", "sequential-5", "raw-edgebreaker")) {
      byte[] file = DracoSamples.file(name);
      for (int length = 0; length < file.length; length += length < 200 ? 1 : 97) {
        ModelFormatException e = refusal(Arrays.copyOf(file, length), LIMITS);
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
        "0 | 100 | byte 1 of its Draco data: expected the name DRACO at byte 0, found other bytes",
        "6 | 1 | byte 7 of its Draco data: expected version 2.2, found 2.1",
        "7 | 0 | byte 8 of its Draco data: expected a mesh (1), found a point cloud (0)",
        "8 | 7 | byte 11 of its Draco data: expected sequential (0) or edgebreaker (1)"
            + " connectivity, found 7",
        "11 | 1 | byte 12 of its Draco data: expected standard (0) or valence (2) traversal,"
            + " found 1",
        "15 | 0 | byte 16 of its Draco data: expected at most three vertices per face,"
            + " found 190 of 0 faces"
      })
  void unreadableHeadersAreRefused(int at, int value, String message) {
    byte[] file = DracoSamples.file("bare-5");
    file[at] = (byte) value;
    assertThat(refusal(file, LIMITS).detail()).isEqualTo(message);
  }

  @Test
  void limitsAreChecked() {
    byte[] holes = DracoSamples.file("holes-5");
    assertThat(refusal(holes, new DracoLimits(255, 1000, bytes -> {})))
        .hasMessageContaining("expected at most 255 faces, found 256");
    assertThat(refusal(DracoSamples.file("sequential-5"), new DracoLimits(1000, 186, b -> {})))
        .hasMessageContaining("expected at most 186 points, found 187");
    ModelFormatException full = new ModelFormatException(Kind.TOO_LARGE, "", "full");
    DracoLimits none =
        new DracoLimits(
            1000,
            1000,
            bytes -> {
              throw full;
            });
    assertThat(refusal(holes, none)).isSameAs(full);
  }

  /** A table with one symbol makes any number of faces of no bytes at all. */
  @Test
  void bombsEndBeforeMemoryIsAllocated() {
    byte[] bomb = {
      'D',
      'R',
      'A',
      'C',
      'O',
      2,
      2,
      1,
      0,
      0,
      0, // sequential
      (byte) 0x80,
      (byte) 0x80,
      (byte) 0x80,
      0x20,
      3, // 2^26 faces of 3 points
      0,
      1,
      1,
      1,
      1,
      64,
      1,
      0, // compressed corners: raw symbols of 1 bit, 1 with frequency 4096
      0 // attributes
    };
    DracoLimits limits =
        new DracoLimits(
            1 << 27,
            3,
            bytes -> {
              if (bytes > 1_000_000) {
                throw new ModelFormatException(Kind.TOO_LARGE, "", bytes + " bytes");
              }
            });
    assertThat(refusal(bomb, limits)).hasMessage("805306368 bytes");
    bomb[11] = (byte) 0x81;
    bomb[14] = 0;
    assertThat(refusal(bomb, limits)).isNull();
  }

  @Test
  void decodingIsInterrupted() {
    assertCancelled(() -> decode(DracoSamples.file("edgebreaker-5")));
  }
}
