package io.github.lumbre.model.format.draco;

import io.github.lumbre.model.ModelFormatException;
import java.util.Optional;

/**
 * Decodes integers: corrections, and the predictions that they correct.
 *
 * @param components numbers per entry
 * @param isNormal whether an entry is two {@link Octahedron} coordinates
 * @param entries their order
 * @param positions from which other values are predicted; empty before they are decoded
 */
record IntegerValues(
    DracoInput input,
    int components,
    boolean isNormal,
    Entries entries,
    Optional<Positions> positions) {
  private static final int NO_PREDICTION = -2;
  private static final int DIFFERENCE = 0;
  private static final int PARALLELOGRAM = 1;
  private static final int CONSTRAINED_MULTI_PARALLELOGRAM = 4;
  private static final int TEXTURE_COORDINATES = 5;
  private static final int GEOMETRIC_NORMAL = 6;
  private static final int WRAPPED = 1;
  private static final int OCTAHEDRAL = 3;

  /** Returns the numbers of all entries. */
  int[] decode() throws ModelFormatException {
    int method = input.signedByte();
    boolean isPredicted = method != NO_PREDICTION;
    if (isPredicted) {
      int expected = isNormal ? OCTAHEDRAL : WRAPPED;
      int transform = input.signedByte();
      if (transform != expected) {
        throw input.unsupported("expected transform " + expected + ", found " + transform);
      }
    }
    int[] values = input.integers((long) entries.count() * components);
    readSymbols(values);
    if (!isPredicted || !isNormal) {
      for (int i = 0; i < values.length; i++) {
        values[i] = SymbolDecoder.signed(values[i]);
      }
    }
    if (isPredicted) {
      readPrediction(method).restore(values);
    }
    return values;
  }

  private void readSymbols(int... values) throws ModelFormatException {
    if (input.unsignedByte() != 0) {
      SymbolDecoder.decode(input, components, values);
      return;
    }
    int size = input.unsignedByte();
    if (size < 1 || size > Integer.BYTES || (long) values.length * size > input.remaining()) {
      throw input.malformed(
          "expected %d numbers of 1 to 4 bytes, found numbers of %d in %d bytes"
              .formatted(values.length, size, input.remaining()));
    }
    for (int i = 0; i < values.length; i++) {
      values[i] = (int) input.integer(size);
    }
  }

  private Prediction readPrediction(int method) throws ModelFormatException {
    if (method == DIFFERENCE) {
      Correction correction =
          isNormal ? OctahedralCorrection.read(input) : WrappedCorrection.read(input, components);
      return new Difference(correction, components);
    }
    if (entries.table().isEmpty() || isNormal != (method == GEOMETRIC_NORMAL)) {
      throw input.unsupported("expected a prediction that fits the values, found " + method);
    }
    boolean isByPosition = method == TEXTURE_COORDINATES || method == GEOMETRIC_NORMAL;
    if (isByPosition && (positions.isEmpty() || components != 2)) {
      throw input.malformed("expected two numbers after integer positions, found others");
    }
    CornerTable table = entries.table().get();
    return switch (method) {
      case PARALLELOGRAM ->
          new Parallelogram(entries, table, components, WrappedCorrection.read(input, components));
      case CONSTRAINED_MULTI_PARALLELOGRAM ->
          ConstrainedMultiParallelogram.read(input, entries, table, components);
      case TEXTURE_COORDINATES -> TextureCoordinates.read(input, entries, table, positions.get());
      case GEOMETRIC_NORMAL -> GeometricNormal.read(input, entries, table, positions.get());
      default ->
          throw input.unsupported("expected prediction -2, 0, 1, 4, 5 or 6, found " + method);
    };
  }
}
