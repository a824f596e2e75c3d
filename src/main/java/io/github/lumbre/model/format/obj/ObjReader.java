package io.github.lumbre.model.format.obj;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.TextScanner;
import java.util.Optional;

/**
 * Reads the geometry of Wavefront OBJ as one mesh: {@code v}, {@code vt}, {@code vn} and {@code f}.
 * Polygons become triangle fans. All other statements are ignored. Stateless.
 */
public final class ObjReader {
  private ObjReader() {}

  /**
   * Returns the mesh in an OBJ text.
   *
   * @throws ModelFormatException if the text is malformed, refers to missing vertices, has no faces
   *     or is too large
   */
  public static ObjMesh read(byte[] text) throws ModelFormatException {
    return read(text, Limits.NONE);
  }

  /** Returns the mesh in an OBJ text within limits; see {@link #read(byte[])}. */
  public static ObjMesh read(byte[] text, Limits limits) throws ModelFormatException {
    ObjCensus census = ObjCensus.of(text, limits);
    TextScanner scanner = new TextScanner(text);
    ObjFaces faces = new ObjFaces(scanner, census, false);
    ObjSurface surface = new ObjSurface(Math.toIntExact(census.triangles()));
    while (scanner.hasMore()) {
      if (scanner.nextWord()) {
        faces.read(surface);
      }
      scanner.endLine();
    }
    if (surface.triangles().count() == 0) {
      throw noFaces(text, scanner);
    }
    return faces.mesh(surface);
  }

  private static ModelFormatException noFaces(byte[] text, TextScanner scanner) {
    Optional<String> picture = FileContent.describe(text);
    return picture.isPresent()
        ? Kind.MALFORMED.at("", "expected an OBJ file, found " + picture.get())
        : scanner.error("expected at least one face, found the end of the file");
  }
}
