package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.internal.Interrupts;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.ModelFormatException.Kind;
import io.github.lumbre.model.internal.ModelFiles;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The buffers and buffer views of a glTF file, read when first used. Mutable. */
final class GltfBuffers {
  private static final int MAX_STRIDE = 252;

  private final GltfDocument document;
  private final Optional<ByteBuffer> binary;
  private final ModelFiles folder;
  private final GltfMeshopt meshopt;
  private final Map<Integer, ByteBuffer> buffers = new HashMap<>();
  private final Map<Integer, ModelFormatException> unreadable = new HashMap<>();
  private final Map<Integer, View> views = new HashMap<>();
  private final Map<String, byte[]> files = new HashMap<>();

  /**
   * A part of a buffer.
   *
   * @param bytes little-endian
   * @param stride bytes from one element to the next; 0 if elements follow each other
   */
  record View(ByteBuffer bytes, int stride) {}

  GltfBuffers(GltfDocument document, Optional<ByteBuffer> binary, ModelFiles folder) {
    this.document = document;
    this.binary = binary;
    this.folder = folder;
    meshopt = new GltfMeshopt(document, this);
  }

  /** Returns the buffer view whose index is the member {@code bufferView}, which must exist. */
  View view(GltfJson json) throws ModelFormatException, IOException {
    return view(document.requireIndex(json, "bufferView", "bufferViews"));
  }

  private View view(int index) throws ModelFormatException, IOException {
    View view = views.get(index);
    if (view == null) {
      view = readView(document.section("bufferViews").get(index));
      views.put(index, view);
    }
    return view;
  }

  private View readView(GltfJson json) throws ModelFormatException, IOException {
    Optional<ByteBuffer> decoded = meshopt.decode(json);
    ByteBuffer bytes = decoded.isPresent() ? decoded.get() : bytes(json);
    return new View(bytes, (int) json.whole("byteStride", 0, 1, MAX_STRIDE));
  }

  /** Returns the part of a buffer that an object names, little-endian. */
  ByteBuffer bytes(GltfJson json) throws ModelFormatException, IOException {
    ByteBuffer buffer = buffer(document.requireIndex(json, "buffer", "buffers"));
    int offset = (int) json.whole("byteOffset", 0, 0, buffer.limit());
    int length = (int) json.requireWhole("byteLength", 0, buffer.limit() - offset);
    return buffer.slice(offset, length).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Returns whether the file or another file contains the buffer that an object names. */
  boolean isStored(GltfJson json) throws ModelFormatException {
    int index = document.requireIndex(json, "buffer", "buffers");
    GltfJson buffer = document.section("buffers").get(index);
    for (String extension : GltfMeshopt.EXTENSIONS) {
      Optional<GltfJson> marks = buffer.extension(extension);
      if (marks.isPresent() && marks.get().flag("fallback", false)) {
        return buffer.has("uri");
      }
    }
    return buffer.has("uri") || index == 0 && binary.isPresent();
  }

  private ByteBuffer buffer(int index) throws ModelFormatException, IOException {
    if (unreadable.containsKey(index)) {
      throw unreadable.get(index);
    }
    ByteBuffer buffer = buffers.get(index);
    if (buffer == null) {
      try {
        buffer = readBuffer(index, document.section("buffers").get(index));
      } catch (ModelFormatException e) {
        unreadable.put(index, e);
        throw e;
      }
      buffers.put(index, buffer);
    }
    return buffer;
  }

  private ByteBuffer readBuffer(int index, GltfJson json) throws ModelFormatException, IOException {
    ByteBuffer bytes;
    if (json.has("uri")) {
      bytes = ByteBuffer.wrap(load(json));
    } else if (index == 0 && binary.isPresent()) {
      bytes = binary.get();
    } else {
      throw json.malformed(
          "uri", "expected a URI, as the file has no binary chunk for it, found nothing");
    }
    int length = (int) json.requireWhole("byteLength", 0, bytes.limit());
    return bytes.slice(0, length);
  }

  /** Returns a copy of the buffer view of an object. */
  byte[] copyOfView(GltfJson json) throws ModelFormatException, IOException {
    ByteBuffer view = view(json).bytes();
    document.budget().allocate(json.location(), view.limit());
    byte[] copy = new byte[view.limit()];
    view.get(0, copy);
    return copy;
  }

  /** Returns the data that the member {@code uri} of an object names or contains. */
  byte[] load(GltfJson json) throws ModelFormatException, IOException {
    Interrupts.check();
    String uri = json.text("uri", "");
    String location = json.location("uri");
    if (GltfUri.isData(uri)) {
      document.budget().allocate(location, uri.length());
      return GltfUri.data(uri, location);
    }
    String name = GltfUri.fileName(uri, location);
    if (name.isEmpty()) {
      throw Kind.ASSET.at(location, "expected the name of a file, found nothing");
    }
    byte[] file = files.get(name);
    if (file == null) {
      file = folder.read(name, location);
      document.budget().allocate(location, file.length);
      files.put(name, file);
    }
    return file;
  }
}
