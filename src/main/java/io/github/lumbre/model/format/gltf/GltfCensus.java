package io.github.lumbre.model.format.gltf;

import io.github.lumbre.base.limit.Limits;
import io.github.lumbre.model.ModelFormatException;
import io.github.lumbre.model.internal.HeapNeed;
import java.nio.ByteBuffer;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Counts what the JSON of a glTF file states, without reading its buffers. Stateless. */
final class GltfCensus {
  private GltfCensus() {}

  /**
   * Returns the triangles and points of all meshes, each counted once; unknown if the JSON is
   * damaged, or not in the start of the file.
   *
   * @param size of the file
   */
  static HeapNeed need(byte[] start, long size) {
    Optional<ByteBuffer> json = GltfContainer.json(start, size);
    try {
      return json.isEmpty()
          ? HeapNeed.UNKNOWN
          : need(GltfJson.read(json.get(), new GltfBudget(Limits.NONE)));
    } catch (ModelFormatException e) {
      return HeapNeed.UNKNOWN; // Reading the file reports what is wrong with it.
    }
  }

  private static HeapNeed need(GltfJson root) throws ModelFormatException {
    List<GltfJson> accessors = root.objects("accessors");
    Set<List<Long>> known = new HashSet<>();
    long triangles = 0;
    long points = 0;
    for (GltfJson mesh : root.objects("meshes")) {
      for (GltfJson primitive : mesh.objects("primitives")) {
        GltfJson attributes = primitive.requireObject("attributes");
        long mode = primitive.whole("mode", GltfTriangles.LIST, 0, Integer.MAX_VALUE);
        GltfJson counted = primitive.has("indices") && mode != 0 ? primitive : attributes;
        String member = counted == primitive ? "indices" : "POSITION";
        int index = counted.index(member, accessors.size()).orElse(-1);
        if (index >= 0 && known.add(List.of((long) index, mode))) {
          int corners = (int) accessors.get(index).whole("count", 0, 0, Integer.MAX_VALUE);
          points += mode == 0 ? corners : 0;
          triangles += mode == 0 ? 0 : GltfTriangles.count((int) mode, corners);
        }
      }
    }
    return new HeapNeed(triangles, points);
  }
}
