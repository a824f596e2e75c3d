package io.github.lumbre.model.format.gltf;

import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.format.meshopt.MeshoptFilter;
import io.github.lumbre.model.format.meshopt.MeshoptMode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Buffer views that are compressed (KHR_meshopt_compression, EXT_meshopt_compression). */
record GltfMeshopt(GltfDocument document, GltfBuffers buffers) {
  /** The names of the extension; their streams are the same. */
  static final List<String> EXTENSIONS =
      List.of("KHR_meshopt_compression", "EXT_meshopt_compression");

  private static final List<String> MODES = names(MeshoptMode.values());
  private static final List<String> FILTERS = names(MeshoptFilter.values());

  /** The longest array of bytes. */
  private static final int MAX_BYTES = Integer.MAX_VALUE - 8;

  private static List<String> names(Enum<?>... values) {
    return Arrays.stream(values).map(Enum::name).toList();
  }

  /**
   * Returns the decoded bytes of a buffer view. If the data is damaged and the file also has plain
   * bytes, there are none, with a warning.
   *
   * @return little-endian; empty if the plain bytes are to be used
   */
  Optional<ByteBuffer> decode(GltfJson view) throws ModelFormatException, IOException {
    for (String name : EXTENSIONS) {
      Optional<GltfJson> extension = view.extension(name);
      if (extension.isPresent()) {
        return decode(view, extension.get(), name);
      }
    }
    return Optional.empty();
  }

  private Optional<ByteBuffer> decode(GltfJson view, GltfJson extension, String name)
      throws ModelFormatException, IOException {
    try {
      return Optional.of(decode(view, extension));
    } catch (ModelFormatException e) {
      boolean isRequired = document.root().texts("extensionsRequired").contains(name);
      if (isRequired || e.kind() == Kind.TOO_LARGE || !buffers.isStored(view)) {
        throw e;
      }
      String message = e.getMessage() + "; the uncompressed data is used";
      document.warnings().add("uncompressed data is used", "", message);
      return Optional.empty();
    }
  }

  private ByteBuffer decode(GltfJson view, GltfJson extension)
      throws ModelFormatException, IOException {
    MeshoptMode mode = MeshoptMode.valueOf(extension.choice("mode", "", MODES));
    MeshoptFilter filter = MeshoptFilter.valueOf(extension.choice("filter", "NONE", FILTERS));
    if (mode != MeshoptMode.ATTRIBUTES && filter != MeshoptFilter.NONE) {
      throw extension.expected("filter", "NONE with the mode " + mode);
    }
    int stride =
        (int) extension.requireWhole("byteStride", MeshoptMode.MIN_STRIDE, MeshoptMode.MAX_STRIDE);
    if (!mode.fits(stride) || !filter.fits(stride)) {
      throw extension.expected("byteStride", "a size of " + mode + " with the filter " + filter);
    }
    long count = extension.requireWhole("count", 0, GltfBudget.MAX_COUNT);
    if (mode == MeshoptMode.TRIANGLES && count % 3 != 0) {
      throw extension.expected("count", "a multiple of 3");
    }
    if (view.requireWhole("byteLength", 0, MAX_BYTES) != count * stride) {
      throw view.expected("byteLength", count + " times " + stride + " bytes");
    }
    ByteBuffer stream = buffers.bytes(extension);
    document.budget().allocate(extension.location(), count * stride);
    ByteBuffer decoded = mode.decode(stream, (int) count, stride, extension.location());
    filter.restore(decoded, stride);
    return decoded;
  }
}
