package io.github.lumbre.model.format.stl;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.internal.HeapNeed;
import io.github.lumbre.model.internal.Model;
import io.github.lumbre.model.internal.ModelLimits;
import io.github.lumbre.model.internal.ModelPart;
import io.github.lumbre.model.internal.PlainModel;
import io.github.lumbre.model.internal.Warnings;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads STL, in binary form and as text. A file is binary if its size matches the number of
 * triangles in its header, since binary files may begin with "solid", too. Each solid of a text is
 * a part. Vertices of the same position are shared, but triangles stay flat. Stated normals have no
 * effect.
 */
public final class StlReader {
  private static final int HEADER_BYTES = 80;
  private static final int EMPTY_BYTES = HEADER_BYTES + Integer.BYTES;
  private static final int FACET_BYTES = 50;

  /** The usual number of bytes of a triangle in a text. */
  private static final int TEXT_BYTES = 250;

  private StlReader() {}

  /** Returns whether a file begins like an STL text, or has the size that its header states. */
  public static boolean startsIn(byte[] start, long size) {
    Optional<String> found = FileContent.describe(start);
    return found.isEmpty()
        ? size > EMPTY_BYTES && claimedBytes(start) == size
        : found.get().equals("STL");
  }

  /** Returns the triangles that a header states, or that a text of this size has. */
  public static HeapNeed need(byte[] start, long size) {
    long claimed = claimedBytes(start);
    return HeapNeed.ofTriangles(
        claimed != size && StlText.startsIn(start)
            ? size / TEXT_BYTES
            : Math.max(0, (Math.min(claimed, size) - EMPTY_BYTES) / FACET_BYTES));
  }

  public static Model read(byte[] file, ModelFolder folder, ModelOptions options)
      throws ModelFormatException {
    Warnings warnings = new Warnings();
    long claimed = claimedBytes(file);
    List<StlSolid> solids =
        claimed != file.length && StlText.startsIn(file)
            ? StlText.read(file, warnings)
            : List.of(readBinary(file, claimed, options, warnings));
    List<ModelPart> parts = new ArrayList<>();
    for (int i = 0; i < solids.size(); i++) {
      int number = solids.size() == 1 ? 0 : i + 1;
      solids.get(i).part(number, options, warnings).ifPresent(parts::add);
    }
    return PlainModel.of(parts, warnings.all());
  }

  /** Returns the size of a binary file by its header; 0 if the file has no header. */
  private static long claimedBytes(byte[] file) {
    if (file.length < EMPTY_BYTES) {
      return 0;
    }
    long triangles = Integer.toUnsignedLong(little(file).getInt(HEADER_BYTES));
    return EMPTY_BYTES + FACET_BYTES * triangles;
  }

  private static StlSolid readBinary(
      byte[] file, long claimed, ModelOptions options, Warnings warnings)
      throws ModelFormatException {
    if (claimed == 0) {
      throw Kind.MALFORMED.at(
          "", "expected \"solid\" or a header of 84 bytes, found " + file.length + " bytes");
    }
    long triangles = (claimed - EMPTY_BYTES) / FACET_BYTES;
    if (claimed > file.length) {
      throw Kind.MALFORMED.at(
          "",
          "expected %d bytes for %d triangles, found %d"
              .formatted(claimed, triangles, file.length));
    }
    if (claimed < file.length) {
      warnings.add("", "ignored " + (file.length - claimed) + " bytes after the last triangle");
    }
    ModelLimits.requireTriangles("", triangles, options.limits());
    ModelLimits.requireMemory("", 12 * triangles, options.limits());
    ModelLimits.requireHeap("", triangles);
    StlSolid solid = new StlSolid("", "", (int) triangles);
    ByteBuffer in = little(file);
    double[] facet = new double[12];
    for (int i = 0; i < triangles; i++) {
      if ((i & ModelLimits.INTERRUPT_MASK) == 0) {
        Interrupts.check();
      }
      int at = EMPTY_BYTES + FACET_BYTES * i;
      for (int k = 0; k < facet.length; k++) {
        facet[k] = in.getFloat(at + Float.BYTES * k);
      }
      solid.add(facet);
    }
    return solid;
  }

  private static ByteBuffer little(byte[] file) {
    return ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
  }
}
