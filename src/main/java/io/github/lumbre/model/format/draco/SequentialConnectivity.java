package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.util.List;
import java.util.Optional;

/** Reads triangles as a list of corners. Stateless. */
final class SequentialConnectivity {
  private static final int COMPRESSED = 0;
  private static final int PLAIN = 1;

  private SequentialConnectivity() {}

  /** Reads the connectivity of a mesh. */
  static Connectivity decode(DracoInput input, DracoLimits limits) throws ModelFormatException {
    int faces = input.count("faces", Math.min(limits.faces(), Integer.MAX_VALUE));
    int points = input.count("points", Math.min(limits.points(), Integer.MAX_VALUE));
    int method = input.unsignedByte();
    int[] corners =
        switch (method) {
          case COMPRESSED -> compressed(input, faces);
          case PLAIN -> plain(input, faces, points);
          default ->
              throw input.unsupported(
                  "expected compressed (0) or plain (1) corners, found " + method);
        };
    for (int corner : corners) {
      if (corner < 0 || corner >= points) {
        throw input.malformed("expected points from 0 to " + (points - 1) + ", found " + corner);
      }
    }
    return new Connectivity(points, corners, Optional.empty(), List.of());
  }

  /** Reads corners as differences to the corners before them. */
  private static int[] compressed(DracoInput input, int faces) throws ModelFormatException {
    int[] corners = input.integers(3L * faces);
    SymbolDecoder.decode(input, 1, corners);
    int last = 0;
    for (int i = 0; i < corners.length; i++) {
      int difference = corners[i] >>> 1;
      last += (corners[i] & 1) == 0 ? difference : -difference;
      corners[i] = last;
    }
    return corners;
  }

  /** Reads corners in the fewest bytes that hold all points. */
  private static int[] plain(DracoInput input, int faces, int points) throws ModelFormatException {
    int size = points < 1 << 8 ? 1 : points < 1 << 16 ? 2 : points < 1 << 21 ? 0 : 4;
    if (3L * faces * Math.max(1, size) > input.remaining()) {
      throw input.malformed(
          "expected the corners of " + faces + " faces, found " + input.remaining() + " bytes");
    }
    int[] corners = input.integers(3L * faces);
    for (int i = 0; i < corners.length; i++) {
      corners[i] = (int) (size == 0 ? input.varint() : input.integer(size));
    }
    return corners;
  }
}
