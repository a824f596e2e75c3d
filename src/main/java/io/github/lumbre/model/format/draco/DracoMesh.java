package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.util.List;

/**
 * A decoded mesh.
 *
 * @param pointCount number of points
 * @param corners the points of the corners of all faces, in [0, pointCount)
 * @param attributes in the order of the stream
 */
public record DracoMesh(int pointCount, int[] corners, List<DracoAttribute> attributes) {
  private static final String MAGIC = "DRACO";
  private static final int MAJOR = 2;
  private static final int MINOR = 2;
  private static final int TRIANGULAR_MESH = 1;
  private static final int SEQUENTIAL = 0;
  private static final int EDGEBREAKER = 1;
  private static final int METADATA_FLAG = 0x8000;

  /**
   * Decodes a stream.
   *
   * @param location of the stream in the file, for messages
   * @throws ModelFormatException if the stream is damaged, exceeds the limits, or has another
   *     version of the bitstream
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static DracoMesh decode(byte[] stream, String location, DracoLimits limits)
      throws ModelFormatException {
    DracoInput input = new DracoInput(stream, location, limits.memory());
    for (int i = 0; i < MAGIC.length(); i++) {
      if (input.unsignedByte() != MAGIC.charAt(i)) {
        throw input.malformed("expected the name DRACO at byte 0, found other bytes");
      }
    }
    int major = input.unsignedByte();
    int minor = input.unsignedByte();
    if (major != MAJOR || minor != MINOR) {
      throw input.unsupported("expected version 2.2, found " + major + "." + minor);
    }
    int type = input.unsignedByte();
    if (type != TRIANGULAR_MESH) {
      throw input.unsupported(
          "expected a mesh (1), found " + (type == 0 ? "a point cloud (0)" : type));
    }
    int method = input.unsignedByte();
    if ((input.unsignedShort() & METADATA_FLAG) != 0) {
      skipMetadata(input);
    }
    Connectivity connectivity =
        switch (method) {
          case SEQUENTIAL -> SequentialConnectivity.decode(input, limits);
          case EDGEBREAKER -> EdgebreakerConnectivity.decode(input, limits);
          default ->
              throw input.unsupported(
                  "expected sequential (0) or edgebreaker (1) connectivity, found " + method);
        };
    List<DracoAttribute> attributes = new AttributesDecoder(input, connectivity).decode();
    return new DracoMesh(connectivity.pointCount(), connectivity.points(), attributes);
  }

  /** Skips names and values: of attributes, then of the mesh, with all that are nested. */
  private static void skipMetadata(DracoInput input) throws ModelFormatException {
    for (long i = input.varint(); i > 0; i--) {
      input.varint();
      skipElement(input);
    }
    skipElement(input);
  }

  private static void skipElement(DracoInput input) throws ModelFormatException {
    long nested = 0;
    do {
      for (long i = input.varint(); i > 0; i--) {
        input.skip(input.unsignedByte());
        input.skip(input.varint());
      }
      nested += input.varint();
      if (nested > 0) {
        input.skip(input.unsignedByte());
      }
    } while (nested-- > 0);
  }
}
