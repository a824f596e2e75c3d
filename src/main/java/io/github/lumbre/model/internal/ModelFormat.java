package io.github.lumbre.model.internal;

import io.github.lumbre.base.file.FileContent;
import io.github.lumbre.geometry.TriangleMesh;
import io.github.lumbre.model.ModelFolder;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelOptions;
import io.github.lumbre.model.format.dae.DaeReader;
import io.github.lumbre.model.format.gltf.GltfReader;
import io.github.lumbre.model.format.obj.ObjModelReader;
import io.github.lumbre.model.format.off.OffReader;
import io.github.lumbre.model.format.ply.PlyReader;
import io.github.lumbre.model.format.ply.PlyWriter;
import io.github.lumbre.model.format.stl.StlReader;
import io.github.lumbre.model.format.threemf.ThreeMfReader;
import io.github.lumbre.model.format.zip.ZipReader;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedMap;
import java.util.stream.Collectors;

/**
 * The formats of model files, by the endings of their names and by their first bytes. Only this
 * class names the packages of the formats.
 */
public enum ModelFormat {
  GLTF("a glTF file", GltfReader::startsIn, GltfReader::read, GltfReader::need, "gltf", "glb"),
  OBJ("an OBJ file", ObjModelReader::startsIn, ObjModelReader::read, "obj"),
  PLY("a PLY file", PlyReader::startsIn, PlyReader::read, PlyReader::need, "ply"),
  STL("an STL file", StlReader::startsIn, StlReader::read, StlReader::need, "stl"),
  OFF("an OFF file", OffReader::startsIn, OffReader::read, OffReader::need, "off"),
  THREE_MF("a 3MF file", ThreeMfReader::startsIn, ThreeMfReader::read, "3mf"),
  COLLADA("a COLLADA file", DaeReader::startsIn, DaeReader::read, "dae"),
  ZIP("a ZIP archive", ZipReader::startsIn, ZipReader::read, "zip");

  /** The formats for texts in which a line may not break after the dot of an ending. */
  public static final String TITLES = "glTF, GLB, OBJ, PLY, STL, OFF, 3MF, COLLADA or ZIP";

  /** The name endings of the formats, for messages: {@code .gltf, .glb}. */
  public static final String ENDINGS =
      Arrays.stream(values())
          .flatMap(format -> format.endings.stream())
          .map("."::concat)
          .collect(Collectors.joining(", "));

  private interface Start {
    /**
     * Returns whether a file may be of the format.
     *
     * @param start the first {@link FileContent#START} bytes, or more; all if the file has fewer
     * @param size of the file in bytes
     */
    boolean isIn(byte[] start, long size);
  }

  private interface Reader {
    /**
     * Returns the content of a file.
     *
     * @param folder reads other files that the model names
     */
    Model read(byte[] content, ModelFolder folder, ModelOptions options)
        throws ModelFormatException, IOException;
  }

  private interface Count {
    /**
     * Returns the triangles and points that a file states before them; {@link HeapNeed#UNKNOWN} if
     * it states none, or is damaged.
     *
     * @param start the first megabytes of the file, or all of it
     * @param size of the file in bytes
     */
    HeapNeed in(byte[] start, long size);
  }

  private final String title;
  private final Start start;
  private final Reader reader;
  private final Count count;
  private final List<String> endings;

  ModelFormat(String title, Start start, Reader reader, String... endings) {
    this(title, start, reader, (first, size) -> HeapNeed.UNKNOWN, endings);
  }

  ModelFormat(String title, Start start, Reader reader, Count count, String... endings) {
    this.title = title;
    this.start = start;
    this.reader = reader;
    this.count = count;
    this.endings = List.of(endings);
  }

  /** Returns what a file of this format states of its motion. */
  ModelMotions motions(byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    return this == GLTF ? GltfReader.motions(content, folder, options) : ModelMotions.NONE;
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

  /** Returns the format of a file's content, whose parameters {@link Start} has; may be empty. */
  static Optional<ModelFormat> in(byte[] start, long size) {
    return Arrays.stream(values()).filter(format -> format.start.isIn(start, size)).findFirst();
  }

  /** Returns the content of a file of this format. */
  Model read(byte[] content, ModelFolder folder, ModelOptions options)
      throws ModelFormatException, IOException {
    return reader.read(content, folder, options);
  }

  /** Returns the triangles and points that a file states; see {@link Count}. */
  HeapNeed need(byte[] first, long size) {
    return count.in(first, size);
  }

  /** Returns the PLY file of a mesh that is not divided into parts. */
  public static byte[] plyOf(TriangleMesh mesh) {
    return PlyWriter.write(mesh);
  }

  /**
   * Returns the PLY file of meshes that are parts, by their names.
   *
   * @throws IllegalArgumentException if a name is not of words with single spaces between them
   */
  public static byte[] plyOf(SortedMap<String, TriangleMesh> parts) {
    return PlyWriter.write(parts);
  }

  /** Returns what kind of file a content is, and what to do; empty if it is not recognized. */
  public static Optional<String> describe(byte[] file) {
    return in(file, file.length)
        .map(format -> format.withAdvice(file))
        .or(() -> FileContent.describe(file).map(FileContent::withAdvice));
  }

  private String withAdvice(byte[] file) {
    boolean isGlb = this == GLTF && file[0] == 'g';
    return (isGlb ? "GLB" : title.split(" ")[1])
        + "; give its name the ending ."
        + endings.get(isGlb ? 1 : 0);
  }

  /**
   * Returns what another kind of file a content is, and what to do; empty if it may be of this
   * format.
   */
  Optional<String> otherThanThis(byte[] file) {
    Optional<String> found = describe(file);
    boolean isThis = in(file, file.length).filter(this::equals).isPresent();
    return isThis || this == GLTF && found.equals(Optional.of("JSON")) ? Optional.empty() : found;
  }
}
