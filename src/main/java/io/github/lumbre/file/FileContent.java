package io.github.lumbre.file;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;

/** Recognizes the format of a file by its first bytes, for messages. Stateless. */
public final class FileContent {
  /** The number of first bytes that are looked at. */
  public static final int START = 4096;

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
          new Kind("BLENDER", "a Blender file"),
          new Kind("DRACO", "Draco"),
          new Kind("Ogawa", "Alembic"),
          new Kind("ISO-10303-21", "STEP"),
          new Kind("#VRML", "VRML"),
          new Kind("3D Geometry File Format", "a Rhino file"),
          new Kind("xof ", "a DirectX model"),
          new Kind("FORM....LW", "LightWave"),
          new Kind("MM....\u0002\u0000", "3DS"),
          new Kind("%PDF", "PDF"),
          new Kind("LUMBRE-FILM", "a checkpoint file"),
          new Kind("\u001f\u008b", "a gzip archive"),
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
      case "an empty file", "JSON", "XML", "PDF", "a video", "another kind of file" -> found;
      default -> found + (found.endsWith(" archive") ? "; unpack it" : "; export it to GLB");
    };
  }

  /** Returns the first {@link #START} bytes of a file as characters. */
  public static String text(byte[] start) {
    return new String(start, 0, Math.min(start.length, START), StandardCharsets.ISO_8859_1);
  }

  /** Returns the kind of a ZIP archive by the names of its first files. */
  private static String archive(String text) {
    if (text.contains(".usd")) {
      return "USDZ";
    }
    return text.contains("3D/3dmodel.model") || text.contains("3dmanufacturing")
        ? "3MF"
        : text.contains("[Content_Types].xml") ? "3MF or an office document" : "a ZIP archive";
  }

  private static Optional<String> ofText(String text) {
    String trimmed = text.startsWith("\u00ef\u00bb\u00bf") ? text.substring(3) : text;
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
    if (text.contains("<svg")) {
      return "an SVG picture";
    }
    boolean isHtml = text.regionMatches(true, 0, "<!doctype html", 0, 14) || text.contains("<html");
    return isHtml ? "an HTML page" : "XML";
  }
}
