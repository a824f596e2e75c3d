package io.github.lumbre.model.format.off;

import io.github.lumbre.base.text.PrintableText;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.TextScanner;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The header of an OFF text.
 *
 * @param hasCoordinates whether vertices have texture coordinates ({@code ST})
 * @param hasColors whether vertices have colors ({@code C})
 * @param hasNormals whether vertices have normals ({@code N})
 * @param vertices the number of vertices
 * @param faces the number of faces
 */
record OffHeader(
    boolean hasCoordinates, boolean hasColors, boolean hasNormals, int vertices, int faces) {
  /** The letters of the attributes, and the number of vertices, which ModelNet40 appends. */
  private static final Pattern KEYWORD = Pattern.compile("((?:ST|[CN])*)([4n]*)OFF(\\d*)");

  /** Larger than the counts of any file that fits into an array. */
  private static final long MAX_COUNT = Integer.MAX_VALUE;

  /** The fewest bytes of a vertex: {@code 0 0 0} with a line end. */
  private static final long VERTEX_BYTES = 6;

  /** The fewest bytes of a face: its number of corners with a line end. */
  private static final long FACE_BYTES = 2;

  /**
   * Reads a header, and the line end after it.
   *
   * @param layout the number of edges may be missing in {@link OffLayout#LINES} alone
   * @param bytes the size of the file
   * @throws ModelFormatException if the text has no header, is shorter than its header requires, or
   *     has another form than vertices of three coordinates as text
   */
  static OffHeader read(TextScanner scanner, int bytes, OffLayout layout)
      throws ModelFormatException {
    Matcher keyword = KEYWORD.matcher(scanner.nextWordOfText() ? scanner.word() : "");
    if (!keyword.matches()) {
      throw scanner.error("expected \"OFF\", found something else");
    }
    String letters = keyword.group(1);
    if (!keyword.group(2).isEmpty()) {
      throw unsupported(
          scanner, "expected three coordinates, found " + PrintableText.quoted(scanner.word()));
    }
    long vertices = keyword.group(3).isEmpty() ? count(scanner) : glued(keyword.group(3));
    long faces = count(scanner);
    if (layout != OffLayout.LINES) {
      count(scanner);
    }
    layout.end(scanner);
    long least = VERTEX_BYTES * vertices + FACE_BYTES * faces;
    // The last line end may be missing.
    long found = bytes - scanner.position() + 1L;
    if (least > found) {
      throw scanner.error(
          "expected %d vertices and %d faces of at least %d bytes, found %d bytes"
              .formatted(vertices, faces, least, found));
    }
    return new OffHeader(
        letters.contains("ST"),
        letters.contains("C"),
        letters.contains("N"),
        (int) vertices,
        (int) faces);
  }

  private static long count(TextScanner scanner) throws ModelFormatException {
    if (!scanner.nextWordOfText()) {
      throw scanner.error("expected the numbers of vertices and faces, found the end of the file");
    }
    if (scanner.wordIs("BINARY")) {
      throw unsupported(scanner, "expected OFF as text, found \"BINARY\"");
    }
    return scanner.integer(0, MAX_COUNT);
  }

  private static long glued(String digits) {
    return digits.length() < 10 ? Long.parseLong(digits) : MAX_COUNT;
  }

  private static ModelFormatException unsupported(TextScanner scanner, String message) {
    return Kind.UNSUPPORTED.at(scanner.location(), message + "; export it as OFF text or GLB");
  }
}
