package io.github.lumbre.base.file;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;

/** Recognizes the format of a file by its first bytes, for messages. Stateless. */
public final class FileContent {
  /** The number of first bytes that are looked at. */
  public static final int START = 4096;

  private static final int LONGEST_MARK = 64;

  /** The offset of the name of an archive's first file. */
  private static final int NAME = 30;

  /** The group code 0 and its first value, perhaps after comments, whose code is 999. */
  private static final Pattern DXF =
      Pattern.compile("(999\\s*\\R[^\\r\\n]*\\R\\s*)*0\\s*\\R\\s*SECTION\\b");

  private static final Pattern PCD =
      Pattern.compile("(#[^\\r\\n]*\\R\\s*)*VERSION\\s+[.\\d]+\\s*\\RFIELDS\\s");

  private static final Pattern IFC = Pattern.compile("FILE_SCHEMA\\s*\\(\\s*\\(\\s*'IFC");

  /**
   * What files of a kind begin with.
   *
   * @param mark with . for any byte
   */
  private record Kind(String mark, int offset, String name) {
    Kind(String mark, String name) {
      this(mark, 0, name);
    }

    boolean isIn(byte[] file) {
      if (file.length < offset + mark.length()) {
        return false;
      }
      for (int i = 0; i < mark.length(); i++) {
        if (mark.charAt(i) != '.' && mark.charAt(i) != (file[offset + i] & 0xff)) {
          return false;
        }
      }
      return true;
    }
  }

  private static final String MTL = "MTL, the materials of an OBJ file";
  private static final String BLENDER = "a Blender file";
  private static final String LFS = "a Git LFS pointer instead of the file";

  private static final List<Kind> KINDS =
      List.of(
          new Kind("\u0089PNG\r\n\u001a\n", "a PNG picture"),
          new Kind("\u00ff\u00d8\u00ff", "a JPEG picture"),
          new Kind("v/1\u0001....", "an OpenEXR picture"),
          new Kind("#?.", "a Radiance HDR picture"),
          new Kind("PF\n", "a PFM picture"),
          new Kind("Pf\n", "a PFM picture"),
          new Kind("GIF8", "a GIF picture"),
          new Kind("RIFF....WEBP", "a WebP picture"),
          new Kind("\u00abKTX ", "a KTX picture"),
          new Kind("sB\u0013\u0000", "a Basis Universal picture"),
          new Kind("DDS ", "a DDS picture"),
          new Kind("8BPS", "a Photoshop picture"),
          new Kind("II*\u0000", "a TIFF picture"),
          new Kind("MM\u0000*", "a TIFF picture"),
          new Kind("BM....\u0000\u0000\u0000\u0000", "a BMP picture"),
          new Kind("\u0000\u0000\u0002\u0000\u0000\u0000\u0000\u0000", "a TGA picture"),
          new Kind("\u0000\u0000\n\u0000\u0000\u0000\u0000\u0000", "a TGA picture"),
          new Kind("\u0000\u0000\u0000\fjP  ", "a JPEG 2000 picture"),
          new Kind("\u00ff\n", "a JPEG XL picture"),
          new Kind("\u0000\u0000\u0000\fJXL ", "a JPEG XL picture"),
          new Kind("ftypavif", 4, "an AVIF picture"),
          new Kind("ftyphei", 4, "a HEIC picture"),
          new Kind("ftypmif1", 4, "a HEIC picture"),
          new Kind("ftyp", 4, "a video"),
          new Kind("glTF", "GLB"),
          new Kind("ply\n", "PLY"),
          new Kind("ply\r", "PLY"),
          new Kind("Kaydara FBX Binary", "FBX"),
          new Kind("; FBX", "FBX"),
          new Kind("PXR-USDC", "USD"),
          new Kind("#usda", "USD"),
          new Kind("BLENDER", BLENDER),
          new Kind("DRACO", "Draco"),
          new Kind("Ogawa", "Alembic"),
          new Kind("AutoCAD Binary DXF", "DXF"),
          new Kind("AC10", "DWG"),
          new Kind("# .PCD", "PCD"),
          new Kind("LASF", "LAS"),
          new Kind("# vtk DataFile", "VTK"),
          new Kind("b3dm", "B3DM"),
          new Kind("i3dm", "I3DM"),
          new Kind("cmpt", "CMPT"),
          new Kind("pnts", "PNTS"),
          new Kind("#VRML", "VRML"),
          new Kind("3D Geometry File Format", "a Rhino file"),
          new Kind("xof ", "a DirectX model"),
          new Kind("FORM....LW", "LightWave"),
          new Kind("MM....\u0002\u0000", "3DS"),
          new Kind("%PDF", "PDF"),
          new Kind("LUMBRE-FILM", "a checkpoint file"),
          new Kind("\u0028\u00b5\u002f\u00fd", "a Zstandard archive"),
          new Kind("7z\u00bc\u00af", "a 7-Zip archive"),
          new Kind("Rar!", "a RAR archive"),
          new Kind("version https://git-lfs", LFS));

  private FileContent() {}

  /**
   * Returns the format of a file, such as {@code a PNG picture} or {@code FBX}; empty if it is not
   * recognized.
   *
   * @param start the first {@link #START} bytes of the file, or more; all if it has fewer
   */
  public static Optional<String> describe(byte[] start) {
    for (Kind kind : KINDS) {
      if (kind.isIn(start)) {
        return Optional.of(kind.name);
      }
    }
    if (new Kind("PK\u0003\u0004", "").isIn(start)) {
      return Optional.of(archive(text(start)));
    }
    if (new Kind("\u001f\u008b", "").isIn(start)) {
      boolean isBlender = describe(unpacked(start)).equals(Optional.of(BLENDER));
      return Optional.of(isBlender ? "a compressed Blender file" : "a gzip archive");
    }
    return ofText(text(start));
  }

  /** Returns {@link #describe} with advice on such a file. */
  public static String withAdvice(String found) {
    if (found.endsWith(" picture")) {
      return found + "; name the scene or model that uses it";
    }
    return switch (found) {
      case MTL -> found + "; name that file";
      case LFS -> found + "; fetch it with git lfs pull";
      case "an HTML page" -> found + "; download the file itself";
      case "a checkpoint file" -> found + "; resume it";
      case "PCD", "LAS", "PNTS" -> found + "; convert it to PLY";
      case "an empty file", "JSON", "XML", "PDF", "a video", "another kind of file" -> found;
      default -> found + (found.endsWith(" archive") ? "; unpack it" : "; export it to GLB");
    };
  }

  /** Returns the first {@link #START} bytes of a file as characters. */
  public static String text(byte[] start) {
    return new String(start, 0, Math.min(start.length, START), StandardCharsets.ISO_8859_1);
  }

  /** Returns the first bytes of what a gzip archive holds; none if it is damaged. */
  private static byte[] unpacked(byte[] start) {
    try (InputStream in = new GZIPInputStream(new ByteArrayInputStream(start))) {
      return in.readNBytes(LONGEST_MARK);
    } catch (IOException e) {
      return new byte[0];
    }
  }

  /** Returns the kind of a ZIP archive by the names of its first files. */
  private static String archive(String text) {
    if (text.contains(".usd")) {
      return "USDZ";
    }
    int length = text.length() < NAME ? 0 : text.charAt(NAME - 4) | text.charAt(NAME - 3) << 8;
    String first = text.substring(Math.min(NAME, text.length())).toLowerCase(Locale.ROOT);
    if (first.startsWith(".amf", length - 4) || first.startsWith(".ifc", length - 4)) {
      return first.startsWith(".amf", length - 4) ? "AMF" : "IFC";
    }
    return text.contains("3D/3dmodel.model") || text.contains("3dmanufacturing")
        ? "3MF"
        : text.contains("[Content_Types].xml") ? "3MF or an office document" : "a ZIP archive";
  }

  private static Optional<String> ofText(String text) {
    boolean isWide = text.startsWith("\u00ff\u00fe") || text.startsWith("\u00fe\u00ff");
    String narrow = isWide ? text.substring(2).replace("\0", "") : text;
    String trimmed = narrow.startsWith("\u00ef\u00bb\u00bf") ? narrow.substring(3) : narrow;
    String begin = trimmed.stripLeading();
    if (begin.isEmpty()) {
      return text.isEmpty() ? Optional.of("an empty file") : Optional.empty();
    }
    if (begin.startsWith("<")) {
      return Optional.of(markup(begin));
    }
    if (begin.matches("(?s)(#[^\\n]*\\n\\s*)*[STCN4n]*OFF[\\s\\d].*")) {
      return Optional.of("OFF");
    }
    if (begin.startsWith("ISO-10303-21")) {
      return Optional.of(IFC.matcher(begin).find() ? "IFC" : "STEP");
    }
    if (DXF.matcher(begin).lookingAt()) {
      return Optional.of("DXF");
    }
    if (PCD.matcher(begin).lookingAt()) {
      return Optional.of("PCD");
    }
    if (begin.matches("(?s)solid\\b.*?\\bfacet\\b.*")) {
      return Optional.of("STL");
    }
    if (begin.matches("(?s)(#[^\\n]*\\n\\s*)*newmtl\\s.*")) {
      return Optional.of(MTL);
    }
    return begin.startsWith("{") ? Optional.of("JSON") : Optional.empty();
  }

  private static String markup(String text) {
    if (text.contains("<COLLADA")) {
      return "COLLADA";
    }
    if (text.contains("<X3D")) {
      return "X3D";
    }
    if (text.contains("<VTKFile")) {
      return "VTK";
    }
    if (text.contains("<amf")) {
      return "AMF";
    }
    if (text.contains("<ifcXML") || text.contains("buildingsmart-tech.org/ifc")) {
      return "IFC";
    }
    if (text.contains("<svg")) {
      return "an SVG picture";
    }
    boolean isHtml = text.regionMatches(true, 0, "<!doctype html", 0, 14) || text.contains("<html");
    return isHtml ? "an HTML page" : "XML";
  }
}
