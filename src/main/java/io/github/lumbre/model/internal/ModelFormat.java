package io.github.lumbre.model.internal;

import io.github.lumbre.file.FileContent;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/** The formats of model files, by the endings of their names and by their first bytes. */
enum ModelFormat {
  GLTF("a glTF file", "GLB", "gltf", "glb"),
  OBJ("an OBJ file", "OBJ", "obj"),
  PLY("a PLY file", "PLY", "ply"),
  STL("an STL file", "STL", "stl");

  private static final Pattern ASSET = Pattern.compile("\"asset\"\\s*:\\s*\\{");
  private static final Pattern VERTEX = Pattern.compile("(?m)^\\s*v\\s+[-+.\\d]");
  private static final Set<String> STATEMENTS =
      Set.of("v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "usemtl", "mtllib");

  private final String title;
  private final String content;
  private final List<String> endings;

  ModelFormat(String title, String content, String... endings) {
    this.title = title;
    this.content = content;
    this.endings = List.of(endings);
  }

  /** Returns the name of a content of this format. */
  String content() {
    return content;
  }

  /** Returns a file of this format in words, with an article. */
  String title() {
    return title;
  }

  /** Returns the format that the ending of a file's name states. */
  static Optional<ModelFormat> named(String name) {
    String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    return Arrays.stream(values()).filter(format -> format.endings.contains(ending)).findFirst();
  }

  /**
   * Returns the format of a file's content; empty if it is none of a model.
   *
   * @param start the first {@link FileContent#START} bytes, or more; all if the file has fewer
   * @param size of the file in bytes
   */
  static Optional<ModelFormat> in(byte[] start, long size) {
    Optional<String> found = FileContent.describe(start);
    if (found.isPresent() && !found.get().equals("JSON")) {
      return Arrays.stream(values()).filter(f -> f.content.equals(found.get())).findFirst();
    }
    String text =
        new String(
            start, 0, Math.min(start.length, FileContent.START), StandardCharsets.ISO_8859_1);
    if (found.isPresent()) {
      return ASSET.matcher(text).find() ? Optional.of(GLTF) : Optional.empty();
    }
    if (isBinaryStl(start, size)) {
      return Optional.of(STL);
    }
    return isObj(text) ? Optional.of(OBJ) : Optional.empty();
  }

  private static boolean isBinaryStl(byte[] start, long size) {
    if (start.length < 84) {
      return false;
    }
    long triangles =
        Integer.toUnsignedLong(ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).getInt(80));
    return triangles > 0 && size == 84 + 50 * triangles;
  }

  /** Returns whether the whole lines of a text are statements, and one states a vertex. */
  private static boolean isObj(String text) {
    String whole = text.substring(0, Math.max(0, text.lastIndexOf('\n')));
    return VERTEX.matcher(whole).find()
        && whole
            .lines()
            .map(String::strip)
            .filter(line -> !line.isEmpty() && line.charAt(0) != '#')
            .allMatch(line -> STATEMENTS.contains(line.split("\\s", 2)[0]));
  }

  /**
   * Returns what another kind of file a content is, and what to do; empty if it may be of this
   * format.
   */
  Optional<String> otherThanThis(byte[] file) {
    Optional<String> found = FileContent.describe(file);
    return found.isEmpty()
            || found.get().equals(content)
            || this == GLTF && found.get().equals("JSON")
        ? Optional.empty()
        : Optional.of(FileContent.withAdvice(found.get()));
  }
}
